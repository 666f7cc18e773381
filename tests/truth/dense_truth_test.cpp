// SPDX-License-Identifier: Apache-2.0
// The known truth is itself known: rows that sum to one, closed forms, and rooms solved in two ways.
#include "support/dense_truth.h"

#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/patch/side.h"

#include "support/known_rooms.h"
#include "support/truth_scenes.h"

namespace luxel::truth {
namespace {

ConvexPolygon square(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return convex_polygon(std::array{a, b, c, d});
}

double row_sum(const std::vector<double>& factors, SideId side) {
  const auto sides = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(factors.size()))));
  double sum = 0.0;
  for (std::size_t t = 0; t < sides; ++t) sum += factors[side.index() * sides + t];
  return sum;
}

// Maximum deviation of the row sums of these sides from one.
double worst_row(const PatchSet& patches, const std::vector<double>& factors, bool back,
                 const std::string& material = "") {
  double worst = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (material.empty() || patches.material_of(p).name == material)
      worst = std::max(worst, std::abs(row_sum(factors, SideId(p, back)) - 1.0));
  return worst;
}

double mean_of(const KnownRoom& room, const std::string& material) {
  return mean_irradiance(room.patches,
                         {room.truth.irradiance.front.begin(), room.truth.irradiance.front.end()}, material);
}

TEST(DenseTruth, a_point_sees_a_disc_like_polygon_as_the_closed_form_says) {
  std::array<Vec3, 16> corners;  // inscribed in a circle of radius 1, one metre above the point
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const double angle = 2.0 * M_PI * static_cast<double>(k) / 16.0;
    corners[k] = {std::cos(angle), std::sin(angle), 1.0};
  }
  // Lambert: n edges of a regular polygon, each seen under the angle g, tilted by its height h at mid-edge.
  const double h = std::cos(M_PI / 16.0);
  const double g = 2.0 * std::asin(std::sin(M_PI / 16.0) / std::sqrt(2.0));
  const double expected = 16.0 / (2.0 * M_PI) * g * h / std::sqrt(1.0 + h * h);
  EXPECT_NEAR(point_factor({0, 0, 0}, {0, 0, 1}, convex_polygon(corners), {}), expected, 1e-7);
  EXPECT_EQ(point_factor({0, 0, 0}, {0, 0, -1}, convex_polygon(corners), {}), 0.0);
}

TEST(DenseTruth, a_screen_takes_away_exactly_its_own_shadow) {
  const auto sky = square({-4, -4, 2}, {4, -4, 2}, {4, 4, 2}, {-4, 4, 2});
  const auto screen = square({-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1});
  const Vec3d point(0.3, 0.1, 0.0), up(0, 0, 1);
  const auto open = point_factor(point, up, sky, {});
  const auto hidden = point_factor(point, up, screen, {});  // its shadow lies wholly in the sky
  EXPECT_NEAR(point_factor(point, up, sky, std::array{screen}), open - hidden, 1e-14);
  EXPECT_NEAR(point_factor(point, up, sky, std::array{screen, screen}), open - hidden, 1e-14);
  EXPECT_NEAR(point_factor(point, up, screen, std::array{sky, screen}), hidden, 1e-14);
  EXPECT_NEAR(point_factor({0.3, 0.1, 1.5}, up, sky, std::array{screen}),
              point_factor({0.3, 0.1, 1.5}, up, sky, {}), 1e-14);
}

TEST(DenseTruth, opposed_and_adjacent_unit_squares_have_their_textbook_factors) {
  const Context context;
  const auto patches = make_patches(cube_a(), {.max_edge = no_max_edge});
  const auto factors = form_factors(patches, {}, context);
  const auto between = [&](std::size_t wall, std::size_t other) {  // two triangles each
    double sum = 0.0;
    for (std::size_t p = 2 * wall; p < 2 * wall + 2; ++p)
      for (std::size_t q = 2 * other; q < 2 * other + 2; ++q) sum += 0.5 * factors[2 * p * 24 + 2 * q];
    return sum;
  };
  EXPECT_NEAR(between(0, 1), 0.19982489569838746, 2e-7);
  EXPECT_NEAR(between(0, 2), 0.20004377607540316, 2e-7);
  EXPECT_LT(worst_row(patches, factors, false), 1e-7);
}

TEST(DenseTruth, rows_of_a_closed_room_sum_to_one) {
  const Context context;
  const auto patches = make_patches(cube_a(), {.max_edge = 0.26f});
  ASSERT_EQ(patches.size(), 384u);
  const auto factors = form_factors(patches, {}, context);
  EXPECT_LT(worst_row(patches, factors, false), 1e-7);
  for (std::size_t p = 0; p < patches.size(); ++p) EXPECT_EQ(row_sum(factors, SideId(p, true)), 0.0);
}

