// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/ray_allocation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/solve/replicate_spread.h"
#include "luxel/solve/sampled_operator.h"
#include "luxel/trace/tracer.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

const Context context(2);

// A room with a thin post, whose patches are a fiftieth of those of the walls.
Scene room_with_post() {
  truth::SceneBuilder room;
  const float low = 0.45f, high = 0.55f;
  room.material("walls", 0.5f, 0.0f)
      .quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0})
      .quad({0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1})
      .quad({0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1})
      .quad({1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0})
      .quad({0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0})
      .quad({0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1});
  constexpr int steps = 8;
  for (int i = 0; i < steps; ++i) {
    const auto z0 = static_cast<float>(i) / steps, z1 = static_cast<float>(i + 1) / steps;
    room.material("post", 0.5f, 0.0f)
        .quad({low, low, z0}, {high, low, z0}, {high, low, z1}, {low, low, z1})
        .quad({high, low, z0}, {high, high, z0}, {high, high, z1}, {high, low, z1})
        .quad({high, high, z0}, {low, high, z0}, {low, high, z1}, {high, high, z1})
        .quad({low, high, z0}, {low, low, z0}, {low, low, z1}, {low, high, z1});
  }
  return room.scene();
}

// The noise of that room's light where every fifth side shines.
class UnevenRoom {
 public:
  // For each receiver: its part of the squared error as gather_errors() finds it, and the variance of its
  // light, times its importance, as replicates show it. Means over seeds.
  struct Parts {
    std::vector<double> found, measured, area;
  };
  Parts parts(int seeds) const {
    Parts sum;
    for (int seed = 1; seed <= seeds; ++seed) add(static_cast<std::uint64_t>(seed), sum);
    for (auto* values : {&sum.found, &sum.measured})
      for (auto& v : *values) v /= seeds;
    return sum;
  }

 private:
  void add(std::uint64_t seed, Parts& sum) const {
    HitStore hits(patches_, all_gather_sides(patches_, make_patch_tree(patches_, context)), tracer_,
                  {.seed = seed, .replicates = 8, .low_discrepancy = false, .stratified = false});
    const auto receivers = static_cast<std::uint32_t>(hits.sides().size());
    std::vector<std::uint32_t> all(receivers);
    std::iota(all.begin(), all.end(), 0u);
    hits.double_rays(all, 64, context);
    const SampledOperator transport(patches_, hits, {.both_ways = false}, context);
    const auto bands = patches_.band_count();
    std::vector<float> light(hits.elements() * bands, 0.0f);
    for (std::uint32_t s = 0; s < receivers; s += 5) std::fill_n(&light[s * bands], bands, 1.0f);
    std::vector<std::vector<float>> rows;
    for (const std::size_t half : {0, 1})
      for (auto& row : transport.replicate_rows(half, light, context)) rows.push_back(std::move(row));
    const auto variance = squared_errors(rows, bands, context);
    std::vector<float> gathered(receivers * bands);
    for (std::size_t i = 0; i < gathered.size(); ++i)
      for (const auto& row : rows) gathered[i] += row[i] / static_cast<float>(rows.size());
    std::vector<float> halves(light.begin(), light.begin() + receivers * bands);
    halves.insert(halves.end(), light.begin(), light.end());
    const std::vector<double> importance(receivers, 1.0);
    std::vector<std::uint32_t> each(receivers + 1);  // a unit of its own
    std::iota(each.begin(), each.end(), 0u);
    const auto found = gather_errors(patches_, transport, {each, importance, halves, gathered, 1.0}, context);
    for (auto* values : {&sum.found, &sum.measured, &sum.area}) values->resize(receivers);
    for (std::size_t s = 0; s < receivers; ++s) {
      sum.found[s] += found[s];
      sum.measured[s] += importance[s] * variance[s];
      sum.area[s] = static_cast<double>(patches_.area[hits.sides().side[s].patch()]);
    }
  }

  PatchSet patches_ = make_patches(room_with_post(), {.max_edge = 1.0f});
  Tracer tracer_{patches_, context};
};

// The parts of all sides of a cube in units of neighbours, where rays count at both ends and all sides have
// the same importance and number of rays. One of `shining` sides shines, so that it is chance which rays meet
// one.
std::vector<double> parts_of_cube(std::uint32_t unit, std::uint32_t shining) {
  const auto patches = make_patches(truth::cube({}), {.max_edge = 0.1f});
  const Tracer tracer(patches, context);
  HitStore hits(patches, all_gather_sides(patches, make_patch_tree(patches, context)), tracer,
                {.seed = 1, .replicates = 4});
  const auto receivers = static_cast<std::uint32_t>(hits.sides().size());
  std::vector<std::uint32_t> all(receivers);
  std::iota(all.begin(), all.end(), 0u);
  hits.double_rays(all, 8, context);
  const SampledOperator transport(patches, hits, {}, context);
  const auto bands = patches.band_count();
  std::vector<float> halves((receivers + hits.elements()) * bands, 0.0f);
  for (std::uint32_t s = 0; s < 2 * receivers; s += shining) std::fill_n(&halves[s * bands], bands, 1.0f);
  const std::vector<float> gathered(receivers * bands, 0.5f);
  const std::vector<double> importance(receivers, 1.0);
  return gather_errors(patches, transport,
                       {neighbour_begins(hits.sides(), unit), importance, halves, gathered, 1.0}, context);
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

// Where rays count for their senders alone, the noise of each side is due to its own rays.
TEST(RoundPlan, doubles_all_samples_where_the_first_error_is_not_above_0) {
  const std::vector<SampleUnit> units(4, {0.0, 10.0});
  const SampledOptions options{.error = 0.02};
  const auto plan_after = [&](bool is_first) { return plan_round(units, {1, 0.0, 3e-4, is_first}, options); };
  EXPECT_EQ(plan_after(true).doublings, std::vector<std::uint8_t>(4, 1));
  EXPECT_EQ(plan_after(true).more_cost, 40.0);
  EXPECT_TRUE(plan_after(false).is_empty());
}

TEST(RayAllocation, the_part_of_a_side_is_its_noise_whatever_its_area) {
  const auto parts = UnevenRoom().parts(40);
  EXPECT_NEAR(sum(parts.found), 1.0, 1e-9);
  const auto smallest = *std::min_element(parts.area.begin(), parts.area.end());
  const auto largest = *std::max_element(parts.area.begin(), parts.area.end());
  ASSERT_GT(largest, 20.0 * smallest);
  double small = 0.0, small_found = 0.0;
  for (std::size_t s = 0; s < parts.area.size(); ++s)
    if (parts.area[s] < 0.5 * (smallest + largest)) {
      small += parts.measured[s] / sum(parts.measured);
      small_found += parts.found[s];
    }
  EXPECT_GT(small, 0.05);
  EXPECT_LT(small, 0.95);
  EXPECT_NEAR(small_found, small, 0.05) << "5 % is for light that no ray has found yet";
}

// Otherwise counts would follow chance, and the light would be too low.
TEST(RayAllocation, neighbours_get_equal_parts_whatever_their_rays_met) {
  const std::uint32_t unit = 32;
  const auto parts = parts_of_cube(unit, 7);
  ASSERT_GT(parts.size(), 3 * unit);
  for (std::size_t s = 0; s + unit <= parts.size(); s += unit)
    for (auto i = s; i < s + unit; ++i) EXPECT_NEAR(parts[i], parts[s], 1e-6 * parts[s]) << "side " << i;
  EXPECT_GT(std::abs(parts[unit] - parts[0]), 1e-3 * parts[0]) << "units differ";
}

}  // namespace
}  // namespace luxel
