// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "luxel/cli/probe_points.h"
#include "luxel/lighting/glare.h"
#include "luxel/runs/option_set.h"

namespace luxel {

// The options of `ugr`: which observers, and how accurately.
struct UgrSettings {
  PointList observers;  // of --observer: eyes and view directions
  std::string file;     // of observers; empty: none
  std::optional<PointGrid> grid;
  std::vector<Vec3d> views;               // unit, of the grid; empty: both ways along both of its sides
  std::string areas;                      // file whose requirements are judged; empty: none
  std::vector<std::string> requirements;  // files
  double require_ugr = 0.0;               // 0: nothing is required
  GlareOptions glare;

  void declare(OptionSet& set);
  // Throws UsageError unless there are observers.
  void check() const;
  // All observers: eyes as positions, view directions as normals. Throws InputError.
  PointList all() const;
};

}  // namespace luxel
