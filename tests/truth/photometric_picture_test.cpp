// SPDX-License-Identifier: Apache-2.0
// Pictures of illuminance and luminance against known light.
#include "luxel/render/photometric_picture.h"

#include <gtest/gtest.h>

#include "luxel/render/render.h"
#include "luxel/surface/smooth_light.h"

#include "support/probe_rig.h"

namespace luxel {
namespace {

// A room whose surfaces receive 60 W/m², reflect 0.6 of it, and one of which emits 100 W/m².
TEST(PhotometricPicture, has_the_values_of_the_surfaces) {
  truth::SceneBuilder b;
  test::add_room(b, {0, 0, 0}, {4, 3, 2.5f}, 0.6f);
  b.material("lamp", 0.0f, 100.0f).quad({1, 2, 2.4f}, {3, 2, 2.4f}, {3, 1, 2.4f}, {1, 1, 2.4f});
  const test::ProbeRig rig(b.scene(), 1.0f, 60.0f);
  const auto light = make_smooth_light(rig.patches, rig.light, {}, rig.context);
  const RenderOptions small{.width = 16, .height = 12, .samples_per_side = 1};
  Camera down;
  down.eye = {2, 1.5f, 1};
  down.target = {2, 1.5f, 0};
  down.up = {0, 1, 0};
  auto at_lamp = down;
  at_lamp.target = {2, 1.5f, 2.4f};
  at_lamp.vertical_fov = 20.0f;
  const auto picture = [&](const PatchSet& patches, const Camera& camera) {
    return render(patches, light, rig.tracer, camera, small, rig.context);
  };
  const auto white = white_patches(rig.patches);
  for (const auto lx : illuminance_values(picture(white, down))) EXPECT_NEAR(lx, test::lux(60.0), 1.0);
  for (const auto lx : illuminance_values(picture(white, at_lamp))) EXPECT_NEAR(lx, test::lux(60.0), 1.0);
  for (const auto L : luminance_values(picture(rig.patches, down)))
    EXPECT_NEAR(L, test::lux(36.0) / double{pi}, 0.5);
  for (const auto L : luminance_values(picture(rig.patches, at_lamp)))
    EXPECT_NEAR(L, test::lux(100.0) / double{pi}, 1.0);
}

}  // namespace
}  // namespace luxel
