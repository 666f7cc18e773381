// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/live_run.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/session/relit_patches.h"

namespace luxel {
namespace {

int threads_of(int asked) { return asked > 0 ? asked : std::max(1, Workers().threads() - 1); }

// Whether samples taken for one are good for the other: all but the bounds is the same.
bool same_samples(const SampledOptions& a, const SampledOptions& b) {
  return a.seed == b.seed && a.replicates == b.replicates && a.low_discrepancy == b.low_discrepancy &&
         a.stratified == b.stratified && a.importance == b.importance &&
         a.control_variate == b.control_variate && a.multiple_importance == b.multiple_importance &&
         a.both_ways == b.both_ways && a.smoothing == b.smoothing;
}

}  // namespace

LiveRun::LiveRun(Board& board, std::filesystem::path file, LiveSettings settings)
    : board_(board),
      file_(std::move(file)),
      settings_(std::move(settings)),
      workers_(threads_of(settings_.threads)),
      light_(settings_.light) {}

bool LiveRun::attempt(const std::function<void()>& work) { return board_.attempt(file_, work); }

void LiveRun::go() {
  const bool is_fine = attempt([&] { open(); });
  {
    const std::lock_guard lock(board_.mutex);
    board_.is_open = true;
    if (is_fine && settings_.begins_at_once && !own_light_ && !board_.solve && !board_.stops)
      board_.solve = SolveOrder{light_};
  }
  board_.changed.notify_all();
  while (wait_for_orders()) {
    while (const auto order = next_solve()) {
      attempt([&] { solve(*order); });
      is_solving_ = false;  // it may have thrown
    }
    std::optional<std::optional<int>> bounces;
    {
      const std::lock_guard lock(board_.mutex);
      bounces = std::exchange(board_.bounces, {});
    }
    take_lighting();
    if (bounces) attempt([&] { show_bounces(*bounces); });
    write_files();
  }
  write_files();
  if (board_.last_save) attempt([&] { write(*board_.last_save); });
}

// ---- Orders ----

bool LiveRun::wait_for_orders() {
  std::unique_lock lock(board_.mutex);
  auto& status = board_.status;
  if (!board_.has_orders()) {
    status.stage.clear();
    status.is_idle = true;
    status.done = 1.0;
    board_.changed.wait(lock, [&] { return board_.closes || board_.has_orders(); });
  }
  status.is_idle = false;
  return !board_.closes;
}

std::optional<SolveOrder> LiveRun::next_solve() {
  const std::lock_guard lock(board_.mutex);
  if (board_.closes) return {};
  auto order = std::exchange(board_.solve, {});
  if (const auto error = std::exchange(board_.error, {})) {
    if (!order && is_sampled()) order = SolveOrder{light_};
    if (order) order->light.sampled.error = *error;
    light_.sampled.error = board_.current.sampled.error = *error;
  }
  board_.stops = false;
  return order;
}

// ---- Light ----

bool LiveRun::goes_on_with_samples(const LightOptions& light) const {
  return samples_ && light.method == LightOptions::by_sampling && same_samples(light.sampled, sampled_);
}

void LiveRun::refuse_too_much(const SolveOrder& order) {
  if (order.force) return;
  begin_stage("forecast");
  const auto forecast = forecast_light(*mesh_.patches, *mesh_.tracer, order.light, workers_);
  if (forecast && is_too_much(*forecast))
    throw InputError(
        file_.string(),
        fmt::format(
            "the method {} would take about {:.0f} minutes and {:.1f} GiB of memory for {} patch sides: "
            "make fewer patches, or choose the method sampled",
            order.light.method, forecast->seconds / 60.0,
            static_cast<double>(forecast->bytes) / (1024.0 * 1024.0 * 1024.0), forecast->sides));
}

// What the sampled solver knows of each lamp apart makes other lamps and colours out of its samples; other
// methods solve for them.
void LiveRun::begin_solve(const SolveOrder& order, SampleStorage& storage) {
  auto face = std::move(light_.dense.face);
  light_ = order.light;
  light_.dense.face = std::move(face);
  lit_ = mesh_;
  if (!is_sampled() && lighting_ != Lighting{})
    lit_.patches = std::make_shared<const PatchSet>(relit_patches(*mesh_.patches, lighting_));
  if (goes_on_with_samples(light_)) storage.from = samples_;
  if (is_sampled())
    storage.keep = [this](auto state) {
      samples_ = std::move(state);
      relighter_.reset();
    };
  sampled_ = light_.sampled;
  if (!storage.from) samples_.reset();
  relighter_.reset();
  bounces_.reset();
  {
    const std::lock_guard lock(board_.mutex);
    auto& status = board_.status;
    board_.current = light_;
    status.method = light_.method;
    status.error_asked = is_sampled() ? light_.sampled.error : 0.0;
    status.is_seen = is_sampled() && light_.sampled.error_measure == ErrorMeasure::seen;
    status.stop.reset();
    if (!storage.from) {
      status.history.clear();
      status.error = 0.0;
      status.rays = 0;
      pace_ = Pace();
    }
    pace_.begin_solve();
  }
  step_ = 0;
  is_out_of_time_ = false;
  begin_bounces();
}

void LiveRun::solve(const SolveOrder& order) {
  if (!mesh_.tracer) throw InputError(file_.string(), "it could not be opened, so there is nothing to light");
  refuse_too_much(order);
  SampleStorage storage;
  begin_solve(order, storage);
  // The solver's own clock would count pauses: watch() has one that does not.
  auto asked = light_;
  if (asked.sampled.seconds > 0.0) asked.sampled.seconds = std::numeric_limits<double>::infinity();
  Solution solution;
  solution.mesh_error = mesh_error_;
  if (settings_.sign) settings_.sign(solution.provenance, light_);
  if (lit_.patches != mesh_.patches) note_lighting(solution.provenance, lighting_);
  is_solving_ = true;
  const auto monitor = [this](const Progress& progress) { return watch(progress); };
  const auto report = [&] {
    try {
      return solve_light(*lit_.patches, *mesh_.tracer, solution, asked, workers_, monitor, storage);
    } catch (const InputError& error) {
      throw InputError(file_.string(), error.what());  // it has no light; the solver knows no file
    }
  }();
  is_solving_ = false;
  pace_.hold();
  const auto stop = is_out_of_time_ ? StopReason::time_limit : report.stop;
  if (is_out_of_time_) solution.stop = stop;
  {
    const std::lock_guard lock(board_.mutex);
    board_.status.rays = std::max(board_.status.rays, report.rays);
    if (const auto error = error_of(report); error > 0.0) board_.status.error = error;
    if (board_.solve || board_.error || is_to_be_lit_anew()) return;  // it is not the last
    board_.status.stop = stop;
  }
  end_solve(std::move(solution));
}

void LiveRun::end_solve(Solution solution) {
  if (lighting_ == Lighting{} || !samples_) {
    show(std::move(solution), true);
    know_group_light();  // so that what is saved has it, and the first change of a lamp is as quick as others
    return;
  }
  own_ = std::move(solution);
  own_light_.reset();
  relight(lighting_);
}

// Hears of the solve's progress, shows its pictures, holds it, and ends it.
Next LiveRun::watch(Progress progress) {
  const double limit = is_sampled() ? light_.sampled.seconds : 0.0;
  const double spent = pace_.solve_seconds();
  if (limit > 0.0) progress.done = std::max(progress.done, std::min(1.0, spent / limit));
  {
    const std::lock_guard lock(board_.mutex);
    pace_.note(progress, board_.status);
    if (progress.light != nullptr) board_.status.steps = step_ + 1;
  }
  if (progress.light != nullptr) {
    note_unshot(*progress.light);
    if (lighting_ == Lighting{} || !is_sampled()) {
      show(*progress.light, false);
    } else if (samples_) {
      own_ = *progress.light;
      own_light_.reset();
      attempt([&] { relight(lighting_); });
    }
    ++step_;
  }
  pace_.hold();
  if (samples_) take_lighting();
  write_files();
  std::unique_lock lock(board_.mutex);
  board_.status.stage = progress.stage;
  if (progress.light != nullptr && board_.is_stepping) board_.status.is_paused = board_.is_paused = true;
  while (board_.is_paused && !must_end(progress)) {
    board_.status.rays_per_second = 0.0;
    board_.changed.wait(lock);
    lock.unlock();
    if (samples_) take_lighting();
    write_files();
    lock.lock();
    board_.status.stage = progress.stage;
  }
  pace_.go_on();
  // There is an answer at least.
  is_out_of_time_ = limit > 0.0 && spent >= limit && progress.error > 0.0;
  return is_out_of_time_ || must_end(progress) ? Next::stop : Next::go_on;
}

bool LiveRun::is_to_be_lit_anew() const {
  return !is_sampled() && board_.lighting && *board_.lighting != lighting_;
}

// Whether the solve is to be left. An order that goes on with its samples waits for the answer that is on its
// way, unless the one there is will do.
bool LiveRun::must_end(const Progress& progress) const {
  if (board_.closes || board_.stops) return true;
  if (board_.solve &&
      !(same_samples(board_.solve->light.sampled, sampled_) && board_.solve->light.method == light_.method))
    return true;
  if (is_to_be_lit_anew()) return true;
  if (!board_.solve && !board_.error) return false;
  if (!is_sampled()) return board_.solve.has_value();
  const auto error = board_.error ? *board_.error : board_.solve->light.sampled.error;
  return progress.light != nullptr || (progress.error > 0.0 && progress.error <= error);
}

// ---- Words ----

void LiveRun::begin_stage(const char* stage) {
  const std::lock_guard lock(board_.mutex);
  board_.status.stage = stage;
  board_.status.done = 0.0;
}

}  // namespace luxel
