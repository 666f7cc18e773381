// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/runs/option_set.h"

namespace luxel {

// The option --quality: values of several options under one word. Its table (quality.cpp) is also where the
// defaults of these options are set, in the column `medium`.
struct QualitySettings {
  std::string level = "medium";
  // Call after the other options are declared: gives those of the table their defaults.
  void declare(OptionSet& set);
};

// Returns whether the bound of rays that a quality has applies to a run with these options: not where the
// user gave another bound, unless this one is given too.
bool has_ray_budget(const OptionSet& set);

// The table as text, one line for each of its options that the set has.
std::string quality_table(const OptionSet& set);

}  // namespace luxel
