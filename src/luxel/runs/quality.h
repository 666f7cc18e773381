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

// Whether the bound of rays that a quality has applies to a run with these options: not where a person gave
// another bound, unless this one as well.
bool has_ray_budget(const OptionSet& set);

// The table as text, with the options that the set has; a line each.
std::string quality_table(const OptionSet& set);

}  // namespace luxel
