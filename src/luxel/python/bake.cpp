// SPDX-License-Identifier: Apache-2.0
// Solves: bake, resume, relight and merge, by the stages of the commands.
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "luxel/python/handles.h"
#include "luxel/runs/bake_stages.h"
#include "luxel/runs/lit_scene.h"
#include "luxel/runs/page_output.h"
#include "luxel/runs/relight_changes.h"
#include "luxel/runs/resumed_options.h"
#include "luxel/solution/merge_solutions.h"
#include "luxel/solve/seen_measure.h"
#include "luxel/version.h"

namespace py = pybind11;

namespace luxel {
namespace {

using Handle = std::shared_ptr<SolutionHandle>;

// Completes a run that has begun: solves the light and keeps the result. Null where it was stopped before.
Handle lit(const BakeSettings& settings, const std::string& name, BakeStart start, const Scene* scene,
           const RunPlace& place) {
  LightStage stage(settings, name, place);
  if (!stage.begin(start.baked, start.refined ? &*start.refined : nullptr, start.from, scene)) return nullptr;
  const auto solved = stage.solve(start.baked, start.faces);
  stage.report_losses(start.baked, solved);
  auto samples = stage.samples_to_store(start.baked);
  stage.checkpoint().finish(start.baked);
  if (stage.fell_short(solved))
    warn(place.reporter.log(),
         fmt::format("{}: ended before its error was reached ({})", name, description(solved.stop)));
  return std::make_shared<SolutionHandle>(
      SolutionHandle{name, std::move(start.baked), std::move(samples), stage.take_tracer()});
}

Handle bake_scene(const SceneHandle& input, const GivenOptions& given, const CallOptions& call) {
  BakeSettings settings;
  OptionSet set("bake", "");
  settings.declare(set);
  auto all = input.given;
  all.insert(all.end(), given.begin(), given.end());
  set.give(all);
  settings.scene.file = input.scene.source;
  settings.check();
  drop_bounds_of_quality(set);
  auto reporter = call.reporter();
  return reporter.run([&] {
    const Context context(call.threads);
    RunRecord record(0.0);
    auto scene = input.scene;
    light_up(settings.scene, scene, context, reporter, settings.light.method);
    const RunPlace place{context, reporter, record};
    const BakeStages stages(settings, set, place);
    auto start = stages.begin(scene, false);
    if (!start) return Handle();
    reporter.say("scene", describe_scene(settings.scene.file, scene, start->baked.patches));
    return lit(settings, settings.scene.file, std::move(*start), &scene, place);
  });
}

// changes_text: the changes as text, for the provenance.
Handle resume(const SolutionHandle& from, const GivenOptions& changes, const std::string& changes_text,
              const CallOptions& call) {
  if (!from.samples)
    throw InputError(from.name, "it stores no samples to continue from: bake with store_transport=True");
  BakeSettings settings;
  OptionSet set("bake", "");
  settings.declare(set);
  BakeStart start{from.baked, {}, from.samples, {}};
  restore_options(changes, changes_text, set, start.baked.solution.provenance);
  settings.keep.checkpoint.clear();
  settings.check();
  bool has_budget = false;
  for (const auto& [name, value] : changes) has_budget |= name == "ray-budget";
  if (!has_budget) settings.light.sampled.ray_budget = 0;  // it resumes to continue
  auto reporter = call.reporter();
  return reporter.run([&] {
    const Context context(call.threads);
    RunRecord record(0.0);
    return lit(settings, from.name, std::move(start), nullptr, {context, reporter, record});
  });
}

std::shared_ptr<RelighterHandle> make_relighter(Handle solution, const CallOptions& call) {
  if (!solution->samples)
    throw InputError(solution->name,
                     "it stores no transport to relight with: bake with store_transport=True");
  auto reporter = call.reporter();
  return reporter.run([&] {
    const Context context(call.threads);
    const auto& tracer = solution->traced(context);
    auto relighter =
        std::make_unique<Relighter>(solution->baked.patches, tracer, solution->samples,
                                    sampled_options_of(solution->baked.solution.provenance), context);
    return std::make_shared<RelighterHandle>(RelighterHandle{solution, std::move(relighter)});
  });
}

Handle relight(RelighterHandle& handle, const GivenOptions& given, const CallOptions& call) {
  RelightChanges changes;
  OptionSet set("relight", "");
  std::string file = handle.solution->name;
  set.set_positional("SOLUTION", file, "", ".vtkhdf");
  changes.declare(set);
  set.give(given);
  auto reporter = call.reporter();
  return reporter.run([&] {
    changes.apply(file, handle.solution->baked.patches, *handle.relighter, handle.is_changed);
    handle.is_changed = true;
    auto baked = relit(*handle.relighter, handle.solution->baked.solution, set);
    return std::make_shared<SolutionHandle>(
        SolutionHandle{file, std::move(baked), nullptr, handle.solution->tracer});
  });
}

Handle merge(const std::vector<Handle>& parts, const CallOptions& call) {
  auto reporter = call.reporter();
  return reporter.run([&] {
    const Context context(call.threads);
    std::vector<NamedSolution> solutions;
    for (const auto& part : parts) solutions.push_back({part->name, part->baked});
    auto merged = merge_solutions(std::move(solutions));
    merged.solution.provenance.program_version = LUXEL_VERSION;
    auto tracer = std::make_shared<Tracer>(merged.patches, context);
    merged.solution.seen_error = seen_error_of(merged.patches, *tracer, merged.solution, context);
    return std::make_shared<SolutionHandle>(
        SolutionHandle{parts.front()->name, std::move(merged), nullptr, std::move(tracer)});
  });
}

}  // namespace

void define_bake(py::module_& module) {
  module.def("bake", bake_scene);
  module.def("resume", resume);
  py::class_<RelighterHandle, std::shared_ptr<RelighterHandle>>(module, "Relighter").def("light", relight);
  module.def("relighter", make_relighter);
  module.def("merge", merge);
}

}  // namespace luxel
