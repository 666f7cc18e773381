// SPDX-License-Identifier: Apache-2.0
// Rays of the sampled operator through panes of glass: reciprocity, and their stored data. Risk of a false
// alarm: about one in a million per comparison.
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/solve/hit_store.h"
#include "luxel/solve/sampled.h"

#include "support/glass_panes.h"

namespace luxel {
namespace {

using truth::glazed_room;
using truth::Glazing;
using truth::parted_room;
using truth::with_portals;

constexpr double sigmas = 6.0;
const Vec3 tint(0.5f, 0.7f, 0.9f);

struct Rays {
  PatchSet patches;
  Context context{2};
  Tracer tracer;
  HitStore hits;

  explicit Rays(PatchSet of, std::uint32_t per_side = 1024)
      : patches(std::move(of)),
        tracer(patches, context),
        hits(patches, all_gather_sides(patches, make_patch_tree(patches, context)), tracer,
             {.replicates = 4}) {
    std::vector<std::uint32_t> all(hits.sides().size());
    for (std::uint32_t s = 0; s < all.size(); ++s) all[s] = s;
    hits.double_rays(all, per_side, context);
  }
  std::vector<std::vector<double>> counts() const {
    std::vector<std::vector<double>> n(hits.sides().size(), std::vector<double>(hits.elements(), 0.0));
    for (std::uint32_t r = 0; r < hits.replicates(); ++r)
      for (std::size_t block = 0; block < hits.blocks(); ++block)
        hits.for_each_hit(r, block, [&](std::uint32_t s, std::uint32_t element) { n[s][element] += 1.0; });
    return n;
  }
};

TEST(GlassRays, rays_through_it_are_reciprocal) {
  const Rays rays(make_patches(parted_room(Vec3(0.4f)), {.max_edge = 0.6f}));
  const auto n = rays.counts();
  std::size_t compared = 0;
  for (std::size_t i = 0; i < n.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto area = [&](std::size_t s) {
        return static_cast<double>(rays.patches.area[rays.hits.sides().side[s].patch()]);
      };
      if (n[i][j] + n[j][i] < 400.0) continue;
      const auto to = area(i) * n[i][j], back = area(j) * n[j][i];
      EXPECT_NEAR(to, back, sigmas * std::hypot(area(i) * std::sqrt(n[i][j]), area(j) * std::sqrt(n[j][i])))
          << i << " " << j;
      ++compared;
    }
  EXPECT_GT(compared, 100u);
}

TEST(GlassRays, rays_are_kept_in_the_fraction_of_the_transmittance_and_tinted_in_the_mean) {
  for (const bool portals : {false, true}) {
    const Rays clear(with_portals(glazed_room(Glazing::sheet, Vec3(1.0f)), portals, 0.6f));
    const Rays glazed(with_portals(glazed_room(Glazing::sheet, tint), portals, 0.6f));
    EXPECT_FALSE(clear.hits.has_panes());
    EXPECT_EQ(glazed.hits.elements(), clear.hits.elements() + 1 + (portals ? 8 : 4));
    const auto n = clear.counts(), m = glazed.counts();
    const auto sinks = clear.hits.sides().size();
    double met = 0.0, lost = 0.0, kept = 0.0;
    std::array<double, 3> of_band{};
    for (std::size_t s = 0; s < n.size(); ++s) {
      for (std::size_t e = 0; e < sinks; ++e) EXPECT_LE(m[s][e], n[s][e]);
      lost += m[s][glazed.hits.in_panes()];
      for (std::size_t e = sinks; e < clear.hits.elements(); ++e)
        if (clear.hits.is_escape(e)) met += n[s][e];
      for (std::size_t e = sinks; e < glazed.hits.elements(); ++e) {
        if (!glazed.hits.is_escape(e)) continue;
        kept += m[s][e];
        for (std::size_t b = 0; b < 3; ++b) of_band[b] += m[s][e] * glazed.hits.tint_of(e, b);
      }
    }
    EXPECT_NEAR(kept + lost, met, 1e-9 * met);
    // The outside escapes without crossing glass; all that is lost crossed it.
    const auto weighted = 0.2126 * of_band[0] + 0.7152 * of_band[1] + 0.0722 * of_band[2];
    EXPECT_NEAR(weighted, kept, 1e-9 * kept);
    EXPECT_GT(lost, 1000.0);
    for (std::size_t b = 0; b < 3; ++b) {
      // Transmittances are nearly in the ratio of those at normal incidence (angles of 50 degrees or so).
      const auto crossed = lost / (1.0 - 0.63);
      EXPECT_NEAR(met - of_band[b], crossed * (1.0 - static_cast<double>(tint[static_cast<int>(b)])),
                  0.2 * crossed)
          << b;
    }
  }
}

TEST(GlassRays, stored_and_streamed_rays_give_the_same_light) {
  const auto patches = with_portals(glazed_room(Glazing::sheet, tint, 0.6f), true);
  const Context context(2);
  const Tracer tracer(patches, context);
  Solution stored, streamed;
  const SampledOptions options{.error = 0.03, .memory = std::uint64_t{1} << 33};
  auto tight = options;
  tight.memory = 1;
  EXPECT_FALSE(solve_sampled(patches, tracer, stored, options, context).streamed);
  EXPECT_TRUE(solve_sampled(patches, tracer, streamed, tight, context).streamed);
  EXPECT_EQ(stored.irradiance.front, streamed.irradiance.front);
  EXPECT_EQ(stored.irradiance.back, streamed.irradiance.back);
  EXPECT_EQ(stored.standard_error.front, streamed.standard_error.front);
}

}  // namespace
}  // namespace luxel
