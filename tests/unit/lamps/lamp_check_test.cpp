// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/lamp_check.h"

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

// A closed cube with a small lamp under its ceiling.
Scene room_with_lamp(float height, bool faces_down) {
  auto room = truth::cube({});
  truth::SceneBuilder b;
  b.material("walls", 0.5f, 0.0f);
  for (const auto& t : room.triangles)
    b.triangle(room.positions[t[0]], room.positions[t[1]], room.positions[t[2]]);
  const float l = 0.4f, r = 0.6f;
  const Vec3 p[4] = {{l, l, height}, {l, r, height}, {r, r, height}, {r, l, height}};
  b.material("lamp", 0.0f, 1.0f);
  faces_down ? b.quad(p[0], p[1], p[2], p[3]) : b.quad(p[3], p[2], p[1], p[0]);
  return b.scene();
}

LampWarning fault_of(const Scene& scene) {
  const auto patches = make_patches(scene, {.max_edge = no_max_edge});
  const Context context(1);
  const Tracer tracer(patches, context);
  const auto views = view_from_lamps(patches, tracer, context);
  EXPECT_EQ(views.size(), 1u);
  return lamp_warning(patches, views.at(0));
}

TEST(LampCheck, a_lamp_that_faces_the_room_is_fine) {
  EXPECT_EQ(fault_of(room_with_lamp(0.995f, true)).text, "");
}

TEST(LampCheck, a_lamp_that_faces_the_ceiling_is_reported_with_the_setting_that_turns_it) {
  const auto fault = fault_of(room_with_lamp(0.998f, false));
  EXPECT_EQ(fault.hints, (std::vector<Hint>{{Setting::flip, "lamp"}})) << fault.text;
}

TEST(LampCheck, a_lamp_that_shines_out_of_the_scene_lights_nothing) {
  auto scene = truth::plates();  // turned round, the lower plate shines away from the upper
  std::swap(scene.triangles[0][0], scene.triangles[0][1]);
  std::swap(scene.triangles[1][0], scene.triangles[1][1]);
  const auto fault = fault_of(scene);
  EXPECT_NE(fault.text.find("lights nothing"), std::string::npos) << fault.text;
}

TEST(LampCheck, the_power_of_a_lamp_is_its_area_times_its_emittance) {
  const auto patches = make_patches(room_with_lamp(0.9f, true), {.max_edge = 0.05f});
  const Context context(1);
  const Tracer tracer(patches, context);
  const auto views = view_from_lamps(patches, tracer, context);
  ASSERT_EQ(views.size(), 1u);
  EXPECT_NEAR(views[0].power[1], 0.04, 1e-6);
  EXPECT_EQ(views[0].front.escaped, 0.0);
}

}  // namespace
}  // namespace luxel
