// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/scene_opener.h"

#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/import/load_scene.h"
#include "luxel/lamps/choose_portals.h"
#include "luxel/lamps/luminaire_check.h"
#include "luxel/patch/focus.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/patch/uncut_faces.h"
#include "luxel/render/default_light.h"
#include "luxel/session/default_sky.h"
#include "luxel/solution/solution_file.h"
#include "luxel/solve/bake.h"

namespace luxel {

SceneOpener::SceneOpener(std::filesystem::path file, const SessionSettings& settings, Context context,
                         Show show)
    : file_(std::move(file)), settings_(settings), context_(std::move(context)), show_(std::move(show)) {}

SceneOpener::OpenedScene SceneOpener::open_scene() const {
  OpenedScene opened;
  auto& mesh = opened.mesh;
  auto loaded = load_scene(file_, settings_.load, context_);
  if (loaded.triangles.empty()) return opened;  // it was stopped: a scene without triangles is an error
  for (const auto& group : move_luminaires_free(loaded, context_)) context_.note(moved_text(group));
  if (settings_.adds_default_light) {
    if (!has_light(loaded)) check_contacts(loaded, settings_.patches, context_);
    const auto added = add_default_light(loaded, context_, default_sky(settings_.light.method));
    if (added.kind != DefaultLightKind::not_needed) context_.note(added.as_text());
  }
  const auto scene = std::make_shared<const Scene>(std::move(loaded));
  auto how = settings_.patches;
  const bool refines = settings_.refine.mesh_error > 0.0;
  if (refines) how.target_count = RefineOptions::coarse_patches;
  auto patches = make_patches_for_light(*scene, how, context_);
  if (patches.size() == 0) return opened;  // stopped, as above
  mesh.scene = scene;
  mesh.geometry = 1;
  mesh.patches = std::make_shared<const PatchSet>(patches);
  show_(mesh);
  try {
    if (refines) {
      set_portals(*scene, patches, context_);
      auto options = settings_.refine;
      options.light = settings_.light.sampled;
      options.smooth = settings_.smooth;
      RefineReport report;
      patches = refine_to_light(std::move(patches), options, report, context_);
      opened.mesh_error = report.mesh_error;
      mesh.geometry = 2;
    }
    set_focus(*scene, settings_.focus, patches);
    group_lamps(*scene, patches);
  } catch (const InputError& error) {
    throw with_file(file_.string(), error);
  }
  mesh.patches = std::make_shared<const PatchSet>(std::move(patches));
  if (settings_.joins_faces) opened.faces = uncut_faces(*scene, *mesh.patches);
  if (begin_stage("hierarchy") == Next::go_on) build_tracer(mesh);
  return opened;
}

// Without requested groups, too many kinds of lamps must not prevent the scene from being shown.
void SceneOpener::group_lamps(const Scene& scene, PatchSet& patches) const {
  if (!settings_.stores_transport && settings_.groups.empty()) return;
  try {
    set_light_groups(scene, settings_.groups, patches);
  } catch (const InputError& error) {
    if (!settings_.groups.empty()) throw;
    join_light_groups(patches);
    context_.warn(fmt::format("all lamps are dimmed together: {}", error.what()));
  }
}

SceneOpener::OpenedSolution SceneOpener::open_solution() const {
  begin_stage("read");
  auto stored = read_stored_run(file_);
  OpenedSolution opened;
  opened.mesh.patches = std::make_shared<const PatchSet>(std::move(stored.baked.patches));
  opened.mesh.geometry = 1;
  opened.solution = std::move(stored.baked.solution);
  opened.samples = std::move(stored.samples);
  return opened;
}

void SceneOpener::build_tracer(SessionMesh& mesh) const {
  begin_stage("hierarchy");
  mesh.tree = std::make_shared<const PatchTree>(make_patch_tree(*mesh.patches, context_));
  mesh.tracer = std::make_shared<const Tracer>(*mesh.patches, context_);
  if (mesh.scene) {
    auto patches = *mesh.patches;
    set_portals(*mesh.scene, *mesh.tracer, patches, context_);
    if (patches.portals != mesh.patches->portals)
      mesh.patches = std::make_shared<const PatchSet>(std::move(patches));
  }
  show_(mesh);
}

}  // namespace luxel
