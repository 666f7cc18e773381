// SPDX-License-Identifier: Apache-2.0
// View factors against the catalogue: counted ones within 4.5 of their standard errors, which with 8
// replicates are exceeded by chance three times in a thousand factors; seeds are fixed, so results are
// reproducible. Closed forms as in Howell's catalogue: C-11 (parallel), C-14 (perpendicular).
#include <cmath>

#include <gtest/gtest.h>

#include "luxel/form_factors/check_view_factors.h"
#include "luxel/form_factors/enforce.h"

#include "support/factor_scenes.h"

namespace luxel::truth {
namespace {

constexpr double opposite = 0.19982489569838746;
constexpr double adjacent = 0.20004377607540316;

bool face_each_other(const std::string& a, const std::string& b) {
  if (a.starts_with("wall")) return b.starts_with("wall") && a[5] == b[5];
  return !b.starts_with("wall");
}

void expect_near(const Factor& factor, double truth, const std::string& which) {
  EXPECT_NEAR(factor.value, truth, 4.5 * factor.standard_error + 1e-9) << which;
}

TEST(ViewFactors, of_the_cube_are_those_of_the_catalogue) {
  const FactorScene cube(cube_a(), Between::materials, ElementSides::front, 0.25f);
  const auto factors = cube.counted({.error = 2e-4});
  EXPECT_EQ(cube.report.stop, StopReason::error_reached);
  EXPECT_LE(cube.report.error, 2e-4);
  ASSERT_EQ(factors.size(), 6u);
  EXPECT_EQ(factors.count(), 30u) << "no wall sees itself";
  for (const auto& a : factors.name)
    for (const auto& b : factors.name)
      if (a != b)
        expect_near(factor(factors, a, b), face_each_other(a, b) ? opposite : adjacent, a + " " + b);
}

TEST(ViewFactors, exact_ones_have_nine_digits) {
  const FactorScene cube(cube_a(), Between::materials);
  const auto factors = cube.exact();
  for (const auto& a : factors.name) {
    EXPECT_NEAR(row_sum(factors, element(factors, a)), 1.0, 1e-9);
    for (const auto& b : factors.name)
      if (a != b) {
        EXPECT_NEAR(factor(factors, a, b).value, face_each_other(a, b) ? opposite : adjacent, 1e-9);
      }
  }
}

TEST(ViewFactors, what_leaves_plates_at_the_edges_goes_to_the_environment) {
  for (const auto& [gap, truth] : {std::pair{1.0f, opposite},
                                   {0.5f, 0.4152532835771469},
                                   {0.1f, 0.8269945223972565},
                                   {0.01f, 0.9804166029259733}}) {
    const FactorScene plates(plates_with_shield(gap, false), Between::materials);
    const auto factors = plates.counted({.error = 5e-4});
    expect_near(factor(factors, "hot", "cold"), truth, "plates");
    EXPECT_NEAR(factors.sink[ViewFactors::environment].factor[0], 1.0 - factor(factors, 0, 1).value, 1e-12);
  }
}

TEST(ViewFactors, a_shield_hides_all_or_the_part_behind_it) {
  const FactorScene whole(plates_with_shield(0.1f, true), Between::materials, ElementSides::both);
  const auto factors = whole.counted({.error = 5e-4});
  ASSERT_EQ(factors.name, (std::vector<std::string>{"hot", "cold", "shield", "shield:back"}));
  EXPECT_LT(factor(factors, "hot", "cold").value, 0.02) << "at the edge alone";
  EXPECT_EQ(factor(factors, "hot", "shield").value, 0.0) << "the front looks to the cold plate";
  expect_near(factor(factors, "hot", "shield:back"), 0.907853142480072, "C-11 at half the gap");
  expect_near(factor(factors, "shield", "cold"), 0.907853142480072, "C-11 at half the gap");

  // Half a shield: counted and exact factors, which are computed independently, agree.
  const FactorScene half(plates_with_shield(0.1f, true, 0.5f), Between::materials, ElementSides::both, 0.5f);
  const auto counted = half.counted({.error = 2e-4});
  const auto exact = half.exact();
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const auto a = factor(counted, i, j), b = factor(exact, i, j);
      EXPECT_NEAR(a.value, b.value, 4.5 * a.standard_error + 3.0 * b.standard_error + 1e-9) << i << ' ' << j;
    }
}

TEST(ViewFactors, with_fronts_alone_the_rest_is_told_as_backs) {
  const FactorScene plates(plates_with_shield(0.1f, true), Between::materials);
  const auto factors = plates.counted({.error = 5e-4});
  ASSERT_EQ(factors.size(), 3u);
  EXPECT_NEAR(factors.sink[ViewFactors::backs].factor[0], 0.907853142480072, 0.005);
  EXPECT_NEAR(row_sum(factors, 0), 1.0, 1e-12);
}

// Net heat that leaves each element, W, and the emissive power of the last two, which are the sides of one
// sheet that keeps no heat: J = e E + (1 - e) F J, q = A (J - F J), by iteration. E: W/m².
struct Network {
  double from_hot = 0.0, to_cold = 0.0;
};
Network solve_network(const ViewFactors& f, double emissivity) {
  std::vector<double> e = {1.0, 0.0, 0.0, 0.0}, radiosity(4, 0.0), arriving(4, 0.0);
  for (int step = 0; step < 20000; ++step) {
    for (std::size_t i = 0; i < 4; ++i) {
      arriving[i] = 0.0;
      for (auto at = f.row_begin[i]; at < f.row_begin[i + 1]; ++at)
        arriving[i] += f.factor[at] * radiosity[f.column[at]];
    }
    e[2] = e[3] = (f.area[2] * arriving[2] + f.area[3] * arriving[3]) / (f.area[2] + f.area[3]);
    for (std::size_t i = 0; i < 4; ++i) radiosity[i] = emissivity * e[i] + (1.0 - emissivity) * arriving[i];
  }
  return {f.area[0] * (radiosity[0] - arriving[0]), f.area[1] * (arriving[1] - radiosity[1])};
}

TEST(ViewFactors, give_the_heat_that_the_textbook_has_for_a_closed_shield) {
  // A hot box within a shield within a cold box. All that leaves the inner meets the outer, so the
  // resistances add up: (1 - e)/(e A) at a surface, 1/A of the inner between two (Incropera and others,
  // "radiation shields").
  SceneBuilder b;
  b.material("hot", 0.5f, 0.0f, false);
  add_cube(b, 0.5f, true);
  b.material("cold", 0.5f, 0.0f, false);
  add_cube(b, 1.0f, false);
  b.material("shield", 0.5f, 0.0f);
  add_cube(b, 0.75f, true);
  const FactorScene boxes(b.scene(), Between::materials, ElementSides::both);
  auto factors = boxes.counted({.error = 5e-4});
  enforce_laws(factors, boxes.context);
  EXPECT_NEAR(factor(factors, "hot", "shield:back").value, 1.0, 1e-9);
  EXPECT_NEAR(factor(factors, "shield:back", "hot").value, 1.0 / 2.25, 1e-9) << "by reciprocity";
  EXPECT_NEAR(factor(factors, "cold", "shield").value, 2.25 / 4.0, 1e-9);
  constexpr double emissivity = 0.3;
  const double hot = 6.0, shield = 6.0 * 2.25, cold = 6.0 * 4.0, surface = (1.0 - emissivity) / emissivity;
  const auto resistance = surface / hot + 1.0 / hot + 2.0 * surface / shield + 1.0 / shield + surface / cold;
  const auto heat = solve_network(factors, emissivity);
  EXPECT_NEAR(heat.from_hot, 1.0 / resistance, 1e-6);
  EXPECT_NEAR(heat.to_cold, 1.0 / resistance, 1e-6) << "nothing is lost on the way";
}

TEST(ViewFactors, give_half_the_heat_between_near_plates_with_a_shield) {
  // 1 m plates 10 mm apart are nearly endless ones: q = (E1 - E2) / ((n + 1) (2/e - 1)). What leaves at the
  // edges, 1 % on each side of the shield, is the difference.
  const FactorScene plates(plates_with_shield(0.01f, true), Between::materials, ElementSides::both);
  auto factors = plates.counted({.error = 5e-4});
  enforce_laws(factors, plates.context);
  constexpr double emissivity = 0.8;
  const auto endless = 1.0 / (2.0 * (2.0 / emissivity - 1.0));
  const auto heat = solve_network(factors, emissivity);
  EXPECT_NEAR(heat.to_cold, endless, 0.03 * endless);
  EXPECT_LT(heat.to_cold, heat.from_hot);
}

TEST(ViewFactors, between_patches_agree_with_closed_forms_and_keep_the_laws) {
  const FactorScene room(l_room(), Between::patches, ElementSides::front, 1.0f);
  const auto counted = room.counted({.rays = 4096, .error = 0.0});
  const auto exact = room.exact();
  double squares = 0.0, expected = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    EXPECT_NEAR(row_sum(counted, i), 1.0, 1e-12);
    for (std::size_t j = 0; j < exact.size(); ++j) {
      const auto a = factor(counted, i, j), b = factor(exact, i, j);
      squares += (a.value - b.value) * (a.value - b.value);
      expected += a.standard_error * a.standard_error;
      // 8 replicates of 512 rays count whole rays: all may be off by one alike, and their spread be 0.
      EXPECT_NEAR(a.value, b.value, 6.0 * a.standard_error + 1.0 / 512 + 1e-4) << i << ' ' << j;
    }
  }
  // Over some thousand factors: 1 within a few per cent.
  EXPECT_NEAR(squares / expected, 1.0, 0.2);
  const auto check = check_view_factors(counted, room.context);
  EXPECT_NEAR(check.reciprocity / check.expected_reciprocity, 1.0, 0.2);
  EXPECT_LE(check.largest, 1.0);
}

