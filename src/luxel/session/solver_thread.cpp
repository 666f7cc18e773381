// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/solver_thread.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/export/export_mesh.h"
#include "luxel/solution/sample_state.h"
#include "luxel/solution/solution_file.h"

namespace luxel {
namespace {

// A person's error is where the run ends, though the light be cheap.
void set_error(double error, LightOptions& light) {
  light.sampled.error = error;
  light.sampled.cheap_rays = 0;
}

}  // namespace

SolverThread::SolverThread(SessionChannels& channels, std::filesystem::path file, SessionSettings settings)
    : channels_(channels),
      file_(std::move(file)),
      settings_(std::move(settings)),
      context_(settings_.threads),
      state_(*channels.solver.get()),
      light_(settings_.light),
      relighting_(context_) {
  set_options(light_);
}

void SolverThread::run() {
  const bool is_fine = attempt([&] { open(); });
  state_.is_open = true;
  take_commands();
  if (is_fine && settings_.begins_at_once && !own_.shown && !pending_.solve && !pending_.stops)
    pending_.solve = command::Solve{light_};
  publish();
  channels_.to_background.push(SolverPublished{});
  while (wait_for_commands()) {
    while (const auto order = next_solve()) {
      attempt([&] { solve(*order); });
      solve_.is_running = false;  // also after an error
    }
    const auto bounces = std::exchange(pending_.bounces, {});
    take_lighting();
    if (bounces) attempt([&] { show_bounces(bounces->count); });
    write_files();
  }
  write_files();
  if (pending_.last_file) attempt([&] { write(command::SaveSolution{*pending_.last_file}); });
  publish();
}

// ---- Commands ----

void SolverThread::publish() { channels_.solver.publish(state_); }

void SolverThread::publish_stage(const char* stage) {
  state_.status.stage = stage;
  state_.status.done = 0.0;
  publish();
}

void SolverThread::set_options(const LightOptions& options) {
  state_.options = std::make_shared<const LightOptions>(options);
}

void SolverThread::take_commands() {
  auto commands = channels_.to_solver.take();
  if (commands.empty()) return;
  state_.commands_done += commands.size();
  pending_.add(std::move(commands));
  state_.status.is_paused = pending_.is_paused;
  state_.status.is_stepping = pending_.is_stepping;
  publish();
}

bool SolverThread::wait_for_commands() {
  take_commands();
  if (pending_.is_empty() && !pending_.begins_step) {
    auto& status = state_.status;
    status.stage.clear();
    status.done = 1.0;
    status.is_idle = true;
    publish();
    channels_.to_solver.wait();
    status.is_idle = false;
    take_commands();
  }
  if (std::exchange(pending_.begins_step, false) && pending_.is_empty())
    pending_.solve = command::Solve{light_};
  return !is_closing();
}

std::optional<command::Solve> SolverThread::next_solve() {
  if (is_closing()) return {};
  auto order = std::exchange(pending_.solve, {});
  if (const auto error = std::exchange(pending_.error, {})) {
    if (!order && is_sampled()) order = command::Solve{light_};
    if (order) set_error(*error, order->light);
    set_error(*error, light_);
    set_options(light_);
  }
  pending_.stops = false;
  return order;
}

// ---- Opening ----

void SolverThread::open() {
  const auto show = [this](const SessionMesh& mesh) {
    state_.mesh = std::make_shared<const SessionMesh>(mesh);
    publish();
    channels_.to_background.push(SolverPublished{});
  };
  const auto log = [this](const Message& message) {
    state_.status.messages.push_back(message);
    publish();
  };
  const auto monitor = [this](const Progress& progress) {
    state_.status.stage = progress.stage;
    state_.status.done = progress.done;
    publish();
    return is_closing() ? Next::stop : Next::go_on;
  };
  const SceneOpener opener(file_, settings_, context_.with_log(log).with_monitor(monitor), show);
  if (is_solution(file_)) return open_solution(opener);
  auto opened = opener.open_scene();
  mesh_ = std::move(opened.mesh);
  mesh_error_ = opened.mesh_error;
  light_.dense.face = std::move(opened.faces);
  if (mesh_.tracer) relighting_.set_mesh(mesh_);
}

// Shows its light before the tracer is built.
void SolverThread::open_solution(const SceneOpener& opener) {
  auto opened = opener.open_solution();
  auto& solution = opened.solution;
  mesh_ = std::move(opened.mesh);
  mesh_error_ = solution.mesh_error;
  if (settings_.options_of) light_ = settings_.options_of(solution.provenance);
  relighting_.begin(light_.sampled, false);
  relighting_.set_samples(std::move(opened.samples));
  auto& status = state_.status;
  set_options(light_);
  status.method = settings_.options_of ? std::string(name(light_.method)) : solution.provenance.method;
  if (status.method == name(Method::sampled)) status.error_asked = light_.sampled.error;
  status.is_seen = solution.seen_error > 0.0;
  status.error = solution.seen_error > 0.0 ? solution.seen_error : solution.predicted_error;
  status.rays = solution.provenance.rays;
  status.stop = solution.stop;
  state_.mesh = std::make_shared<const SessionMesh>(mesh_);
  solve_.mesh = mesh_;
  show(std::move(solution), true);
  opener.build_tracer(mesh_);
  relighting_.set_mesh(mesh_);
  auto light = *own_.shown;
  light.mesh = mesh_;
  own_.shown = publish_light(std::move(light));
}

// ---- Files ----

void SolverThread::write_files() {
  while (!pending_.files.empty()) {
    const auto order = std::move(pending_.files.front());
    pending_.files.pop_front();
    attempt([&] { write(order); });
  }
}

void SolverThread::write(const FileCommand& order) {
  const auto light = state_.light;
  const auto* glb = std::get_if<command::ExportGlb>(&order);
  const auto& file = glb != nullptr ? glb->file : std::get<command::SaveSolution>(order).file;
  if (!light) throw InputError(file.string(), "there is no light yet to write into it");
  publish_stage("write");
  auto done = fmt::format("{} is written", file.string());
  if (glb != nullptr) {
    if (!light->smooth)
      throw InputError(file.string(), "it was closed before there was light to write into it");
    export_glb(file, *light->mesh.patches, light->solution, *light->smooth, glb->up,
               {.tone = glb->tone, .compression = MeshCompression::quantised});
  } else if (light->is_relit) {
    auto patches = *light->mesh.patches;
    join_light_groups(patches);  // the file has no samples, so the light of single groups is not in it
    write_solution(file, patches, light->solution);
  } else if (light->bounces || !settings_.stores_transport) {
    write_solution(file, *light->mesh.patches, light->solution);
  } else {
    if (light->is_last && !is_closing()) find_group_light();
    const auto& samples = light->is_last ? relighting_.samples() : light->samples;
    write_solution(file, *light->mesh.patches, light->solution, samples.get());
    if (samples && samples->gathered.empty())
      done += ", without the light of each lamp apart, which is not known yet: its first relighting finds it";
  }
  state_.status.messages.push_back({.severity = Severity::note, .text = std::move(done)});
  publish();
}

}  // namespace luxel
