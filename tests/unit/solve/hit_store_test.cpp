// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/hit_store.h"

#include <vector>

#include <gtest/gtest.h>

#include "luxel/core/sobol.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/patch/side.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

class HitStoreTest : public testing::Test {
 protected:
  HitStore make(const HitStoreOptions& options = {}) const {
    return {patches_, all_gather_sides(patches_, make_patch_tree(patches_, one_)), tracer_, options};
  }
  static std::vector<std::uint32_t> all_receivers(const HitStore& hits) {
    std::vector<std::uint32_t> receivers(hits.sides().size());
    for (std::uint32_t s = 0; s < receivers.size(); ++s) receivers[s] = s;
    return receivers;
  }
  static std::vector<std::uint32_t> hits_of(const HitStore& store, std::uint32_t replicate) {
    std::vector<std::uint32_t> hits;
    for (std::size_t b = 0; b < store.blocks(); ++b)
      store.for_each_hit(replicate, b, [&](std::uint32_t, std::uint32_t e) { hits.push_back(e); });
    return hits;
  }

  Context one_{1}, five_{5};
  PatchSet patches_ = make_patches(truth::l_room(), {.max_edge = 0.2f});
  Tracer tracer_{patches_, one_};
};

// Rays are made many at a time and traced in another order; each is still the one of its own address.
TEST_F(HitStoreTest, a_hit_is_that_of_the_ray_made_and_traced_alone) {
  auto hits = make({.seed = 7, .replicates = 2});
  constexpr std::uint32_t n = 32;
  hits.double_rays(all_receivers(hits), n, five_);
  const auto& sides = hits.sides();
  for (const std::uint32_t replicate : {0u, 1u}) {
    const auto met = hits_of(hits, replicate);
    ASSERT_EQ(met.size(), sides.size() * n);
    for (std::size_t i = 0; i < met.size(); i += 5) {
      const auto receiver = i / n;
      const auto back = receiver >= sides.fronts ? 1u : 0u;
      const auto key = mix64(stream_key(7, 0x67617468u, 2 * replicate + back));
      const OwenSobol points(stream_key(key, 0, sides.position[receiver] / sequence_positions));
      const auto x = points.first4(sides.position[receiver] * n + static_cast<std::uint32_t>(i % n));
      const std::array<float, 4> u = {x[2], x[3], x[0], x[1]};
      const auto hit = tracer_.nearest(PatchEmitter(patches_, sides.side[receiver]).ray(u));
      if (hit && sides.receiver_of_side[SideId(hit.patch, hit.back).index()] != none)
        ASSERT_EQ(met[i], sides.receiver_of_side[SideId(hit.patch, hit.back).index()]) << i;
      else
        ASSERT_GE(met[i], sides.size()) << i;
    }
  }
}

TEST_F(HitStoreTest, streamed_or_stored_the_hits_are_the_same) {
  for (const bool low_discrepancy : {true, false})
    for (const bool stratified : {true, false}) {
      const HitStoreOptions options{
          .replicates = 3, .low_discrepancy = low_discrepancy, .stratified = stratified};
      auto stored = make(options);
      auto streamed = make(options);
      for (auto* hits : {&stored, &streamed}) {
        hits->double_rays(all_receivers(*hits), 4, hits == &stored ? one_ : five_);
        // Some get more: every third.
        std::vector<std::uint32_t> some;
        for (std::uint32_t s = 0; s < hits->sides().size(); s += 3) some.push_back(s);
        hits->double_rays(some, 0, five_);
        std::vector<std::uint8_t> kept(hits->sides().size(), 1);
        for (std::size_t s = 0; s < kept.size(); s += 7) kept[s] = 0;
        hits->keep(kept, five_);
      }
      streamed.stream();
      EXPECT_EQ(streamed.bytes(), 0u);
      EXPECT_GT(stored.bytes(), 0u);
      EXPECT_EQ(hits_of(streamed, 2), hits_of(stored, 2));
    }
}

}  // namespace
}  // namespace luxel
