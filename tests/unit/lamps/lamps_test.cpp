// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/lamps.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "luxel/core/address.h"
#include "luxel/lamps/lamp_sample.h"
#include "luxel/lamps/light_tree.h"
#include "luxel/lamps/polygon_irradiance.h"
#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

LampTriangle lamp_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  truth::SceneBuilder builder;
  builder.material("lamp", 0.5f, static_cast<float>(M_PI)).triangle(a, b, c);
  return Lamps(make_patches(builder.scene(), {.max_edge = no_max_edge})).triangles()[0];
}

// Irradiance at unit radiance by cutting the lamp into n² triangles.
double by_quadrature(const LampTriangle& lamp, const Vec3d& x, const Vec3d& n, int cuts) {
  const auto a = Vec3d(lamp.corner[0]);
  const auto ab = (Vec3d(lamp.corner[1]) - a) / static_cast<double>(cuts);
  const auto ac = (Vec3d(lamp.corner[2]) - a) / static_cast<double>(cuts);
  double sum = 0.0;
  const auto add = [&](double i, double j) {
    const auto to = a + i * ab + j * ac - x;
    const auto r2 = glm::dot(to, to);
    sum += std::max(0.0, glm::dot(n, to)) * std::max(0.0, -glm::dot(lamp.normal, to)) / (r2 * r2);
  };
  for (int i = 0; i < cuts; ++i)
    for (int j = 0; i + j < cuts; ++j) {
      add(i + 1.0 / 3.0, j + 1.0 / 3.0);
      if (i + j + 2 <= cuts) add(i + 2.0 / 3.0, j + 2.0 / 3.0);
    }
  return sum * lamp.area / (static_cast<double>(cuts) * cuts);
}

Vec3d direction(std::uint64_t i) {
  const auto u = uniform4(stream_key(5, 0, 0), i);
  return glm::normalize(Vec3d(u[0] - 0.5, u[1] - 0.5, u[2] - 0.5));
}

TEST(Lamps, patches_of_one_triangle_are_joined_again) {
  truth::SceneBuilder builder;
  builder.material("dark", 0.5f, 0.0f).triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  builder.material("lamp", 0.5f, 3.0f).quad({0, 0, 2}, {0, 3, 2.5f}, {2, 3, 2.5f}, {2, 0, 2});
  const auto patches = make_patches(builder.scene(), {.max_edge = 0.1f});
  const Lamps lamps(patches);
  ASSERT_EQ(lamps.size(), 2u);
  EXPECT_TRUE(lamps.one_colour());
  for (const auto& lamp : lamps.triangles()) {
    EXPECT_NEAR(lamp.area, std::hypot(3.0, 0.5), 1e-6);
    EXPECT_LT(lamp.normal.z, -0.9);
    EXPECT_NEAR(lamp.weight, 9.0 / M_PI, 1e-6);
  }
  EXPECT_FLOAT_EQ(lamps.radiance(1)[2], static_cast<float>(3.0 / M_PI));
  for (std::size_t p = 0; p < patches.size(); ++p)
    EXPECT_EQ(lamps.lamp_at(p, patches.points(p)[0]),
              patches.triangle[p] == 0 ? none : patches.triangle[p] - 1);
}

