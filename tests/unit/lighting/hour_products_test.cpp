// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/hour_products.h"

#include <cmath>

#include <gtest/gtest.h>

namespace luxel {
namespace {

// Numbers that floats hold exactly, so that any order of summing gives the same.
TEST(PackedColumns, times_skies_are_sums_over_patches) {
  for (const std::size_t points : {1u, 7u, 8u, 9u, 30u})
    for (const std::size_t hours : {0u, 1u, 3u, 4u, 33u, 70u}) {
      constexpr std::size_t patches = 5;
      PackedColumns columns(patches, points);
      std::vector<float> sky(hours * patches);
      for (std::size_t p = 0; p < patches; ++p)
        for (std::size_t m = 0; m < points; ++m) columns.at(p, m) = static_cast<float>(p * p + 3 * m);
      for (std::size_t i = 0; i < sky.size(); ++i) sky[i] = static_cast<float>(i % 11);
      const auto light = columns.times(sky, Context(3));
      ASSERT_EQ(light.size(), hours * points);
      for (std::size_t h = 0; h < hours; ++h)
        for (std::size_t m = 0; m < points; ++m) {
          float sum = 0.0f;
          for (std::size_t p = 0; p < patches; ++p)
            sum += static_cast<float>((h * patches + p) % 11) * static_cast<float>(p * p + 3 * m);
          EXPECT_EQ(light[h * points + m], sum) << points << " points, hour " << h << ", point " << m;
        }
    }
}

}  // namespace
}  // namespace luxel
