// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/sky_not_found.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/patch/patch_tree.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

class SkyNotFoundTest : public testing::Test {
 protected:
  // In a closed room, so that no ray meets the sky.
  HitStore hits_of(const PatchSet& patches, const Tracer& tracer, std::uint32_t rays) const {
    HitStore hits(patches, all_gather_sides(patches, make_patch_tree(patches, workers_)), tracer,
                  {.replicates = replicates});
    std::vector<std::uint32_t> slots(hits.sides().size());
    std::iota(slots.begin(), slots.end(), 0u);
    hits.double_rays(slots, rays, workers_);
    return hits;
  }

  static constexpr std::uint32_t replicates = 4;
  Workers workers_{2};
  PatchSet patches_ = make_patches(truth::l_room(), {.max_edge = 0.2f});
  Tracer tracer_{patches_, workers_};
};

// Jeffreys' estimate of a share of which N trials met nothing is 1/2 in N + 1; the mean of N trials of that
// share has a variance of nearly (1/2) / N².
TEST_F(SkyNotFoundTest, is_half_a_ray_of_each_unit) {
  patches_.sky = {2.0f, 1.0f, 0.0f};
  const auto hits = hits_of(patches_, tracer_, 8);
  const auto units = neighbour_begins(hits.sides(), 64);
  const auto variance = sky_not_found(patches_, hits, units);
  ASSERT_EQ(variance.size(), hits.sides().size() * 3);
  ASSERT_GT(units.size(), 3u);
  for (std::size_t u = 0; u + 1 < units.size(); ++u) {
    const auto n = static_cast<double>(units[u + 1] - units[u]) * 8 * replicates;
    const auto p = 0.5 / (n + 1.0);
    for (auto s = units[u]; s < units[u + 1]; ++s)
      for (std::size_t b = 0; b < 3; ++b) {
        const auto irradiance = std::numbers::pi * static_cast<double>(patches_.sky[b]);
        const auto expected = irradiance * irradiance * p * (1.0 - p) / n;
        EXPECT_NEAR(static_cast<double>(variance[s * 3 + b]), expected, 2.0 / n * expected) << s;
      }
  }
}

TEST_F(SkyNotFoundTest, falls_to_a_quarter_with_twice_the_rays) {
  patches_.sky = {1.0f, 1.0f, 1.0f};
  const auto few = hits_of(patches_, tracer_, 4);
  const auto many = hits_of(patches_, tracer_, 8);
  const auto units = neighbour_begins(few.sides(), 64);
  const auto of_few = sky_not_found(patches_, few, units);
  const auto of_many = sky_not_found(patches_, many, units);
  for (std::size_t i = 0; i < of_few.size(); ++i) EXPECT_FLOAT_EQ(of_many[i], 0.25f * of_few[i]);
}

TEST_F(SkyNotFoundTest, is_nothing_without_a_sky) {
  const auto hits = hits_of(patches_, tracer_, 1);
  for (const auto v : sky_not_found(patches_, hits, neighbour_begins(hits.sides(), 64))) EXPECT_EQ(v, 0.0f);
}

}  // namespace
}  // namespace luxel
