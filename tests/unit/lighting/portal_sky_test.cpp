// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/portal_sky.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/lighting/daylight_scene.h"
#include "luxel/patch/make_patches.h"

#include "support/stored_run.h"
#include "support/window_rooms.h"

namespace luxel {
namespace {

// A room with a window under an even sky of patches.
PatchSet patches_under(const SkyPatches& sky) {
  auto scene = truth::window_room().scene();
  set_only_sky(sky, std::vector<double>(sky.size(), 1000.0), scene);
  auto patches = make_patches(scene, {.max_edge = 0.5f});
  patches.portals = truth::window_portals();
  return patches;
}

class PortalSkyTest : public testing::Test {
 protected:
  const SkyPatches directions_{1, {0, 0, 1}, {0, 1, 0}};
  const Context context_{2};
  const PatchSet patches_ = patches_under(directions_);
  const Tracer tracer_{patches_, context_};
  // Without the control variate, direct light is the mean over its samples.
  const SampledOptions options_{
      .error = 0.05, .error_measure = ErrorMeasure::power, .control_variate = false};
  const truth::StoredRun run_ = truth::stored_run(patches_, tracer_, options_, context_);
};

TEST_F(PortalSkyTest, has_the_direct_light_of_the_run) {
  Sampling sampling(patches_, tracer_, options_, context_);
  sampling.restore(*run_.state);
  const auto units = sampling.units().size() - 1;
  std::vector<std::uint8_t> doublings(units + sampling.hits().sides().size(), 0);
  std::fill_n(doublings.begin(), units, std::uint8_t{2});
  ASSERT_TRUE(sampling.take(doublings, {})) << "rounds are added up";
  const auto light = PortalSky(sampling, context_)
                         .irradiance(0, std::vector<float>(directions_.size(), patches_.sky[0]), context_);
  const auto& direct = sampling.direct().irradiance();
  const auto bands = patches_.band_count();
  double found = 0.0, expected = 0.0;
  ASSERT_EQ(light.size(), direct.size());
  for (std::size_t r = 0; r < light.size(); ++r) {
    found += std::accumulate(light[r].begin(), light[r].end(), 0.0);
    for (std::size_t i = 0; i < direct[r].size(); i += bands) expected += static_cast<double>(direct[r][i]);
  }
  EXPECT_GT(expected, 0.0);
  EXPECT_NEAR(found, expected, 1e-5 * expected);
}

TEST_F(PortalSkyTest, gives_any_block_of_the_sky) {
  Sampling sampling(patches_, tracer_, options_, context_);
  sampling.restore(*run_.state);
  const PortalSky sky(sampling, context_);
  const std::vector<float> ones(directions_.size(), 1.0f);
  const auto whole = sky.irradiance(0, ones, context_);
  constexpr std::size_t first = 40, columns = 20;
  const auto block = sky.irradiance(first, std::span(ones).first(columns), context_);
  double sum = 0.0;
  for (std::size_t r = 0; r < whole.size(); ++r)
    for (std::size_t s = 0; s < block[r].size() / columns; ++s)
      for (std::size_t c = 0; c < columns; ++c) {
        EXPECT_EQ(block[r][s * columns + c], whole[r][s * ones.size() + first + c]);
        sum += static_cast<double>(block[r][s * columns + c]);
      }
  EXPECT_GT(sum, 0.0);
}

}  // namespace
}  // namespace luxel
