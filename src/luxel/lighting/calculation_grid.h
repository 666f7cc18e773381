// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "luxel/core/none.h"
#include "luxel/lighting/areas.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/scene.h"
#include "luxel/solution/solution.h"
#include "luxel/trace/tracer.h"

namespace luxel {

using Vec2d = glm::dvec2;

// The scene that areas lie in. Keeps references.
struct AreaScene {
  const PatchSet& patches;
  const Solution& solution;
  const Tracer& tracer;
  Vec3d up{0.0, 0.0, 1.0};       // unit
  const Scene* scene = nullptr;  // for names of objects and groups; null: only materials have names
};

// The points of an area: the middles of the cells of a rectangle around it, where these lie inside of it.
// Places in its plane are m along `along` and `across` from `corner`.
struct CalculationGrid {
  Vec3d corner{0.0};                                  // m, in the coordinates of the scene's file
  Vec3d along{1.0, 0.0, 0.0}, across{0.0, 1.0, 0.0};  // unit
  Vec3d normal{0.0, 0.0, 1.0};       // unit: direction that the points face, but for `facing`
  std::optional<Vec3d> facing;       // m: place that they all face
  double width = 0.0, height = 0.0;  // m; height 0: a line
  std::size_t columns = 1, rows = 1;
  double spacing = 0.0;                     // m, that was requested or is the rule's
  bool is_by_rule = false;                  // the grid of EN 12464-1
  std::vector<std::uint32_t> cell;          // [point]: row * columns + column
  std::vector<Vec3d> position;              // [point], m
  std::vector<std::vector<Vec2d>> outline;  // boundary loops of the area, m
  std::size_t points() const { return position.size(); }
  Vec2d middle(std::uint32_t cell_index) const {
    return {width * (static_cast<double>(cell_index % columns) + 0.5) / static_cast<double>(columns),
            height * (static_cast<double>(cell_index / columns) + 0.5) / static_cast<double>(rows)};
  }
  // Unit: direction that a point faces.
  Vec3d direction(std::size_t point) const {
    return facing ? glm::normalize(*facing - position[point]) : normal;
  }
  // [cell]: index of its point, or none.
  std::vector<std::uint32_t> point_of_cells() const;
};

// Makes the grid of an area. Bands around task areas have no points outside of the scene's extents, nor where
// a surface stands between them and the task area. Throws InputError where a surface does not exist or is not
// flat, where no point is left, and where a point is the place that it would face.
CalculationGrid make_grid(const CalculationArea& area, const AreaScene& scene);

// Intersection of the scene's surfaces with the plane `lift` m above that of the grid: connected lines, m in
// the plane, with corners only where they bend.
std::vector<std::vector<Vec2d>> plan_of(const PatchSet& patches, const CalculationGrid& grid, double lift);

}  // namespace luxel
