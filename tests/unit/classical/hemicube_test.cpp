// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/hemicube.h"

#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <string>

#include <gtest/gtest.h>

#include "luxel/classical/hemicube_pixels.h"
#include "luxel/core/error.h"
#include "luxel/lamps/polygon_irradiance.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/side.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

double sum_of(const FormFactorRow& row) {
  return std::accumulate(
      row.entries.begin(), row.entries.end(), row.escaped,
      [](double sum, const auto& entry) { return sum + static_cast<double>(entry.factor); });
}

// Sums of the factors of each material's fronts, and of its backs under its name and " back".
std::map<std::string, double> by_material(const PatchSet& patches, const FormFactorRow& row) {
  std::map<std::string, double> sums;
  for (const auto& entry : row.entries)
    sums[patches.material_of(entry.side.patch()).name + (!entry.side.is_back() ? "" : " back")] +=
        static_cast<double>(entry.factor);
  return sums;
}

TEST(HemicubePixels, are_worth_one_together_and_each_its_integral) {
  for (const int n : {2, 4, 64, 512}) {
    const auto pixels = make_hemicube_pixels(n);
    const auto top = std::accumulate(pixels.top.begin(), pixels.top.end(), 0.0);
    const auto side = std::accumulate(pixels.side.begin(), pixels.side.end(), 0.0);
    EXPECT_NEAR(top + 4.0 * side, 1.0, 1e-12) << n;
    EXPECT_NEAR(top, 4.0 * 0.13853160599489298, 1e-12);
  }
  const auto pixels = make_hemicube_pixels(16);
  // Each against the point's closed form for the same rectangle.
  for (std::size_t j = 0; j < 16; ++j)
    for (std::size_t i = 0; i < 16; ++i) {
      const auto u = -1.0 + static_cast<double>(i) / 8.0, v = -1.0 + static_cast<double>(j) / 8.0,
                 h = 1.0 / 8.0;
      const std::array<Vec3d, 4> above = {Vec3d(u, v, 1), Vec3d(u, v + h, 1), Vec3d(u + h, v + h, 1),
                                          Vec3d(u + h, v, 1)};
      EXPECT_NEAR(pixels.top[16 * j + i], unit_irradiance(above, {0, 0, 0}, {0, 0, 1}) / M_PI, 1e-15);
      if (j >= 8) continue;
      const auto z = static_cast<double>(j) / 8.0;
      const std::array<Vec3d, 4> aside = {Vec3d(1, u, z), Vec3d(1, u, z + h), Vec3d(1, u + h, z + h),
                                          Vec3d(1, u + h, z)};
      EXPECT_NEAR(pixels.side[16 * j + i], unit_irradiance(aside, {0, 0, 0}, {0, 0, 1}) / M_PI, 1e-15);
    }
}

TEST(Hemicube, nothing_escapes_a_closed_room_and_rows_sum_to_one) {
  for (const auto& scene :
       {truth::cube_a(), truth::l_room(), truth::sphere(16, 0.5f), truth::furnace(Vec3(0.5f), Vec3(0.5f))}) {
    const auto patches = make_patches(scene, {.max_edge = 0.3f});
    Hemicube hemicube(patches, {.resolution = 64});
    FormFactorRow row;
    for (std::size_t p = 0; p < patches.size(); p += 7) {
      hemicube.row(SideId(p, false), row);
      EXPECT_EQ(row.escaped, 0.0) << p;
      EXPECT_NEAR(sum_of(row), 1.0, 1e-6);
      for (std::size_t k = 0; k < row.entries.size(); ++k) {
        EXPECT_EQ(row.entries[k].side.is_back(), 0u);  // backs are outside
        EXPECT_NE(row.entries[k].side, SideId(p, false));
        EXPECT_TRUE(k == 0 || row.entries[k - 1].side < row.entries[k].side);
      }
    }
  }
}

