// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/import/csv_table.h"
#include "luxel/import/luminaires.h"
#include "luxel/photometry/read_photometry.h"

namespace luxel {
namespace {

constexpr auto columns = std::to_array<std::string_view>(
    {"file",  "x",        "y",        "z",       "aim_x",       "aim_y",  "aim_z", "dir_x",
     "dir_y", "dir_z",    "rotation", "dimming", "maintenance", "group",  "red",   "green",
     "blue",  "lamp_set", "turn",     "columns", "rows",        "step_x", "step_y"});
constexpr std::size_t max_luminaires = 100'000;  // of one line
constexpr double max_dimming = 1000.0;

double checked(const CsvTable& table, std::string_view name, double fallback, double low, double high) {
  const auto value = table.number(name).value_or(fallback);
  if (!(value >= low && value <= high))
    table.refuse(fmt::format("expected {} from {:g} to {:g}, found {:g}", name, low, high, value));
  return value;
}

std::size_t count(const CsvTable& table, std::string_view name) {
  const auto value = checked(table, name, 1.0, 1.0, static_cast<double>(max_luminaires));
  if (value != std::floor(value))
    table.refuse(fmt::format("expected a whole number for {}, found {:g}", name, value));
  return static_cast<std::size_t>(value);
}

void read_aim(const CsvTable& table, LuminairePlacement& placement) {
  const auto aim = table.three_numbers({"aim_x", "aim_y", "aim_z"});
  const auto direction = table.three_numbers({"dir_x", "dir_y", "dir_z"});
  if (aim && direction)
    table.refuse(
        "expected a point to aim at (aim_x, aim_y, aim_z) or a direction (dir_x, dir_y, dir_z), "
        "found both");
  if (!aim && !direction) return;
  const auto& v = aim ? *aim : *direction;
  placement.direction = Vec3d(v[0], v[1], v[2]);
  if (aim) *placement.direction -= placement.position;
  if (!(glm::length(*placement.direction) > 0.0))
    table.refuse(aim ? "expected a point to aim at away from the luminaire, found its own position"
                     : "expected a direction other than 0, 0, 0");
}

void read_array(const CsvTable& table, const Vec3& up, LuminairePlacement& placement) {
  placement.columns = count(table, "columns");
  placement.rows = count(table, "rows");
  if (placement.columns * placement.rows > max_luminaires)
    table.refuse(fmt::format("expected at most {} luminaires, found {} x {}", max_luminaires,
                             placement.columns, placement.rows));
  const auto step = [&](std::size_t along, std::string_view name) {
    if (along > 1 && !table.number(name))
      table.refuse(fmt::format("expected a distance in {} for an array of {} luminaires", name, along));
    return checked(table, name, 0.0, -1e6, 1e6);
  };
  placement.column_step = {step(placement.columns, "step_x"), 0.0, 0.0};
  const auto across = step(placement.rows, "step_y");
  placement.row_step = up.y > 0.5f ? Vec3d(0.0, 0.0, across) : Vec3d(0.0, across, 0.0);
}

Vec3d read_colour(const CsvTable& table) {
  const auto colour = table.three_numbers({"red", "green", "blue"});
  if (!colour) return Vec3d(1.0);
  const Vec3d rgb((*colour)[0], (*colour)[1], (*colour)[2]);
  if (!(rgb.r >= 0.0 && rgb.g >= 0.0 && rgb.b >= 0.0 && rgb.r + rgb.g + rgb.b > 0.0))
    table.refuse("expected red, green and blue of 0 or more, and not all 0");
  return rgb;
}

}  // namespace

std::shared_ptr<const Photometry> PhotometryStore::load(const std::filesystem::path& path,
                                                        const PhotometryOptions& options) {
  const auto known = std::find_if(read_.begin(), read_.end(), [&](const Entry& e) {
    return e.path == path && e.options.lamp_set == options.lamp_set && e.options.rotate == options.rotate;
  });
  if (known != read_.end()) return known->photometry;
  auto photometry = checked(load_photometry(path.string(), options));
  read_.push_back({path, options, photometry});
  return photometry;
}

std::shared_ptr<const Photometry> PhotometryStore::parse(const std::string& bytes, const std::string& name,
                                                         const PhotometryOptions& options) {
  return checked(read_photometry(bytes, name, options));
}

std::shared_ptr<const Photometry> PhotometryStore::checked(Photometry photometry) const {
  for (const auto& warning : photometry.warnings) context_.warn(warning);
  if (!(photometry.intensity.maximum() > 0.0))
    throw InputError(photometry.file, "expected a luminous intensity above 0 in some direction, found none");
  return std::make_shared<const Photometry>(std::move(photometry));
}

std::vector<LuminairePlacement> read_luminaires(const std::filesystem::path& path, const Vec3& up,
                                                PhotometryStore& store) {
  CsvTable table(path, columns);
  std::vector<LuminairePlacement> placements;
  while (table.next()) {
    const auto file = table.text("file");
    if (file.empty()) table.refuse("expected the name of an IES or EULUMDAT file in the column 'file'");
    LuminairePlacement placement;
    const PhotometryOptions options{
        .lamp_set = static_cast<std::size_t>(checked(table, "lamp_set", 1.0, 1.0, 1000.0)),
        .rotate = checked(table, "turn", 0.0, -360.0, 360.0)};
    try {
      placement.photometry = store.load(path.parent_path() / file, options);
    } catch (const InputError& error) {
      table.refuse(error.what());
    }
    placement.group = table.text("group");
    if (placement.group.empty()) placement.group = std::filesystem::path(file).stem().string();
    placement.position = {table.required_number("x"), table.required_number("y"), table.required_number("z")};
    read_aim(table, placement);
    placement.rotation = checked(table, "rotation", 0.0, -360.0, 360.0);
    placement.dimming = checked(table, "dimming", 1.0, 0.0, max_dimming);
    placement.maintenance = checked(table, "maintenance", 1.0, 1e-3, 1.0);
    placement.colour = read_colour(table);
    read_array(table, up, placement);
    placements.push_back(std::move(placement));
  }
  if (placements.empty()) throw InputError(path.string(), "expected at least one luminaire, found none");
  return placements;
}

}  // namespace luxel
