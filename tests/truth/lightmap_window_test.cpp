// SPDX-License-Identifier: Apache-2.0
// Texels of a room that is lit through a window: cosine rays alone find it too rarely.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/render/make_lightmap.h"
#include "luxel/solve/sampled.h"

#include "support/window_rooms.h"

namespace luxel {
namespace {

// Light falls by 3 % from texel to texel where it falls fastest, beside the window; the noise of a texel is
// 2 %. A texel that misses the window is darker by half.
TEST(Lightmap, has_no_flecks_in_a_room_with_a_window) {
  auto patches = make_patches(truth::under_sky(truth::window_room()), {.max_edge = 0.4f});
  patches.portals = truth::window_portals();
  const Context context;
  const Tracer tracer(patches, context);
  Solution light;
  solve_sampled(patches, tracer, light, {.error = 0.01}, context);
  LightmapReport report;
  const auto map = make_lightmap({patches, light, &tracer}, {.texels_per_metre = 30.0}, &report, context);
  int compared = 0;
  double largest = 0.0;
  for (const auto& page : map.pages) {
    const auto width = page.irradiance.width;
    for (int i = width; i + width < static_cast<int>(page.texels.size()); ++i) {
      const std::array<int, 5> cross = {i, i - 1, i + 1, i - width, i + width};
      float mean = 0.0f;
      bool is_inside = true;
      for (const auto at : cross) {
        is_inside &= page.texels[static_cast<std::size_t>(at)] == Texel::inside;
        mean += 0.2f * page.irradiance.pixels[static_cast<std::size_t>(at)].g;
      }
      if (!is_inside) continue;
      ++compared;
      const auto here = page.irradiance.pixels[static_cast<std::size_t>(i)].g;
      largest = std::max(largest, static_cast<double>(std::abs(here - mean) / mean));
    }
  }
  EXPECT_GT(compared, 10'000);
  EXPECT_LT(largest, 0.15);
  EXPECT_EQ(report.texels.short_of_it, 0u);
}

}  // namespace
}  // namespace luxel
