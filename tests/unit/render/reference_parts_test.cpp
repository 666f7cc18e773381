// SPDX-License-Identifier: Apache-2.0
// The parts of path tracing.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/side.h"
#include "luxel/render/batch_means.h"
#include "luxel/render/lamp_table.h"
#include "luxel/render/strata.h"

#include "support/chi_square.h"
#include "support/truth_scenes.h"

namespace luxel {
namespace {

PatchSet two_lamps() {
  truth::SceneBuilder b;
  b.material("strong", Vec3(0.5f), {3.0f, 0.0f, 0.0f}).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  b.material("weak", Vec3(0.5f), {0.0f, 0.5f, 0.5f}).quad({0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {0, 1, 1});
  b.material("wall", 0.5f, 0.0f).quad({0, 0, 2}, {2, 0, 2}, {2, 1, 2}, {0, 1, 2});
  return make_patches(b.scene(), {.max_edge = 0.5f});
}

TEST(LampTable, chooses_patches_by_their_power_as_its_density_says) {
  const auto patches = two_lamps();
  const LampTable lamps(patches);
  std::vector<std::size_t> counts(patches.size(), 0);
  constexpr std::size_t n = 100'000;
  for (std::size_t i = 0; i < n; ++i) {
    const auto u = uniform4(stream_key(1, 0, 0), i);
    const auto point = lamps.sample(patches, {u[0], u[1], u[2]});
    EXPECT_FALSE(point.back);
    ++counts[point.patch];
  }
  double chi2 = 0.0;
  double whole = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto fraction = lamps.density(patches, p) * static_cast<double>(patches.area[p]);
    whole += fraction;
    if (fraction == 0.0) {
      EXPECT_EQ(counts[p], 0u);
      continue;
    }
    const auto expected = fraction * static_cast<double>(n);
    chi2 +=
        (static_cast<double>(counts[p]) - expected) * (static_cast<double>(counts[p]) - expected) / expected;
  }
  EXPECT_NEAR(whole, 1.0, 1e-6);
  EXPECT_LT(chi2, statistics::chi_square_limit(static_cast<double>(lamps.size() - 1)));
}

TEST(SurfacePoint, lies_before_its_side_and_inside_its_patch) {
  const auto patches = two_lamps();
  for (const bool back : {false, true})
    for (const auto& weights : {Vec2(0.0f), Vec2(1.0f, 0.0f), Vec2(0.0f, 1.0f), Vec2(0.3f, 0.3f)}) {
      const auto point = surface_point(patches, 9, back, weights);
      const auto above = glm::dot(point.position - patches.points(9)[0], patches.normal[9]);
      EXPECT_EQ(above < 0.0f, back);
      EXPECT_NE(above, 0.0f);
      EXPECT_LT(std::abs(above), 1e-4f);
      EXPECT_EQ(point.normal, back ? -patches.normal[9] : patches.normal[9]);
    }
}

TEST(Strata, have_one_sample_in_each_cell_and_orders_of_their_own) {
  for (const auto side : {1u, 4u, 7u}) {
    const Strata pairs(99, 1, side), others(99, 2, side);
    std::vector<int> count(side * side, 0);
    bool differ = side == 1;
    for (std::uint32_t i = 0; i < side * side; ++i) {
      const auto p = pairs.pair(i, 0.999999f, 0.5f);
      ASSERT_LT(p.x, 1.0f);
      ++count[static_cast<std::size_t>(p.x * static_cast<float>(side)) +
              side * static_cast<std::size_t>(p.y * static_cast<float>(side))];
      differ |= p != others.pair(i, 0.999999f, 0.5f);
    }
    for (const auto c : count) EXPECT_EQ(c, 1);
    EXPECT_TRUE(differ);
  }
}

TEST(Strata, of_one_sample_are_uniform_over_keys) {
  std::vector<std::size_t> counts(16, 0);
  for (std::uint64_t key = 0; key < 16'000; ++key)
    ++counts[static_cast<std::size_t>(16.0f * Strata(mix64(key), 3, 4).number(5, 0.5f))];
  EXPECT_LT(statistics::chi_square(counts, 1000.0), statistics::chi_square_limit(15.0));
}

// Batches whose sums are known numbers.
TEST(BatchMeans, have_the_mean_and_the_variance_of_what_was_drawn) {
  BatchMeans means(3, 1);
  const auto draw = [](std::size_t element, std::uint64_t batch, std::span<double> sums) {
    sums[0] = static_cast<double>(BatchMeans::batch_paths) * static_cast<double>(element + batch % 2);
    return std::uint64_t{2};
  };
  const Context context;
  const auto stop = means.run(
      {.samples = 130}, draw, [](const BatchMeans&) { return 1.0; }, context, "light");
  EXPECT_EQ(stop, StopReason::ray_limit);
  EXPECT_EQ(means.rays(), 3u * 2u * 9u) << "130 paths are nine batches";
  EXPECT_TRUE(means.complete());
  for (std::size_t e = 0; e < 3; ++e) {
    EXPECT_NEAR(means.mean(e, 0), static_cast<double>(e) + 4.0 / 9.0, 1e-12);
    EXPECT_NEAR(means.variance(e, 0), (20.0 / 81.0) / 8.0, 1e-12);
  }
}

TEST(BatchMeans, go_on_until_the_error_is_reached_and_not_far_beyond) {
  BatchMeans means(1, 1);
  const auto draw = [](std::size_t, std::uint64_t, std::span<double>) { return std::uint64_t{1}; };
  const auto error = [](const BatchMeans& m) { return 1.0 / std::sqrt(static_cast<double>(m.batches(0))); };
  const Context context;
  EXPECT_EQ(means.run({.error = 0.1}, draw, error, context, "light"), StopReason::error_reached);
  EXPECT_GE(means.batches(0), 100u);
  EXPECT_LE(means.batches(0), 110u);
  EXPECT_THROW(means.run({.error = 0.0}, draw, error, context, "light"), InputError);
}

}  // namespace
}  // namespace luxel
