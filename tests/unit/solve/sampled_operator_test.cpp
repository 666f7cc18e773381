// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/sampled_operator.h"

#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/classical/gauss_seidel.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/patch_tree.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

const Context one(1), five(5);

struct Room {
  PatchSet patches;
  Tracer tracer{patches, one};

  HitStore hits(const HitStoreOptions& options, std::uint32_t per_receiver) const {
    HitStore store(patches, all_gather_sides(patches, make_patch_tree(patches, one)), tracer, options);
    store.double_rays(receivers(store, 1), per_receiver, one);
    return store;
  }
  static std::vector<std::uint32_t> receivers(const HitStore& store, std::uint32_t every) {
    std::vector<std::uint32_t> some;
    for (std::uint32_t s = 0; s < store.sides().size(); s += every) some.push_back(s);
    return some;
  }
};

std::vector<float> some_light(const HitStore& hits, std::size_t bands) {
  std::vector<float> light(hits.elements() * bands);
  for (std::size_t i = 0; i < light.size(); ++i) light[i] = 0.01f * static_cast<float>(i % 89);
  return light;
}

// All results of an operator, in sequence.
std::vector<float> everything(const PatchSet& patches, const HitStore& hits, const Context& context) {
  const auto bands = patches.band_count();
  const SampledOperator transport(patches, hits, {}, context);
  const auto light = some_light(hits, bands);
  const auto numbers = hits.sides().size() * bands;
  std::vector<float> all, irradiance(numbers);
  for (const std::size_t half : {0, 1}) {
    transport.apply(half, bands, light, irradiance, context);
    all.insert(all.end(), irradiance.begin(), irradiance.end());
    for (const auto& rows : transport.replicate_rows(half, light, context))
      all.insert(all.end(), rows.begin(), rows.end());
  }
  const std::vector<double> importance(hits.sides().size(), 1.0);
  const std::vector<float> level(numbers, 0.3f);
  const auto worth = transport.ray_worth(importance, light, level, context);
  all.insert(all.end(), worth.own.begin(), worth.own.end());
  all.insert(all.end(), worth.given.begin(), worth.given.end());
  return all;
}

TEST(SampledOperator, streamed_or_stored_and_on_any_number_of_threads_the_sums_have_the_same_bits) {
  const Room room{make_patches(truth::l_room(), {.max_edge = 0.2f})};
  for (const std::uint32_t replicates : {4, 5}) {
    auto hits = room.hits({.replicates = replicates}, 4);
    hits.double_rays(Room::receivers(hits, 3), 0, five);
    std::vector<std::uint8_t> kept(hits.sides().size(), 1);
    for (std::size_t s = 0; s < kept.size(); s += 7) kept[s] = 0;
    hits.keep(kept, five);
    const auto expected = everything(room.patches, hits, one);
    EXPECT_EQ(everything(room.patches, hits, five), expected);
    hits.stream();
    EXPECT_EQ(everything(room.patches, hits, five), expected);
  }
}

TEST(SampledOperator, rows_sum_to_one_however_few_the_rays) {
  const Room room{make_patches(truth::l_room(), {.max_edge = 0.3f})};
  auto hits = room.hits({.replicates = 8}, 1);
  hits.double_rays(Room::receivers(hits, 5), 0, one);
  const SampledOperator transport(room.patches, hits, {}, one);
  const std::vector<float> ones(hits.elements(), 1.0f);
  std::vector<float> sums(hits.sides().size());
  double worst_replicate = 0.0;
  for (const std::size_t half : {0, 1}) {
    transport.apply(half, 1, ones, sums, one);
    for (const auto sum : sums) ASSERT_NEAR(sum, 1.0f, 1e-5f);
    for (const auto& rows : transport.replicate_rows(half, ones, one))
      for (const auto sum : rows) ASSERT_NEAR(sum, 1.0f, 1e-5f);
  }
  for (std::size_t s = 0; s < sums.size(); ++s)
    worst_replicate = std::max(worst_replicate, std::abs(transport.row_sum(0, s) - 1.0));
  EXPECT_GT(worst_replicate, 0.3) << "one replicate alone is far from it";
}

