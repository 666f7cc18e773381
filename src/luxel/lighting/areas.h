// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/lighting/requirements.h"

namespace luxel {

enum class AreaKind { task, surround, background, plane, wall, ceiling, escape_route, anti_panic };

// "task", "surround", "background", "plane", "wall", "ceiling", "escape_route", "anti_panic".
const char* name(AreaKind kind);

// Parts of the maintained light: lamp lumen maintenance, lamp survival, luminaire and room surface
// maintenance.
struct MaintenanceFactor {
  double factor = 1.0;  // their product
  std::optional<double> llmf, lsf, lmf, rmf;
};

// A calculation plane as described by the user. Lengths in m, in the coordinates of the scene's file. One of
// `polygon`, `surface` and `line` is given.
struct CalculationArea {
  std::string name;
  AreaKind kind = AreaKind::plane;
  std::vector<Vec3d> polygon;       // corners in one plane, at least three
  std::string surface;              // material, object or group of a flat surface; * and ? are wildcards
  double offset = 0.0;              // of a surface's points, along its normal
  std::vector<Vec3d> line;          // two ends
  std::optional<Vec3d> normal;      // unit: direction that the points face; else that of the plane, upwards
  std::optional<Vec3d> facing;      // place that all points face instead, such as an observer's
  double border = 0.0;              // strip along the edges without points
  std::optional<double> spacing;    // of the points; else the grid of EN 12464-1
  std::optional<double> Ez_height;  // on the up axis: where cylindrical illuminance is measured
  std::optional<Vec3d> semicylindrical;  // direction that a semi-cylinder faces
  bool has_cylinders = false;            // whether cylindrical illuminance is measured
  bool is_direct = false;                // without reflections
  bool has_surround = false;             // whether its surround and background are measured, too
  Requirement requirement;
  MaintenanceFactor maintenance;
  std::vector<std::vector<Vec3d>> without = {};  // polygons in the same plane whose inside has no points
  std::string around = {};                       // name of the task area that this band belongs to
};

// A file of areas: TOML, or glTF, whose nodes with the extra "calculation_area" are areas. Throws InputError.
TomlFile read_area_file(const std::string& file);

// The areas of a file: [[area]] tables, and maintenance for all of them. up: axis of the scene. Derives the
// surround and background areas of task areas. Throws InputError with file and line.
std::vector<CalculationArea> read_areas(const std::string& file, const RequirementTable& requirements,
                                        const Vec3d& up);
// The maintenance factor at the top of a file of areas; nothing where there is none.
std::optional<MaintenanceFactor> maintenance_of(const TomlFile& file);
std::vector<CalculationArea> areas_of(const TomlFile& file, const RequirementTable& requirements,
                                      const Vec3d& up);

}  // namespace luxel
