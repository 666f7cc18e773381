// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "luxel/cli/daylight_report.h"
#include "luxel/cli/probe_settings.h"
#include "luxel/export/daylight_page.h"
#include "luxel/lighting/daylight_plans.h"
#include "luxel/lighting/metric_plan.h"
#include "luxel/runs/daylight_study.h"
#include "luxel/runs/option_set.h"
#include "luxel/runs/outputs.h"

namespace luxel {

// The input of drawings of daylight.
struct DrawnDaylight {
  const DaylightReport& report;
  const DaylightAnswer& answer;
  std::optional<MetricGround> ground;  // where the points are a grid
};

// The drawings of `daylight`: plans over the grid of points, of the hours of a day too, and the heat map of
// the year.
class DaylightDrawings {
 public:
  void declare(OptionSet& set);
  // Throws UsageError where a drawing needs a grid or the weather of a year.
  void check(const ProbeSettings& places, const std::vector<std::string>& outputs, bool has_weather) const;
  // Throws InputError where --heat-map-point is none of the points.
  void check_point(std::size_t points) const;
  // The files of the drawings, with their options.
  std::vector<NamedOutput> files() const;

  // The plan around the points; nothing where these are no grid.
  static std::optional<MetricGround> ground_of(const ProbeSettings& places, const DaylightAnswer& answer);
  // Writes a .svg file: the heat map or the plans.
  void write(const std::string& output, const DrawnDaylight& drawn) const;
  // Adds the drawings to a page.
  void add(const DrawnDaylight& drawn, DaylightPage& page) const;

 private:
  std::string heat_map(const DrawnDaylight& drawn) const;
  std::string day_plans(const DrawnDaylight& drawn) const;

  std::string heat_map_, day_plans_;
  CalendarDay day_;
  std::size_t point_ = 0;  // from 1; 0: the mean
};

}  // namespace luxel
