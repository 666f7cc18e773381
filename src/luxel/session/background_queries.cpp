// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/background_queries.h"

#include <utility>

#include "luxel/core/error.h"
#include "luxel/session/diagnose.h"

namespace luxel {

BackgroundQueries::BackgroundQueries(SessionChannels& channels, std::filesystem::path file, int threads)
    : channels_(channels), file_(std::move(file)), context_(threads) {}

// Queries that come before the file is open wait for it. A comparison runs first, as it is faster.
void BackgroundQueries::run() {
  while (true) {
    channels_.to_background.wait();
    if (is_closing()) return;
    take_commands();
    const auto solver = channels_.solver.get();
    answers_.is_busy = diagnostics_requested_ || next_second_ || second_;
    channels_.answers.publish(answers_);
    if (!solver->is_open) continue;
    if (next_second_) attempt([&] { read_second(); });
    const auto light = channels_.solver.get()->light;
    if (second_ && light && light->number != second_->compared) attempt([&] { compare(*light); });
    if (std::exchange(diagnostics_requested_, false)) attempt([&] { find_diagnostics(solver->mesh.get()); });
    answers_.is_busy = false;
    channels_.answers.publish(answers_);
  }
}

void BackgroundQueries::take_commands() {
  const auto commands = channels_.to_background.take();
  for (const auto& each : commands) {
    if (std::holds_alternative<FindDiagnostics>(each)) diagnostics_requested_ = true;
    if (const auto* with = std::get_if<CompareWith>(&each)) next_second_ = *with;
  }
  answers_.commands_done += commands.size();
}

void BackgroundQueries::read_second() {
  const auto with = *std::exchange(next_second_, {});
  second_.reset();
  answers_.difference.reset();
  if (with.solution) second_ = Second{*with.solution, read_solution(*with.solution)};
}

void BackgroundQueries::compare(const SessionLight& light) {
  const Baked shown{*light.mesh.patches, light.solution};
  LightDifference difference;
  try {
    difference.comparison = compare_solutions(second_->baked, shown);
    difference.relative = relative_differences(second_->baked, shown);
  } catch (...) {
    second_.reset();  // each further light would fail in the same way
    throw;
  }
  difference.file = second_->file;
  difference.light = second_->compared = light.number;
  answers_.difference = std::make_shared<const LightDifference>(std::move(difference));
}

void BackgroundQueries::find_diagnostics(const SessionMesh* mesh) {
  if (mesh == nullptr || !mesh->scene)
    throw InputError(file_.string(), "faults are looked for in a scene's file; this one has no scene");
  const auto closing = [this](const Progress&) { return is_closing() ? Next::stop : Next::go_on; };
  answers_.diagnostics =
      std::make_shared<const CheckReport>(diagnose(*mesh->scene, {}, context_.with_monitor(closing)));
}

}  // namespace luxel