TEST(Lamps, two_colours_are_noticed) {
  truth::SceneBuilder builder;
  builder.material("red", Vec3(0.5f), Vec3(2, 1, 1)).triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  builder.material("red_too", Vec3(0.5f), Vec3(4, 2, 2)).triangle({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
  EXPECT_TRUE(Lamps(make_patches(builder.scene())).one_colour());
  builder.material("blue", Vec3(0.5f), Vec3(1, 1, 2)).triangle({0, 0, 2}, {1, 0, 2}, {0, 1, 2});
  EXPECT_FALSE(Lamps(make_patches(builder.scene())).one_colour());
}

TEST(UnitIrradiance, agrees_with_quadrature_for_any_normal) {
  const auto lamp = lamp_of({0, 0, 2}, {0.3f, 1.5f, 2.2f}, {1, 0.2f, 1.7f});
  for (std::uint64_t i = 0; i < 200; ++i) {
    const auto n = direction(i);
    const auto x = Vec3d(0.3, 0.4, 1.0) + 0.7 * direction(1000 + i);
    EXPECT_NEAR(unit_irradiance(lamp, x, n), by_quadrature(lamp, x, n, 200), 1e-4) << i;
  }
}

TEST(UnitIrradiance, a_lamp_that_fills_the_view_gives_pi) {
  const auto lamp = lamp_of({-1000, -1000, 1}, {0, 2000, 1}, {1000, -1000, 1});
  for (const double gap : {1e-1, 1e-3, 1e-6, 1e-9})
    EXPECT_NEAR(unit_irradiance(lamp, {0, 0, 1 - gap}, {0, 0, 1}), M_PI, 1e-6);
}

TEST(UnitIrradiance, is_zero_behind_the_lamp_in_its_plane_and_below_the_horizon) {
  const auto lamp = lamp_of({0, 0, 1}, {0, 1, 1}, {1, 0, 1});
  EXPECT_EQ(unit_irradiance(lamp, {0.2, 0.2, 1.5}, {0, 0, -1}), 0.0);
  EXPECT_EQ(unit_irradiance(lamp, {0.2, 0.2, 1.0}, {0, 0, 1}), 0.0);
  EXPECT_EQ(unit_irradiance(lamp, {0.0, 0.5, 1.0}, {1, 0, 0}), 0.0);
  EXPECT_EQ(unit_irradiance(lamp, {0.2, 0.2, 0.0}, {0, 0, -1}), 0.0);
}

// A wall that meets the lamp's edge at a right angle sees half of a quarter space: half of pi at the edge.
TEST(UnitIrradiance, is_finite_and_right_up_to_the_edge) {
  const auto lamp = lamp_of({0, -500, 1}, {0, 500, 1}, {500, 0, 1});
  for (const double gap : {1e-3, 1e-6, 1e-9, 1e-12})
    EXPECT_NEAR(unit_irradiance(lamp, {0, 0, 1 - gap}, {1, 0, 0}), M_PI / 2, 4e-3);
  const auto at_corner = unit_irradiance(lamp, {0, -500, 1 - 1e-12}, {0, 1, 0});
  EXPECT_TRUE(at_corner >= 0.0 && at_corner <= M_PI);
}

TEST(UnitIrradiance, a_far_lamp_gives_area_times_cosines_over_distance_squared) {
  const auto lamp = lamp_of({0, 0, 0}, {0, 1e-3f, 0}, {1e-3f, 0, 0});
  const Vec3d x(0, 0, -10);
  EXPECT_NEAR(unit_irradiance(lamp, x, {0, 0, 1}) / (lamp.area / 100.0), 1.0, 1e-6);
}

// The mean of cosine over density is the closed form; of one over density, the solid angle: the same one
// whichever corner the warp begins with.
TEST(LampSample, density_and_samples_agree_with_the_closed_form) {
  const auto lamp = lamp_of({0, 0, 2}, {0.3f, 1.5f, 2.2f}, {1, 0.2f, 1.7f});
  for (const auto& x :
       {Vec3d(0.3, 0.4, 1.0), Vec3d(0.3, 0.5, 1.9), Vec3d(0.4, 0.5, -20), Vec3d(-2, 0.5, 1.9)}) {
    const auto n = glm::normalize(Vec3d(0.45, 0.5, 2.0) - x);
    constexpr int side = 400;
    double sum = 0.0;
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j) {
        const auto sample = sample_lamp(lamp, x, (i + 0.5) / side, (j + 0.5) / side);
        ASSERT_GT(sample.density, 0.0);
        ASSERT_NEAR(glm::length(sample.direction), 1.0, 1e-12);
        ASSERT_NEAR(lamp_density(lamp, x, sample.direction) / sample.density, 1.0, 1e-9);
        const auto point = x + sample.distance * sample.direction;
        ASSERT_NEAR(glm::dot(lamp.normal, point - Vec3d(lamp.corner[0])), 0.0, 1e-9);
        sum += std::max(0.0, glm::dot(n, sample.direction)) / sample.density;
      }
    const auto expected = unit_irradiance(lamp, x, n);
    EXPECT_NEAR(sum / (side * side), expected, 2e-4 * expected);
  }
}

// Equal intervals of the random numbers cover equal solid angles: tests moments of the direction, not only
// its cosine.
TEST(LampSample, directions_are_uniform_in_solid_angle) {
  const auto lamp = lamp_of({0, 0, 2}, {0.3f, 1.5f, 2.2f}, {1, 0.2f, 1.7f});
  const Vec3d x(0.3, 0.5, 1.8);
  constexpr int side = 500;
  for (std::uint64_t k = 0; k < 5; ++k) {
    const auto n = direction(k);
    double sum = 0.0;
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j) {
        const auto sample = sample_lamp(lamp, x, (i + 0.5) / side, (j + 0.5) / side);
        sum += std::max(0.0, glm::dot(n, sample.direction)) / sample.density;
      }
    EXPECT_NEAR(sum / (side * side), unit_irradiance(lamp, x, n), 5e-4) << k;
  }
}

