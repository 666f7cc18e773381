// SPDX-License-Identifier: Apache-2.0
// Cameras as pure movements; then pictures that the graphics card draws off screen, compared with the same
// arithmetic on the processor.
#include <cmath>

#include <gtest/gtest.h>

#include "luxel/image/image.h"
#include "luxel/viewer/frame.h"
#include "luxel/viewer/lines.h"
#include "luxel/viewer/surfaces.h"

#include "support/lit_patches.h"
#include "support/off_screen.h"

namespace luxel {
namespace {

using test::LitPatches;
using test::plain_material;

const Space z_up(Vec3(0.0f, 0.0f, 1.0f));

Vec2 on_screen(const Pose& pose, const Space& space, const Vec3& point) {
  const auto a = axes(pose, space);
  const Vec3 way = point - pose.eye;
  return Vec2(glm::dot(way, a.right), glm::dot(way, a.up)) / glm::dot(way, a.ahead);
}

TEST(Pose, a_camera_looks_where_its_pose_does_and_the_other_way_round) {
  for (const auto& space : {Space(), z_up}) {
    const Camera camera{
        .eye = Vec3(1, 2, 3), .target = Vec3(4, -1, 2.5f), .up = space.up, .vertical_fov = 40};
    const auto pose = pose_of(camera, space);
    const auto again = camera_of(pose, space, glm::length(camera.target - camera.eye));
    EXPECT_LT(glm::length(again.target - camera.target), 1e-5f);
    EXPECT_EQ(again.vertical_fov, 40.0f);
  }
}

TEST(Pose, the_point_one_orbits_stays_where_it_is_on_the_screen) {
  const Pose pose{.eye = Vec3(0, -5, 1), .turn = 0.2f, .pitch = 0.1f};
  const Vec3 pivot(0.4f, 1.0f, 1.5f);
  const auto turned = orbit(pose, z_up, pivot, 0.8f, -0.4f);
  EXPECT_LT(glm::length(on_screen(turned, z_up, pivot) - on_screen(pose, z_up, pivot)), 1e-5f);
  EXPECT_NEAR(glm::length(turned.eye - pivot), glm::length(pose.eye - pivot), 1e-5f);
  const auto nearer = approach(pose, pivot, 0.5f);
  EXPECT_LT(glm::length(on_screen(nearer, z_up, pivot) - on_screen(pose, z_up, pivot)), 1e-5f);
}

TEST(Pose, one_flies_along_the_view_and_never_tips_over) {
  Pose pose{.eye = Vec3(0.0f)};
  pose = fly(pose, z_up, Vec3(0, 0, 1), 2.0f);
  EXPECT_LT(glm::length(pose.eye - 2.0f * z_up.ahead), 1e-6f);
  EXPECT_EQ(look(pose, 0.0f, 10.0f).pitch, steepest);
  EXPECT_EQ(fly(pose, z_up, Vec3(0.0f), 1.0f).eye, pose.eye);
}

TEST(Pose, focus_puts_a_point_into_the_middle_at_its_distance) {
  const Pose pose{.eye = Vec3(3, 3, 3)};
  const Vec3 point(0, 1, 0);
  const auto focused = focus(pose, z_up, point, 2.0f);
  EXPECT_LT(glm::length(on_screen(focused, z_up, point)), 1e-5f);
  EXPECT_NEAR(glm::length(focused.eye - point), 2.0f, 1e-5f);
}

TEST(Pose, a_pixels_sight_meets_what_the_projection_puts_there) {
  const Pose pose{.eye = Vec3(0, -5, 1), .turn = 0.2f, .pitch = 0.1f};
  const auto seen = sight(pose, z_up, 1.6f, 0.3f, -0.7f);
  const Bounds box{Vec3(-5.0f), Vec3(5.0f)};
  const auto clip = projection(pose, z_up, box, 1.6f) * Vec4(seen.origin + 4.0f * seen.direction, 1.0f);
  EXPECT_NEAR(clip.x / clip.w, 0.3f, 1e-4f);
  EXPECT_NEAR(clip.y / clip.w, -0.7f, 1e-4f);
}

// Grout lies two tenths of a millimetre below tiles that are five metres away.
TEST(Pose, where_nothing_is_near_the_depths_of_grout_and_tiles_differ) {
  const Pose pose{.eye = Vec3(0, -5, 0)};
  const Bounds box{Vec3(-9.0f), Vec3(9.0f)};
  const auto steps_between = [&](float empty) {
    const auto all = projection(pose, z_up, box, 1.6f, {}, empty);
    const auto depth = [&](float y) {
      const auto clip = all * Vec4(0.0f, y, 0.0f, 1.0f);
      return 0.5 * static_cast<double>(clip.z) / static_cast<double>(clip.w);
    };
    return (depth(2e-4f) - depth(0.0f)) * (1 << 24);
  };
  EXPECT_GT(steps_between(4.0f), 1.0);
  EXPECT_GT(steps_between(4.0f), 2.5 * steps_between(0.0f));
}

TEST(ColourMap, a_scale_holds_nearly_all_values_between_round_ends) {
  std::vector<float> values;
  for (int i = 1; i <= 1000; ++i) values.push_back(0.4f * static_cast<float>(i));
  values.push_back(1e9f);
  values.push_back(std::nanf(""));
  const auto scale = automatic_value_scale(values, false, ColourMap::heat);
  EXPECT_EQ(scale.low, 0.0f);
  EXPECT_EQ(scale.high, 500.0f);
  const auto both = automatic_value_scale({-0.03f, 0.01f}, false, ColourMap::difference);
  EXPECT_EQ(both.low, -both.high);
  const auto log = automatic_value_scale(values, true, ColourMap::heat);
  EXPECT_NEAR(log.value_at(log.fraction(7.0f)), 7.0f, 1e-4f);
  EXPECT_EQ(scale_text(0.25f), "0.25");
}

// ---- What the card draws ----

// Two upright sheets before the eye: the left one shows its front, the right one its back.
LitPatches two_sides() {
  LitPatches lit({plain_material("paper", 0.8f)});
  for (const float x : {-1.0f, -0.02f, 0.02f, 1.0f})
    for (const float z : {-1.0f, 1.0f}) lit.vertex(Vec3(x, 0.0f, z));
  lit.patch({0, 2, 3}, 5.0f, 1.0f);
  lit.patch({0, 3, 1}, 5.0f, 1.0f);
  lit.patch({4, 7, 6}, 3.0f, 20.0f);
  lit.patch({4, 5, 7}, 3.0f, 20.0f);
  return lit;
}

constexpr ScreenSize size{64, 32};

class Card : public test::OffScreen {
 protected:
  Card() : OffScreen(size) {}

