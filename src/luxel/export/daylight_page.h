// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "luxel/export/room_data.h"
#include "luxel/lighting/daylight_factor.h"
#include "luxel/lighting/metrics.h"

namespace luxel {

// Numbers and drawings of a report on daylight. Texts are UTF-8.
struct DaylightPage {
  std::string title, scene, version, command;
  std::string scene_date;          // day on which the file of the scene was written
  std::string place, weather;      // of the weather file, and the file; empty: none
  std::string points_description;  // "8 × 12 points at 0.85 m, ..."
  RoomData room;
  std::vector<DaylightFactors> factors;    // the first is that of the provision
  std::vector<FactorProvision> provision;  // empty without a climate
  double median_diffuse = 0.0;             // lx; 0: not known
  bool knows_openings = false;
  std::optional<YearReport> year;
  MetricOptions metrics;
  std::size_t sky_patches = 0;       // above the horizon
  double albedo = 0.2, north = 0.0;  // degrees
  double solve_error = 0.0;          // a fraction
  std::uint64_t seed = 1;
  std::vector<std::string> notes;  // sentences: how the scene was read
  std::vector<std::string> plans;  // <svg> elements
  bool are_plans_wide = false;     // one per row
  std::string heat_map;            // an <svg> element; empty: none
};

// The sections on daylight of another report: headings begin with "Daylight". HTML; without room, origin and
// title.
std::string daylight_sections(const DaylightPage& page);

// The report as one HTML page, as report_page() makes those of lighting designs.
std::string daylight_page(const DaylightPage& page);

}  // namespace luxel
