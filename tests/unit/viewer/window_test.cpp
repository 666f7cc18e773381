// SPDX-License-Identifier: Apache-2.0
// Parts that need no graphics card: scripts, settings by name, and control of the view by keys and mouse.
#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/viewer/camera_controller.h"
#include "luxel/viewer/light_mixer.h"
#include "luxel/viewer/look.h"
#include "luxel/viewer/overlays.h"
#include "luxel/viewer/script.h"

#include "support/lit_patches.h"

namespace luxel {
namespace {

std::string complaint(const std::string& script) {
  try {
    parse_script("script.txt", script);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Script, verbs_and_words_are_checked_with_their_line) {
  const auto script = parse_script("script.txt", "wait mesh  # first\n\nkey W\ndrop my room.obj\n");
  ASSERT_EQ(script.actions.size(), 3u);
  EXPECT_EQ(script.actions[1].line, 3u);
  EXPECT_EQ(script.actions[2].words, (std::vector<std::string>{"drop", "my", "room.obj"}));
  EXPECT_EQ(complaint("wait mesh\njump\n"), "script.txt:2: there is no verb 'jump'");
  EXPECT_EQ(complaint("move 3"), "script.txt:1: expected: move X Y");
}

TEST(Look, choices_are_made_by_name_and_wrong_ones_are_said) {
  Look look;
  look.set("show", "standard-error");
  look.set("tone", "reinhard-local");
  look.set("wires", "on");
  look.set("exposure", "-1.5");
  EXPECT_EQ(look.show, Show::standard_error);
  EXPECT_EQ(look.tone.op, ToneOperator::reinhard_local);
  EXPECT_TRUE(look.wires);
  EXPECT_EQ(look.tone.exposure, -1.5f);
  EXPECT_THROW(look.set("show", "nonsense"), InputError);
  EXPECT_THROW(look.set("wires", "maybe"), InputError);
  EXPECT_THROW(look.set("exposure", "1e9"), InputError);
  EXPECT_THROW(look.set("colour", "red"), InputError);
}

// A floor at z = 0 under an eye that looks down at it.
class Flight : public testing::Test {
 protected:
  Flight()
      : camera_([this](float x, float y) -> std::optional<Vec3> {
          const auto seen = sight(camera_.pose(), camera_.space(), camera_.aspect(), x, y);
          if (!(seen.direction.z < 0.0f)) return std::nullopt;
          return seen.origin - seen.origin.z / seen.direction.z * seen.direction;
        }) {
    camera_.set_screen({800, 600});
    camera_.set_space(Space(Vec3(0.0f, 0.0f, 1.0f)), {Vec3(-4, -4, 0), Vec3(4, 4, 3)});
    camera_.set_home({.eye = Vec3(0, -3, 2), .pitch = -0.5f}, false);
  }
  void key(Key which, bool down) { camera_.handle({.kind = Event::Kind::key, .key = which, .down = down}); }
  void move(float x, float y) { camera_.handle({.kind = Event::Kind::move, .at = Vec2(x, y)}); }
  void button(bool down) { camera_.handle({.kind = Event::Kind::button, .down = down}); }

  CameraController camera_;
};

TEST_F(Flight, keys_move_the_eye_and_shift_is_faster) {
  const auto begin = camera_.pose().eye;
  key('W', true);
  camera_.advance(0.5);
  const auto slow = glm::length(camera_.pose().eye - begin);
  EXPECT_NEAR(slow, 0.5f * camera_.speed(), 1e-4f);
  key(key::shift, true);
  camera_.advance(0.5);
  EXPECT_NEAR(glm::length(camera_.pose().eye - begin), 5.0f * slow, 1e-3f);
  key('W', false);
  const auto end = camera_.pose();
  camera_.advance(0.5);
  EXPECT_EQ(camera_.pose(), end);
}

TEST_F(Flight, a_drag_turns_about_what_is_under_the_cursor) {
  move(500, 350);
  const auto aim = camera_.aim();
  const auto seen = sight(camera_.pose(), camera_.space(), camera_.aspect(), aim.x, aim.y);
  const auto held = seen.origin - seen.origin.z / seen.direction.z * seen.direction;
  button(true);
  move(560, 330);
  button(false);
  EXPECT_FALSE(camera_.is_click());
  const auto after = sight(camera_.pose(), camera_.space(), camera_.aspect(), aim.x, aim.y);
  const auto way = glm::normalize(held - after.origin);
  EXPECT_LT(glm::length(way - after.direction), 1e-4f);
  EXPECT_GT(glm::length(after.origin - seen.origin), 0.1f);
}

TEST_F(Flight, the_mouse_looks_around_only_while_flying) {
  move(400, 300);
  move(500, 300);
  EXPECT_EQ(camera_.pose().turn, 0.0f);
  camera_.set_flying(true);
  move(400, 300);
  move(500, 300);
  EXPECT_GT(camera_.pose().turn, 0.1f);
}

TEST_F(Flight, the_wheel_goes_nearer_to_what_is_under_the_cursor) {
  const auto wheel = [&](float turns) {
    return camera_.handle({.kind = Event::Kind::wheel, .at = Vec2(0.0f, turns)});
  };
  move(500, 350);
  const auto aim = camera_.aim();
  const auto begin = camera_.pose();
  const auto seen = sight(begin, camera_.space(), camera_.aspect(), aim.x, aim.y);
  const auto point = seen.origin - seen.origin.z / seen.direction.z * seen.direction;
  EXPECT_TRUE(wheel(1.0f));
  EXPECT_NEAR(glm::length(camera_.pose().eye - point), 0.95f * glm::length(begin.eye - point), 1e-5f);
  EXPECT_LT(glm::length(glm::normalize(point - camera_.pose().eye) - seen.direction), 1e-5f);
  EXPECT_TRUE(wheel(-1.0f));
  EXPECT_LT(glm::length(camera_.pose().eye - begin.eye), 1e-5f);
  // Control leaves it to the exposure.
  key(key::control, true);
  EXPECT_FALSE(wheel(1.0f));
  key(key::control, false);
  // While flying it goes ahead, by 6 % of the scene's radius.
  camera_.set_flying(true);
  const auto here = camera_.pose();
  EXPECT_TRUE(wheel(2.0f));
  const auto way = camera_.pose().eye - here.eye;
  EXPECT_NEAR(glm::length(way), 2.0f * 0.06f * 0.5f * glm::length(Vec3(8, 8, 3)), 1e-4f);
  EXPECT_GT(glm::dot(glm::normalize(way), axes(here, camera_.space()).ahead), 0.9999f);
}

TEST_F(Flight, the_wheel_never_loses_the_scene) {
  move(400, 10);  // above the floor's end
  for (int i = 0; i < 1000; ++i) camera_.handle({.kind = Event::Kind::wheel, .at = Vec2(0.0f, -1.0f)});
  EXPECT_LT(glm::length(camera_.pose().eye), 21.0f * glm::length(Vec3(8, 8, 3)));
}

TEST_F(Flight, no_key_is_down_once_they_go_to_another_window) {
  key('W', true);
  camera_.release_keys();
  const auto begin = camera_.pose();
  camera_.advance(0.5);
  EXPECT_EQ(camera_.pose(), begin);
  EXPECT_FALSE(camera_.is_moving());
}

TEST_F(Flight, views_are_kept_and_home_is_found_again) {
  const auto begin = camera_.pose();
  key(key::control, true);
  key('1', true);
  key('1', false);
  key(key::control, false);
  ASSERT_TRUE(camera_.has_view(0));
  move(400, 500);
  key('F', true);
  camera_.advance(1.0);
  EXPECT_NE(camera_.pose(), begin);
  key('1', true);
  camera_.advance(1.0);
  EXPECT_LT(glm::length(camera_.pose().eye - begin.eye), 1e-5f);
  camera_.go_to({});
  key('H', true);
  camera_.advance(1.0);
  EXPECT_LT(glm::length(camera_.pose().eye - begin.eye), 1e-5f);
}

// A square floor of 4 m at z = 0 with a tracer, and an eye above it.
class DrawnLine : public testing::Test {
 protected:
  DrawnLine() {
    test::LitPatches lit;
    for (const auto& p : {Vec3(-2, -2, 0), Vec3(2, -2, 0), Vec3(2, 2, 0), Vec3(-2, 2, 0)}) lit.vertex(p);
    lit.patch({0, 1, 2}, 1.0f);
    lit.patch({0, 2, 3}, 1.0f);
    auto mesh = std::make_shared<SessionMesh>();
    mesh->patches = std::make_shared<const PatchSet>(lit.patches);
    mesh->tracer = std::make_shared<const Tracer>(lit.patches, Context(1));
    mesh->geometry = 1;
    mesh_ = mesh;
  }
  void frame() {
    light_probe_.update_profile(*mesh_, nullptr);
    overlays_.update({}, mesh_, nullptr, light_probe_, nullptr);
  }

  std::shared_ptr<const SessionMesh> mesh_;
  LightProbe light_probe_;
  Overlays overlays_;
};

TEST_F(DrawnLine, lies_on_the_scene_while_its_plot_is_there) {
  const Space space(Vec3(0, 0, 1));
  const Pose above{.eye = Vec3(0, 0, 3), .pitch = -steepest};
  frame();
  EXPECT_TRUE(overlays_.marks().empty());
  light_probe_.draw_line(above, space, 1.0f, Vec2(-0.5f, 0.0f), Vec2(0.5f, 0.0f));
  frame();
  EXPECT_GT(overlays_.marks().segments.size(), 100u);
  for (const auto& mark : overlays_.marks().segments) EXPECT_NEAR(mark.place.z, 0.0f, 1e-5f);
  const auto before = overlays_.marks().segments.front().place;
  // The line stays at its place while the probe and the view change.
  light_probe_.look_at(*mesh_, nullptr, {.eye = Vec3(1, 1, 1), .pitch = -steepest}, space, 1.0f, Vec2(0.1f));
  frame();
  ASSERT_FALSE(overlays_.marks().segments.empty());
  EXPECT_EQ(overlays_.marks().segments.front().place, before);
  light_probe_.clear_line();
  frame();
  EXPECT_TRUE(overlays_.marks().empty());
}

TEST(LightMixer, untouched_it_changes_nothing_and_a_slider_changes_its_own_group_alone) {
  test::LitPatches lit({test::plain_material("wall", 0.5f), test::plain_material("lamp", 0.0f, true, 9.0f)});
  lit.patches.light_groups = {"desk", "sky"};
  LightMixer board(lit.patches);
  EXPECT_TRUE(board.lighting(lit.patches).lamps.empty());
  board.lamps[0].factor = 0.5f;
  board.materials[0].colour = Vec3(0.2f, 0.3f, 0.4f);
  const auto lighting = board.lighting(lit.patches);
  EXPECT_EQ(lighting.lamps, (std::vector<float>{0.5f, 0.5f, 0.5f, 1.0f, 1.0f, 1.0f}));
  EXPECT_EQ(lighting.reflectance, (std::vector<float>{0.2f, 0.3f, 0.4f, 0.0f, 0.0f, 0.0f}));
}

}  // namespace
}  // namespace luxel
