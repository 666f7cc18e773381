// SPDX-License-Identifier: Apache-2.0
#include "luxel/live/live_run.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "luxel/export/export_mesh.h"
#include "luxel/report/error.h"
#include "luxel/solution/solution_file.h"

namespace luxel {
namespace {

int threads_of(int asked) { return asked > 0 ? asked : std::max(1, Workers().threads() - 1); }

// Whether samples taken for one are good for the other: all but the bounds is the same.
bool same_samples(const SampledOptions& a, const SampledOptions& b) {
  return a.seed == b.seed && a.replicates == b.replicates && a.low_discrepancy == b.low_discrepancy &&
         a.stratified == b.stratified && a.importance == b.importance &&
         a.control_variate == b.control_variate && a.multiple_importance == b.multiple_importance &&
         a.share == b.share;
}

}  // namespace

LiveRun::LiveRun(Board& board, std::filesystem::path file, LiveSettings settings)
    : board_(board),
      file_(std::move(file)),
      settings_(std::move(settings)),
      workers_(threads_of(settings_.threads)),
      light_(settings_.light) {}

template <typename Work>
bool LiveRun::attempt(Work work) {
  const auto fail = [&](std::string sentence) {
    const std::lock_guard lock(board_.mutex);
    board_.status.error_message = std::move(sentence);
    ++board_.status.errors;
    return false;
  };
  try {
    work();
    return true;
  } catch (const std::bad_alloc&) {
    return fail(fmt::format("{}: there is not enough memory", file_.string()));
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}

void LiveRun::go() {
  const bool is_open = attempt([&] { open(); });
  if (is_open && settings_.begins_at_once && !own_light_) {
    const std::lock_guard lock(board_.mutex);
    if (!board_.solve && !board_.stops) board_.solve = SolveOrder{light_};
  }
  while (wait_for_orders()) {
    while (const auto order = next_solve()) attempt([&] { solve(*order); });
    std::optional<Lighting> lighting;
    {
      const std::lock_guard lock(board_.mutex);
      lighting = std::exchange(board_.lighting, {});
    }
    if (lighting) attempt([&] { relight(*lighting); });
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
    if (!order) order = SolveOrder{light_};
    order->light.sampled.error = *error;
    light_.sampled.error = *error;
    if (order->light.method != LightOptions::by_sampling) return {};
  }
  board_.stops = false;
  return order;
}

void LiveRun::write_files() {
  while (true) {
    std::optional<FileOrder> order;
    {
      const std::lock_guard lock(board_.mutex);
      if (board_.files.empty()) return;
      order = std::move(board_.files.front());
      board_.files.pop_front();
    }
    attempt([&] { write(*order); });
  }
}

void LiveRun::write(const FileOrder& order) {
  const auto light = [&] {
    const std::lock_guard lock(board_.mutex);
    return board_.light;
  }();
  const auto* glb = std::get_if<GlbOrder>(&order);
  const auto& file = glb != nullptr ? glb->file : std::get<std::filesystem::path>(order);
  if (!light) throw InputError(file.string(), "there is no light yet to write into it");
  begin_stage("write");
  if (glb != nullptr) {
    export_glb(file, *light->mesh.patches, light->solution, *light->smooth, glb->up, {.tone = glb->tone});
  } else if (light->is_relit) {
    auto patches = *light->mesh.patches;
    patches.light_groups.clear();  // what was kept for each apart is not in the new file
    for (auto& material : patches.materials) material.light_group = 0;
    write_solution(file, patches, light->solution);
  } else {
    if (light->is_last && !is_closing()) know_group_light();
    const auto* samples = light->is_last ? samples_.get() : light->samples.get();
    write_solution(file, *light->mesh.patches, light->solution,
                   settings_.keeps_transport ? samples : nullptr);
  }
  const std::lock_guard lock(board_.mutex);
  board_.status.messages.push_back({Severity::info, fmt::format("{} is written", file.string())});
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

void LiveRun::solve(const SolveOrder& order) {
  if (!mesh_.tracer) throw InputError(file_.string(), "it could not be opened, so there is nothing to light");
  refuse_too_much(order);
  auto face = std::move(light_.dense.face);
  light_ = order.light;
  light_.dense.face = std::move(face);
  const bool is_sampled = light_.method == LightOptions::by_sampling;
  SampleKeeping keeping;
  if (goes_on_with_samples(light_)) keeping.from = samples_;
  if (is_sampled) keeping.keep = [this](auto state) { samples_ = std::move(state); };
  sampled_ = light_.sampled;
  if (!keeping.from) samples_.reset();
  relighter_.reset();
  {
    const std::lock_guard lock(board_.mutex);
    auto& status = board_.status;
    board_.current = light_;
    status.method = light_.method;
    status.error_asked = is_sampled ? light_.sampled.error : 0.0;
    status.stop.reset();
    if (!keeping.from) {
      status.history.clear();
      status.error = 0.0;
      status.rays = 0;
      pace_ = Pace();
    }
    pace_.go_on();
  }
  step_ = 0;
  begin_bounces();

  Solution solution;
  solution.mesh_error = mesh_error_;
  if (settings_.sign) settings_.sign(solution.provenance, light_);
  const auto monitor = [this](const Progress& progress) { return watch(progress); };
  const auto report = [&] {
    try {
      return solve_light(*mesh_.patches, *mesh_.tracer, solution, light_, workers_, monitor, keeping);
    } catch (const InputError& error) {
      throw InputError(file_.string(), error.what());  // it has no light; the solver knows no file
    }
  }();
  pace_.hold();
  bool is_interrupted = false;
  {
    const std::lock_guard lock(board_.mutex);
    is_interrupted = board_.solve || board_.error;
    if (!is_interrupted) board_.status.stop = report.stop;
    board_.status.rays = std::max(board_.status.rays, report.rays);
    if (report.predicted_error > 0.0) board_.status.error = report.predicted_error;
  }
  if (is_interrupted) return;
  show(std::move(solution), true);
  if (lighting_ == Lighting{}) return;
  if (samples_) return relight(lighting_);
  lighting_ = {};
}

// Hears of the solve's progress, shows its pictures, holds it, and ends it.
Next LiveRun::watch(const Progress& progress) {
  {
    const std::lock_guard lock(board_.mutex);
    pace_.note(progress, board_.status);
    if (progress.light != nullptr) board_.status.steps = step_ + 1;
  }
  if (progress.light != nullptr) {
    note_unshot(*progress.light);
    if (lighting_ == Lighting{}) show(*progress.light, false);
    ++step_;
  }
  write_files();
  std::unique_lock lock(board_.mutex);
  if (progress.light != nullptr && board_.is_stepping) board_.status.is_paused = board_.is_paused = true;
  while (board_.is_paused && !must_end(progress)) {
    pace_.hold();
    board_.status.rays_per_second = 0.0;
    board_.changed.wait(lock);
    lock.unlock();
    write_files();
    lock.lock();
  }
  pace_.go_on();
  board_.status.stage = progress.stage;
  return must_end(progress) ? Next::stop : Next::go_on;
}

// Whether the solve is to be left. An order that goes on with its samples waits for the answer that is on its
// way, unless the one there is will do.
bool LiveRun::must_end(const Progress& progress) const {
  if (board_.closes || board_.stops) return true;
  if (board_.solve &&
      !(same_samples(board_.solve->light.sampled, sampled_) && board_.solve->light.method == light_.method))
    return true;
  if (!board_.solve && !board_.error) return false;
  if (light_.method != LightOptions::by_sampling) return board_.solve.has_value();
  const auto error = board_.error ? *board_.error : board_.solve->light.sampled.error;
  return progress.light != nullptr || (progress.error > 0.0 && progress.error <= error);
}

bool LiveRun::goes_by_bounces() const {
  if (light_.method == LightOptions::by_dense) return light_.dense.solver == DenseSolver::jacobi;
  return light_.method != LightOptions::by_sampling;
}

// Before the first bounce all that is there is what lamps emit.
void LiveRun::begin_bounces() {
  for (auto* values : {&radiosity_front_, &radiosity_back_, &unshot_front_, &unshot_back_}) values->clear();
  if (!goes_by_bounces()) return;
  const auto& patches = *mesh_.patches;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto& emittance = patches.material_of(p).emittance;
    radiosity_front_.insert(radiosity_front_.end(), emittance.begin(), emittance.end());
  }
  radiosity_back_.assign(radiosity_front_.size(), 0.0f);
}

// What a bounce brought is what the next one will send on.
void LiveRun::note_unshot(const Solution& light) {
  if (!goes_by_bounces()) return;
  const auto book = [](const std::vector<float>& now, std::vector<float>& before,
                       std::vector<float>& unshot) {
    unshot.resize(now.size());
    for (std::size_t i = 0; i < now.size(); ++i) unshot[i] = std::max(0.0f, now[i] - before[i]);
    before = now;
  };
  book(light.radiosity_front, radiosity_front_, unshot_front_);
  book(light.radiosity_back, radiosity_back_, unshot_back_);
}

LiveLight LiveRun::light_of(LiveMesh mesh, Solution solution) const {
  LiveLight light;
  light.mesh = std::move(mesh);
  light.solution = std::move(solution);
  light.samples = samples_;
  light.sampled = sampled_;
  light.step = step_;
  const auto& last = own_light_;
  const bool is_same = last && last->mesh.geometry == light.mesh.geometry &&
                       last->solution.irradiance_front == light.solution.irradiance_front &&
                       last->solution.irradiance_back == light.solution.irradiance_back;
  light.smooth = is_same || is_closing()
                     ? (last ? last->smooth : nullptr)
                     : std::make_shared<const SmoothLight>(make_smooth_light(
                           *light.mesh.patches, light.solution, settings_.smooth, workers_));
  return light;
}

// Pictures that come faster than they can be shown are left out, but for the last, and where each is waited
// for.
void LiveRun::show(Solution solution, bool is_last) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  {
    const std::lock_guard lock(board_.mutex);
    if (!is_last && !board_.is_stepping && begin - shown_ < 2 * cost_of_showing_) return;
  }
  auto light = light_of(mesh_, std::move(solution));
  light.is_last = is_last;
  light.unshot_front = unshot_front_;
  light.unshot_back = unshot_back_;
  own_light_ = publish(std::move(light));
  shown_ = Clock::now();
  cost_of_showing_ = shown_ - begin;
}

std::shared_ptr<const LiveLight> LiveRun::publish(LiveLight light) {
  light.number = ++lights_;
  auto newest = std::make_shared<const LiveLight>(std::move(light));
  const std::lock_guard lock(board_.mutex);
  board_.status.can_relight = newest->samples != nullptr;
  board_.light = newest;
  return newest;
}

bool LiveRun::is_closing() const {
  const std::lock_guard lock(board_.mutex);
  return board_.closes;
}

void LiveRun::know_group_light() {
  if (!samples_ || !samples_->gathered.empty() || !settings_.keeps_transport) return;
  begin_stage("light groups");
  samples_ = with_group_light(*mesh_.patches, *mesh_.tracer, samples_, sampled_, workers_);
}

void LiveRun::relight(const Lighting& lighting) {
  lighting_ = lighting;
  if (lighting == Lighting{}) {
    if (own_light_) publish(*own_light_);
    return;
  }
  if (!samples_ || !mesh_.tracer)
    throw InputError(file_.string(),
                     "its light keeps no samples to relight with: solve it by the method sampled");
  know_group_light();
  begin_stage("relight");
  if (!relighter_)
    relighter_ = std::make_unique<Relighter>(*mesh_.patches, *mesh_.tracer, samples_, sampled_, workers_);
  const auto& patches = *mesh_.patches;
  std::vector<float> own;
  for (const auto& material : patches.materials)
    own.insert(own.end(), material.reflectance.begin(), material.reflectance.end());
  relighter_->set_lamps(!lighting.lamps.empty()
                            ? lighting.lamps
                            : std::vector<float>(patches.group_count() * patches.band_count(), 1.0f));
  relighter_->set_reflectance(!lighting.reflectance.empty() ? lighting.reflectance : own);
  auto mesh = mesh_;
  mesh.patches = std::make_shared<const PatchSet>(relighter_->patches());
  auto light = light_of(std::move(mesh), relighter_->light());
  light.is_relit = light.is_last = true;
  publish(std::move(light));
}

// ---- Words ----

void LiveRun::begin_stage(const char* stage) {
  const std::lock_guard lock(board_.mutex);
  board_.status.stage = stage;
  board_.status.done = 0.0;
}

}  // namespace luxel
