// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/import/load_scene.h"
#include "luxel/lamps/choose_portals.h"
#include "luxel/patch/focus.h"
#include "luxel/patch/uncut_faces.h"
#include "luxel/session/live_run.h"
#include "luxel/solution/solution_file.h"

// The beginning of a live scene: from the file to a mesh with its tracer.

namespace luxel {

void LiveRun::open() {
  if (is_solution(file_)) return open_solution();
  open_scene();
}

void LiveRun::open_scene() {
  auto scene = std::make_shared<const Scene>(load_scene(file_, settings_.load, log(), closing_monitor()));
  if (scene->triangles.empty()) return;  // closed meanwhile
  auto how = settings_.patches;
  const bool refines = settings_.refine.mesh_error > 0.0;
  if (refines) how.target_count = RefineOptions::coarse_patches;
  auto patches = make_patches(*scene, how, workers_, log(), closing_monitor());
  if (patches.size() == 0) return;
  mesh_.scene = scene;
  mesh_.geometry = 1;
  mesh_.patches = std::make_shared<const PatchSet>(patches);
  show_mesh();
  try {
    if (refines) {
      set_portals(*scene, patches, workers_);
      auto options = settings_.refine;
      options.light = light_.sampled;
      options.smooth = settings_.smooth;
      RefineReport report;
      patches = refine_to_light(std::move(patches), options, report, workers_, closing_monitor());
      mesh_error_ = report.mesh_error;
      mesh_.geometry = 2;
    }
    set_focus(*scene, settings_.focus, patches);
    group_lamps(*scene, patches);
  } catch (const InputError& error) {
    throw InputError(file_.string(), error.what());
  }
  mesh_.patches = std::make_shared<const PatchSet>(std::move(patches));
  if (settings_.joins_faces) light_.dense.face = uncut_faces(*scene, *mesh_.patches);
  if (!is_closing()) build_tracer();
}

// Where nobody said which lamps belong together, too many of them are no reason to show nothing.
void LiveRun::group_lamps(const Scene& scene, PatchSet& patches) {
  if (!settings_.stores_transport && settings_.groups.empty()) return;
  try {
    set_light_groups(scene, settings_.groups, patches);
  } catch (const InputError& error) {
    if (!settings_.groups.empty()) throw;
    join_light_groups(patches);
    warn(log(), fmt::format("all lamps are dimmed together: {}", error.what()));
  }
}

void LiveRun::open_solution() {
  begin_stage("read");
  auto kept = read_stored_run(file_);
  mesh_.patches = std::make_shared<const PatchSet>(std::move(kept.baked.patches));
  mesh_.geometry = 1;
  samples_ = std::move(kept.samples);
  auto& solution = kept.baked.solution;
  if (settings_.options_of) light_ = settings_.options_of(solution.provenance);
  sampled_ = light_.sampled;
  mesh_error_ = solution.mesh_error;
  {
    const std::lock_guard lock(board_.mutex);
    board_.current = light_;
    board_.status.method = settings_.options_of ? light_.method : solution.provenance.method;
    if (board_.status.method == LightOptions::by_sampling) board_.status.error_asked = light_.sampled.error;
    board_.status.is_seen = solution.seen_error > 0.0;
    board_.status.error = solution.seen_error > 0.0 ? solution.seen_error : solution.predicted_error;
    board_.status.rays = solution.provenance.rays;
    board_.status.stop = solution.stop;
  }
  show_mesh();
  lit_ = mesh_;
  show(std::move(solution), true);
  build_tracer();
  auto light = *own_light_;
  light.mesh = mesh_;
  own_light_ = publish(std::move(light));
}

void LiveRun::build_tracer() {
  begin_stage("hierarchy");
  mesh_.tree = std::make_shared<const PatchTree>(make_patch_tree(*mesh_.patches, workers_));
  mesh_.tracer = std::make_shared<const Tracer>(*mesh_.patches, workers_);
  if (mesh_.scene) {
    auto patches = *mesh_.patches;
    set_portals(*mesh_.scene, *mesh_.tracer, patches, workers_);
    if (patches.portals != mesh_.patches->portals)
      mesh_.patches = std::make_shared<const PatchSet>(std::move(patches));
  }
  show_mesh();
}

void LiveRun::show_mesh() {
  auto mesh = std::make_shared<const LiveMesh>(mesh_);
  const std::lock_guard lock(board_.mutex);
  board_.mesh = std::move(mesh);
}

LogSink LiveRun::log() {
  return [this](const Message& message) {
    const std::lock_guard lock(board_.mutex);
    board_.status.messages.push_back(message);
  };
}

Monitor LiveRun::closing_monitor() {
  return [this](const Progress& progress) {
    const std::lock_guard lock(board_.mutex);
    board_.status.stage = progress.stage;
    board_.status.done = progress.done;
    return board_.closes ? Next::stop : Next::go_on;
  };
}

}  // namespace luxel