TEST(ViewFactors, of_patches_are_counted_until_a_row_is_known_and_their_number_is_foretold) {
  const FactorScene room(l_room(), Between::patches, ElementSides::front, 0.2f);
  auto factors = room.counted({.error = 0.0, .row_error = 0.04, .is_enforced = true});
  EXPECT_EQ(room.report.stop, StopReason::error_reached);
  EXPECT_LE(room.report.row_error, 0.04);
  EXPECT_EQ(room.report.rays_per_side, 1024u) << "1 / 0.04² is 625";
  const auto predicted = static_cast<double>(room.report.predicted_factors);
  const auto done = enforce_laws(factors, room.context);
  EXPECT_EQ(done.count, factors.count());
  EXPECT_NEAR(predicted / static_cast<double>(factors.count()), 1.0, 0.15);
}

TEST(ViewFactors, dropped_ones_keep_their_sum) {
  const FactorScene room(l_room(), Between::patches, ElementSides::front, 1.0f);
  const auto all = room.counted({.rays = 1024, .error = 0.0});
  const auto some = room.counted({.rays = 1024, .error = 0.0, .min_factor = 0.01});
  EXPECT_LT(some.count(), all.count());
  for (std::size_t i = 0; i < some.size(); ++i) {
    EXPECT_NEAR(row_sum(some, i), 1.0, 1e-12);
    for (auto at = some.row_begin[i]; at < some.row_begin[i + 1]; ++at) {
      EXPECT_GE(some.factor[at], 0.01);
      EXPECT_EQ(some.factor[at], factor(all, i, some.column[at]).value);
    }
  }
}

}  // namespace
}  // namespace luxel::truth
