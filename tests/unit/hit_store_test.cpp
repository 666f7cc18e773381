// SPDX-License-Identifier: Apache-2.0
#include "luxel/transport/sampled_operator.h"

#include <vector>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/random/sobol.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

class SampledOperatorTest : public testing::Test {
 protected:
  SampledOperator make(const SampledOperatorOptions& options = {}) const {
    return {patches_, all_gather_sides(patches_, make_patch_tree(patches_, one_)), tracer_, options};
  }
  static std::vector<std::uint32_t> all_slots(const SampledOperator& transport) {
    std::vector<std::uint32_t> slots(transport.sides().size());
    for (std::uint32_t s = 0; s < slots.size(); ++s) slots[s] = s;
    return slots;
  }
  static std::vector<std::uint32_t> hits_of(const SampledOperator& transport, std::uint32_t replicate) {
    std::vector<std::uint32_t> hits;
    for (std::size_t b = 0; b < transport.blocks(); ++b)
      transport.for_each_hit(replicate, b, [&](std::uint32_t, std::uint32_t e) { hits.push_back(e); });
    return hits;
  }
  // By one replicate, and by all.
  static std::vector<float> applied(const SampledOperator& transport, const Workers& workers) {
    const auto bands = transport.replicate(0).bands();
    std::vector<float> radiosity(transport.elements() * bands);
    for (std::size_t i = 0; i < radiosity.size(); ++i) radiosity[i] = 0.01f * static_cast<float>(i % 89);
    std::vector<float> irradiance(transport.sides().size() * bands);
    transport.replicate(1).apply(radiosity, irradiance, 0, transport.sides().size(), workers);
    auto both = irradiance;
    transport.all_replicates().apply(radiosity, irradiance, 0, transport.sides().size(), workers);
    both.insert(both.end(), irradiance.begin(), irradiance.end());
    return both;
  }

  Workers one_{1}, five_{5};
  PatchSet patches_ = make_patches(truth::l_room(), {.max_edge = 0.2f});
  Tracer tracer_{patches_, one_};
};

// Rays are made many at a time and traced in another order; each is still the one of its own address.
TEST_F(SampledOperatorTest, a_hit_is_that_of_the_ray_made_and_traced_alone) {
  auto transport = make({.seed = 7, .replicates = 2});
  constexpr std::uint32_t n = 32;
  transport.double_rays(all_slots(transport), n, five_);
  const auto& sides = transport.sides();
  for (const std::uint32_t replicate : {0u, 1u}) {
    const auto hits = hits_of(transport, replicate);
    ASSERT_EQ(hits.size(), sides.size() * n);
    for (std::size_t i = 0; i < hits.size(); i += 5) {
      const auto slot = i / n;
      const auto back = slot >= sides.fronts ? 1u : 0u;
      const OwenSobol points(mix64(stream_key(7, 0x67617468u, 2 * replicate + back)));
      const auto x = points.first4(sides.position[slot] * n + static_cast<std::uint32_t>(i % n));
      const std::array<float, 4> u = {x[2], x[3], x[0], x[1]};
      const auto hit = tracer_.nearest(PatchEmitter(patches_, sides.side[slot]).ray(u));
      if (hit && sides.slot_of_side[side_of(hit.patch, hit.back)] != GatherSides::none)
        ASSERT_EQ(hits[i], sides.slot_of_side[side_of(hit.patch, hit.back)]) << i;
      else
        ASSERT_GE(hits[i], sides.size()) << i;
    }
  }
}

TEST_F(SampledOperatorTest, all_replicates_bring_the_mean_of_what_each_brings) {
  auto transport = make({.replicates = 3});
  transport.double_rays(all_slots(transport), 4, one_);
  const auto bands = transport.replicate(0).bands();
  std::vector<float> radiosity(transport.elements() * bands);
  for (std::size_t i = 0; i < radiosity.size(); ++i) radiosity[i] = 0.01f * static_cast<float>(i % 89);
  const auto size = transport.sides().size();
  std::vector<double> mean(size * bands, 0.0);
  std::vector<float> one(size * bands);
  for (std::uint32_t r = 0; r < 3; ++r) {
    transport.replicate(r).apply(radiosity, one, 0, size, five_);
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += static_cast<double>(one[i]) / 3.0;
  }
  transport.all_replicates().apply(radiosity, one, 0, size, five_);
  for (std::size_t i = 0; i < mean.size(); ++i)
    ASSERT_NEAR(static_cast<double>(one[i]), mean[i], 1e-6 * mean[i]) << i;
}

TEST_F(SampledOperatorTest, streamed_or_stored_and_on_any_number_of_threads_the_sums_have_the_same_bits) {
  for (const bool low_discrepancy : {true, false})
    for (const bool stratified : {true, false}) {
      const SampledOperatorOptions options{
          .replicates = 3, .low_discrepancy = low_discrepancy, .stratified = stratified};
      auto stored = make(options);
      auto streamed = make(options);
      for (auto* transport : {&stored, &streamed}) {
        transport->double_rays(all_slots(*transport), 4, transport == &stored ? one_ : five_);
        // Some get more: every third.
        std::vector<std::uint32_t> some;
        for (std::uint32_t s = 0; s < transport->sides().size(); s += 3) some.push_back(s);
        transport->double_rays(some, 0, five_);
        std::vector<std::uint8_t> kept(transport->sides().size(), 1);
        for (std::size_t s = 0; s < kept.size(); s += 7) kept[s] = 0;
        transport->keep(kept, five_);
      }
      streamed.stream();
      EXPECT_EQ(streamed.bytes(), 0u);
      EXPECT_GT(stored.bytes(), 0u);
      const auto expected = applied(stored, one_);
      EXPECT_EQ(applied(stored, five_), expected);
      EXPECT_EQ(applied(streamed, five_), expected);
      EXPECT_EQ(hits_of(streamed, 2), hits_of(stored, 2));
    }
}

}  // namespace
}  // namespace luxel
