// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/areas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"

namespace luxel {
namespace {

constexpr double far = 1e9;               // m
constexpr double surround_width = 0.5;    // m, EN 12464-1
constexpr double background_width = 3.0;  // m, EN 12464-1
constexpr double anti_panic_rim = 0.5;    // m, EN 1838
constexpr double seated_eyes = 1.2;       // m, EN 12464-1: cylindrical illuminance of seated people

constexpr std::array<std::pair<AreaKind, const char*>, 8> kinds = {{{AreaKind::task, "task"},
                                                                    {AreaKind::surround, "surround"},
                                                                    {AreaKind::background, "background"},
                                                                    {AreaKind::plane, "plane"},
                                                                    {AreaKind::wall, "wall"},
                                                                    {AreaKind::ceiling, "ceiling"},
                                                                    {AreaKind::escape_route, "escape_route"},
                                                                    {AreaKind::anti_panic, "anti_panic"}}};

const std::vector<std::string>& area_keys() {
  static const auto keys = [] {
    std::vector<std::string> all = {"name",        "kind",        "corner",         "first",   "second",
                                    "polygon",     "height",      "surface",        "offset",  "line",
                                    "normal",      "facing",      "tilt",           "towards", "border",
                                    "spacing",     "Ez_height",   "cylindrical",    "direct",  "surround",
                                    "requirement", "maintenance", "semicylindrical"};
    all.insert(all.end(), requirement_keys().begin(), requirement_keys().end());
    return all;
  }();
  return keys;
}

MaintenanceFactor read_maintenance(const TomlKeys& keys) {
  MaintenanceFactor m;
  const auto* parts = keys.table("maintenance");
  if (parts == nullptr) {
    m.factor = keys.number("maintenance", 0.01, 1.0).value_or(1.0);
    return m;
  }
  const TomlKeys of_parts(keys.source(), *parts, keys.line("maintenance"), {"LLMF", "LSF", "LMF", "RMF"});
  for (const auto& [key, part] :
       {std::pair{"LLMF", &m.llmf}, {"LSF", &m.lsf}, {"LMF", &m.lmf}, {"RMF", &m.rmf}}) {
    *part = of_parts.number(key, 0.01, 1.0);
    if (!*part) keys.refuse("maintenance", "expected a number, or all of LLMF, LSF, LMF and RMF in braces");
    m.factor *= **part;
  }
  return m;
}

// Reads one [[area]].
class AreaReader {
 public:
  AreaReader(const TomlKeys& keys, const RequirementTable& requirements, const Vec3d& up)
      : keys_(keys), requirements_(requirements), up_(up) {}

  CalculationArea read() {
    area_.name = keys_.text("name").value_or("");
    if (area_.name.empty()) keys_.refuse({}, "expected a name, such as name = \"desk\"");
    read_kind();
    read_shape();
    read_normal();
    read_requirement_of_area();
    area_.border =
        keys_.number("border", 0.0, far).value_or(area_.kind == AreaKind::anti_panic ? anti_panic_rim : 0.0);
    area_.spacing = keys_.number("spacing", 1e-6, 1e6);
    area_.is_direct = keys_.flag("direct").value_or(is_emergency());
    area_.has_surround = keys_.flag("surround").value_or(false);
    if (area_.has_surround &&
        (area_.kind != AreaKind::task || area_.polygon.empty() || !area_.requirement.Em))
      keys_.refuse("surround",
                   "expected it at an area of kind \"task\" with a polygon or corners, and with Em");
    read_cylinders();
    return std::move(area_);
  }

 private:
  bool is_emergency() const {
    return area_.kind == AreaKind::escape_route || area_.kind == AreaKind::anti_panic;
  }

  void read_kind() {
    const auto word = keys_.text("kind").value_or("plane");
    const auto* found =
        std::find_if(kinds.begin(), kinds.end(), [&](const auto& kind) { return word == kind.second; });
    if (found == kinds.end())
      keys_.refuse("kind",
                   fmt::format("expected task, surround, background, plane, wall, ceiling, escape_route or "
                               "anti_panic, found \"{}\"",
                               word));
    area_.kind = found->first;
  }

  void read_shape() {
    const int shapes = (keys_.has("corner") ? 1 : 0) + (keys_.has("polygon") ? 1 : 0) +
                       (keys_.has("surface") ? 1 : 0) + (keys_.has("line") ? 1 : 0);
    if (shapes != 1)
      keys_.refuse({}, "expected one of corner (with first and second), polygon, surface and line");
    if (keys_.has("height") != (keys_.has("polygon") && is_flat_list()))
      keys_.refuse("height", "expected it together with a polygon of points with two numbers");
    if (keys_.has("corner")) return read_corners();
    if (keys_.has("polygon")) return read_polygon();
    if (keys_.has("line")) return read_line();
    area_.surface = keys_.text("surface").value_or("");
    area_.offset = keys_.number("offset", -far, far).value_or(0.0);
  }

