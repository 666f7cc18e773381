// SPDX-License-Identifier: Apache-2.0
// Edges of hard shadows against closed forms: parallel and central projections of squares.
#include "luxel/lamps/shadow_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/solve/bake.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

constexpr float max_edge = 0.25f;

// A floor of 8 m x 8 m around the origin, and above it a square screen of 1 m x 1 m with this centre.
truth::SceneBuilder screen_above_floor(const Vec3& centre) {
  truth::SceneBuilder builder;
  builder.material("floor", 0.5f, 0.0f).quad({-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0});
  builder.material("screen", 0.5f, 0.0f);
  const auto at = [&](float x, float y) { return centre + Vec3(x, y, 0.0f); };
  builder.quad(at(-0.5f, -0.5f), at(0.5f, -0.5f), at(0.5f, 0.5f), at(-0.5f, 0.5f));
  return builder;
}

// The same floor in strips along y, cut at these places of x.
truth::SceneBuilder floor_of_strips(const std::vector<float>& cuts) {
  truth::SceneBuilder builder;
  builder.material("floor", 0.5f, 0.0f);
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    builder.quad({cuts[i], -4, 0}, {cuts[i + 1], -4, 0}, {cuts[i + 1], 4, 0}, {cuts[i], 4, 0});
  builder.material("screen", 0.5f, 0.0f);
  return builder;
}

// A square at a height of 1 m.
void add_screen(truth::SceneBuilder& builder, float x, float half) {
  builder.quad({x - half, -half, 1}, {x + half, -half, 1}, {x + half, half, 1}, {x - half, half, 1});
}

PointLight sun(const Vec3& direction) {
  return {.name = "sun", .kind = PointLightKind::directional, .direction = glm::normalize(direction)};
}

std::vector<ShadowLine> lines_of(const Scene& scene, const ShadowLineOptions& options,
                                 const Context& context = Context(2)) {
  const auto triangles = make_patches(scene, {.max_edge = no_max_edge, .contacts = false});
  return find_shadow_lines(triangles, Tracer(triangles), options, context);
}

std::vector<ShadowLine> lines_of(const Scene& scene, std::size_t max_patches = 100'000,
                                 const Context& context = Context(2)) {
  return lines_of(scene, {.max_edge = max_edge, .contact_gap = 1e-4, .max_patches = max_patches}, context);
}

double distance_to(const Vec3d& p, const Vec3d& a, const Vec3d& b) {
  const auto t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
  return glm::distance(p, a + t * (b - a));
}

double length(const ShadowLine& line) { return glm::distance(line.ends[0], line.ends[1]); }

// All lines lie on the boundary of the polygon, and they cover it.
void expect_boundary(const std::vector<ShadowLine>& lines, const std::vector<Vec3d>& polygon) {
  double perimeter = 0.0, found = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    perimeter += glm::distance(polygon[i], polygon[(i + 1) % polygon.size()]);
  for (const auto& line : lines) {
    found += length(line);
    EXPECT_LT(line.triangle, 2u);  // the floor
    EXPECT_NEAR(line.lit_side.z, 1.0, 1e-9);
    double off = 1.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      off = std::min(off, std::max(distance_to(line.ends[0], a, b), distance_to(line.ends[1], a, b)));
    }
    EXPECT_LT(off, 1e-5);
  }
  EXPECT_NEAR(found, perimeter, 1e-5 * perimeter);
}

TEST(ShadowLines, a_square_under_the_sun_has_the_shadow_of_a_parallel_projection) {
  auto scene = screen_above_floor({0.3f, 0.1f, 1.0f}).scene();
  scene.point_lights = {sun({0.6f, 0.35f, -1.0f})};
  // Corners move by the direction over its fall: 0.6 and 0.35 per metre.
  expect_boundary(lines_of(scene), {{0.4, -0.05, 0}, {1.4, -0.05, 0}, {1.4, 0.95, 0}, {0.4, 0.95, 0}});
}

TEST(ShadowLines, a_square_under_a_point_light_has_the_shadow_of_a_central_projection) {
  auto scene = screen_above_floor({0.3f, 0.1f, 1.0f}).scene();
  scene.point_lights = {{.name = "lamp", .position = {0.1f, 0.2f, 2.0f}}};
  // Twice as far from the lamp: (x, y) becomes 2 (x, y) - (0.1, 0.2).
  expect_boundary(lines_of(scene), {{-0.5, -1.0, 0}, {1.5, -1.0, 0}, {1.5, 1.0, 0}, {-0.5, 1.0, 0}});
}

