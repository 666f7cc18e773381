// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "luxel/cli/probe_points.h"
#include "luxel/cli/ugr_settings.h"
#include "luxel/lighting/glare.h"
#include "luxel/lighting/glare_verdict.h"

namespace luxel {

// The verdict on the observers in an area; without a name, on all observers.
struct AreaVerdict {
  std::string area;
  Verdict verdict;
};

// The result of `ugr`.
struct UgrReport {
  std::string solution;  // file
  Vec3d origin{0.0};     // of the patches, m
  PointList observers = {};
  std::vector<ObservedGlare> glare = {};  // [observer]
  std::size_t lamps = 0;                  // that may dazzle
  SolutionErrors solution_errors = SolutionErrors::not_stated;
  std::vector<AreaVerdict> verdicts = {};
};

// A line of names, then one per observer.
std::string csv_of(const UgrReport& report);
std::string json_of(const UgrReport& report, const UgrSettings& settings,
                    const std::vector<std::string>& outputs);
// A line per observer for a person, of the first ten, and the highest UGR.
std::string summary_of(const UgrReport& report);
// Warnings: observers that miss the requested error, see no background, or large sources.
std::vector<std::string> warnings_of(const UgrReport& report);

}  // namespace luxel
