// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "luxel/lighting/daylight_factor.h"
#include "luxel/lighting/metrics.h"
#include "luxel/lighting/window_groups.h"
#include "luxel/lighting/year.h"
#include "luxel/photometry/weather.h"
#include "luxel/runs/daylight_transport.h"
#include "luxel/runs/run_place.h"

namespace luxel {

struct DaylightQuestion {
  std::optional<Weather> weather = {};  // nothing: daylight factors alone
  Vec3d up{0.0, 0.0, 1.0};              // unit
  double north = 0.0;                   // degrees, as north_of() has it
  double albedo = 0.2;                  // of the ground outside
  int subdivision = 2;                  // of the sky's patches
  DaylightSolveOptions solve = {};
  CoefficientOptions coefficients = {};
  MetricOptions metrics = {};
  std::vector<WindowGroup> blinds = {};                // empty: all windows are one group
  double transmittance = WindowGroup{}.transmittance;  // of its closed blinds
};

// Result of a daylight study; its members refer to each other.
struct DaylightAnswer {
  DaylightQuestion question;
  SkyPatches sky;
  YearSkies skies;
  std::optional<DaylightTransport> transport;
  DaylightCoefficients coefficients;
  std::vector<DaylightFactors> factors;  // CIE types 16 and 1
  WindowLight windows;
  std::optional<DaylightYear> year;  // with weather, as the report
  std::optional<YearReport> report;

  DaylightAnswer() = default;
  DaylightAnswer(const DaylightAnswer&) = delete;
  DaylightAnswer& operator=(const DaylightAnswer&) = delete;
};

// Returns the points, counted from the patches' origin. Called before the solve; may throw to stop it.
using PointsOfPatches = std::function<std::vector<ProbePoint>(const PatchSet&)>;

// Computes daylight factors at points and, with weather, a year, from one solve. name: of the scene, for
// messages. Nothing where the run was interrupted. Throws InputError.
std::unique_ptr<DaylightAnswer> study_daylight(Scene scene, const std::string& name,
                                               DaylightQuestion question, const PointsOfPatches& points,
                                               const RunPlace& place);

// Computes the same from a stored run (daylight_run.h), whose windows are named by their material alone:
// reflected light uses the run's stored rays.
std::unique_ptr<DaylightAnswer> study_daylight(DaylightTransport transport, DaylightQuestion question,
                                               const PointsOfPatches& points, const RunPlace& place);

}  // namespace luxel
