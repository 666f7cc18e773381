// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/lighting/areas.h"
#include "luxel/runs/option_set.h"

namespace luxel {

// The options of `probe` for calculation areas.
struct AreaSettings {
  std::string file;   // of areas; empty: none
  std::string scene;  // file, for names of objects and groups
  std::string drawing = "lines";

  bool is_given() const { return !file.empty(); }
  void declare(OptionSet& set);
  // Throws UsageError where options need --areas.
  void check() const;
  // up: axis of the scene. Throws InputError.
  std::vector<CalculationArea> areas(const RequirementTable& requirements, const Vec3d& up) const;
};

}  // namespace luxel
