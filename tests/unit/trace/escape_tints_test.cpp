// SPDX-License-Identifier: Apache-2.0
// Tints that escapes through tinted glass are dealt to.
#include "luxel/trace/escape_tints.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/scene/glass.h"

#include "support/glass_panes.h"

namespace luxel {
namespace {

struct Tints {
  explicit Tints(const Vec3& transmittance)
      : patches(make_patches(truth::glazed_room(truth::Glazing::sheet, transmittance), {.max_edge = 1.0f})),
        panes(patches),
        tints(patches, panes) {}

  double mean_of(const std::array<double, 3>& through) const { return panes.luminous(through); }
  // Means of what a ray carries, by evenly spaced u, [band]; the last is the mean of the squares of blue.
  std::array<double, 4> means(const std::array<double, 3>& through) const {
    constexpr int n = 200'000;
    std::array<double, 4> sum{};
    for (int i = 0; i < n; ++i) {
      const auto tint = tints.choose(through, mean_of(through), (i + 0.5) / n);
      for (std::size_t b = 0; b < 3; ++b) sum[b] += (tint ? tints.of(*tint, b) : 1.0) / n;
      const auto blue = tint ? tints.of(*tint, 2) : 1.0;
      sum[3] += blue * blue / n;
    }
    return sum;
  }

  PatchSet patches;
  Panes panes;
  EscapeTints tints;
};

TEST(EscapeTints, grey_glass_has_none) {
  EXPECT_EQ(Tints(Vec3(0.7f)).tints.size(), 0u);
  EXPECT_EQ(Tints(Vec3(0.7f, 0.7f, 0.6f)).tints.size(), 4u);
}

TEST(EscapeTints, each_band_has_its_mean_whatever_the_ray_crosses) {
  for (const auto& glass : {Vec3(0.5f, 0.7f, 0.9f), Vec3(0.9f, 0.1f, 0.1f), Vec3(0.0f, 0.0f, 0.8f)}) {
    const Tints tints(glass);
    for (const auto& through :
         {std::array{0.5, 0.7, 0.9}, std::array{0.25, 0.49, 0.81}, std::array{0.9, 0.1, 0.1},
          std::array{0.3, 0.3, 0.3}, std::array{0.0, 0.0, 0.5}, std::array{1e-3, 1e-6, 0.0}}) {
      const auto means = tints.means(through);
      for (std::size_t b = 0; b < 3; ++b) EXPECT_NEAR(means[b], through[b] / tints.mean_of(through), 1e-3);
    }
  }
}

// Dealt to single bands alone, as far as no mean over all bands holds them, blue would have a mean square of
// 5 times the square of its mean.
TEST(EscapeTints, a_tint_per_material_saves_most_of_the_noise_of_single_bands) {
  const Tints tints({0.5f, 0.7f, 0.9f});
  const auto ratio = [&](double cosine) {
    std::array<double, 3> through{};
    for (std::size_t b = 0; b < 3; ++b) through[b] = pane_transmittance(std::array{0.5, 0.7, 0.9}[b], cosine);
    const auto means = tints.means(through);
    return means[3] / (means[2] * means[2]);
  };
  EXPECT_LT(ratio(0.7071), 1.001);
  EXPECT_LT(ratio(1.0), 2.0);
  EXPECT_LT(ratio(0.3), 2.0);
}

}  // namespace
}  // namespace luxel
