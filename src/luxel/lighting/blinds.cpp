// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/blinds.h"

#include <algorithm>

namespace luxel {

Blinds::Blinds(const DaylightYear& year, const std::vector<bool>& is_occupied, const BlindsRule& rule,
               const YearSchedule& schedule)
    : year_(year) {
  const auto points = year.points();
  for (std::size_t g = 0; g < year.groups().size(); ++g) {
    auto& closed = closed_.emplace_back();
    const auto& sun = year.direct_sun_through(g);
    for (std::size_t h = 0; h < year.hours().size(); ++h) {
      if (!schedule.closed.empty()) {
        closed.push_back(schedule.closed[g][year.hours()[h].record]);
        continue;
      }
      std::size_t bright = 0;
      for (std::size_t m = 0; m < points; ++m)
        if (static_cast<double>(sun[h * points + m]) > rule.limit) ++bright;
      const bool closes =
          is_occupied[h] && static_cast<double>(bright) > rule.part * static_cast<double>(points);
      closed.push_back(closes ? 1.0f : 0.0f);
    }
  }
}

void Blinds::apply(std::vector<float>& light, std::uint32_t left_out) const {
  const auto points = year_.points();
  const auto open = light;
  for (std::size_t g = 0; g < closed_.size(); ++g) {
    const auto& closed = closed_[g];
    if (std::none_of(closed.begin(), closed.end(), [](float part) { return part > 0.0f; })) continue;
    const auto through = year_.through(g, open, left_out);
    const auto blocked = static_cast<float>(1.0 - year_.groups()[g].transmittance);
    for (std::size_t h = 0; h < closed.size(); ++h)
      for (std::size_t m = 0; closed[h] > 0.0f && m < points; ++m)
        light[h * points + m] -= blocked * closed[h] * through[h * points + m];
  }
  for (auto& lux : light) lux = std::max(0.0f, lux);
}

}  // namespace luxel
