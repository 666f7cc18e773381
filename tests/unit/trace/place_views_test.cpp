// SPDX-License-Identifier: Apache-2.0
#include "luxel/trace/place_views.h"

#include <cmath>

#include <gtest/gtest.h>

#include "luxel/core/bounds.h"
#include "luxel/core/error.h"
#include "luxel/patch/focus.h"
#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

bool is_inside(const Bounds& box, const Vec3& p) {
  return glm::all(glm::greaterThan(p, box.low)) && glm::all(glm::lessThan(p, box.high));
}

// The six walls of a box, facing inwards; without the wall at the lowest x where it is open.
void add_box(truth::SceneBuilder& b, const Bounds& box, bool is_open = false) {
  const auto [l, h] = box;
  b.quad({l.x, l.y, l.z}, {h.x, l.y, l.z}, {h.x, h.y, l.z}, {l.x, h.y, l.z});
  b.quad({l.x, h.y, h.z}, {h.x, h.y, h.z}, {h.x, l.y, h.z}, {l.x, l.y, h.z});
  if (!is_open) b.quad({l.x, l.y, l.z}, {l.x, h.y, l.z}, {l.x, h.y, h.z}, {l.x, l.y, h.z});
  b.quad({h.x, l.y, h.z}, {h.x, h.y, h.z}, {h.x, h.y, l.z}, {h.x, l.y, l.z});
  b.quad({l.x, l.y, h.z}, {h.x, l.y, h.z}, {h.x, l.y, l.z}, {l.x, l.y, l.z});
  b.quad({l.x, h.y, l.z}, {h.x, h.y, l.z}, {h.x, h.y, h.z}, {l.x, h.y, h.z});
}

// A square lamp that shines down, of a tenth of the box, near its ceiling.
void add_lamp(truth::SceneBuilder& b, const Bounds& box) {
  const auto middle = 0.5f * (box.low + box.high);
  const auto half = 0.05f * (box.high - box.low);
  const auto z = box.high.z - 0.02f * (box.high.z - box.low.z);
  b.material("lamp", 0.0f, 10.0f);
  b.quad({middle.x - half.x, middle.y + half.y, z}, {middle.x + half.x, middle.y + half.y, z},
         {middle.x + half.x, middle.y - half.y, z}, {middle.x - half.x, middle.y - half.y, z});
}

// A flat ground around the origin.
void add_ground(truth::SceneBuilder& b, float half) {
  b.material("ground", 0.3f, 0.0f);
  b.quad({-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0});
}

struct Placed {
  PatchSet patches;
  ViewSets views;
};

Placed place(const Scene& scene, int threads = 2) {
  Placed placed{make_patches(scene, {.max_edge = no_max_edge}), {}};
  const Context context(threads);
  placed.views = place_views(placed.patches, Tracer(placed.patches, context), context);
  return placed;
}

double weight_in(const Views& views, const Bounds& box) {
  double sum = 0.0;
  for (std::size_t v = 0; v < views.size(); ++v)
    if (is_inside(box, views.eye[v])) sum += static_cast<double>(views.weight[v]);
  return sum;
}

Scene with_sky(Scene scene) {
  scene.sky = Vec3(1.0f);
  return scene;
}

const Bounds hall{{0, 0, 0}, {10, 10, 4}};

TEST(PlaceViews, a_closed_room_with_a_lamp_is_one_place_and_all_its_views_are_inside) {
  truth::SceneBuilder b;
  b.material("walls", 0.5f, 0.0f);
  add_box(b, hall);
  add_lamp(b, hall);
  const auto [patches, views] = place(b.scene());
  EXPECT_NEAR(views.places, 1.0, 0.2);
  EXPECT_GT(views.dealing.size(), 100u);
  EXPECT_NEAR(weight_in(views.stating, hall), 1.0, 1e-5);
  EXPECT_NEAR(weight_in(views.dealing, hall), 1.0, 1e-5);
}