TEST(Hemicube, a_point_under_a_plate_sees_what_the_closed_form_says) {
  truth::SceneBuilder b;
  b.material("small", 0.5f, 0.0f).triangle({0.499f, 0.499f, 0}, {0.501f, 0.499f, 0}, {0.5f, 0.502f, 0});
  b.material("plate", 0.5f, 0.0f).quad({0, 0, 0.25f}, {0, 1, 0.25f}, {1, 1, 0.25f}, {1, 0, 0.25f});
  b.material("above", 0.5f, 0.0f).quad({-4, -4, 1}, {-4, 5, 1}, {5, 5, 1}, {5, -4, 1});
  const auto patches = make_patches(b.scene(), {.max_edge = no_max_edge});
  FormFactorRow row;
  Hemicube(patches, {.resolution = 512}).row(SideId(0, false), row);
  auto factors = by_material(patches, row);
  EXPECT_NEAR(factors["plate"], 0.8310285001567376, 2e-3);  // hides the other from the middle
  EXPECT_EQ(factors.count("plate back"), 0u);
  EXPECT_GT(factors["above"], 0.05);
  EXPECT_NEAR(sum_of(row), 1.0, 1e-6);
  EXPECT_GT(row.escaped, 0.0);
  Hemicube(patches).row(SideId(0, true), row);  // downwards is nothing
  EXPECT_TRUE(row.entries.empty());
  EXPECT_NEAR(row.escaped, 1.0, 1e-12);
  Hemicube(patches).row(SideId(3, false), row);  // the plate before `above` looks down past it, from behind
  factors = by_material(patches, row);
  EXPECT_GT(factors["plate back"], 0.002);
}

TEST(Hemicube, more_points_tell_near_patches_better) {
  const auto patches = make_patches(truth::cube_a(), {.max_edge = no_max_edge});
  const auto floor_to_wall = [&](int points, int resolution) {
    Hemicube hemicube(patches, {.resolution = resolution, .points = points});
    double sum = 0.0;
    for (const auto side : {SideId(0, false), SideId(1, false)}) {
      FormFactorRow row;
      hemicube.row(side, row);
      sum += 0.5 * by_material(patches, row)["wall_x0"];
      EXPECT_NEAR(sum_of(row), 1.0, 1e-6);
    }
    return sum;
  };
  const auto exact = 0.20004377607540316;
  EXPECT_GT(std::fabs(floor_to_wall(1, 256) - exact), 5e-3);
  EXPECT_NEAR(floor_to_wall(256, 256), exact, 1e-3);
}

TEST(Hemicube, patches_that_cross_the_horizon_or_the_eye_s_plane_are_drawn) {
  truth::SceneBuilder b;
  b.material("small", 0.5f, 0.0f).triangle({-0.01f, -0.01f, 0}, {0.01f, -0.01f, 0}, {0, 0.02f, 0});
  // One huge triangle round the corner of everything: from far below to far above, on one side.
  b.material("wall", 0.5f, 0.0f).triangle({1, 1000, -1000}, {1, 0, 3000}, {1, -1000, -1000});
  const auto patches = make_patches(b.scene(), {.max_edge = no_max_edge});
  FormFactorRow row;
  Hemicube(patches, {.resolution = 256}).row(SideId(0, false), row);
  ASSERT_EQ(row.entries.size(), 1u);
  EXPECT_NEAR(row.entries[0].factor, 0.5, 3e-3);  // half of all that it sees
  EXPECT_NEAR(row.escaped, 0.5, 3e-3);
}

TEST(Hemicube, what_has_no_area_sees_nothing_and_bad_options_are_refused) {
  auto patches = make_patches(truth::cube_a(), {.max_edge = no_max_edge});
  patches.vertices[patches.corners[0][2]] = patches.vertices[patches.corners[0][0]];
  FormFactorRow row;
  Hemicube hemicube(patches, {.resolution = 32});
  hemicube.row(SideId(0, false), row);
  EXPECT_TRUE(row.entries.empty());
  EXPECT_EQ(row.escaped, 1.0);
  hemicube.row(SideId(2, false), row);
  for (const auto& entry : row.entries) EXPECT_GT(entry.side.patch(), 0u);
  EXPECT_THROW(Hemicube(patches, {.resolution = 0}), InputError);
  EXPECT_THROW(Hemicube(patches, {.resolution = 63}), InputError);
  EXPECT_THROW(Hemicube(patches, {.resolution = 8192}), InputError);
  EXPECT_THROW(Hemicube(patches, {.points = 5}), InputError);
}

TEST(Hemicube, a_row_does_not_depend_on_the_rows_before) {
  const auto patches = make_patches(truth::l_room(), {.max_edge = 0.5f});
  Hemicube used(patches, {.resolution = 32});
  FormFactorRow row, again;
  for (std::size_t side = 0; side < 40; ++side) used.row(SideId::at(side), row);
  used.row(SideId(5, false), row);
  Hemicube(patches, {.resolution = 32}).row(SideId(5, false), again);
  ASSERT_EQ(row.entries.size(), again.entries.size());
  for (std::size_t k = 0; k < row.entries.size(); ++k) {
    EXPECT_EQ(row.entries[k].side, again.entries[k].side);
    EXPECT_EQ(row.entries[k].factor, again.entries[k].factor);
  }
}

}  // namespace
}  // namespace luxel
