// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "luxel/cli/area_settings.h"
#include "luxel/cli/probe_points.h"
#include "luxel/cli/requirement_settings.h"
#include "luxel/patch/patch_set.h"
#include "luxel/render/probe_light.h"
#include "luxel/runs/option_set.h"

namespace luxel {

// The options of `probe`: which points, and how accurately.
struct ProbeSettings {
  std::string file;  // of points; empty: none
  std::optional<PointLine> line;
  std::optional<PointGrid> grid;
  std::optional<double> plane;  // m: height of a horizontal grid, on the up axis
  double spacing = 0.5;         // m, of that grid
  double border = 0.0;          // m, that it leaves free
  std::optional<Vec3d> normal;
  std::optional<Vec3d> facing;  // m: place that all points face
  std::string harmonics = "none";
  AreaSettings areas;
  RequirementSettings required;  // of a grid or a plane
  bool lists_requirements = false;
  ProbeOptions probe;

  void declare(OptionSet& set);
  // Throws UsageError unless exactly one kind of points, or areas are given.
  void check() const;
  // The points. up: axis of the scene. Throws InputError.
  PointList points(const PatchSet& patches, const Vec3d& up) const;
  // The cells of --grid or --plane; nothing for other points. Throws InputError.
  std::optional<PointGrid> cells(const PatchSet& patches, const Vec3d& up) const;
  // The options of the points alone, without areas.
  void declare_points(OptionSet& set);
};

}  // namespace luxel
