// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/picture_camera.h"

#include <algorithm>
#include <cmath>

#include "luxel/classical/stochastic_jacobi.h"
#include "luxel/core/error.h"
#include "luxel/patch/make_patches.h"
#include "luxel/render/automatic_camera.h"

namespace luxel {
namespace {

constexpr float usual_aspect = 4.0f / 3.0f;  // of the pictures that a view is found for
// Patches of the mesh that a view is found on; scenes of more triangles have one each.
constexpr std::size_t patches_of_view = 20'000;

// Light for finding a camera. It depends neither on the method of the picture's own light nor on its
// progress, so that pictures of one scene can be compared.
Solution light_at_a_glance(const PatchSet& patches, const Tracer& tracer, const Context& context) {
  if (patches.has_sky()) return {};
  Solution light;
  try {
    solve_stochastic_jacobi(patches, tracer, light, glance(patches), context);
  } catch (const InputError&) {
    return {};  // no light: all surfaces count alike
  }
  return light;
}

// A view for a picture of one shape, in one of another: a narrower picture shows as much from left to right.
Camera framed(Camera view, float meant, float aspect) {
  if (aspect >= meant) return view;
  const auto tangent = std::tan(0.5f * glm::radians(view.vertical_fov));
  view.vertical_fov = 2.0f * glm::degrees(std::atan(tangent * meant / aspect));
  return view;
}

}  // namespace

void restore_up(const Provenance& provenance, LookSettings& look) {
  if (look.up != "auto") return;
  for (const auto& [key, value] : provenance.options)
    if (key == "up" && (value == "y" || value == "z")) look.up = value;
}

Vec3 up_of(const LookSettings& look, const PatchSet& patches) {
  if (look.up == "y") return {0.0f, 1.0f, 0.0f};
  if (look.up == "z") return {0.0f, 0.0f, 1.0f};
  return automatic_up(patches);
}

Camera view_of(const Scene& scene, const LookSettings& look, const Context& context) {
  const auto patches =
      make_patches(scene, {.target_count = patches_of_view, .contacts = false}, context.quiet());
  const Tracer tracer(patches, context.quiet());
  return automatic_camera(patches, light_at_a_glance(patches, tracer, context.quiet()), tracer,
                          up_of(look, patches), usual_aspect, context.quiet());
}

Camera camera_of(const PictureSettings& picture, const LookSettings& look, const Baked& baked,
                 const Tracer& tracer, const Context& context) {
  const auto& patches = baked.patches;
  const auto up = up_of(look, patches);
  // A strip uses the camera of the widest or tallest picture that can be judged.
  const auto aspect =
      std::clamp(static_cast<float>(picture.render.width) / static_cast<float>(picture.render.height),
                 smallest_aspect, max_aspect);
  const bool is_open = !picture.eye && !picture.target;
  Camera camera;
  camera.up = up;
  if (!patches.cameras.empty() && is_open)
    camera = framed(patches.cameras.front(), patches.cameras.front().aspect, aspect);
  else if (patches.view && is_open && patches.view->up == up)
    camera = framed(*patches.view, usual_aspect, aspect);
  else if (!picture.is_given())
    camera =
        automatic_camera(patches, light_at_a_glance(patches, tracer, context), tracer, up, aspect, context);
  if (picture.eye) camera.eye = Vec3(*picture.eye - baked.patches.origin);
  if (picture.target) camera.target = Vec3(*picture.target - baked.patches.origin);
  if (picture.vertical_fov != PictureSettings::automatic_fov) camera.vertical_fov = picture.vertical_fov;
  camera.aspect = aspect;
  // A plan is drawn with what lies to the north (-z where y is up) at its top.
  const Vec3d view = glm::normalize(Vec3d(camera.target) - Vec3d(camera.eye));
  const Vec3d tilt = glm::cross(view, glm::normalize(Vec3d(camera.up)));
  if (glm::length(tilt) < 1e-5) camera.up = std::abs(camera.up.y) > 0.5f ? Vec3(0, 0, -1) : Vec3(0, 1, 0);
  return camera;
}

}  // namespace luxel
