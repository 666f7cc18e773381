// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/part_light.h"

#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include <gtest/gtest.h>

#include "luxel/patch/refine_patches.h"

#include "support/known_rooms.h"
#include "support/thread_ranks.h"

namespace luxel {
namespace {

// A furnace, where all surfaces emit 1 - reflectance, so that irradiance and radiosity are 1 everywhere.
// Every third patch is cut.
class PartLight : public testing::Test {
 protected:
  PartLight() {
    std::vector<std::uint8_t> marks(room_.patches.size(), 0);
    for (std::size_t p = 0; p < marks.size(); p += 3) marks[p] = 1;
    refined_ = refine_patches(room_.patches, marks, one_);
    tracer_.emplace(refined_.patches, one_);
    cut_.emplace(Cut{refined_.patches, *tracer_, refined_.parent});
    whole_.bands = room_.patches.bands;
    for (auto values : {&Solution::irradiance, &Solution::radiosity}) {
      (whole_.*values).front.assign(room_.patches.size() * room_.patches.band_count(), 1.0f);
      (whole_.*values).back.assign(room_.patches.size() * room_.patches.band_count(), 0.0f);
    }
    weight_.assign(2 * room_.patches.size(), 1.0);
  }

  std::size_t parts_of(std::size_t part) const {
    return static_cast<std::size_t>(
        std::count(refined_.parent.begin(), refined_.parent.end(), refined_.parent[part]));
  }

  Context one_{1};
  truth::KnownRoom room_ = truth::mixed_furnace();
  RefinedPatches refined_;
  std::optional<Tracer> tracer_;
  std::optional<Cut> cut_;
  Solution whole_;
  std::vector<double> weight_;
};

TEST_F(PartLight, rays_are_those_that_the_error_needs_and_only_for_parts) {
  const auto rays_for = [&](double allowed) {
    std::optional<std::uint32_t> of_parts;
    const auto rays = rays_of_parts(*cut_, inherited_light(whole_, *cut_), weight_, allowed);
    for (std::uint32_t p = 0; p < refined_.patches.size(); ++p) {
      if (parts_of(p) == 1) {
        EXPECT_EQ(rays[SideId(p, false).index()], 0u);
      } else {
        if (!of_parts) of_parts = rays[SideId(p, false).index()];
        EXPECT_EQ(rays[SideId(p, false).index()], *of_parts);
      }
      EXPECT_EQ(rays[SideId(p, true).index()], parts_of(p) == 1 ? 0u : 16u) << "dark as far as is known";
    }
    return of_parts.value_or(0);
  };
  const auto bands = static_cast<double>(room_.patches.band_count());
  EXPECT_EQ(rays_for(bands / 64.0), 64u);
  EXPECT_EQ(rays_for(bands / 40.0), 64u);
  EXPECT_EQ(rays_for(bands), 16u);
  EXPECT_EQ(rays_for(1e-9), 128u);
}

// Noise is judged by its own spread: the mean lies within five of its standard errors of the truth (false
// alarm: 1 in a million).
TEST_F(PartLight, parts_of_a_furnace_gather_what_their_wholes_have) {
  auto light = inherited_light(whole_, *cut_);
  const auto before = light;
  const auto rays = rays_of_parts(*cut_, light, weight_, 1e-9);
  const auto traced = gather_on_parts(*cut_, rays, {.seed = 5}, std::array{&light}, one_);
  ASSERT_TRUE(traced);
  const auto sent = std::accumulate(rays.begin(), rays.end(), std::uint64_t{0});
  EXPECT_GE(*traced, sent);
  EXPECT_LE(*traced, 2 * sent) << "direct light and hits";
  const auto bands = room_.patches.band_count();
  double count = 0.0, sum = 0.0, squares = 0.0;
  for (std::size_t p = 0; p < refined_.patches.size(); ++p)
    for (auto i = p * bands; i < (p + 1) * bands; ++i) {
      if (parts_of(p) == 1) {
        EXPECT_EQ(light.irradiance.front[i], before.irradiance.front[i]);
        EXPECT_EQ(light.radiosity.front[i], before.radiosity.front[i]);
        continue;
      }
      EXPECT_NEAR(light.irradiance.front[i], 1.0f, 0.5f);
      const auto reflectance = 1.0f - refined_.patches.emittance(static_cast<std::uint32_t>(p), i % bands);
      EXPECT_NEAR(light.radiosity.front[i], 1.0f - reflectance + reflectance * light.irradiance.front[i],
                  1e-5f);
      if (i % bands > 0) continue;  // the bands are alike
      const auto off = static_cast<double>(light.irradiance.front[i]) - 1.0;
      count += 1.0;
      sum += off;
      squares += off * off;
    }
  ASSERT_GT(count, 400.0);
  EXPECT_LT(std::abs(sum / count), 5.0 * std::sqrt(squares) / count);
}

TEST_F(PartLight, a_monitor_that_stops_leaves_the_light_as_it_was) {
  auto light = inherited_light(whole_, *cut_);
  const auto rays = rays_of_parts(*cut_, light, weight_, 1e-9);
  const auto stop = one_.with_monitor([](const Progress&) { return Next::stop; });
  EXPECT_FALSE(gather_on_parts(*cut_, rays, {}, std::array{&light}, stop));
  EXPECT_EQ(light.irradiance.front, inherited_light(whole_, *cut_).irradiance.front);
}

TEST_F(PartLight, ranks_have_the_bits_of_one) {
  auto alone = inherited_light(whole_, *cut_);
  auto other = alone;
  const auto rays = rays_of_parts(*cut_, alone, weight_, 0.05);
  const auto traced = gather_on_parts(*cut_, rays, {.seed = 5}, std::array{&alone, &other}, one_);
  EXPECT_NE(alone.irradiance.front, other.irradiance.front) << "each has rays of its own";
  for (const std::size_t count : {2u, 3u})
    ThreadRanks::run(count, [&](const Ranks& ranks) {
      const Context context({.threads = 2, .ranks = &ranks});
      auto light = inherited_light(whole_, *cut_);
      auto second = light;
      EXPECT_EQ(gather_on_parts(*cut_, rays, {.seed = 5}, std::array{&light, &second}, context), traced);
      EXPECT_EQ(light.irradiance.front, alone.irradiance.front);
      EXPECT_EQ(light.radiosity.front, alone.radiosity.front);
      EXPECT_EQ(second.irradiance.front, other.irradiance.front);
    });
}

}  // namespace
}  // namespace luxel
