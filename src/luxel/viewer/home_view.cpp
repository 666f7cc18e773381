// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/home_view.h"

#include <algorithm>

#include "luxel/render/automatic_camera.h"

namespace luxel {
namespace {

constexpr float default_fov = 50.0f;  // degrees, if only the eye is given

Bounds box_of(const PatchSet& patches) {
  Bounds box;
  for (const auto& corners : patches.corners)
    for (const auto corner : corners) box.add(patches.vertices[corner]);
  return box;
}

}  // namespace

void HomeView::begin(const SessionMesh& mesh, const WindowSettings& settings, bool is_first,
                     CameraController& camera) {
  const auto& patches = *mesh.patches;
  camera.set_space(Space(settings.up.value_or(automatic_up(patches))), box_of(patches));
  has_space_ = true;
  if (settings.eye && settings.target && is_first) {
    const Camera chosen{.eye = Vec3(*settings.eye - patches.origin),
                        .target = Vec3(*settings.target - patches.origin),
                        .vertical_fov = settings.vertical_fov > 0.0f ? settings.vertical_fov : default_fov};
    camera.set_home(pose_of(chosen, camera.space()), false);
    is_known_ = true;
  } else if (mesh.scene && !mesh.scene->cameras.empty()) {
    camera.set_home(pose_of(mesh.scene->cameras.front(), camera.space()), false);
    is_known_ = true;
  }
}

void HomeView::update(const CurrentSession& session, const WindowSettings& settings,
                      CameraController& camera) {
  const auto& mesh = session.mesh();
  if (!has_space_) begin(*mesh, settings, session.number() == 1, camera);
  if (const auto found = search_.take(); found && found->scene == session.number() && !is_known_) {
    camera.set_home(found->pose, true);
    is_known_ = true;
  }
  // The view is rated by the first light; without any light, by the surfaces.
  const bool has_light_to_judge = session.light() || session.status().is_idle;
  if (is_known_ || search_.is_busy() || !mesh->tracer || !has_light_to_judge) return;
  search_.start([mesh, light = session.light(), space = camera.space(), aspect = camera.aspect(),
                 scene = session.number()] {
    const Solution nothing;
    const auto found =
        automatic_camera(*mesh->patches, light ? light->solution : nothing, *mesh->tracer, space.up,
                         std::clamp(aspect, smallest_aspect, max_aspect), Context(1));
    return Found{scene, pose_of(found, space)};
  });
}

}  // namespace luxel
