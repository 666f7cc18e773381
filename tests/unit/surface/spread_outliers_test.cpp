// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/spread_outliers.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "luxel/core/address.h"
#include "luxel/patch/make_patches.h"
#include "luxel/trace/gather_sides.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

constexpr WindowColumns columns{8, 3};
constexpr std::size_t marked = 300, fifth = 5;  // a receiver and a replicate

Scene floor_scene() {
  return truth::SceneBuilder()
      .material("floor", 0.5f, 1.0f, false)
      .quad({0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0})
      .scene();
}

class SpreadOutliers : public testing::Test {
 protected:
  explicit SpreadOutliers(const Scene& scene = floor_scene(), float max_edge = 0.2f)
      : patches_(make_patches(scene, {.max_edge = max_edge})),
        tree_(make_patch_tree(patches_, Context(1))),
        sides_(all_gather_sides(patches_, tree_)),
        sheets_(make_light_sheets(patches_, tree_, sides_)),
        values_(sheet().size() * columns.size(), 0.0f) {}

  const LightSheet& sheet() const { return sheets_.front(); }
  float& value(std::size_t receiver, std::size_t replicate, std::size_t band) {
    return values_[receiver * columns.size() + replicate * columns.stride() + band];
  }
  // 1, 0.5 and 0.25 with noise of a tenth.
  void fill() {
    for (std::size_t i = 0; i < sheet().size(); ++i)
      for (std::uint32_t r = 0; r < columns.replicates; ++r) {
        const auto u = uniform4({1, r, static_cast<std::uint32_t>(i), 0});
        for (std::size_t b = 0; b < columns.bands; ++b)
          value(i, r, b) = std::pow(0.5f, static_cast<float>(b)) * (1.0f + 0.3f * (u[0] - 0.5f));
      }
  }
  double power(std::size_t replicate, std::size_t band) {
    double sum = 0.0;
    for (std::size_t i = 0; i < sheet().size(); ++i)
      sum += static_cast<double>(sheet().area[i] * value(i, replicate, band));
    return sum;
  }
  void spread() {
    const auto grids = make_window_grids(sheet());
    spread_outliers(sheet(), grids, columns, values_,
                    [](std::size_t count, const auto& body) { body(0, count); });
  }

  PatchSet patches_;
  PatchTree tree_;
  GatherSides sides_;
  std::vector<LightSheet> sheets_;
  std::vector<float> values_;
};

TEST_F(SpreadOutliers, what_one_ray_brought_goes_to_the_sides_around_and_the_power_stays) {
  ASSERT_EQ(sheets_.size(), 1u);
  fill();
  const auto before = values_;
  for (std::size_t b = 0; b < columns.bands; ++b) value(marked, fifth, b) *= 200.0f;
  const auto red = power(fifth, 0), blue = power(fifth, 2);
  spread();
  EXPECT_LT(value(marked, fifth, 0), 2.0f);
  EXPECT_NEAR(value(marked, fifth, 2) / value(marked, fifth, 0), 0.25f, 1e-4f);
  EXPECT_NEAR(power(fifth, 0), red, 1e-4 * red);
  EXPECT_NEAR(power(fifth, 2), blue, 1e-4 * blue);
  for (std::size_t i = 0; i < sheet().size(); ++i)
    for (std::size_t r = 0; r < columns.replicates; ++r) {
      const auto was = before[i * columns.size() + r * columns.stride()];
      const auto at = glm::length(sheet().place[i] - sheet().place[marked]);
      if (r != fifth || at > 1.5f) {
        EXPECT_EQ(value(i, r, 0), was);
      }
    }
}

TEST_F(SpreadOutliers, light_that_all_replicates_know_stays) {
  fill();
  for (std::size_t r = 0; r < columns.replicates; ++r)
    for (std::size_t b = 0; b < columns.bands; ++b) value(marked, r, b) *= 200.0f;
  const auto before = values_;
  spread();
  EXPECT_EQ(values_, before);
}

TEST_F(SpreadOutliers, where_few_rays_found_light_nothing_is_judged) {
  for (std::size_t i = 0; i < sheet().size(); i += 20) value(i, i / 20 % columns.replicates, 0) = 100.0f;
  const auto before = values_;
  spread();
  EXPECT_EQ(values_, before);
}

TEST_F(SpreadOutliers, sides_that_no_light_reaches_do_not_hide_one) {
  for (std::size_t i = marked % 12; i < sheet().size(); i += 12)
    for (std::uint32_t r = 0; r < columns.replicates; ++r)
      value(i, r, 0) = 1.0f + 0.3f * (uniform4({1, r, static_cast<std::uint32_t>(i), 0})[0] - 0.5f);
  value(marked, fifth, 0) = 200.0f;
  const auto all = power(fifth, 0);
  spread();
  EXPECT_LT(value(marked, fifth, 0), 2.0f);
  EXPECT_NEAR(power(fifth, 0), all, 1e-4 * all);
}

TEST_F(SpreadOutliers, where_most_values_are_below_zero_an_outlier_gives_all_and_no_more) {
  fill();
  for (auto& v : values_) v -= 5.0f;
  for (std::size_t b = 0; b < columns.bands; ++b) value(marked, fifth, b) = 200.0f;
  const auto red = power(fifth, 0);
  spread();
  EXPECT_EQ(value(marked, fifth, 0), 0.0f);
  EXPECT_NEAR(power(fifth, 0), red, 1e-4 * std::abs(red));
}

// Six sides of 0.7 m beside 800 of 0.1 m: windows of nine median patches hold one of the large ones at most.
Scene floor_with_large_sides() {
  truth::SceneBuilder builder;
  builder.material("floor", 0.5f, 1.0f, false);
  for (int i = 0; i < 20; ++i)
    for (int k = 0; k < 20; ++k) {
      const Vec3 at(0.1f * static_cast<float>(i), 0.1f * static_cast<float>(k), 0.0f);
      builder.quad(at, at + Vec3(0.1f, 0, 0), at + Vec3(0.1f, 0.1f, 0), at + Vec3(0, 0.1f, 0));
    }
  for (int k = 0; k < 3; ++k) {
    const Vec3 at(2.0f, 0.7f * static_cast<float>(k), 0.0f);
    builder.quad(at, at + Vec3(0.7f, 0, 0), at + Vec3(0.7f, 0.7f, 0), at + Vec3(0, 0.7f, 0));
  }
  return builder.scene();
}

class SpreadOutliersOfLargeSides : public SpreadOutliers {
 protected:
  SpreadOutliersOfLargeSides() : SpreadOutliers(floor_with_large_sides(), 2.0f) {}
};

TEST_F(SpreadOutliersOfLargeSides, a_side_alone_is_judged_by_those_farther_away) {
  ASSERT_EQ(sheets_.size(), 1u);
  fill();
  const auto large = std::max_element(sheet().area.begin(), sheet().area.end()) - sheet().area.begin();
  const auto at = static_cast<std::size_t>(large);
  for (std::size_t b = 0; b < columns.bands; ++b) value(at, fifth, b) *= 200.0f;
  const auto all = power(fifth, 0);
  spread();
  EXPECT_LT(value(at, fifth, 0), 2.0f);
  EXPECT_NEAR(power(fifth, 0), all, 1e-4 * all);
}

}  // namespace
}  // namespace luxel
