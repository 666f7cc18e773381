// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "luxel/render/compare.h"

namespace luxel {

// How the light that is shown differs from a second solution on the same patches.
struct LiveDifference {
  std::filesystem::path file;  // the second solution
  std::uint64_t light = 0;     // number of the light that was compared
  Comparison comparison;       // a: the second solution, b: the light shown
  // (b - a) / a of the mean over bands, side 2 * patch (front) and 2 * patch + 1; see relative_differences().
  std::vector<float> relative;
};

}  // namespace luxel
