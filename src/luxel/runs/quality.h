// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
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

// Options that end a run in the place of those of a quality.
inline constexpr std::array bounds_of_run = {"error", "rays", "time"};

// Returns whether a number of rays that a quality has, ray-budget or cheap-rays, applies to a run with these
// options: not where the user gave another bound, unless this number is given too.
bool has_bound_of_quality(const OptionSet& set, const std::string& option);
// Makes none the value and default of those that do not apply: before the options are recorded, so that a
// resumed run ends alike.
void drop_bounds_of_quality(OptionSet& set);

// The table as text, one line for each of its options that the set has.
std::string quality_table(const OptionSet& set);

}  // namespace luxel