  bool is_flat_list() const {
    const auto rows = keys_.rows("polygon");
    return rows && !rows->empty() && rows->front().size() == 2;
  }

  void read_corners() {
    const auto corner = keys_.point("corner"), first = keys_.point("first"), second = keys_.point("second");
    if (!first || !second) keys_.refuse("corner", "expected first and second, the neighbours of the corner");
    if (!(glm::length(glm::cross(*first - *corner, *second - *corner)) > 0.0))
      keys_.refuse("corner", "expected three corners that are not on a line");
    area_.polygon = {*corner, *first, *first + *second - *corner, *second};
  }

  // Two numbers are the horizontal coordinates in the order of the file: x, y, or x, z where y is up.
  Vec3d corner_of(const std::vector<double>& row, const char* key) const {
    if (row.size() == 3) return {row[0], row[1], row[2]};
    if (row.size() != 2 || !keys_.has("height"))
      keys_.refuse(key, "expected points with three numbers, or with two and a height");
    const auto height = keys_.number("height", -far, far).value_or(0.0);
    return std::abs(up_.y) > 0.5 ? Vec3d(row[0], height, row[1]) : Vec3d(row[0], row[1], height);
  }

  void read_polygon() {
    const auto rows = keys_.rows("polygon").value_or(std::vector<std::vector<double>>());
    // A corner given twice in succession counts once, and so does a last one that closes the ring.
    for (const auto& row : rows)
      if (const auto corner = corner_of(row, "polygon");
          area_.polygon.empty() || corner != area_.polygon.back())
        area_.polygon.push_back(corner);
    if (area_.polygon.size() > 1 && area_.polygon.front() == area_.polygon.back()) area_.polygon.pop_back();
    if (area_.polygon.size() < 3) keys_.refuse("polygon", "expected at least three corners");
    Vec3d normal(0.0);
    double extent = 0.0;
    for (std::size_t i = 0; i < area_.polygon.size(); ++i) {
      const auto a = area_.polygon[i] - area_.polygon[0];
      const auto b = area_.polygon[(i + 1) % area_.polygon.size()] - area_.polygon[0];
      normal += glm::cross(a, b);
      extent = std::max(extent, glm::length(a));
    }
    if (!(glm::length(normal) > 1e-12 * extent * extent))
      keys_.refuse("polygon", "expected corners that are not on a line");
    normal = glm::normalize(normal);
    constexpr double flatness = 1e-3;  // of the polygon's extent
    for (const auto& corner : area_.polygon)
      if (std::abs(glm::dot(corner - area_.polygon[0], normal)) > flatness * extent)
        keys_.refuse("polygon", "expected corners in one plane");
  }

  void read_line() {
    const auto rows = keys_.rows("line").value_or(std::vector<std::vector<double>>());
    if (rows.size() != 2 || rows[0].size() != 3 || rows[1].size() != 3)
      keys_.refuse("line", "expected two points such as [[0, 0, 0], [8, 0, 0]]");
    for (const auto& row : rows) area_.line.push_back({row[0], row[1], row[2]});
    if (!(glm::length(area_.line[1] - area_.line[0]) > 0.0))
      keys_.refuse("line", "expected two different points");
  }

  void read_normal() {
    if (const auto normal = keys_.point("normal")) {
      if (!(glm::length(*normal) > 0.0)) keys_.refuse("normal", "expected a direction, not [0, 0, 0]");
      area_.normal = glm::normalize(*normal);
    }
    area_.facing = keys_.point("facing");
    const auto tilt = keys_.number("tilt", 0.0, 180.0);
    if (area_.facing && (area_.normal || tilt))
      keys_.refuse("facing", "expected a place that all points face, or their direction, not both");
    if (!tilt) return;
    const auto towards = keys_.point("towards");
    if (area_.normal || !towards)
      keys_.refuse("tilt", "expected it with towards, the direction to which the points lean, and no normal");
    const auto level = *towards - glm::dot(*towards, up_) * up_;
    if (!(glm::length(level) > 0.0)) keys_.refuse("towards", "expected a direction that is not vertical");
    const auto angle = *tilt * std::numbers::pi / 180.0;
    area_.normal = std::cos(angle) * up_ + std::sin(angle) * glm::normalize(level);
  }

  void read_requirement_of_area() {
    auto name = keys_.text("requirement");
    if (!name && area_.kind == AreaKind::escape_route) name = "escape-route";
    if (!name && area_.kind == AreaKind::anti_panic) name = "anti-panic";
    if (name) {
      const auto* found = requirements_.find(*name);
      if (found == nullptr)
        keys_.refuse("requirement",
                     fmt::format("there is no requirement \"{}\"; expected one of {}, or a file "
                                 "that defines it",
                                 *name, requirements_.names()));
      area_.requirement = *found;
    }
    if (area_.requirement.source.empty()) area_.requirement.source = keys_.source();
    const bool is_wall = area_.kind == AreaKind::wall;
    if (is_wall || area_.kind == AreaKind::ceiling) {
      auto& r = area_.requirement;
      constexpr double U0_of_rooms_surfaces = 0.10;  // EN 12464-1:2021
      const auto Em = is_wall ? r.E_wall : r.E_ceiling;
      r = {.name = r.name, .source = r.source, .Em = Em};
      if (Em) r.U0 = U0_of_rooms_surfaces;
    }
    read_requirement(keys_, area_.requirement);
  }

