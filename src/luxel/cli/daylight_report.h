// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "luxel/cli/probe_points.h"
#include "luxel/lighting/daylight_factor.h"
#include "luxel/lighting/metrics.h"
#include "luxel/photometry/weather_figures.h"

namespace luxel {

// The result of `daylight`.
struct DaylightReport {
  std::string scene;
  PointList points;
  std::vector<DaylightFactors> factors;    // types 16 and 1
  std::vector<FactorProvision> provision;  // of type 16; empty without a climate
  double median_diffuse = 0.0;             // lx; 0: not known
  bool knows_openings = false;
  std::string place;  // of the weather; empty without
  std::optional<YearReport> year;
  std::size_t sky_patches = 0;  // above the horizon
  double solve_error = 0.0;     // of the run behind it
};

std::string summary_of(const DaylightReport& report);
std::string csv_of(const DaylightReport& report);
// The same without the keys of a whole document.
nlohmann::ordered_json json_of(const DaylightReport& report);
std::string json_of(const DaylightReport& report, const std::vector<std::string>& outputs);

}  // namespace luxel