// Detects wrong shadows: the screen itself must replace what it hides.
TEST(DenseTruth, rows_of_rooms_with_screens_sum_to_one) {
  const Context context;
  const auto l = l_shaped();
  EXPECT_LT(worst_row(l.patches, form_factors(l.patches, l_room_screens(), context), false), 1e-5);
  const auto hung = hung_plate();
  const auto factors = form_factors(hung.patches, hung_plate_screens(), context);
  EXPECT_LT(worst_row(hung.patches, factors, false), 1e-5);
  EXPECT_LT(worst_row(hung.patches, factors, true, "plate"), 1e-5);
}

// The exact means are those of the continuous room. Patches of a quarter metre, of constant radiosity each,
// differ from them: by half a per cent on a ceiling that receives only reflections of its own light, by 1.3 %
// in the L's ends; half of that on patches of half the area.
TEST(DenseTruth, agrees_with_the_exact_means_of_the_enclosures) {
  const auto expect = [](const KnownRoom& room, const std::map<std::string, double>& means,
                         double tolerance) {
    for (const auto& [name, exact] : means)
      EXPECT_NEAR(mean_of(room, name) / exact, 1.0, tolerance) << room.name << ", " << name;
  };
  const auto cube = luminous_ceiling();
  expect(cube, {{"wall_x0", 0.36221119}, {"wall_y1", 0.36221119}}, 0.001);
  expect(cube, {{"floor", 0.34243212}}, 0.002);
  expect(cube, {{"ceiling", 0.20872313}}, 0.006);
  const auto open = open_plates();
  expect(open, {{"upper", 0.20189437848}}, 0.001);
  expect(open, {{"lower", 0.02043611012}}, 0.003);
  const auto l = l_shaped();
  expect(l,
         {{"ceiling", 0.1391531}, {"wall_y0", 0.2038067}, {"inner_y1", 0.3212263}, {"floor_lit", 0.3307676}},
         0.001);
  expect(l, {{"wall_x0", 0.0836591}, {"floor_corner", 0.0966175}}, 0.004);
  expect(l,
         {{"end_x2", 0.1689368}, {"inner_x1", 0.0214627}, {"end_y2", 0.0208882}, {"floor_dark", 0.0312427}},
         0.015);
}

TEST(DenseTruth, a_furnace_shines_with_one_everywhere) {
  auto scene = cube_a();
  const std::array<float, 6> reflectance = {0.2f, 0.8f, 0.5f, 0.3f, 0.65f, 0.1f};
  for (std::size_t k = 0; k < 6; ++k) {
    scene.materials[k].reflectance = Vec3(reflectance[k]);
    scene.materials[k].emittance = Vec3(1.0f - reflectance[k]);
  }
  const Context context;
  const auto patches = make_patches(scene, {.max_edge = 0.5f});
  const auto light = true_light(patches, form_factors(patches, {}, context));
  for (const auto H : light.irradiance.front) EXPECT_NEAR(H, 1.0, 1e-6);
}

// Two cubes that share a wall: one box with a screen across is each of them alone.
TEST(DenseTruth, a_wall_across_a_box_makes_two_rooms) {
  const auto half = [](SceneBuilder& b, float x, bool lamp) {
    b.material("shell", 0.5f, 0.0f);
    b.quad({x, 0, 0}, {x + 1, 0, 0}, {x + 1, 1, 0}, {x, 1, 0});
    b.quad({x, 0, 1}, {x + 1, 0, 1}, {x + 1, 0, 0}, {x, 0, 0});
    b.quad({x, 1, 0}, {x + 1, 1, 0}, {x + 1, 1, 1}, {x, 1, 1});
    b.material(lamp ? "lamp" : "dim lamp", 0.5f, lamp ? 1.0f : 0.1f);
    b.quad({x, 1, 1}, {x + 1, 1, 1}, {x + 1, 0, 1}, {x, 0, 1});
  };
  SceneBuilder b;
  half(b, 0.0f, true);
  half(b, 1.0f, false);
  b.material("left", 0.5f, 0.0f).quad({0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1});
  b.material("right", 0.5f, 0.0f).quad({2, 0, 1}, {2, 1, 1}, {2, 1, 0}, {2, 0, 0});
  b.material("across", 0.5f, 0.0f).quad({1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1});  // faces x = 2
  const Context context;
  KnownRoom room;
  room.patches = make_patches(b.scene(), {.max_edge = 0.51f});
  const auto across = square({1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1});
  room.truth = true_light(room.patches, form_factors(room.patches, {across}, context));

  const auto alone_patches = make_patches(cube_a(), {.max_edge = 0.51f});
  const auto alone = true_light(alone_patches, form_factors(alone_patches, {}, context));
  const std::vector<float> front(alone.irradiance.front.begin(), alone.irradiance.front.end());
  const auto wall = mean_irradiance(alone_patches, front, "wall_x0");
  EXPECT_NEAR(mean_of(room, "left"), wall, 2e-6);
  EXPECT_NEAR(mean_of(room, "right"), 0.1 * wall, 1e-6);
  EXPECT_NEAR(mean_of(room, "across"), 0.1 * wall, 1e-6);
  room.truth.irradiance.front.swap(room.truth.irradiance.back);
  EXPECT_NEAR(mean_of(room, "across"), wall, 2e-6);
}

}  // namespace
}  // namespace luxel::truth