TEST(LampSample, slivers_and_specks_and_grazing_views_keep_their_digits) {
  for (const float size : {1.0f, 1e-2f, 1e-4f})
    for (const float thin : {1.0f, 1e-3f}) {
      const auto lamp = lamp_of({0, 0, 0}, {0, size, 0}, {size * thin, 0, 0});
      for (const double height : {1.0, 1e-2, 1e-4}) {
        const Vec3d x(0.3 * size, 0.2 * size, -height * size);
        const Vec3d n(0, 0, 1);
        constexpr int side = 200;
        double sum = 0.0;
        for (int i = 0; i < side; ++i)
          for (int j = 0; j < side; ++j) {
            const auto sample = sample_lamp(lamp, x, (i + 0.5) / side, (j + 0.5) / side);
            sum += std::max(0.0, glm::dot(n, sample.direction)) / sample.density;
          }
        const auto expected = unit_irradiance(lamp, x, n);
        EXPECT_NEAR(sum / (side * side), expected, 0.01 * expected) << size << ' ' << thin << ' ' << height;
      }
    }
}

// Three hundred small ones on a sphere, facing anywhere.
Lamps scattered_lamps() {
  truth::SceneBuilder builder;
  builder.material("lamp", 0.5f, 1.0f);
  for (std::uint64_t i = 0; i < 300; ++i) {
    const auto at = Vec3(3.0 * direction(3 * i));
    builder.triangle(at, at + 0.2f * Vec3(direction(3 * i + 1)), at + 0.2f * Vec3(direction(3 * i + 2)));
  }
  return Lamps(make_patches(builder.scene(), {.max_edge = no_max_edge}));
}

// Probabilities add up to one over the whole range of the number that chooses.
TEST(LightTree, a_lamp_is_chosen_with_the_probability_that_is_said) {
  const auto lamps = scattered_lamps();
  const LightTree tree(lamps);
  std::vector<LampBranch> whole;
  const Vec3 x(0.5f, 0, 0);
  const Vec3 n(0, 0, 1);
  tree.cut(x, 0.0f, n, 1, false, whole);
  ASSERT_EQ(whole.size(), 1u);
  for (const bool by_area : {false, true}) {
    std::vector<double> said(lamps.size(), 0.0);
    std::vector<double> chosen(lamps.size(), 0.0);
    constexpr int tries = 1'000'000;
    for (int i = 0; i < tries; ++i) {
      const auto choice = tree.choose(whole[0], x, n, (i + 0.5) / tries, by_area);
      if (!(choice.probability > 0.0)) continue;
      chosen[choice.lamp] += 1.0 / tries;
      said[choice.lamp] = choice.probability;
      ASSERT_TRUE(choice.rest >= 0.0 && choice.rest < 1.0);
    }
    for (std::size_t i = 0; i < lamps.size(); ++i) {
      EXPECT_NEAR(chosen[i], said[i], 3e-6);
      const auto lamp = static_cast<std::uint32_t>(i);
      EXPECT_TRUE(tree.holds(whole[0], lamp));
      EXPECT_NEAR(tree.probability(whole[0], lamp, x, n, by_area), said[i], 1e-9);
      if (unit_irradiance(lamps.triangles()[i], Vec3d(x), Vec3d(n)) > 0.0) {
        EXPECT_GT(said[i], 0.0) << i;
      }
    }
  }
}

TEST(LightTree, a_cut_holds_every_lamp_that_may_light_the_patch_once) {
  const auto lamps = scattered_lamps();
  const LightTree tree(lamps);
  std::vector<LampBranch> branches;
  const Vec3 x(0.5f, 0, 0);
  const Vec3 n(0, 0, 1);
  tree.cut(x, 0.1f, n, 10'000, false, branches);
  std::vector<int> times(lamps.size(), 0);
  for (const auto& branch : branches) {
    ASSERT_TRUE(branch.single);
    ++times[branch.index];
  }
  EXPECT_LT(branches.size(), lamps.size());
  EXPECT_EQ(*std::max_element(times.begin(), times.end()), 1);
  for (std::uint64_t k = 0; k < 20; ++k) {
    const auto near = Vec3d(x) + 0.0999 * direction(k);
    for (std::size_t i = 0; i < lamps.size(); ++i)
      if (unit_irradiance(lamps.triangles()[i], near, Vec3d(n)) > 1e-9) {
        EXPECT_EQ(times[i], 1) << i;
      }
  }
  tree.cut(x, 0.1f, n, 20, false, branches);
  EXPECT_LE(branches.size(), 20u);
}

}  // namespace
}  // namespace luxel