TEST(ShadowLines, a_spot_has_no_lines_outside_of_its_cone) {
  auto scene = screen_above_floor({0.0f, 0.0f, 1.0f}).scene();
  // Its cone has a radius of 0.4 m at the screen, which hides all of it.
  scene.point_lights = {{.name = "spot",
                         .kind = PointLightKind::spot,
                         .position = {0.0f, 0.0f, 2.0f},
                         .direction = {0.0f, 0.0f, -1.0f},
                         .cos_inner = 0.95f,
                         .cos_outer = 1.0f / std::hypot(1.0f, 0.4f)}};
  EXPECT_TRUE(lines_of(scene).empty());
  scene.point_lights[0].cos_outer = 0.3f;
  expect_boundary(lines_of(scene), {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
}

// A square lamp of 4 or 10 cm above the centre of a screen of 1 m, half way to the floor: each edge of the
// screen has a line where the whole lamp is hidden, and one where none of it is.
TEST(ShadowLines, a_small_lamp_has_lines_where_its_penumbra_begins_and_ends) {
  for (const float half : {0.02f, 0.05f}) {
    SCOPED_TRACE(half);
    auto builder = screen_above_floor({0.0f, 0.0f, 1.0f});
    builder.material("lamp", 0.0f, 1000.0f);
    builder.quad({-half, -half, 2}, {-half, half, 2}, {half, half, 2}, {half, -half, 2});
    const auto lines = lines_of(builder.scene());
    double found = 0.0;
    for (const auto& line : lines) {
      EXPECT_LT(line.triangle, 2u);  // the floor
      found += length(line);
      for (const auto& end : line.ends) {
        const auto x = std::abs(end.x), y = std::abs(end.y);
        const bool is_on_side = std::abs(std::abs(std::max(x, y) - 1.0) - half) < 1e-4;
        EXPECT_TRUE(is_on_side || std::abs(x + y - 2.0) < 1e-4) << "on a side, or between two at a corner";
        // The ends of lines meet, also where different corners of the lamp make them.
        EXPECT_TRUE(std::any_of(lines.begin(), lines.end(),
                                [&](const ShadowLine& other) {
                                  return &other != &line &&
                                         distance_to(end, other.ends[0], other.ends[1]) < 1e-4;
                                }))
            << end.x << ' ' << end.y;
      }
    }
    EXPECT_GT(found, 8 * 1.999) << "two lines of 2 m on each side";
    EXPECT_LT(found, 8 * 2.0 + 8 * 3.0 * half) << "and short ones at their ends";
  }
}

TEST(ShadowLines, a_large_lamp_has_a_soft_shadow_without_lines) {
  auto builder = screen_above_floor({0.0f, 0.0f, 1.0f});
  builder.material("lamp", 0.0f, 1000.0f);
  builder.quad({-0.2f, -0.2f, 2}, {-0.2f, 0.2f, 2}, {0.2f, 0.2f, 2}, {0.2f, -0.2f, 2});
  EXPECT_TRUE(lines_of(builder.scene()).empty());
}

TEST(ShadowLines, only_the_outer_boundary_of_two_shadows_that_overlap_is_found) {
  auto builder = screen_above_floor({0.0f, 0.0f, 1.0f});
  builder.quad({0.0f, 0.0f, 1.5f}, {1.0f, 0.0f, 1.5f}, {1.0f, 1.0f, 1.5f}, {0.0f, 1.0f, 1.5f});
  auto scene = builder.scene();
  scene.point_lights = {sun({0.0f, 0.0f, -1.0f})};
  auto lines = lines_of(scene);
  // The upper square has a shadow on the lower one, too.
  double on_screen = 0.0;
  for (const auto& line : lines) on_screen += line.triangle >= 2u ? length(line) : 0.0;
  EXPECT_NEAR(on_screen, 1.0, 1e-5);
  lines.erase(std::remove_if(lines.begin(), lines.end(), [](const auto& l) { return l.triangle >= 2u; }),
              lines.end());
  expect_boundary(lines, {{-0.5, -0.5, 0},
                          {0.5, -0.5, 0},
                          {0.5, 0, 0},
                          {1, 0, 0},
                          {1, 1, 0},
                          {0, 1, 0},
                          {0, 0.5, 0},
                          {-0.5, 0.5, 0}});
}

TEST(ShadowLines, a_box_on_the_floor_has_a_shadow_that_starts_at_its_corners) {
  truth::SceneBuilder builder;
  builder.material("floor", 0.5f, 0.0f).quad({-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0});
  const auto at = [](int i) {
    return Vec3((i & 1) != 0 ? 1.0f : 0.0f, (i & 2) != 0 ? 1.0f : 0.0f, (i & 4) != 0 ? 1.0f : 0.0f);
  };
  builder.material("box", 0.5f, 0.0f);
  for (const auto& f : std::vector<std::array<int, 4>>{
           {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}, {4, 5, 7, 6}, {0, 2, 3, 1}})
    builder.quad(at(f[0]), at(f[1]), at(f[2]), at(f[3]));
  auto scene = builder.scene();
  scene.point_lights = {sun({0.5f, 0.25f, -1.0f})};
  const auto lines = lines_of(scene);
  double found = 0.0, nearest = 1.0;
  for (const auto& line : lines) {
    found += length(line);
    for (const auto& end : line.ends) nearest = std::min(nearest, glm::distance(end, Vec3d(1, 0, 0)));
  }
  // From (1,0) and (0,1) by (0.5, 0.25), and the parts of 1 m of the top's two edges.
  EXPECT_NEAR(found, 2.0 + 2.0 * std::hypot(0.5, 0.25), 1e-5);
  EXPECT_LT(nearest, 1e-6);
}

double sum_of_lengths(const std::vector<ShadowLine>& lines) {
  double sum = 0.0;
  for (const auto& line : lines) sum += length(line);
  return sum;
}

// A strip of 5 mm across the shadow, a fiftieth of the longest edge, divides the floor: as between the arches
// of a wall.
TEST(ShadowLines, a_shadow_goes_on_over_a_narrow_triangle) {
  auto builder = floor_of_strips({-4.0f, 0.1f, 0.105f, 4.0f});
  add_screen(builder, 0.0f, 0.5f);
  auto scene = builder.scene();
  scene.point_lights = {sun({0.0f, 0.0f, -1.0f})};
  EXPECT_NEAR(sum_of_lengths(lines_of(scene)), 4.0, 1e-4);
}

// Strips of 0.2 mm and 1 mm, cut by their diagonals: too narrow for rays on both sides of a line. Without
// their pieces the line has gaps, through which light comes to the patches around.
TEST(ShadowLines, a_shadow_has_no_gap_where_it_crosses_needles) {
  auto builder = floor_of_strips({-4.0f, -0.4f, -0.3998f, -0.3996f, 0.0f, 0.001f, 0.2f, 0.2002f, 4.0f});
  add_screen(builder, 0.0f, 0.5f);
  auto scene = builder.scene();
  scene.point_lights = {sun({0.0f, 0.0f, -1.0f})};
  EXPECT_NEAR(sum_of_lengths(lines_of(scene)), 4.0, 2e-5);
}

// A large screen has a shadow over two strips of 2 cm, small screens beside it have shadows of 30 cm. With
// few patches the line of an edge is whole or absent.
TEST(ShadowLines, an_edge_has_its_whole_line_or_none) {
  auto builder = floor_of_strips({-4.0f, -0.2f, -0.18f, 0.1f, 0.12f, 4.0f});
  add_screen(builder, 0.0f, 0.5f);
  for (const float x : {1.0f, 1.5f, 2.0f, 2.5f, 3.0f}) add_screen(builder, x, 0.15f);
  auto scene = builder.scene();
  scene.point_lights = {sun({0.0f, 0.0f, -1.0f})};
  double all = 0.0;
  for (const std::size_t limit : {150u, 200u, 250u, 300u, 350u, 500u}) {
    SCOPED_TRACE(limit);
    std::array<double, 2> found{};  // along the edges at y = -0.5 and 0.5
    for (const auto& line : lines_of(scene, limit))
      for (const auto i : {0u, 1u}) {
        const auto y = i == 0 ? -0.5 : 0.5;
        if (std::abs(line.ends[0].y - y) < 1e-5 && std::abs(line.ends[1].y - y) < 1e-5)
          found[i] += length(line);
      }
    for (const auto f : found) EXPECT_NEAR(f, std::round(f), 1e-4);
    all = found[0] + found[1];
  }
  EXPECT_NEAR(all, 2.0, 1e-4);
}

// A screen whose corners are cut by 6 mm: edges too short for lines of their own.
TEST(ShadowLines, a_shadow_is_closed_at_blunt_corners) {
  constexpr float half = 0.5f, cut = 0.494f;
  truth::SceneBuilder builder;
  builder.material("floor", 0.5f, 0.0f).quad({-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0});
  builder.material("screen", 0.5f, 0.0f);
  const std::vector<Vec3d> outline = {{half, -cut, 0}, {half, cut, 0},   {cut, half, 0},   {-cut, half, 0},
                                      {-half, cut, 0}, {-half, -cut, 0}, {-cut, -half, 0}, {cut, -half, 0}};
  for (std::size_t i = 0; i < outline.size(); ++i)
    builder.triangle({0, 0, 1}, Vec3(outline[i]) + Vec3(0, 0, 1),
                     Vec3(outline[(i + 1) % outline.size()]) + Vec3(0, 0, 1));
  auto scene = builder.scene();
  scene.point_lights = {sun({0.0f, 0.0f, -1.0f})};
  expect_boundary(lines_of(scene), outline);
}

// The disc of a sun makes two lines, 2 mm apart below a screen 22 cm above the floor.
TEST(ShadowLines, a_narrow_penumbra_has_both_its_lines_where_patches_are_large) {
  auto scene = screen_above_floor({0.0f, 0.0f, 0.22f}).scene();
  scene.point_lights = {sun({0.0f, 0.0f, -1.0f})};
  scene.point_lights[0].angular_radius = 0.00465f;
  const auto lines =
      lines_of(scene, {.max_edge = 8.0, .detail = 2.0, .contact_gap = 1e-4, .max_patches = 100'000});
  EXPECT_NEAR(sum_of_lengths(lines), 8.0, 1e-2);
}

TEST(ShadowLines, a_scene_without_lamps_has_the_patches_of_make_patches) {
  const auto scene = screen_above_floor({0.3f, 0.1f, 1.0f}).scene();
  EXPECT_TRUE(lines_of(scene).empty());
  const auto patches = make_patches(scene, {.max_edge = max_edge});
  const auto for_light = make_patches_for_light(scene, {.max_edge = max_edge});
  EXPECT_EQ(patches.vertices, for_light.vertices);
  EXPECT_EQ(patches.corners, for_light.corners);
  EXPECT_EQ(patches.contacts, for_light.contacts);
}

// Leaves above the floor, of 4 cm to 30 cm, at any angle.
Scene leaves(int count) {
  truth::SceneBuilder builder;
  builder.material("floor", 0.5f, 0.0f).quad({-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0});
  builder.material("leaf", 0.5f, 0.0f);
  for (int i = 0; i < count; ++i) {
    const auto u = static_cast<float>(i) * 0.7548777f, v = static_cast<float>(i) * 0.5698403f;
    const auto w = static_cast<float>(i) * 0.3819660f;
    const Vec3 at(3.0f * (u - std::floor(u)) - 1.5f, 3.0f * (v - std::floor(v)) - 1.5f,
                  1.0f + w - std::floor(w));
    const auto size = 0.04f + 0.26f * (w - std::floor(w));
    builder.triangle(at, at + size * Vec3(std::cos(w), std::sin(w), 0.3f),
                     at + size * Vec3(-std::sin(w), std::cos(w), -0.2f));
  }
  auto scene = builder.scene();
  scene.point_lights = {sun({0.2f, 0.1f, -1.0f}), {.name = "lamp", .position = {0.0f, 0.0f, 4.0f}}};
  return scene;
}

TEST(ShadowLines, are_the_same_for_any_number_of_threads) {
  const auto scene = leaves(300);
  const auto one = lines_of(scene, 5000, Context(1));
  const auto four = lines_of(scene, 5000, Context(4));
  ASSERT_EQ(one.size(), four.size());
  EXPECT_GT(one.size(), 100u);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].triangle, four[i].triangle);
    EXPECT_EQ(one[i].ends, four[i].ends);
    EXPECT_EQ(one[i].lit_side, four[i].lit_side);
  }
}

TEST(ShadowLines, add_no_more_patches_than_they_may) {
  const auto scene = leaves(300);
  const auto without = make_patches(scene, {.max_edge = max_edge}).size();
  for (const std::size_t limit : {500u, 2000u, 8000u}) {
    const auto patches = make_patches(scene, {.max_edge = max_edge, .shadow_lines = lines_of(scene, limit)});
    EXPECT_GT(patches.size(), without + limit / 4);
    EXPECT_LT(patches.size(), without + limit + limit / 4);
  }
}

}  // namespace
}  // namespace luxel
