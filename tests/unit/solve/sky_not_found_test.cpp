// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/solve/survey_sides.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

class SkyNotFoundTest : public testing::Test {
 protected:
  HitStore hits_of(const PatchSet& patches, const Tracer& tracer, std::uint32_t rays) const {
    HitStore hits(patches, all_gather_sides(patches, make_patch_tree(patches, context_)), tracer,
                  {.replicates = replicates});
    std::vector<std::uint32_t> receivers(hits.sides().size());
    std::iota(receivers.begin(), receivers.end(), 0u);
    hits.double_rays(receivers, rays, context_);
    return hits;
  }

  static constexpr std::uint32_t replicates = 4;
  Context context_{2};
  PatchSet patches_ = make_patches(truth::l_room(), {.max_edge = 0.2f});
  Tracer tracer_{patches_, context_};
};

// Jeffreys' estimate of a fraction of which N trials met nothing is 1/2 in N + 1; the mean of N trials of
// that fraction has a variance of nearly (1/2) / N².
TEST_F(SkyNotFoundTest, under_an_open_sky_is_half_a_ray_of_each_unit) {
  auto open = make_patches(truth::plates(), {.max_edge = 0.1f});
  open.sky = {2.0f, 1.0f, 0.0f};
  const Tracer tracer(open, context_);
  const auto hits = hits_of(open, tracer, 8);
  const auto units = neighbour_begins(hits.sides(), 64);
  const SkyNotFound not_found(open, hits, units, context_);
  const auto variance = not_found.variance();
  ASSERT_EQ(variance.size(), hits.sides().size() * 3);
  ASSERT_GT(units.size(), 3u);
  for (std::size_t u = 0; u + 1 < units.size(); ++u) {
    EXPECT_GT(not_found.expected()[u], 0.05);
    const auto n = static_cast<double>(units[u + 1] - units[u]) * 8 * replicates;
    const auto p = 0.5 / (n + 1.0);
    for (auto s = units[u]; s < units[u + 1]; ++s)
      for (std::size_t b = 0; b < 3; ++b) {
        const auto irradiance = std::numbers::pi * static_cast<double>(open.sky[b]);
        const auto expected = irradiance * irradiance * p * (1.0 - p) / n;
        EXPECT_NEAR(static_cast<double>(variance[s * 3 + b]), expected, 20.0 / n * expected) << s;
      }
  }
}

// In a closed room no ray of the scene's N meets the sky: each unit of n may have met half of 1 in N.
TEST_F(SkyNotFoundTest, in_a_closed_room_is_what_half_a_ray_of_all_may_bring) {
  patches_.sky = {1.0f, 1.0f, 1.0f};
  const auto hits = hits_of(patches_, tracer_, 8);
  const auto units = neighbour_begins(hits.sides(), 64);
  const SkyNotFound not_found(patches_, hits, units, context_);
  const auto all = static_cast<double>(hits.sides().size()) * 8 * replicates;
  const auto variance = not_found.variance();
  std::size_t inside = 0;
  for (std::size_t u = 0; u + 1 < units.size(); ++u) {
    if (hits.sides().side[units[u]].is_back()) continue;  // the back of a wall, outside
    ++inside;
    EXPECT_NEAR(not_found.expected()[u], 0.5 / all, 1e-3 / all);
    const auto n = static_cast<double>(units[u + 1] - units[u]) * 8 * replicates;
    const auto expected = std::pow(std::numbers::pi, 2.0) * 0.5 / all / n / (1.0 + n / all);
    EXPECT_NEAR(static_cast<double>(variance[units[u] * 3]), expected, 2e-3 * expected);
  }
  EXPECT_GT(inside, 3u);
}

TEST_F(SkyNotFoundTest, later_rays_take_off_but_do_not_change_what_is_expected) {
  patches_.sky = {1.0f, 1.0f, 1.0f};
  auto hits = hits_of(patches_, tracer_, 8);
  const auto units = neighbour_begins(hits.sides(), 64);
  const SkyNotFound before(patches_, hits, units, context_);
  const auto of_few = before.variance();
  std::vector<std::uint32_t> receivers(hits.sides().size());
  std::iota(receivers.begin(), receivers.end(), 0u);
  hits.double_rays(receivers, 0, context_);
  const SkyNotFound after(patches_, hits, units, context_);
  EXPECT_TRUE(std::ranges::equal(after.expected(), before.expected()));
  const auto of_many = after.variance();
  for (std::size_t i = 0; i < of_few.size(); ++i) {
    EXPECT_LT(of_many[i], 0.51f * of_few[i]);
    EXPECT_GT(of_many[i], 0.24f * of_few[i]);
  }
}

TEST_F(SkyNotFoundTest, is_the_same_where_hits_are_streamed_and_on_one_thread) {
  patches_.sky = {1.0f, 1.0f, 1.0f};
  auto hits = hits_of(patches_, tracer_, 2);
  const auto units = neighbour_begins(hits.sides(), 64);
  const auto stored = SkyNotFound(patches_, hits, units, context_).variance();
  hits.stream();
  EXPECT_EQ(SkyNotFound(patches_, hits, units, Context(1)).variance(), stored);
}

TEST_F(SkyNotFoundTest, is_nothing_without_a_sky) {
  const auto hits = hits_of(patches_, tracer_, 1);
  const auto units = neighbour_begins(hits.sides(), 64);
  for (const auto v : SkyNotFound(patches_, hits, units, context_).variance()) EXPECT_EQ(v, 0.0f);
}

}  // namespace
}  // namespace luxel
