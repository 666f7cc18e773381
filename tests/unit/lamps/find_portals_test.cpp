// SPDX-License-Identifier: Apache-2.0
// Which windows, doors and missing walls are found, and which are worth aiming at.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "luxel/core/triangle.h"
#include "luxel/lamps/choose_portals.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/open_polygons.h"

#include "support/window_rooms.h"

namespace luxel {
namespace {

double area_of(const Portal& portal) {
  return triangle_area(portal.corner[0], portal.corner[1], portal.corner[2]);
}

double total_area(const std::vector<Portal>& portals) {
  double area = 0.0;
  for (const auto& portal : portals) area += area_of(portal);
  return area;
}

std::vector<Portal> portals_of(const Scene& scene) {
  auto patches = make_patches(scene, {.max_edge = no_max_edge});
  set_portals(scene, patches, Context(2));
  return patches.portals;
}

bool faces(const Portal& portal, const Vec3& direction) {
  const auto normal = area_vector2(portal.corner[0], portal.corner[1], portal.corner[2]);
  return glm::dot(glm::normalize(normal), Vec3d(glm::normalize(direction))) > 0.999;
}

// Four boxes round a gap of 1 x 1 m in the wall at y = 0, 0.2 m thick; and the rest of the room, 3 x 3 x 3 m.
truth::SceneBuilder boxes_round_a_gap(float sill) {
  truth::SceneBuilder builder;
  builder.material("concrete", 0.5f, 0.0f);
  truth::add_box(builder, {-0.2f, -0.2f, -0.2f}, {3.2f, 3.2f, 0});
  truth::add_box(builder, {-0.2f, -0.2f, 3}, {3.2f, 3.2f, 3.2f});
  truth::add_box(builder, {-0.2f, 0, 0}, {0, 3, 3});
  truth::add_box(builder, {3, 0, 0}, {3.2f, 3, 3});
  truth::add_box(builder, {-0.2f, 3, 0}, {3.2f, 3.2f, 3});
  truth::add_box(builder, {-0.2f, -0.2f, 0}, {1, 0, 3});
  truth::add_box(builder, {2, -0.2f, 0}, {3.2f, 0, 3});
  if (sill > 0.0f) truth::add_box(builder, {1, -0.2f, 0}, {2, 0, sill});
  truth::add_box(builder, {1, -0.2f, 2}, {2, 0, 3});
  return builder;
}

Scene turned(Scene scene, double angle) {
  const auto c = std::cos(angle), s = std::sin(angle);
  for (auto& p : scene.positions) {
    const Vec3d q(p);
    p = Vec3(Vec3d(c * q.x - s * q.y, s * q.x + c * q.y, q.z));
  }
  return scene;
}

// Every triangle with corners of its own, in an order that has nothing to do with the walls.
Scene soup_of(const Scene& scene) {
  auto soup = scene;
  soup.positions.clear();
  for (auto& t : soup.triangles)
    for (auto& corner : t) {
      soup.positions.push_back(scene.positions[corner]);
      corner = static_cast<std::uint32_t>(soup.positions.size() - 1);
    }
  std::reverse(soup.triangles.begin(), soup.triangles.end());
  std::reverse(soup.triangle_material.begin(), soup.triangle_material.end());
  return soup;
}

TEST(FindPortals, finds_the_hole_in_a_wall_to_the_millimetre) {
  const auto portals = portals_of(truth::under_sky(truth::window_room()));
  ASSERT_EQ(portals.size(), 2u);
  EXPECT_NEAR(total_area(portals), 0.25, 1e-3);
  for (const auto& portal : portals) {
    EXPECT_TRUE(faces(portal, {0, 1, 0})) << "inwards";
    EXPECT_FALSE(portal.both_ways);
  }
}

TEST(FindPortals, needs_no_connected_walls_and_no_axes) {
  for (const auto angle : {0.0, 0.4, 1.1}) {
    const auto portals = portals_of(soup_of(turned(truth::under_sky(boxes_round_a_gap(1.0f)), angle)));
    ASSERT_EQ(portals.size(), 2u) << angle;
    EXPECT_NEAR(total_area(portals), 1.0, 0.02) << angle;
  }
}

// Each triangle of a heap fills the raster again: a file of 1 MB took 16 s.
TEST(FindPortals, ignores_planes_in_which_triangles_lie_in_heaps) {
  const auto scene = boxes_round_a_gap(1.0f).scene();
  const auto holes = [&](int layers) {
    std::vector<Triangle3> all;
    for (int layer = 0; layer < layers; ++layer)
      for (const auto& c : scene.triangles)
        all.push_back({scene.positions[c[0]], scene.positions[c[1]], scene.positions[c[2]]});
    return find_wall_holes(all, 6.0).size();
  };
  EXPECT_GT(holes(1), 0u);
  EXPECT_EQ(holes(3), holes(1));
  EXPECT_EQ(holes(20), 0u);
}

TEST(FindPortals, finds_a_door_that_only_the_floor_closes) {
  const auto portals = portals_of(truth::under_sky(boxes_round_a_gap(0.0f)));
  ASSERT_EQ(portals.size(), 2u);
  EXPECT_NEAR(total_area(portals), 2.0, 0.04);
}

TEST(FindPortals, takes_one_of_the_two_faces_of_a_thin_box_of_glass) {
  auto builder = truth::window_room();
  builder.material("glass", 0.5f, 0.0f);
  truth::add_box(builder, {0.76f, -0.02f, 0.51f}, {1.24f, -0.01f, 0.99f});
  auto scene = truth::under_sky(builder);
  scene.materials.back().opaque = false;
  const auto portals = portals_of(scene);
  EXPECT_EQ(portals.size(), 2u) << "the hole or a face of the glass";
  EXPECT_NEAR(total_area(portals), 0.25, 0.03);
}

TEST(FindPortals, a_pane_alone_is_enough) {
  // A tent that widens behind the pane, so that no wall is flat around it.
  truth::SceneBuilder builder;
  builder.material("cloth", 0.5f, 0.0f);
  const std::array<Vec3, 4> pane = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 0, 1), Vec3(0, 0, 1)};
  const std::array<Vec3, 4> ring = {Vec3(-1.5f, 1, -1.5f), Vec3(2.5f, 1, -1.5f), Vec3(2.5f, 1, 2.5f),
                                    Vec3(-1.5f, 1, 2.5f)};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto next = (i + 1) % 4;
    builder.quad(pane[i], pane[next], ring[next], ring[i]).triangle(ring[i], ring[next], {0.5f, 4, 0.5f});
  }
  builder.material("glass", 0.5f, 0.0f).quad({0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1});
  auto scene = truth::under_sky(builder);
  scene.materials.back().opaque = false;
  const auto panes = find_open_polygons(scene);
  EXPECT_TRUE(std::any_of(panes.begin(), panes.end(), [](const auto& p) { return p.size() == 4; }));
  EXPECT_NEAR(total_area(portals_of(scene)), 1.0, 0.02);
}

