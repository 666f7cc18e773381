// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "luxel/patch/side.h"
#include "luxel/surface/flat_cover.h"
#include "luxel/surface/make_charts.h"

#include "support/lightmap_scenes.h"

namespace luxel::test {

inline Charts charts_of(const PatchSet& patches, float texel, float back = 0.0f, int max_texels = 1000) {
  return make_charts(patches, even_light(patches, 1.0f, back), {.texel = texel, .max_texels = max_texels},
                     Context(2));
}

inline void expect_every_front_once(const PatchSet& patches, const Charts& charts) {
  std::size_t sides = 0;
  for (const auto& chart : charts.charts) sides += chart.sides.size();
  EXPECT_EQ(sides, patches.size());
  for (std::size_t p = 0; p < patches.size(); ++p) EXPECT_NE(charts.of_side[2 * p], none);
}

// No projected side covers another of its chart.
inline void expect_no_overlap(const PatchSet& patches, const Charts& charts) {
  for (const auto& chart : charts.charts) {
    FlatCover cover({0.0, 0.0}, {chart.size[0], chart.size[1]}, chart.sides.size());
    for (const auto side : chart.sides) {
      FlatCover::Triangle t;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto at = Charts::place(chart, patches.points(side.patch())[!side.is_back() ? k : 2 - k]);
        t[k] = {at[0], at[1]};
        EXPECT_GE(std::min(at[0], at[1]), -1e-5);
        EXPECT_LE(at[0], chart.size[0] + 1e-5);
        EXPECT_LE(at[1], chart.size[1] + 1e-5);
      }
      EXPECT_TRUE(cover.add(t));
    }
  }
}

}  // namespace luxel::test
