// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/cli/daylight_report.h"
#include "luxel/cli/probe_settings.h"
#include "luxel/cli/year_settings.h"
#include "luxel/core/log.h"
#include "luxel/export/daylight_page.h"
#include "luxel/runs/daylight_study.h"
#include "luxel/runs/option_set.h"

namespace luxel {

inline constexpr double en_17037_height = 0.85, en_17037_border = 0.5;  // m, of the reference plane

// Sky, weather and use of a room, from the command line.
struct DaylightInput {
  std::string weather;  // file; empty: none
  double north = 0.0, albedo = 0.2;
  double median_diffuse = 0.0;  // lx; 0: that of the weather
  int subdivision = 2;          // of the sky's patches
  YearSettings year;

  void declare_sky(OptionSet& options);
  // Reads the weather, whose oddities are reported. Light and points are left to the caller.
  DaylightQuestion question(const Vec3d& up, const LogSink& log) const;
  // scene: file.
  DaylightReport report_of(const DaylightAnswer& answer, const std::string& scene, PointList points) const;
  // Without title, origin, points' description and drawings.
  DaylightPage page_of(const DaylightReport& report, const DaylightAnswer& answer, RoomData room) const;
};

// "8 × 12 points at a height of 0.85 m, ...".
std::string points_text(const PointList& points, const ProbeSettings& places);

// Counted from the patches' origin.
std::vector<ProbePoint> probe_points(const PatchSet& patches, const PointList& list);

}  // namespace luxel
