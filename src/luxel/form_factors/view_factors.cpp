// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/view_factors.h"

#include <utility>

namespace luxel {

ViewFactors ViewFactors::between(std::vector<std::string> names, std::vector<double> areas) {
  ViewFactors factors;
  factors.name = std::move(names);
  factors.area = std::move(areas);
  const auto n = factors.area.size();
  factors.rays.assign(n, 0.0);
  factors.row_begin.assign(n + 1, 0);
  factors.is_known.assign(n, 0);
  for (auto& column : factors.sink) {
    column.factor.assign(n, 0.0);
    column.standard_error.assign(n, 0.0f);
  }
  return factors;
}

}  // namespace luxel
