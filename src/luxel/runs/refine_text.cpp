// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/refine_text.h"

#include <cstdint>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "luxel/runs/quantity.h"
#include "luxel/solution/stop_reason.h"

namespace luxel {

RefineStopText text_of(RefineStop stop) {
  switch (stop) {
    case RefineStop::mesh_error_reached:
      return {"mesh_error_reached", "mesh error reached"};
    case RefineStop::patch_limit:
      return {"patch_limit", "patch limit"};
    case RefineStop::level_limit:
      return {"level_limit", "level limit"};
    case RefineStop::cost_limit:
      return {"cost_limit", "cost limit"};
    case RefineStop::drowned_in_noise:
      return {"noise_limit", "noise limit"};
    case RefineStop::stopped_by_user:
      return {name(StopReason::stopped_by_user), description(StopReason::stopped_by_user)};
  }
  return {};
}

std::string mesh_error_text(const RefineReport& report, double mesh_error) {
  return mesh_error == 0.0 && !report.levels.empty() ? percent_of(0.0) : error_text(mesh_error);
}

std::string describe(const RefineReport& report, bool is_late) {
  std::uint64_t rays = 0;
  std::vector<std::size_t> patches;
  for (const auto& level : report.levels) {
    rays += level.rays;
    if (patches.empty() || patches.back() != level.patches) patches.push_back(level.patches);
  }
  const auto why = is_late ? description(StopReason::time_limit) : text_of(report.stop).description;
  return fmt::format("refined where the light needs it: {} patches; {} rays; {}: mesh error {}",
                     fmt::join(patches, " > "), rays, why, mesh_error_text(report, report.mesh_error));
}

}  // namespace luxel
