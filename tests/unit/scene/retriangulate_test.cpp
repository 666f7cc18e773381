// SPDX-License-Identifier: Apache-2.0
// Flat surfaces of needles: triangulated again, they cover the same places with the same colours.
#include "luxel/scene/retriangulate.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/core/triangle.h"
#include "luxel/lamps/shadow_lines.h"
#include "luxel/patch/make_patches.h"
#include "luxel/scene/triangle_shape.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

constexpr int steps = 40;

// A wall of 20 m x 4 m on the plane z = 0, whose top has a vertex every 0.5 m, as a fan around its lower left
// corner: 40 needles, and a triangle below them.
truth::SceneBuilder wall_of_needles() {
  truth::SceneBuilder builder;
  builder.material("wall", 0.5f, 0.0f);
  const auto top = [](int i) { return Vec3(20.0f * static_cast<float>(i) / steps, 4.0f, 0.0f); };
  builder.triangle({0, 0, 0}, {20, 0, 0}, top(steps));
  for (int i = steps; i > 0; --i) builder.triangle({0, 0, 0}, top(i), top(i - 1));
  return builder;
}

std::array<Vec3, 3> corners(const Scene& scene, std::size_t t) {
  const auto& c = scene.triangles[t];
  return {scene.positions[c[0]], scene.positions[c[1]], scene.positions[c[2]]};
}

double area_of(const Scene& scene) {
  double sum = 0.0;
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const auto [a, b, c] = corners(scene, t);
    sum += area_vector2(a, b, c).z / 2.0;
  }
  return sum;
}

double max_slenderness(const Scene& scene) {
  double result = 0.0;
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const auto [a, b, c] = corners(scene, t);
    result = std::max(result, slenderness(a, b, c));
  }
  return result;
}

TEST(Retriangulate, a_fan_of_needles_becomes_triangles_of_good_shape) {
  auto scene = wall_of_needles().scene();
  const auto before = scene.triangles.size();
  EXPECT_GT(max_slenderness(scene), 50.0);
  const auto made = retriangulate_needles(scene);
  EXPECT_EQ(made.surfaces, 1u);
  EXPECT_EQ(made.before, before);
  EXPECT_EQ(made.after, scene.triangles.size());
  EXPECT_NO_THROW(check_scene(scene));
  EXPECT_LT(max_slenderness(scene), 8.0 + 1e-6);
  EXPECT_NEAR(area_of(scene), 80.0, 1e-5);
}

TEST(Retriangulate, pictures_and_colours_stay_where_they_are) {
  auto scene = wall_of_needles().scene();
  const auto place = [](const Vec3& p) {
    return Vec2(0.3f * p.x - 0.2f * p.y, 0.1f * p.x + 0.7f * p.y + 3.0f);
  };
  const auto colour = [](const Vec3& p) { return Vec3(p.x / 20.0f, p.y / 4.0f, 0.5f); };
  scene.uv_sets.emplace_back();
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const auto [a, b, c] = corners(scene, t);
    scene.uv_sets[0].push_back({place(a), place(b), place(c)});
    scene.corner_colours.push_back({colour(a), colour(b), colour(c)});
  }
  ASSERT_EQ(retriangulate_needles(scene).surfaces, 1u);
  ASSERT_EQ(scene.uv_sets[0].size(), scene.triangles.size());
  ASSERT_EQ(scene.corner_colours.size(), scene.triangles.size());
  for (std::size_t t = 0; t < scene.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto p = corners(scene, t)[k];
      EXPECT_LT(glm::distance(scene.uv_sets[0][t][k], place(p)), 2e-6f);
      EXPECT_LT(glm::distance(scene.corner_colours[t][k], colour(p)), 1e-6f);
    }
}

