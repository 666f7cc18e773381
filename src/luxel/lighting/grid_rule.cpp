// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/grid_rule.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace luxel {

GridRule en12464_grid(double first, double second) {
  assert(first > 0.0 && second > 0.0);
  constexpr double largest_spacing = 10.0;  // m
  const auto longer = std::max(first, second), shorter = std::min(first, second);
  const auto d = longer >= 2.0 * shorter ? shorter : longer;
  GridRule rule;
  rule.spacing = std::min(largest_spacing, 0.2 * std::pow(5.0, std::log10(d)));
  const auto cells = [&](double side) {
    return static_cast<std::size_t>(std::max(1.0, std::round(side / rule.spacing)));
  };
  rule.columns = cells(first);
  rule.rows = cells(second);
  return rule;
}

}  // namespace luxel
