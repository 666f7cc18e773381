// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "luxel/lighting/grid_figures.h"

namespace luxel {

// A statistic of numbers that exist in independent replicates, [replicate][number]: its value for the means
// over all replicates, and an interval of 95 % by the jackknife (Tukey 1958): the statistic with each
// replicate left out once. statistic: of numbers, [number].
using Statistic = std::function<double(std::span<const float>)>;
Figure jackknifed(const std::vector<std::vector<float>>& replicates, const Statistic& statistic);

// The same from the values themselves: of all replicates, and with each left out.
Figure jackknifed(double of_all, std::span<const double> left_out);

// The means over all replicates but one; over all where `left_out` is none of them.
std::vector<float> mean_without(const std::vector<std::vector<float>>& replicates, std::size_t left_out);

}  // namespace luxel