TEST(FindPortals, finds_the_missing_wall_of_a_box) {
  auto scene = truth::cube({});
  // Without its first wall, two triangles.
  scene.triangles.erase(scene.triangles.begin(), scene.triangles.begin() + 2);
  scene.triangle_material.erase(scene.triangle_material.begin(), scene.triangle_material.begin() + 2);
  scene.triangle_group.erase(scene.triangle_group.begin(), scene.triangle_group.begin() + 2);
  if (scene.triangle_line.size() > 2)
    scene.triangle_line.erase(scene.triangle_line.begin(), scene.triangle_line.begin() + 2);
  EXPECT_EQ(find_missing_walls(turned(scene, 0.3)).size(), 1u);
}

TEST(FindPortals, none_where_rays_find_the_sky_or_never_can) {
  truth::SceneBuilder open;
  open.material("ground", 0.5f, 0.0f).quad({-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0});
  truth::add_box(open, {0, 0, 0}, {1, 1, 1});
  truth::add_box(open, {3, 0, 0}, {4, 1, 1});
  EXPECT_TRUE(portals_of(truth::under_sky(open)).empty());
  auto sealed = truth::cube({});
  sealed.sky = Vec3(1.0f);
  EXPECT_TRUE(portals_of(sealed).empty());
  EXPECT_TRUE(portals_of(truth::window_room().scene()).empty()) << "no sky";
}

TEST(FindPortals, hundreds_of_windows_are_all_found) {
  // A flat roof of 20 x 20 m over a hall 6 m high, with 196 skylights.
  truth::SceneBuilder builder;
  builder.material("hall", 0.5f, 0.0f)
      .quad({0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {0, 20, 0})
      .quad({0, 0, 0}, {0, 20, 0}, {0, 20, 6}, {0, 0, 6})
      .quad({20, 0, 0}, {20, 0, 6}, {20, 20, 6}, {20, 20, 0})
      .quad({0, 0, 0}, {0, 0, 6}, {20, 0, 6}, {20, 0, 0})
      .quad({0, 20, 0}, {20, 20, 0}, {20, 20, 6}, {0, 20, 6});
  const auto line = [](std::size_t i) {
    return i == 29 ? 20.0f : 1.4f * static_cast<float>(i / 2) + 0.9f * static_cast<float>(i % 2);
  };
  for (std::size_t i = 0; i < 29; ++i)
    for (std::size_t j = 0; j < 29; ++j)
      if (i % 2 == 0 || j % 2 == 0)
        builder.quad({line(i), line(j), 6}, {line(i), line(j + 1), 6}, {line(i + 1), line(j + 1), 6},
                     {line(i + 1), line(j), 6});
  const auto portals = portals_of(truth::under_sky(builder));
  EXPECT_EQ(portals.size(), 2u * 196u);
}

}  // namespace
}  // namespace luxel
