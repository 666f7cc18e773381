// SPDX-License-Identifier: Apache-2.0
// The solves of a session: their start, reports, pauses and end.
#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/session/relit_patches.h"
#include "luxel/session/solver_thread.h"

namespace luxel {

bool SolverThread::goes_by_bounces() const {
  if (light_.method == Method::dense) return light_.dense.solver == DenseSolver::jacobi;
  return light_.method != Method::sampled;
}

void SolverThread::refuse_long_solve(const command::Solve& order) {
  if (order.force) return;
  publish_stage("forecast");
  const auto forecast = forecast_light(*mesh_.patches, *mesh_.tracer, order.light, context_);
  if (forecast && is_too_much(*forecast))
    throw InputError(
        file_.string(),
        fmt::format(
            "the method {} would take about {:.0f} minutes and {:.1f} GiB of memory for {} patch sides: "
            "make fewer patches, or choose the method sampled",
            name(order.light.method), forecast->seconds / 60.0,
            static_cast<double>(forecast->bytes) / (1024.0 * 1024.0 * 1024.0), forecast->sides));
}

// Samples of the sampled method are relit with other lamps and colours; other methods solve again.
void SolverThread::begin_solve(const command::Solve& order, SolveHooks& hooks) {
  auto face = std::move(light_.dense.face);
  light_ = order.light;
  light_.dense.face = std::move(face);
  solve_.mesh = mesh_;
  if (!is_sampled() && lighting_ != Lighting{})
    solve_.mesh.patches = std::make_shared<const PatchSet>(relit_patches(*mesh_.patches, lighting_));
  const bool continues = relighting_.has_samples() && is_sampled() && relighting_.fits(light_.sampled);
  relighting_.begin(light_.sampled, continues);
  hooks.from = relighting_.samples();
  if (is_sampled()) hooks.keep = [this](auto state) { relighting_.set_samples(std::move(state)); };
  auto& status = state_.status;
  set_options(light_);
  status.method = name(light_.method);
  status.error_asked = is_sampled() ? light_.sampled.error : 0.0;
  status.is_seen = is_sampled() && light_.sampled.error_measure == ErrorMeasure::seen;
  status.stop.reset();
  if (!continues) {
    status.history.clear();
    status.error = 0.0;
    status.rays = 0;
    solve_.clock = SolveClock();
  }
  solve_.clock.begin_solve();
  solve_.step = 0;
  solve_.is_out_of_time = false;
  if (goes_by_bounces())
    solve_.unshot.begin(*solve_.mesh.patches);
  else
    solve_.unshot.clear();
  publish();
}

void SolverThread::solve(const command::Solve& order) {
  if (!mesh_.tracer) throw InputError(file_.string(), "it could not be opened, so there is nothing to light");
  refuse_long_solve(order);
  SolveHooks hooks;
  begin_solve(order, hooks);
  // The solver's own clock would count pauses; the one in on_progress() does not.
  auto options = light_;
  if (options.sampled.seconds > 0.0) options.sampled.seconds = std::numeric_limits<double>::infinity();
  Solution solution;
  solution.mesh_error = mesh_error_;
  if (settings_.sign) settings_.sign(solution.provenance, light_);
  if (solve_.mesh.patches != mesh_.patches) describe_lighting(*mesh_.patches, lighting_, solution.provenance);
  solve_.is_running = true;
  hooks.on_light = [this](const Solution& light, const Progress&) { solve_.new_light = &light; };
  const auto monitor = [this](const Progress& progress) { return on_progress(progress); };
  const auto report = [&] {
    try {
      return solve_light(*solve_.mesh.patches, *mesh_.tracer, solution, options, hooks,
                         context_.with_monitor(monitor));
    } catch (const InputError& error) {
      throw with_file(file_.string(), error);  // the scene has no light; the error lacks its file
    }
  }();
  solve_.is_running = false;
  solve_.clock.pause();
  const auto stop = solve_.is_out_of_time ? StopReason::time_limit : report.stop;
  if (solve_.is_out_of_time) solution.stop = stop;
  auto& status = state_.status;
  status.rays = std::max(status.rays, report.rays);
  if (const auto error = error_of(report); error > 0.0) status.error = error;
  take_commands();
  if (pending_.solve || pending_.error || needs_new_solve()) return;  // another one follows immediately
  status.stop = stop;
  end_solve(std::move(solution));
}

void SolverThread::end_solve(Solution solution) {
  if (lighting_ == Lighting{} || !relighting_.has_samples()) {
    show(std::move(solution), true);
    find_group_light();  // so that it is saved, and the first change of a lamp is as fast as later ones
    return;
  }
  own_ = {std::move(solution), nullptr};
  relight(lighting_);
}

// Shows the light of each result, pauses, and ends the solve.
Next SolverThread::on_progress(Progress progress) {
  const auto* light = std::exchange(solve_.new_light, nullptr);
  const bool has_light = light != nullptr;
  const double limit = is_sampled() ? light_.sampled.seconds : 0.0;
  const double spent = solve_.clock.solve_seconds();
  if (limit > 0.0) progress.done = std::max(progress.done, std::min(1.0, spent / limit));
  solve_.clock.note(progress, has_light, state_.status);
  take_commands();
  if (has_light) {
    state_.status.steps = solve_.step + 1;
    solve_.unshot.add_bounce(*light);
    if (lighting_ == Lighting{} || !is_sampled()) {
      show(*light, false);
    } else if (relighting_.has_samples()) {
      own_ = {*light, nullptr};
      attempt([&] { relight(lighting_); });
    }
    ++solve_.step;
  }
  solve_.clock.pause();
  if (relighting_.has_samples()) take_lighting();
  write_files();
  state_.status.stage = progress.stage;
  if (has_light && pending_.is_stepping) state_.status.is_paused = pending_.is_paused = true;
  publish();
  wait_while_paused(progress, has_light);
  pending_.begins_step = false;  // the step belonged to this solve
  solve_.clock.resume();
  // The time limit takes effect only once there is a result.
  solve_.is_out_of_time = limit > 0.0 && spent >= limit && progress.error > 0.0;
  return solve_.is_out_of_time || must_end(progress, has_light) ? Next::stop : Next::go_on;
}

void SolverThread::wait_while_paused(const Progress& progress, bool has_light) {
  while (pending_.is_paused && !must_end(progress, has_light)) {
    state_.status.rays_per_second = 0.0;
    publish();
    channels_.to_solver.wait();
    take_commands();
    if (relighting_.has_samples()) take_lighting();
    write_files();
    state_.status.stage = progress.stage;
  }
}

bool SolverThread::needs_new_solve() const {
  return !is_sampled() && pending_.lighting && *pending_.lighting != lighting_;
}

// Returns whether to end the solve. A command that continues from its samples waits for the next result,
// unless the present one is sufficient.
bool SolverThread::must_end(const Progress& progress, bool has_light) const {
  if (is_closing() || pending_.stops) return true;
  const auto& next = pending_.solve;
  if (next && !(next->light.method == light_.method && relighting_.fits(next->light.sampled))) return true;
  if (needs_new_solve()) return true;
  if (!next && !pending_.error) return false;
  if (!is_sampled()) return next.has_value();
  const auto error = pending_.error ? *pending_.error : next->light.sampled.error;
  return has_light || (progress.error > 0.0 && progress.error <= error);
}

}  // namespace luxel
