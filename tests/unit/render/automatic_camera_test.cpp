// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/automatic_camera.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/render/render.h"

#include "support/lit_rooms.h"

namespace luxel {
namespace {

using test::Facing;
using test::LitPatches;
using test::plain_material;

constexpr Vec3 y_up(0.0f, 1.0f, 0.0f);

Camera camera_for(const LitPatches& lit, int threads = 2, float aspect = 4.0f / 3.0f) {
  const Context context(threads);
  const Tracer tracer(lit.patches, context);
  return automatic_camera(lit.patches, lit.solution, tracer, y_up, aspect, context);
}

// Fraction of the pixels that are brighter than this, W/(sr m²).
double lit_fraction(const LitPatches& lit, const Camera& camera, float above = 0.0f) {
  const Context context(2);
  const Tracer tracer(lit.patches, context);
  const auto image = render(lit.patches, make_smooth_light(lit.patches, lit.solution), tracer, camera,
                            {.width = 80, .height = 60, .samples_per_side = 1}, context);
  double lit_pixels = 0.0;
  for (const auto& pixel : image.pixels) lit_pixels += pixel.g > above ? 1.0 : 0.0;
  return lit_pixels / static_cast<double>(image.pixels.size());
}

bool within(const Vec3& p, const Vec3& low, const Vec3& high) {
  return glm::all(glm::greaterThan(p, low)) && glm::all(glm::lessThan(p, high));
}

std::string as_text(const Vec3& v) {
  return "(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ")";
}

// Walls of different brightness, so that no two views are alike.
LitPatches room(const Vec3& size, bool open = false) {
  LitPatches lit;
  test::add_box(lit, Vec3(0.0f), size, Facing::inwards, 1.0f, open);
  auto& irradiance = lit.solution.irradiance.front;
  for (std::size_t i = 0; i < lit.patches.size(); ++i) {
    const auto p = lit.patches.points(i);
    const auto middle = (p[0] + p[1] + p[2]) / (3.0f * size);
    for (std::size_t band = 0; band < 3; ++band)
      irradiance[3 * i + band] = 1.0f + 0.6f * middle.x + 0.3f * middle.z;
  }
  return lit;
}

TEST(AutomaticCamera, in_a_closed_room_it_stands_inside_and_sees_lit_walls_only) {
  const auto lit = room({4.0f, 3.0f, 5.0f});
  const auto camera = camera_for(lit);
  EXPECT_TRUE(within(camera.eye, Vec3(0.0f), {4.0f, 3.0f, 5.0f})) << as_text(camera.eye);
  EXPECT_EQ(lit_fraction(lit, camera), 1.0);
}

TEST(AutomaticCamera, in_a_room_it_stands_at_eye_level_and_looks_across) {
  const Vec3 size(4.0f, 3.0f, 5.0f);
  const auto camera = camera_for(room(size));
  EXPECT_GT(camera.eye.y, 0.3f * size.y);
  EXPECT_LT(camera.eye.y, 0.8f * size.y);
  const auto view = glm::normalize(camera.target - camera.eye);
  EXPECT_LT(std::abs(view.y), 0.5f);
  EXPECT_EQ(camera.up, y_up);
  const auto middle = glm::normalize(0.5f * size - camera.eye);
  EXPECT_GT(glm::dot(view, middle), 0.5f) << "it does not look into the room";
}

TEST(AutomaticCamera, an_open_box_is_seen_through_its_opening) {
  const Vec3 size(4.0f, 3.0f, 4.0f);
  const auto lit = room(size, true);
  for (const auto aspect : {1.0f, 4.0f / 3.0f, 16.0f / 9.0f}) {
    const auto camera = camera_for(lit, 2, aspect);
    EXPECT_LT(camera.target.z, camera.eye.z) << "it looks away from the box";
    EXPECT_TRUE(camera.eye.z > size.z || within(camera.eye, Vec3(0.0f), size)) << as_text(camera.eye);
  }
  EXPECT_GE(lit_fraction(lit, camera_for(lit)), 0.8);
}

// The sky lights the box from outside first.
TEST(AutomaticCamera, under_a_sky_it_looks_into_a_box_and_at_a_thing_alone) {
  const Context context(2);
  auto box = room({4.0f, 2.5f, 3.0f}, true);
  LitPatches thing;
  test::add_box(thing, Vec3(0.0f), Vec3(1.0f), Facing::outwards, 1.0f);
  for (auto* lit : {&box, &thing}) {
    lit->patches.sky = {1.0f, 1.0f, 1.0f};
    const auto camera = camera_for(*lit);
    const Tracer tracer(lit->patches, context);
    const auto seen = tracer.nearest({camera.eye, glm::normalize(camera.target - camera.eye)});
    ASSERT_TRUE(seen);
    EXPECT_FALSE(seen.back) << "the outside of a box, or the inside of a thing";
  }
}

TEST(AutomaticCamera, of_two_rooms_it_chooses_the_lit_one) {
  LitPatches lit;
  test::add_box(lit, Vec3(0.0f), {4.0f, 3.0f, 4.0f}, Facing::inwards, 0.0f);
  test::add_box(lit, {6.0f, 0.0f, 0.0f}, {9.0f, 3.0f, 3.0f}, Facing::inwards, 1.0f);
  const auto camera = camera_for(lit);
  EXPECT_TRUE(within(camera.eye, {6.0f, 0.0f, 0.0f}, {9.0f, 3.0f, 3.0f})) << as_text(camera.eye);
  EXPECT_EQ(lit_fraction(lit, camera), 1.0);
}

// The insides of the shades receive most of the power, but a person cannot stand there.
TEST(AutomaticCamera, it_does_not_look_into_lamp_shades) {
  auto lit = room({4.0f, 3.0f, 5.0f});
  const auto bulb = static_cast<std::uint32_t>(lit.patches.materials.size());
  lit.patches.materials.push_back(plain_material("bulb", 0.0f, true, 1e4f));
  for (const float x : {0.5f, 1.5f, 2.5f, 3.5f}) {
    test::add_box(lit, {x - 0.07f, 1.5f, 0.02f}, {x + 0.07f, 1.64f, 0.16f}, Facing::inwards, 5000.0f, true);
    test::add_plate(lit, {x - 0.02f, 1.55f, 0.05f}, {0.04f, 0.0f, 0.0f}, {0.0f, 0.04f, 0.0f}, 1, 0.0f, 0.0f,
                    bulb);
  }
  const auto camera = camera_for(lit);
  for (const float x : {0.5f, 1.5f, 2.5f, 3.5f})
    EXPECT_FALSE(within(camera.eye, {x - 0.07f, 1.5f, 0.0f}, {x + 0.07f, 1.64f, 0.2f}))
        << as_text(camera.eye);
  EXPECT_LT(lit_fraction(lit, camera, 100.0f), 0.02) << as_text(camera.eye);
}

TEST(AutomaticCamera, it_does_not_stand_in_the_furniture) {
  const Vec3 low(1.0f, 0.01f, 1.0f);
  const Vec3 high(3.0f, 2.0f, 3.0f);
  auto lit = room({6.0f, 3.0f, 6.0f});
  test::add_box(lit, low, high, Facing::outwards, 1.0f);
  const auto camera = camera_for(lit);
  EXPECT_TRUE(within(camera.eye, Vec3(0.0f), {6.0f, 3.0f, 6.0f})) << as_text(camera.eye);
  EXPECT_FALSE(within(camera.eye, low, high)) << as_text(camera.eye);
  EXPECT_EQ(lit_fraction(lit, camera), 1.0);
}

TEST(AutomaticCamera, a_thing_alone_is_seen_from_outside) {
  LitPatches lit;
  test::add_box(lit, Vec3(-1.0f), Vec3(1.0f), Facing::outwards, 1.0f);
  const auto camera = camera_for(lit);
  EXPECT_FALSE(within(camera.eye, Vec3(-1.0f), Vec3(1.0f))) << as_text(camera.eye);
  EXPECT_GT(lit_fraction(lit, camera), 0.2);
  EXPECT_GT(glm::dot(glm::normalize(camera.target - camera.eye), glm::normalize(-camera.eye)), 0.9f)
      << "it does not look at the thing";
}

// The corner's place in a picture of 4 to 3: -1 to 1 from side to side, and from the lower edge to the upper.
Vec2 place_in_picture(const Camera& camera, const Vec3& corner) {
  const auto ahead = glm::normalize(camera.target - camera.eye);
  const auto side = glm::normalize(glm::cross(ahead, camera.up));
  const auto way = corner - camera.eye;
  const auto half_height = std::tan(glm::radians(0.5f * camera.vertical_fov)) * glm::dot(way, ahead);
  return {0.75f * glm::dot(way, side) / half_height, glm::dot(way, glm::cross(side, ahead)) / half_height};
}

TEST(AutomaticCamera, a_solid_under_the_sky_is_seen_whole_and_from_above) {
  for (const Vec3& size : {Vec3(1.0f), Vec3(1.0f, 3.0f, 1.0f), Vec3(20.0f, 4.0f, 8.0f)}) {
    LitPatches lit;
    test::add_box(lit, Vec3(0.0f), size, Facing::outwards, 1.0f);
    lit.patches.sky = {1.0f, 1.0f, 1.0f};
    const auto camera = camera_for(lit);
    const bool is_tower = size.y > size.x;  // which may be seen level
    EXPECT_TRUE(is_tower || camera.eye.y > size.y) << "its top is hidden: " << as_text(camera.eye);
    for (int corner = 0; corner < 8; ++corner) {
      const auto at = place_in_picture(
          camera, Vec3(corner & 1 ? size.x : 0.0f, corner & 2 ? size.y : 0.0f, corner & 4 ? size.z : 0.0f));
      EXPECT_LT(std::max(std::abs(at.x), std::abs(at.y)), 1.0f) << as_text(size) << ", corner " << corner;
    }
  }
}

TEST(AutomaticCamera, the_same_room_in_millimetres_is_seen_from_the_same_place) {
  const auto metres = room({4.0f, 3.0f, 5.0f});
  auto millimetres = metres;
  test::scale(millimetres, 1000.0f);
  const auto a = camera_for(metres);
  const auto b = camera_for(millimetres);
  EXPECT_LT(glm::length(b.eye / 1000.0f - a.eye), 0.01f) << as_text(a.eye) << " and " << as_text(b.eye);
  EXPECT_LT(glm::length(b.target / 1000.0f - a.target), 0.01f);
  EXPECT_EQ(a.vertical_fov, b.vertical_fov);
}

TEST(AutomaticCamera, the_view_does_not_depend_on_threads) {
  const auto lit = room({4.0f, 3.0f, 5.0f});
  const auto one = camera_for(lit, 1);
  for (const auto threads : {2, 7}) {
    const auto many = camera_for(lit, threads);
    EXPECT_EQ(one.eye, many.eye);
    EXPECT_EQ(one.target, many.target);
  }
}

TEST(AutomaticCamera, a_scene_not_solved_yet_has_a_view_too) {
  auto lit = room({4.0f, 3.0f, 5.0f});
  lit.solution = {};
  const auto camera = camera_for(lit);
  const auto lit_room = room({4.0f, 3.0f, 5.0f});
  EXPECT_TRUE(within(camera.eye, Vec3(0.0f), {4.0f, 3.0f, 5.0f})) << as_text(camera.eye);
  EXPECT_EQ(lit_fraction(lit_room, camera), 1.0);
}

TEST(AutomaticCamera, wrong_requests_are_refused) {
  const auto lit = room(Vec3(1.0f));
  const Context context(1);
  const Tracer tracer(lit.patches, context);
  EXPECT_THROW(automatic_camera(lit.patches, lit.solution, tracer, Vec3(0.0f), 1.0f, context), InputError);
  EXPECT_THROW(automatic_camera(lit.patches, lit.solution, tracer, y_up, 0.0f, context), InputError);
  EXPECT_THROW(automatic_camera({}, {}, tracer, y_up, 1.0f, context), InputError);
}

TEST(AutomaticUp, floor_and_ceiling_say_it) {
  EXPECT_EQ(automatic_up(room({4.0f, 2.0f, 5.0f}).patches), Vec3(0.0f, 1.0f, 0.0f));
  EXPECT_EQ(automatic_up(room({4.0f, 5.0f, 2.0f}).patches), Vec3(0.0f, 0.0f, 1.0f));
}

TEST(AutomaticUp, in_a_cube_the_lamp_says_it_and_without_one_it_is_y) {
  auto lit = room(Vec3(1.0f));
  EXPECT_EQ(automatic_up(lit.patches), Vec3(0.0f, 1.0f, 0.0f));
  lit.patches.materials.push_back(plain_material("lamp", 0.0f, true, 5.0f));
  test::add_plate(lit, {0.45f, 0.45f, 0.99f}, {0.0f, 0.1f, 0.0f}, {0.1f, 0.0f, 0.0f}, 1, 0.0f, 0.0f, 1);
  EXPECT_EQ(automatic_up(lit.patches), Vec3(0.0f, 0.0f, 1.0f));
}

}  // namespace
}  // namespace luxel
