// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/daylight_transport.h"

#include <utility>

#include <fmt/format.h>

#include "luxel/lamps/choose_portals.h"
#include "luxel/solve/bake.h"
#include "luxel/solve/refine_to_light.h"

namespace luxel {

std::optional<DaylightTransport> solve_daylight(const Scene& scene, const std::string& name,
                                                const DaylightSolveOptions& options,
                                                const std::function<void(const PatchSet&)>& on_patches,
                                                const RunPlace& place) {
  const auto& context = place.context;
  auto& reporter = place.reporter;
  DaylightTransport t;
  t.patches = place.record.stage("patches", [&](auto&) {
    auto how = options.patches;
    if (how.max_edge == automatic_edge) how.target_count = RefineOptions::coarse_patches;
    return make_patches_for_light(scene, how, reporter.detailing(context));
  });
  if (reporter.is_interrupted()) return std::nullopt;
  set_portals(scene, t.patches, context);
  reporter.say("scene", fmt::format("{}: {} patches, {} windows and other openings", name, t.patches.size(),
                                    t.patches.portals.size()));
  if (on_patches) on_patches(t.patches);
  t.options.error = options.error;
  t.options.seed = options.seed;
  t.tracer.emplace(t.patches, context);
  const SolveHooks hooks{
      .from = {},
      .keep = [&](std::shared_ptr<const SampleState> state) { t.samples = std::move(state); },
      .on_light = {}};
  place.record.stage("light", [&](auto& stage) {
    stage.rays =
        solve_sampled(t.patches, *t.tracer, t.solution, t.options, hooks, reporter.reporting(context)).rays;
  });
  if (reporter.is_interrupted() || !t.samples) return std::nullopt;
  t.error = t.solution.seen_error;
  reporter.say("light", fmt::format("error {:.2g} % of the mean sky's light", 100.0 * t.error));
  return t;
}

}  // namespace luxel