  void read_cylinders() {
    area_.semicylindrical = keys_.point("semicylindrical");
    const auto& r = area_.requirement;
    area_.has_cylinders =
        keys_.flag("cylindrical").value_or(area_.semicylindrical || r.Ez || r.modelling_min);
    area_.Ez_height = keys_.number("Ez_height", -far, far);
    if (!area_.has_cylinders || area_.Ez_height) return;
    const auto height = area_.polygon.empty() ? -1.0 : glm::dot(area_.polygon[0], up_);
    if (!(height >= 0.0 && height <= seated_eyes))
      keys_.refuse({}, fmt::format("area \"{}\" measures cylindrical illuminance: expected Ez_height, the "
                                   "height of the eyes in m",
                                   area_.name));
    area_.Ez_height = seated_eyes;
  }

  const TomlKeys& keys_;
  const RequirementTable& requirements_;
  Vec3d up_;
  CalculationArea area_;
};

Vec3d normal_of(const std::vector<Vec3d>& polygon) {
  Vec3d normal(0.0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    normal += glm::cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return glm::normalize(normal);
}

// The polygon whose edges lie `width` outside; corners are mitred.
std::vector<Vec3d> grown(const std::vector<Vec3d>& polygon, double width) {
  const auto n = polygon.size();
  const auto normal = normal_of(polygon);
  const auto outwards = [&](std::size_t i) {
    return glm::normalize(glm::cross(polygon[(i + 1) % n] - polygon[i], normal));
  };
  std::vector<Vec3d> result;
  for (std::size_t i = 0; i < n; ++i) {
    const auto a = outwards((i + n - 1) % n), b = outwards(i);
    const auto middle = a + b;
    const auto squared = std::max(glm::dot(middle, middle), 0.5);  // of sharp corners the mitre is cut
    result.push_back(polygon[i] + 2.0 * width / squared * middle);
  }
  return result;
}

// A band around a task area, in its plane.
CalculationArea band_around(const CalculationArea& task, AreaKind kind, double from, double width) {
  auto band = task;
  band.kind = kind;
  band.name = fmt::format("{} {}", task.name, name(kind));
  band.around = task.name;
  band.has_surround = band.has_cylinders = false;
  band.semicylindrical.reset();
  band.border = 0.0;
  band.requirement =
      kind == AreaKind::surround ? surround_of(*task.requirement.Em) : background_of(*task.requirement.Em);
  band.without = {from > 0.0 ? grown(task.polygon, from) : task.polygon};
  band.polygon = grown(task.polygon, from + width);
  return band;
}

}  // namespace

const char* name(AreaKind kind) {
  for (const auto& [value, word] : kinds)
    if (value == kind) return word;
  return "";
}

std::optional<MaintenanceFactor> maintenance_of(const TomlFile& file) {
  if (file.tables.empty()) return std::nullopt;
  const TomlKeys keys(file.source, file.tables.front(), {"maintenance"});  // before the first header
  if (!keys.has("maintenance")) return std::nullopt;
  return read_maintenance(keys);
}

std::vector<CalculationArea> areas_of(const TomlFile& file, const RequirementTable& requirements,
                                      const Vec3d& up) {
  std::vector<CalculationArea> areas;
  const auto of_all = maintenance_of(file);
  for (const auto& table : file.tables) {
    if (table.name.empty() || table.name.starts_with("requirement.")) continue;
    if (table.name != "area" || !table.is_element)
      throw InputError(file.source, table.line,
                       fmt::format("expected [[area]] or [requirement.NAME], found [{}]", table.name));
    const TomlKeys keys(file.source, table, area_keys());
    auto area = AreaReader(keys, requirements, up).read();
    if (keys.has("maintenance"))
      area.maintenance = read_maintenance(keys);
    else if (of_all)
      area.maintenance = *of_all;
    for (const auto& other : areas)
      if (other.name == area.name) keys.refuse("name", "there is an area of this name already");
    areas.push_back(std::move(area));
    const auto task = areas.back();
    if (!task.has_surround) continue;
    areas.push_back(band_around(task, AreaKind::surround, 0.0, surround_width));
    areas.push_back(band_around(task, AreaKind::background, surround_width, background_width));
  }
  if (areas.empty()) throw InputError(file.source, "expected at least one [[area]], found none");
  return areas;
}

std::vector<CalculationArea> read_areas(const std::string& file, const RequirementTable& requirements,
                                        const Vec3d& up) {
  const auto toml = read_area_file(file);
  auto all = requirements;
  all.add(toml);
  return areas_of(toml, all, up);
}

}  // namespace luxel
