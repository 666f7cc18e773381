// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "luxel/core/error.h"
#include "luxel/session/live_run.h"

// How solutions become the pictures of a live scene: with smooth light, relit, bounce by bounce.

namespace luxel {

bool LiveRun::goes_by_bounces() const {
  if (light_.method == LightOptions::by_dense) return light_.dense.solver == DenseSolver::jacobi;
  return light_.method != LightOptions::by_sampling;
}

// Before the first bounce all that is there is what lamps emit.
void LiveRun::begin_bounces() {
  for (auto* values : {&radiosity_front_, &radiosity_back_, &unshot_front_, &unshot_back_}) values->clear();
  if (!goes_by_bounces()) return;
  const auto& patches = *lit_.patches;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    for (std::size_t b = 0; b < patches.band_count(); ++b)
      radiosity_front_.push_back(patches.emittance(p, b));
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
  auto light = light_of(lit_, std::move(solution));
  light.is_last = is_last;
  light.is_relit = lit_.patches != mesh_.patches;
  light.unshot_front = unshot_front_;
  light.unshot_back = unshot_back_;
  const auto shown = publish(std::move(light));
  own_light_ = shown->is_relit ? nullptr : shown;
  own_.reset();
  shown_ = Clock::now();
  cost_of_showing_ = shown_ - begin;
}

std::shared_ptr<const LiveLight> LiveRun::publish(LiveLight light) {
  light.number = ++lights_;
  auto newest = std::make_shared<const LiveLight>(std::move(light));
  {
    const std::lock_guard lock(board_.mutex);
    board_.status.can_relight = newest->samples != nullptr;
    board_.light = newest;
  }
  board_.changed.notify_all();  // it may be compared
  return newest;
}

bool LiveRun::is_closing() const {
  const std::lock_guard lock(board_.mutex);
  return board_.closes;
}

void LiveRun::know_group_light() {
  if (!samples_ || !samples_->gathered.empty() || !settings_.stores_transport) return;
  begin_stage("light groups");
  const auto monitor = [this](const Progress& progress) {
    const std::lock_guard lock(board_.mutex);
    board_.status.done = progress.done;
    return board_.closes || board_.solve || board_.error ? Next::stop : Next::go_on;
  };
  auto samples = with_group_light(*mesh_.patches, *mesh_.tracer, samples_, sampled_, workers_, monitor);
  if (samples) samples_ = std::move(samples);
}

// What it came from, and what was changed.
void LiveRun::sign_relit(Solution& relit, const Lighting& lighting) const {
  const auto& own = own_light_ ? own_light_->solution : *own_;
  auto provenance = own.provenance;
  provenance.rays = relit.provenance.rays;
  provenance.scene_fingerprint = relit.provenance.scene_fingerprint;
  note_lighting(provenance, lighting);
  relit.provenance = std::move(provenance);
  relit.mesh_error = own.mesh_error;
  relit.stop = own.stop;
}

// As `luxel relight` would be told.
void LiveRun::note_lighting(Provenance& provenance, const Lighting& lighting) const {
  const auto& patches = *mesh_.patches;
  const auto bands = patches.band_count();
  std::string flags;
  const auto note = [&](const char* option, const std::string& name, std::span<const float> values) {
    const bool is_grey = std::all_of(values.begin(), values.end(), [&](float v) { return v == values[0]; });
    const auto value = fmt::format("{}={}", name, fmt::join(is_grey ? values.first(1) : values, ","));
    provenance.options.emplace_back(option, value);
    flags += fmt::format(" --{} {}", option, value);
  };
  for (std::size_t g = 0; g < lighting.lamps.size() / bands; ++g) {
    const auto weight = std::span(lighting.lamps).subspan(g * bands, bands);
    if (std::any_of(weight.begin(), weight.end(), [](float w) { return w != 1.0f; }))
      note("tint", patches.light_groups.empty() ? "all" : patches.light_groups[g], weight);
  }
  for (std::size_t m = 0; m < lighting.reflectance.size() / bands; ++m) {
    const auto reflectance = std::span(lighting.reflectance).subspan(m * bands, bands);
    const auto& own = patches.materials[m].reflectance;
    if (!std::equal(own.begin(), own.end(), reflectance.begin()))
      note("reflectance", patches.materials[m].name, reflectance);
  }
  provenance.command_line += fmt::format("; luxel relight{}", flags);
}

void LiveRun::show_bounces(std::optional<int> count) {
  if (!count) return relight(lighting_);
  if (!samples_ || !mesh_.tracer)
    throw InputError(file_.string(), "its light keeps no samples to bounce: solve it by the method sampled");
  begin_stage("bounces");
  if (!bounces_)
    bounces_ = std::make_unique<Bounces>(*mesh_.patches, *mesh_.tracer, *samples_, sampled_, workers_);
  const auto before = *count > 0 ? bounces_->light(*count - 1) : Solution();
  auto light = light_of(mesh_, bounces_->light(std::max(0, *count)));
  light.bounces = std::max(0, *count);
  light.is_last = true;
  const auto less = [](std::vector<float> values, const std::vector<float>& others) {
    for (std::size_t i = 0; i < others.size(); ++i) values[i] = std::max(0.0f, values[i] - others[i]);
    return values;
  };
  light.unshot_front = less(light.solution.radiosity_front, before.radiosity_front);
  light.unshot_back = less(light.solution.radiosity_back, before.radiosity_back);
  publish(std::move(light));
}

// What is empty is as in the scene. Each costs something, so what stays is not set again.
void LiveRun::set_lighting(const Lighting& lighting) {
  const auto& patches = *mesh_.patches;
  auto lamps = lighting.lamps;
  if (lamps.empty()) lamps.assign(patches.group_count() * patches.band_count(), 1.0f);
  auto reflectance = lighting.reflectance;
  if (reflectance.empty())
    for (const auto& material : patches.materials)
      reflectance.insert(reflectance.end(), material.reflectance.begin(), material.reflectance.end());
  if (lamps != relit_.lamps) relighter_->set_lamps(lamps);
  if (reflectance != relit_.reflectance) relighter_->set_reflectance(reflectance);
  relit_ = {std::move(lamps), std::move(reflectance)};
}

void LiveRun::take_lighting() {
  std::optional<Lighting> lighting;
  {
    const std::lock_guard lock(board_.mutex);
    lighting = std::exchange(board_.lighting, {});
  }
  if (lighting) attempt([&] { relight(*lighting); });
}

// Where there are no samples to do it with, it is solved anew.
void LiveRun::relight(const Lighting& lighting) {
  const bool is_other = lighting_ != lighting;
  lighting_ = lighting;
  if (!samples_ || !mesh_.tracer) {
    if (!mesh_.tracer)
      throw InputError(file_.string(), "it could not be opened, so there is nothing to light");
    const std::lock_guard lock(board_.mutex);
    if (is_other && !board_.solve) board_.solve = SolveOrder{light_};
    return;
  }
  if (lighting == Lighting{}) {
    if (own_light_) {
      publish(*own_light_);
    } else if (own_) {
      shown_ = {};  // it is not left out, however soon
      show(*own_, !is_solving_);
    }
    return;
  }
  know_group_light();
  if (is_closing()) return;
  begin_stage("relight");
  if (!relighter_) {
    relit_ = {};
    relighter_ = std::make_unique<Relighter>(*mesh_.patches, *mesh_.tracer, samples_, sampled_, workers_);
  }
  set_lighting(lighting);
  auto mesh = mesh_;
  mesh.patches = std::make_shared<const PatchSet>(relighter_->patches());
  auto light = light_of(std::move(mesh), relighter_->light());
  sign_relit(light.solution, lighting);
  light.is_relit = true;
  light.is_last = !is_solving_;
  publish(std::move(light));
}

}  // namespace luxel