// The mean over seeds is the form factor: that between opposed unit squares one metre apart is 0.199825.
// False alarms: 3 in 1000 (three standard errors).
TEST(SampledOperator, the_mean_over_seeds_is_the_form_factor_whatever_the_counts) {
  const Room room{make_patches(truth::plates(), {.max_edge = 0.6f})};
  constexpr int seeds = 200;
  for (const float trust : {1.0f, 3.0f}) {
    double sum = 0.0;
    double squares = 0.0;
    for (int seed = 1; seed <= seeds; ++seed) {
      auto hits = room.hits({.seed = static_cast<std::uint64_t>(seed), .replicates = 4}, 1);
      // Sides of one plate have eight times as many.
      std::vector<std::uint32_t> upper;
      std::vector<float> light(hits.elements(), 0.0f);
      double area = 0.0;
      for (std::uint32_t s = 0; s < hits.sides().size(); ++s) {
        const auto patch = hits.sides().side[s].patch();
        if (room.patches.points(patch)[0].z > 0.5f)
          upper.push_back(s);
        else
          light[s] = 1.0f;
      }
      for (int i = 0; i < 3; ++i) hits.double_rays(upper, 0, one);
      const SampledOperator transport(room.patches, hits, {.own_trust = trust}, one);
      std::vector<float> irradiance(hits.sides().size());
      transport.apply(seed % 2, 1, light, irradiance, one);
      double factor = 0.0;
      for (const auto s : upper) {
        const double a = room.patches.area[hits.sides().side[s].patch()];
        factor += a * static_cast<double>(irradiance[s]);
        area += a;
      }
      factor *= 2.0 / area;  // one of the two sides of each patch sees the other plate
      sum += factor;
      squares += factor * factor;
    }
    const auto mean = sum / seeds;
    const auto error = std::sqrt((squares / seeds - mean * mean) / (seeds - 1));
    EXPECT_LT(error, 0.01);
    EXPECT_NEAR(mean, 0.199825, 3.0 * error) << "trust " << trust;
  }
}

// Light that a small bright patch sends out and gets back from its surroundings. Where one half of the
// replicates sent it on itself, each ray would bring back what it took out. False alarms: 3 in 1000.
TEST(SampledOperator, a_bright_patch_does_not_see_itself_by_its_own_rays) {
  const Room room{make_patches(truth::cube_a(), {.max_edge = 0.2f})};
  constexpr std::uint32_t bright = 100;
  constexpr double rho = 0.5;
  const auto returned = [&](std::uint64_t seed, std::uint32_t rays, bool crossed, bool both_ways) {
    auto hits = room.hits({.seed = seed, .replicates = 4}, 1);
    std::vector<std::uint32_t> only = {bright};
    for (std::uint32_t n = 1; n < rays; n *= 2) hits.double_rays(only, 0, one);
    if (!both_ways)
      for (std::uint32_t n = 1; n < rays; n *= 2) {
        auto others = Room::receivers(hits, 1);
        std::erase(others, bright);
        hits.double_rays(others, 0, one);
      }
    const SampledOperator transport(room.patches, hits, {.both_ways = both_ways}, one);
    std::vector<float> light(hits.elements(), 0.0f), first(hits.sides().size()), second(first);
    light[bright] = 1.0f;
    transport.apply(0, 1, light, first, one);
    std::fill(light.begin(), light.end(), 0.0f);
    for (std::size_t s = 0; s < first.size(); ++s) light[s] = static_cast<float>(rho) * first[s];
    transport.apply(crossed ? 1 : 0, 1, light, second, one);
    return static_cast<double>(second[bright]);
  };
  double truth = 0.0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) truth += returned(1000 + seed, 1024, true, false) / 4.0;
  constexpr int seeds = 300;
  for (const bool crossed : {false, true}) {
    double sum = 0.0;
    double squares = 0.0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const auto x = returned(seed, 16, crossed, true);
      sum += x;
      squares += x * x;
    }
    const auto mean = sum / seeds;
    const auto error = std::sqrt((squares / seeds - mean * mean) / (seeds - 1));
    if (crossed)
      EXPECT_NEAR(mean, truth, 3.0 * error + 0.02 * truth);
    else
      EXPECT_GT(mean, 1.3 * truth);
  }
}

// In a furnace all light is E / (1 - rho), exactly, for rows sum to one.
TEST(SampledOperator, at_reflectance_098_and_8_rays_per_side_the_iteration_converges) {
  const Room room{make_patches(truth::furnace(Vec3(0.98f), Vec3(0.98f)), {.max_edge = 0.2f})};
  const auto hits = room.hits({.replicates = 8}, 1);
  const SampledOperator transport(room.patches, hits, {}, one);
  const CrossedHalves crossed(transport, 1);
  const std::vector<float> direct(crossed.size(), 1.0f), reflectance(crossed.size(), 0.98f);
  std::vector<float> radiosity(crossed.size() + hits.elements() - hits.sides().size(), 0.0f);
  std::vector<float> irradiance(crossed.size());
  // What escapes through the seams of this room would be missing from its light: it shines as much.
  std::fill(radiosity.begin() + static_cast<std::ptrdiff_t>(crossed.size()), radiosity.end(), 49.0f);
  const auto report = gauss_seidel(crossed, {direct, reflectance, radiosity, irradiance},
                                   {.tolerance = 1e-6, .parts = 2}, one);
  EXPECT_TRUE(report.converged);
  EXPECT_LT(report.change.size(), 200u);
  for (const auto H : irradiance) ASSERT_NEAR(H, 50.0f, 0.05f);
}

}  // namespace
}  // namespace luxel
