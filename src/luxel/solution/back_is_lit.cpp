// SPDX-License-Identifier: Apache-2.0
#include "luxel/solution/back_is_lit.h"

#include <algorithm>

namespace luxel {

bool back_is_lit(const Solution& solution, std::size_t patch) {
  const auto bands = solution.bands.size();
  if ((patch + 1) * bands > solution.irradiance.back.size()) return false;
  const auto* back = solution.irradiance.back.data() + patch * bands;
  return std::any_of(back, back + bands, [](float h) { return h > 0.0f; });
}

}  // namespace luxel
