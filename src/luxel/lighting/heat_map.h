// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "luxel/lighting/year.h"

namespace luxel {

// A year of illuminance, to be drawn.
struct HeatMap {
  std::string title;
  std::vector<std::string> figures;  // lines below the title
  std::vector<float> illuminance;    // lx, [hour of DaylightYear::hours()]
  double from = 8.0, to = 18.0;      // occupied hours, which are marked
};

// The illuminance of each hour: at a point, or where there is none the mean over all points. Cost: that of
// DaylightYear::illuminance().
std::vector<float> hourly_illuminance(const DaylightYear& year, std::optional<std::size_t> point);

// Days of the year to the right, hours of local standard time upwards, illuminance as colours on a
// logarithmic scale from 10 to 100,000 lx. Hours without light are black, those that the weather file lacks
// grey. A whole <svg> element; texts are escaped.
std::string heat_map_svg(const HeatMap& map, const DaylightYear& year, const Weather& weather);

}  // namespace luxel
