// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "luxel/cli/daylight_input.h"
#include "luxel/cli/workplace.h"
#include "luxel/export/lighting_report.h"
#include "luxel/runs/option_set.h"
#include "luxel/scene/scene.h"

namespace luxel {

// The sections on daylight of `report`: the results of `daylight` for the solved scene, on the reference
// plane of EN 17037 over the floor.
class ReportDaylight {
 public:
  void declare(OptionSet& options);
  // Throws UsageError where options need others.
  void check(bool has_scene) const;
  bool is_wanted() const { return !input_.weather.empty() || input_.median_diffuse > 0.0; }

  // Computes it and adds its page to the report, whose room is known. file: of the scene. Returns false where
  // the user stopped the work.
  bool add(const Scene& scene, const std::string& file, const Workplace& place, LightingReport& report);
  // Empty before add().
  const std::optional<DaylightReport>& result() const { return result_; }

 private:
  DaylightInput input_;
  std::optional<DaylightReport> result_;
};

}  // namespace luxel
