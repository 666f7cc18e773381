// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/local_lines.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/patch/side.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

struct Shot {
  Context context{1};
  PatchSet patches;
  Tracer tracer;

  explicit Shot(const Scene& scene)
      : patches(make_patches(scene, {.max_edge = no_max_edge})), tracer(patches, context) {}
  LineCounts counts(SideId side, std::uint32_t lines, std::uint64_t seed = 1, std::uint32_t step = 0) const {
    LineCounts counts;
    count_local_lines(patches, tracer, side, {lines, seed, step}, counts);
    return counts;
  }
};

std::uint64_t met(const LineCounts& counts) {
  return std::accumulate(counts.entries.begin(), counts.entries.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const auto& entry) { return sum + entry.lines; });
}

TEST(LocalLines, every_line_ends_somewhere_and_is_counted_once) {
  const Shot shot(truth::cube_a());
  const auto counts = shot.counts(SideId(0, false), 10'001);
  EXPECT_EQ(counts.lines, 10'001u);
  EXPECT_EQ(counts.escaped, 0u);
  EXPECT_EQ(met(counts), 10'001u);
  for (std::size_t k = 0; k < counts.entries.size(); ++k) {
    EXPECT_GT(counts.entries[k].lines, 0u);
    EXPECT_FALSE(counts.entries[k].side.is_back());
    EXPECT_GT(counts.entries[k].side.patch(), 1u);  // none ends on the floor it came from
    EXPECT_TRUE(k == 0 || counts.entries[k - 1].side < counts.entries[k].side);
  }
}

TEST(LocalLines, a_row_has_an_address) {
  const Shot shot(truth::cube_a());
  const auto same = [](const LineCounts& a, const LineCounts& b) {
    return a.entries.size() == b.entries.size() &&
           std::equal(a.entries.begin(), a.entries.end(), b.entries.begin(),
                      [](const auto& x, const auto& y) { return x.side == y.side && x.lines == y.lines; });
  };
  const auto counts = shot.counts(SideId(0, false), 5000);
  EXPECT_TRUE(same(counts, shot.counts(SideId(0, false), 5000)));
  EXPECT_FALSE(same(counts, shot.counts(SideId(0, false), 5000, 2)));
  EXPECT_FALSE(same(counts, shot.counts(SideId(0, false), 5000, 1, 1)));
}

TEST(LocalLines, what_meets_nothing_has_escaped_and_backs_are_told_from_fronts) {
  const Shot shot(truth::plates());  // two squares of two triangles, the upper looks down
  const auto up = shot.counts(SideId(0, false), 20'000), out = shot.counts(SideId(0, true), 100);
  EXPECT_EQ(met(up) + up.escaped, 20'000u);
  EXPECT_EQ(out.escaped, 100u);
  EXPECT_TRUE(out.entries.empty());
  const auto row = row_of(up);
  double sum = row.escaped;
  for (const auto& entry : row.entries) {
    EXPECT_FALSE(entry.side.is_back());
    EXPECT_GE(entry.side.patch(), 2u);
    sum += static_cast<double>(entry.factor);
  }
  EXPECT_NEAR(sum, 1.0, 1e-6);
  // Four triangle pairs make the plates' factor; by symmetry two rows of them are alike. Five standard
  // errors.
  EXPECT_NEAR(1.0 - row.escaped, 0.19982489569838746, 5.0 * line_standard_error(up.escaped, up.lines));
  EXPECT_EQ(row_of(shot.counts(SideId(0, false), 0)).entries.size(), 0u);
}

TEST(LocalLines, the_error_bar_is_that_of_a_fraction) {
  EXPECT_NEAR(line_standard_error(2500, 10'000), std::sqrt(0.25 * 0.75 / 10'000), 1e-6);
  EXPECT_GT(line_standard_error(0, 100), 1e-3);  // none seen is not none
  EXPECT_NEAR(line_standard_error(0, 100), line_standard_error(100, 100), 1e-15);
  EXPECT_EQ(line_factor(25, 100), 0.25);
  EXPECT_EQ(line_factor(0, 0), 0.0);
}

}  // namespace
}  // namespace luxel