TEST(PlaceViews, a_sealed_box_in_a_room_has_none_inside) {
  const Bounds crate{{4, 4, 0.5f}, {7, 7, 3.5f}};
  truth::SceneBuilder b;
  b.material("walls", 0.5f, 0.0f);
  add_box(b, hall);
  add_box(b, crate);
  add_lamp(b, hall);
  const auto views = place(b.scene()).views;
  EXPECT_GT(views.stating.size(), 100u);
  EXPECT_EQ(weight_in(views.stating, crate), 0.0);
  EXPECT_EQ(weight_in(views.dealing, crate), 0.0);
}

TEST(PlaceViews, a_dark_room_is_open_space_where_a_camera_stands_in_it) {
  truth::SceneBuilder b;
  b.material("walls", 0.5f, 0.0f);
  add_box(b, hall);
  auto scene = b.scene();
  EXPECT_TRUE(place(scene).views.empty());
  scene.cameras.push_back({.eye = {5, 5, 2}, .target = {0, 5, 2}, .up = {0, 0, 1}});
  const auto views = place(scene).views;
  EXPECT_GT(views.stating.size(), 100u);
  EXPECT_NEAR(weight_in(views.stating, hall), 1.0, 1e-5);
}

TEST(PlaceViews, a_camera_counts_by_what_its_picture_shows_too) {
  truth::SceneBuilder b;
  b.material("walls", 0.5f, 0.0f);
  add_box(b, hall);
  add_lamp(b, hall);
  b.material("stamp", 0.5f, 0.0f);
  b.quad({0.01f, 4.9f, 1.9f}, {0.01f, 5.1f, 1.9f}, {0.01f, 5.1f, 2.1f}, {0.01f, 4.9f, 2.1f});
  auto scene = b.scene();
  const auto stamp_in = [](const Placed& placed) {
    const auto& views = placed.views.stating;
    double fraction = 0.0;
    for (std::size_t v = 0; v < views.size(); ++v)
      for (const auto code : views.seen_by(v))
        if (code < Views::sky && placed.patches.material_of(views.sides[code].patch()).name == "stamp")
          fraction += static_cast<double>(views.weight[v]) / static_cast<double>(views.seen_by(v).size());
    return fraction;
  };
  EXPECT_LT(stamp_in(place(scene)), 1e-3);
  // It fills half of the picture's height, and as much of its width where that is as large.
  const auto fov = 2.0f * glm::degrees(std::atan(0.2f / 4.99f));
  scene.cameras.push_back({{5, 5, 2}, {0, 5, 2}, {0, 0, 1}, fov, 1.0f});
  const auto placed = place(scene);
  EXPECT_NEAR(placed.views.places, 1.0, 0.2);
  EXPECT_NEAR(stamp_in(placed), 0.25 * 0.25, 0.005);  // a quarter of the weight is of the picture
}

TEST(PlaceViews, two_rooms_of_very_different_size_weigh_alike) {
  const Bounds hangar{{20, 0, 0}, {100, 80, 30}};
  const Bounds closet{{0, 0, 0}, {1.5f, 1.5f, 2.5f}};
  truth::SceneBuilder b;
  b.material("walls", 0.5f, 0.0f);
  add_box(b, hangar);
  add_box(b, closet);
  add_lamp(b, hangar);
  add_lamp(b, closet);
  const auto views = place(b.scene()).views;
  EXPECT_NEAR(views.places, 2.0, 0.3);
  EXPECT_NEAR(weight_in(views.stating, closet), 0.5, 0.1);
  EXPECT_NEAR(weight_in(views.stating, hangar), 0.5, 0.1);
}

TEST(PlaceViews, a_block_of_flats_weighs_by_flat) {
  truth::SceneBuilder b;
  b.material("walls", 0.5f, 0.0f);
  std::vector<Bounds> flats;
  for (int i = 0; i < 12; ++i) {
    const auto x = 20.0f * static_cast<float>(i);
    const auto size = 3.0f + 1.0f * static_cast<float>(i % 4);
    flats.push_back({{x, 0, 0}, {x + size, size, 3}});
    b.material("walls", 0.5f, 0.0f);
    add_box(b, flats.back());
    add_lamp(b, flats.back());
  }
  const auto views = place(b.scene()).views;
  for (const auto& flat : flats) EXPECT_NEAR(weight_in(views.stating, flat), 1.0 / 12.0, 0.05);
}

