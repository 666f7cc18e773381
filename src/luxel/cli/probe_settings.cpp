// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/probe_settings.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/bounds.h"
#include "luxel/runs/quantity.h"

namespace luxel {
namespace {

std::string text_of(const Vec3d& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

double parse_height(const std::string& text) {
  const auto height = parse_double(text);
  if (!height || !(std::abs(*height) <= 1e9))
    throw UsageError(fmt::format("--plane: expected a height in metres such as 0.85, not '{}'", text));
  return *height;
}

// A horizontal grid over the extents of the surfaces.
PointGrid grid_of_plane(const PatchSet& patches, const ProbeSettings& settings, const Vec3d& up) {
  Bounds box;
  for (const auto& v : patches.vertices) box.add(v);
  auto low = patches.in_file(box.low), high = patches.in_file(box.high);
  const int height_axis = std::abs(up.y) > 0.5 ? 1 : 2;
  const int along = height_axis == 1 ? 2 : 0, across = height_axis == 1 ? 0 : 1;  // along x across = up
  for (const auto axis : {along, across}) {
    low[axis] += settings.border;
    high[axis] -= settings.border;
    if (!(high[axis] > low[axis]))
      throw InputError(
          fmt::format("--border {}: it leaves nothing of the scene, whose surfaces extend over {:.4g} m; "
                      "expected less than half "
                      "of that",
                      settings.border, high[axis] - low[axis] + 2.0 * settings.border));
  }
  const auto cells = [&](int axis) {
    return static_cast<std::size_t>(std::max(1.0, std::round((high[axis] - low[axis]) / settings.spacing)));
  };
  PointGrid grid;
  grid.corner = low;
  grid.corner[height_axis] = *settings.plane;
  grid.first = grid.second = grid.corner;
  grid.first[along] = high[along];
  grid.second[across] = high[across];
  grid.columns = cells(along);
  grid.rows = cells(across);
  if (grid.columns > max_points / grid.rows)
    throw InputError(fmt::format("--spacing {}: it makes more than {} points; expected a larger one",
                                 settings.spacing, max_points));
  return grid;
}

}  // namespace

void ProbeSettings::declare_points(OptionSet& set) {
  set.heading("Points");
  set.add_text(
      "points", "FILE", file,
      "CSV file of points: x,y,z or x,y,z,nx,ny,nz on each line, m, in the coordinates of the scene; a first "
      "line with these names may select columns");
  set.add({"line", "POINT:POINT:N", "N points from one point to another, such as 0,0,0.85:4,0,0.85:21",
           [this](const std::string& text) {
             line = parse_line(text);
             if (!line && !text.empty())
               throw UsageError(fmt::format(
                   "--line: expected two points and a number from 2, such as 0,0,0.85:4,0,0.85:21, not '{}'",
                   text));
           },
           [this] {
             return line ? fmt::format("{}:{}:{}", text_of(line->from), text_of(line->to), line->count)
                         : std::string();
           }});
  set.add(
      {"grid", "CORNER:CORNER:CORNER:NxM",
       "N x M points on a parallelogram, in the middles of its cells: a corner, its neighbour along the N "
       "columns, and its neighbour along the M rows",
       [this](const std::string& text) {
         grid = parse_grid(text);
         if (!grid && !text.empty())
           throw UsageError(fmt::format(
               "--grid: expected three corners that are not on a line and a number of cells, such "
               "as 0,0,1:4,0,1:0,3,1:8x6, not '{}'",
               text));
       },
       [this] {
         return grid ? fmt::format("{}:{}:{}:{}x{}", text_of(grid->corner), text_of(grid->first),
                                   text_of(grid->second), grid->columns, grid->rows)
                     : std::string();
       }});
  set.add({"plane", "m", "a horizontal grid at this height on the up axis, over the extents of the scene",
           [this](const std::string& text) {
             plane.reset();
             if (!text.empty()) plane = parse_height(text);
           },
           [this] { return plane ? fmt::format("{}", *plane) : std::string(); }});
  set.add_number("spacing", "m", spacing, 1e-6, 1e6,
                 "--plane: distance of its points, rounded to fill the extents");
  set.add_number("border", "m", border, 0.0, 1e6, "--plane: width of the border without points");
  set.add_point(
      "normal", "x,y,z", normal,
      "direction that the points face, where no file gives one; auto: up, and for --grid the right-hand "
      "rule from its columns to its rows");
  set.add_point("facing", "x,y,z", facing,
                "place that all points face instead, such as an observer's or a camera's: illuminance in the "
                "line of sight");
}

void ProbeSettings::declare(OptionSet& set) {
  declare_points(set);
  areas.declare(set);
  set.heading("Requirements");
  required.declare(set, false);
  Declaration list{"list-requirements", "",
                   "print the table of requirements, with the source of each row, and end",
                   [this](const std::string& text) { lists_requirements = text == "true"; },
                   [this] { return lists_requirements ? "true" : "false"; }};
  list.is_flag = list.alone = true;
  list.configurable = list.recorded = false;
  set.add(std::move(list));
  set.heading("Light");
  set.add_fraction(
      "error", probe.error,
      "standard error of the sampling per point, relative to its illuminance, such as 2% or 0.02");
  set.add_number("floor", "lx", probe.floor, 0.0, 1e9,
                 "--error of darker points is relative to this illuminance; 0: always to their own");
  set.add({"rays", "count",
           "maximum number of cosine rays per point, such as 256k, and as many shadow rays; points that need "
           "more are "
           "reported",
           [this](const std::string& text) {
             const auto count = parse_count("rays", text);
             if (count < 1024 || count > (1u << 30))
               throw UsageError(
                   fmt::format("--rays: expected a count from 1024 to 1073741824, not '{}'", text));
             probe.max_rays = static_cast<std::uint32_t>(count);
           },
           [this] { return fmt::format("{}", probe.max_rays); }});
  set.add_flag("direct", probe.direct,
               "only light straight from lamps and the sky, without reflections, as for emergency lighting");
  set.add_choice("sh", {"none", "4", "9"}, harmonics,
                 "number of spherical harmonics of the radiance from all around, for game engines");
  set.add_count("seed", probe.seed, "seed of the random numbers; other seeds give independent errors");
}

void ProbeSettings::check() const {
  const auto kinds =
      (file.empty() ? 0 : 1) + (line ? 1 : 0) + (grid ? 1 : 0) + (plane ? 1 : 0) + (areas.is_given() ? 1 : 0);
  if (kinds == 0)
    throw UsageError(
        "no points: give one of --points FILE, --line, --grid or --plane HEIGHT, or --areas FILE");
  if (kinds > 1)
    throw UsageError("expected one of --points, --line, --grid, --plane and --areas, found several");
  areas.check();
  required.check(areas.is_given());
  if (required.is_given() && !grid && !plane)
    throw UsageError(
        "--requirement, --require-mean and --require-uniformity belong to --plane and --grid; areas have "
        "requirements in their file");
  if (areas.is_given() && (normal || facing || harmonics != "none"))
    throw UsageError(
        "--normal, --facing and --sh do not belong to --areas, whose file has directions of its own");
  if (normal && facing) throw UsageError("expected one of --normal and --facing, found both");
  if (!plane && (spacing != ProbeSettings().spacing || border != ProbeSettings().border))
    throw UsageError("--spacing and --border belong to --plane");
  if (normal && !(glm::length(*normal) > 0.0)) throw UsageError("--normal: expected a direction, not 0,0,0");
}

std::optional<PointGrid> ProbeSettings::cells(const PatchSet& patches, const Vec3d& up) const {
  if (!file.empty() || line) return std::nullopt;
  return grid ? *grid : grid_of_plane(patches, *this, up);
}

PointList ProbeSettings::points(const PatchSet& patches, const Vec3d& up) const {
  std::optional<Vec3d> given;
  if (normal) given = glm::normalize(*normal);
  auto points = !file.empty() ? read_points(file, given.value_or(up))
                : line        ? points_of(*line, given.value_or(up))
                : grid        ? points_of(*grid, given)
                              : points_of(*cells(patches, up), given.value_or(up));
  for (std::size_t i = 0; facing && i < points.position.size(); ++i) {
    if (points.position[i] == *facing)
      throw InputError("--facing: expected a place that is none of the points, which face it");
    points.normal[i] = glm::normalize(*facing - points.position[i]);
  }
  return points;
}

}  // namespace luxel
