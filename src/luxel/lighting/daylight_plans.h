// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/lighting/daylight_factor.h"
#include "luxel/lighting/metric_plan.h"
#include "luxel/lighting/metrics.h"

namespace luxel {

// "85.2 % (84.9 to 85.6)" of a fraction; without the interval where it has no extent, with one more decimal
// place where its ends would read alike. The interval is cut to possible fractions.
std::string per_cent_text(const Figure& fraction, int decimals);

// The drawing of daylight factors in %, with lines at 0.5, 1, 2 and 5 %.
MetricPlan plan_of(const DaylightFactors& factors);

// The drawings of a year: daylight autonomy with the line of 50 %, useful daylight illuminance, and hours of
// direct sun with the line of 250 h.
std::vector<MetricPlan> plans_of(const YearMetrics& year);

// A day of a year.
struct CalendarDay {
  unsigned month = 3, day = 21;
};

// The illuminance in each hour with light of a day, blinds open; without lines, since sunlight ends in
// jumps. Empty where the year has no such hours. Cost: that of DaylightYear::illuminance().
std::vector<MetricPlan> plans_of_day(const DaylightYear& year, const Weather& weather,
                                     const CalendarDay& day);

}  // namespace luxel