  void set_up() override {
    patches_ = std::make_shared<PatchSet>(lit_.patches);
    light_ = std::make_shared<SmoothLight>(make_smooth_light(lit_.patches, lit_.solution));
    surfaces_ = std::make_unique<Surfaces>();
    surfaces_->set_mesh(patches_);
  }

  Image draw(SurfaceView view, EdgeSmoothing edges = EdgeSmoothing::sampled) {
    while (!surfaces_->upload(1.0)) {
    }
    const Pose pose{.eye = Vec3(0.0f, -1.0f, 0.0f)};
    view.projection = projection(pose, z_up, {Vec3(-1, 0, -1), Vec3(1, 0, 1)}, 2.0f);
    view.eye = pose.eye;
    DrawnFrame frame;
    frame.begin(size, Vec3(0.0f), edges);
    surfaces_->draw(view);
    frame.resolve();
    return frame.read();
  }
  static void expect_near(const Image& image, int x, const Vec3& linear) {
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(srgb_code(image.at(x, 16)[c]), srgb_code(linear[c]), 1.01)
          << "channel " << c << " at " << x;
  }

  LitPatches lit_ = two_sides();
  std::shared_ptr<const PatchSet> patches_;
  std::shared_ptr<const SmoothLight> light_;
  std::unique_ptr<Surfaces> surfaces_;
};

TEST_F(Card, a_mesh_without_light_is_grey) {
  const auto image = draw({.paint = Paint::light});
  EXPECT_FALSE(surfaces_->has_light());
  EXPECT_GT(image.at(20, 16).r, 0.3f);
  EXPECT_LE(image.at(20, 16).r, 0.61f);
  EXPECT_EQ(image.at(20, 16).r, image.at(20, 16).g);
}

TEST_F(Card, every_tone_curve_gives_the_codes_that_the_processor_gives) {
  surfaces_->set_light(patches_, light_, VertexValue::radiance);
  for (const auto op :
       {ToneOperator::neutral, ToneOperator::maximum, ToneOperator::clamp, ToneOperator::reinhard})
    for (const float white : {0.0f, 2.0f}) {
      const ToneCurve curve{{.op = op, .white = white}, 0.17f};
      const auto image = draw({.paint = Paint::light, .tone = curve});
      expect_near(image, 20, curve(Vec3(0.8f * 5.0f / pi)));
      expect_near(image, 44, curve(Vec3(0.8f * 20.0f / pi)));
    }
}

TEST_F(Card, rough_and_coarse_edges_change_no_colour) {
  surfaces_->set_light(patches_, light_, VertexValue::radiance);
  const ToneCurve curve{{.op = ToneOperator::clamp}, 0.1f};
  for (const auto edges :
       {EdgeSmoothing::rough, EdgeSmoothing::coarse, EdgeSmoothing::coarsest, EdgeSmoothing::rough})
    expect_near(draw({.paint = Paint::light, .tone = curve}, edges), 20, curve(Vec3(0.8f * 5.0f / pi)));
}

TEST_F(Card, false_colours_are_those_of_the_legend) {
  surfaces_->set_light(patches_, light_, VertexValue::watts);
  for (const bool logarithmic : {false, true}) {
    const ValueScale scale{.low = 1.0f, .high = 100.0f, .logarithmic = logarithmic};
    const auto image = draw({.paint = Paint::smooth, .scale = scale});
    expect_near(image, 20, map_colour(scale.map, scale.fraction(15.0f)));
    expect_near(image, 44, map_colour(scale.map, scale.fraction(60.0f)));
  }
}

TEST_F(Card, values_of_patches_stand_on_their_sides) {
  surfaces_->set_side_values(std::make_shared<std::vector<float>>(
      std::vector<float>{-0.5f, 0.0f, -0.5f, 0.0f, 0.0f, 0.25f, 0.0f, std::nanf("")}));
  const ValueScale scale{.low = -1.0f, .high = 1.0f, .map = ColourMap::difference};
  const auto image = draw({.paint = Paint::patches, .scale = scale});
  expect_near(image, 20, map_colour(scale.map, 0.25f));
  EXPECT_NEAR(image.at(60, 28).r, map_colour(scale.map, 0.625f).r, 0.02f);
  EXPECT_NEAR(image.at(36, 10).r, 0.2f, 0.01f);  // no number: grey
}

TEST_F(Card, sides_are_told_apart) {
  const auto image = draw({.paint = Paint::sides});
  EXPECT_GT(image.at(20, 16).b, 2.0f * image.at(20, 16).r);
  EXPECT_GT(image.at(44, 16).r, 2.0f * image.at(44, 16).b);
}

TEST_F(Card, rough_pictures_joined_have_smooth_edges) {
  DrawnFrame frame;
  MarkBuffer marks;
  Marks some;
  some.add_segment(Vec3(-1, 0, -0.3f), Vec3(1, 0, 0.31f), Vec3(1.0f));
  marks.set(some);
  const Pose pose{.eye = Vec3(0.0f, -1.0f, 0.0f)};
  for (int shift = 0; shift < shifts; ++shift) {
    frame.begin(size, Vec3(0.0f), EdgeSmoothing::rough);
    marks.draw(projection(pose, z_up, {Vec3(-1, 0, -1), Vec3(1, 0, 1)}, 2.0f, shifted_tile(shift, size)),
               1.0f, false);
    frame.resolve();
    frame.join(shift);
  }
  frame.show_joined();
  int between = 0;
  for (const auto& pixel : frame.read().pixels) between += pixel.r > 0.1f && pixel.r < 0.9f ? 1 : 0;
  EXPECT_GT(between, 20);
}

}  // namespace
}  // namespace luxel