TEST(PlaceViews, a_plate_under_a_sky_is_seen_from_above_and_below) {
  truth::SceneBuilder b;
  add_ground(b, 2.0f);
  const auto views = place(with_sky(b.scene())).views;
  EXPECT_GT(views.stating.size(), 50u);
  const auto above = weight_in(views.stating, {{-100, -100, 0}, {100, 100, 100}});
  EXPECT_GT(above, 0.2);
  EXPECT_LT(above, 0.8);
}

TEST(PlaceViews, a_small_house_in_a_wide_landscape_weighs_about_as_much_as_the_landscape) {
  const Bounds house{{0, 0, 0.1f}, {5, 4, 3}};
  truth::SceneBuilder b;
  add_ground(b, 1000.0f);
  b.material("walls", 0.6f, 0.0f);
  add_box(b, house, true);
  const auto views = place(with_sky(b.scene())).views;
  const auto inside = weight_in(views.stating, house);
  EXPECT_GT(inside, 0.2);
  EXPECT_LT(inside, 0.8);
}

TEST(PlaceViews, views_do_not_hang_on_threads) {
  truth::SceneBuilder b;
  b.material("walls", 0.5f, 0.0f);
  add_box(b, hall);
  add_lamp(b, hall);
  const auto one = place(b.scene(), 1).views;
  const auto four = place(b.scene(), 4).views;
  EXPECT_EQ(one.stating.seen, four.stating.seen);
  EXPECT_EQ(one.stating.sides, four.stating.sides);
  EXPECT_EQ(one.stating.weight, four.stating.weight);
  EXPECT_EQ(one.dealing.seen, four.dealing.seen);
}

TEST(PlaceViews, with_a_focus_only_named_surfaces_count) {
  truth::SceneBuilder b;
  b.material("walls", 0.5f, 0.0f);
  add_box(b, hall);
  b.material("picture", 0.5f, 0.0f);
  b.quad({3, 9.9f, 1}, {5, 9.9f, 1}, {5, 9.9f, 2}, {3, 9.9f, 2});
  add_lamp(b, hall);
  const auto scene = b.scene();
  auto patches = make_patches(scene, {.max_edge = no_max_edge});
  set_focus(scene, "pict*", patches);
  const Context context(2);
  const Tracer tracer(patches, context);
  const auto views = place_views(patches, tracer, context).stating;
  ASSERT_GT(views.size(), 50u);
  for (const auto s : views.seen) {
    if (s >= Views::sky) continue;
    EXPECT_EQ(patches.material_of(views.sides[s].patch()).name, "picture");
  }
  EXPECT_THROW(set_focus(scene, "sofa", patches), InputError);
  EXPECT_THROW(set_focus(scene, "camera", patches), InputError);
}

TEST(PlaceViews, with_the_focus_on_cameras_views_are_what_they_see) {
  truth::SceneBuilder b;
  b.material("walls", 0.5f, 0.0f);
  add_box(b, hall);
  add_lamp(b, hall);
  auto scene = b.scene();
  scene.cameras.push_back({.eye = {5, 5, 2}, .target = {0, 5, 2}, .up = {0, 0, 1}, .vertical_fov = 20.0f});
  auto patches = make_patches(scene, {.max_edge = no_max_edge});
  set_focus(scene, "camera", patches);
  const Context context(2);
  const Tracer tracer(patches, context);
  const auto views = place_views(patches, tracer, context).stating;
  ASSERT_EQ(views.size(), 1u);
  for (const auto side : views.sides)
    EXPECT_LT(patches.centroid(side.patch()).x, 1.0f) << "the wall in front";
}

}  // namespace
}  // namespace luxel