TEST(Retriangulate, surfaces_end_where_pictures_colours_materials_or_objects_change) {
  const auto needles = wall_of_needles().scene();
  const auto count = needles.triangles.size();
  auto other_places = needles;
  other_places.uv_sets.emplace_back(count);
  auto other_colours = needles;
  other_colours.corner_colours.assign(count, {Vec3(1.0f), Vec3(1.0f), Vec3(1.0f)});
  auto other_materials = needles;
  other_materials.materials.push_back(needles.materials.front());
  auto other_objects = needles;
  other_objects.objects = {"a", "b"};
  other_objects.triangle_object.assign(count, 0);
  for (std::size_t t = 0; t < count; t += 2) {
    other_places.uv_sets[0][t].fill(Vec2(0.5f));
    other_colours.corner_colours[t].fill(Vec3(0.5f));
    other_materials.triangle_material[t] = static_cast<MaterialId>(needles.materials.size());
    other_objects.triangle_object[t] = 1;
  }
  for (const auto& scene : {other_places, other_colours, other_materials, other_objects}) {
    auto same = scene;
    EXPECT_EQ(retriangulate_needles(same).surfaces, 0u);
    EXPECT_EQ(same.triangles, scene.triangles);
    EXPECT_EQ(same.positions.size(), scene.positions.size());
  }
}

TEST(Retriangulate, bent_surfaces_narrow_rectangles_and_doubled_walls_stay) {
  auto bent = wall_of_needles().scene();
  for (auto& p : bent.positions)
    if (p.y > 3.9f) p.z = 0.2f * std::sin(p.x);
  auto doubled = wall_of_needles();
  for (int i = steps; i > 0; --i)
    doubled.triangle({0, 0, 0}, {20.0f * static_cast<float>(i - 1) / steps, 4, 0},
                     {20.0f * static_cast<float>(i) / steps, 4, 0});
  truth::SceneBuilder strips;
  strips.material("strips", 0.5f, 0.0f).quad({0, 0, 0}, {5, 0, 0}, {5, 0.01f, 0}, {0, 0.01f, 0});
  strips.quad({0, 1, 0}, {5, 1, 0}, {5, 1.01f, 0}, {0, 1.01f, 0});
  for (const auto& scene : {bent, doubled.scene(), strips.scene()}) {
    auto same = scene;
    EXPECT_EQ(retriangulate_needles(same).surfaces, 0u);
    EXPECT_EQ(same.triangles, scene.triangles);
  }
}

TEST(Retriangulate, other_triangles_keep_their_order_lines_and_materials) {
  auto builder = wall_of_needles();
  builder.material("last", 0.25f, 0.0f).quad({0, 0, 5}, {1, 0, 5}, {1, 1, 5}, {0, 1, 5});
  auto scene = builder.scene();
  for (std::size_t t = 0; t < scene.triangles.size(); ++t)
    scene.triangle_line[t] = static_cast<std::uint32_t>(t + 1);
  const auto old = scene;
  ASSERT_EQ(retriangulate_needles(scene).surfaces, 1u);
  const auto last = scene.triangles.size() - 1, old_last = old.triangles.size() - 1;
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(scene.triangles[last - i], old.triangles[old_last - i]);
    EXPECT_EQ(scene.triangle_line[last - i], old.triangle_line[old_last - i]);
    EXPECT_EQ(scene.triangle_material[last - i], old.triangle_material[old_last - i]);
  }
  for (std::size_t t = 0; t + 2 < scene.triangles.size(); ++t) EXPECT_EQ(scene.triangle_line[t], 1u);
}

// The shadow of a square lies across the tips of the needles, where pieces of its edges are too short for
// pairs of points on both sides.
TEST(Retriangulate, the_edge_of_a_shadow_on_needles_is_whole) {
  auto builder = wall_of_needles();
  builder.material("screen", 0.5f, 0.0f)
      .quad({0.5f, 0.6f, 1}, {1.5f, 0.6f, 1}, {1.5f, 1.6f, 1}, {0.5f, 1.6f, 1});
  auto scene = builder.scene();
  scene.point_lights = {
      {.name = "sun", .kind = PointLightKind::directional, .direction = Vec3(0.0f, 0.0f, -1.0f)}};
  retriangulate_needles(scene);
  const auto triangles = make_patches(scene, {.max_edge = no_max_edge, .contacts = false});
  double length = 0.0;
  for (const auto& line :
       find_shadow_lines(triangles, Tracer(triangles),
                         {.max_edge = 0.25f, .contact_gap = 1e-4, .max_patches = 100'000}, Context(2)))
    length += glm::distance(line.ends[0], line.ends[1]);
  EXPECT_NEAR(length, 4.0, 1e-4);
}

}  // namespace
}  // namespace luxel
