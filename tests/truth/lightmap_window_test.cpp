// SPDX-License-Identifier: Apache-2.0
// Texels of a room that is lit through a window: cosine rays alone find it too rarely.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/render/make_lightmap.h"
#include "luxel/solve/sampled.h"

#include "support/window_rooms.h"

namespace luxel {
namespace {

// |texel - mean of it and its four neighbours| over that mean, at texels that the function takes:
// is_taken(page, [5] of the cross).
template <typename IsTaken>
std::vector<double> deviations(const Lightmap& map, const IsTaken& is_taken) {
  std::vector<double> found;
  for (std::size_t p = 0; p < map.pages.size(); ++p) {
    const auto& page = map.pages[p];
    const auto width = page.irradiance.width;
    for (int i = width; i + width < static_cast<int>(page.texels.size()); ++i) {
      const std::array<int, 5> cross = {i, i - 1, i + 1, i - width, i + width};
      float mean = 0.0f;
      bool is_inside = true;
      for (const auto at : cross) {
        is_inside &= page.texels[static_cast<std::size_t>(at)] == Texel::inside;
        mean += 0.2f * page.irradiance.pixels[static_cast<std::size_t>(at)].g;
      }
      if (!is_inside || !is_taken(p, cross)) continue;
      const auto here = page.irradiance.pixels[static_cast<std::size_t>(i)].g;
      found.push_back(static_cast<double>(std::abs(here - mean) / mean));
    }
  }
  return found;
}

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
  const auto found = deviations(map, [](std::size_t, const auto&) { return true; });
  EXPECT_GT(found.size(), 10'000u);
  EXPECT_LT(*std::max_element(found.begin(), found.end()), 0.15);
  EXPECT_EQ(report.texels.short_of_it, 0u);
}

// All light comes from a spot of 6 cm on the floor, which few rays find. Where the light of the patches is
// even, that of texels is, too: to 1.4 %, where gathered light alone was off by 15 %.
TEST(Lightmap, has_no_flecks_in_a_room_lit_by_a_small_bright_spot) {
  auto scene = truth::window_room().scene();
  scene.point_lights.push_back({.name = "spot",
                                .kind = PointLightKind::spot,
                                .position = Vec3(1.0f, 1.0f, 1.4f),
                                .direction = Vec3(0, 0, -1),
                                .intensity = Vec3(1000.0f),
                                .cos_inner = 0.9998f,
                                .cos_outer = 0.9995f});
  const auto patches = make_patches(scene, {.max_edge = 0.1f});
  const Context context;
  const Tracer tracer(patches, context);
  Solution light;
  solve_sampled(patches, tracer, light, {.error = 0.03}, context);
  TexelOptions none;
  none.error = 0.0;
  LightmapReport report;
  const auto even =
      make_lightmap({patches, light, &tracer}, {.texels_per_metre = 30.0, .texels = none}, nullptr, context);
  const auto map = make_lightmap({patches, light, &tracer}, {.texels_per_metre = 30.0}, &report, context);
  EXPECT_GT(report.texels.gathered, 1000u);
  const auto is_even = [&](std::size_t p, const std::array<int, 5>& cross) {
    float low = 1e30f, high = 0.0f;
    for (const auto at : cross) {
      const auto E = even.pages[p].irradiance.pixels[static_cast<std::size_t>(at)].g;
      low = std::min(low, E);
      high = std::max(high, E);
    }
    return high < 1.03f * low;
  };
  const auto found = deviations(map, is_even);
  ASSERT_GT(found.size(), 3'000u);
  double squares = 0.0;
  for (const auto x : found) squares += x * x / static_cast<double>(found.size());
  EXPECT_LT(std::sqrt(squares), 0.03);
}

}  // namespace
}  // namespace luxel
