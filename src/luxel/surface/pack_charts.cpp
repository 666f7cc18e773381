// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/pack_charts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/image/pack_rectangles.h"
#include "luxel/patch/side.h"

namespace luxel {
namespace {

constexpr int smallest_page = 8;  // texels
constexpr int max_page = 16384;
constexpr int widest_margin = 64;

void check_texels(double count) {
  constexpr auto most = max_texels_of_pages;
  if (count > most)
    throw InputError(fmt::format(
        "the surfaces need {:.0f} million texels, expected at most {:.0f}: take fewer texels a metre",
        1e-6 * count, 1e-6 * most));
}

// Steps from the first texel to the last, at least one.
int steps(double length, double texel) {
  constexpr double rounding = 1e-4;  // of a texel
  return std::max(1, static_cast<int>(std::ceil(length / texel - rounding)));
}

// Puts all charts on pages of this size; a margin goes with each to its right and below.
int pack(std::vector<Rectangle>& rectangles, int page_size, int margin) {
  const auto room = page_size - margin;
  for (const auto& r : rectangles)
    if (r.width > room || r.height > room) return 0;
  return pack_rectangles(rectangles, room);
}

std::array<Vec2, 3> on_page(const PatchSet& patches, const Chart& chart, const Atlas::Place& place,
                            SideId side) {
  std::array<Vec2, 3> corners;
  const auto along = [&](std::size_t axis, int first, int count, double at) {
    const auto fraction = chart.size[axis] > 0.0 ? std::clamp(at / chart.size[axis], 0.0, 1.0) : 0.0;
    return static_cast<float>(first + 0.5 + fraction * (count - 1));
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = Charts::place(chart, patches.vertices[patches.corners[side.patch()][k]]);
    corners[k] = {along(0, place.x, place.width, at[0]), along(1, place.y, place.height, at[1])};
  }
  return corners;
}

}  // namespace

void check_pack_options(const PatchSet& patches, const PackOptions& options) {
  if (!(options.texel > 0.0f) || !std::isfinite(options.texel))
    throw InputError(fmt::format("a texel must be larger than 0 m, but it is {}", options.texel));
  if (options.page_size < smallest_page || options.page_size > max_page)
    throw InputError(fmt::format("a page must be from {} to {} texels wide, but it is {}", smallest_page,
                                 max_page, options.page_size));
  if (options.margin < 0 || options.margin > widest_margin || max_texels(options) < 1)
    throw InputError(
        fmt::format("the margin between charts must be from 0 to {} texels and leave room on a page, "
                    "but it is {}",
                    widest_margin, options.margin));
  const auto texel = static_cast<double>(options.texel);
  check_texels(std::accumulate(patches.area.begin(), patches.area.end(), 0.0) / (texel * texel));
}

Atlas pack_charts(const PatchSet& patches, const Charts& charts, const PackOptions& options) {
  check_pack_options(patches, options);
  std::vector<Rectangle> rectangles;
  std::int64_t area = 0;
  for (const auto& chart : charts.charts) {
    Rectangle r;
    r.width = steps(chart.size[0], static_cast<double>(options.texel)) + 1 + options.margin;
    r.height = steps(chart.size[1], static_cast<double>(options.texel)) + 1 + options.margin;
    area += std::int64_t{r.width} * r.height;
    rectangles.push_back(r);
  }

  check_texels(static_cast<double>(area));

  Atlas atlas;
  atlas.margin = options.margin;
  for (auto size = smallest_page; size < options.page_size && atlas.pages != 1; size *= 2) {
    if (std::int64_t{size} * size < area) continue;
    atlas.page_size = size;
    atlas.pages = pack(rectangles, size, options.margin);
  }
  if (atlas.pages != 1) {
    atlas.page_size = options.page_size;
    atlas.pages = pack(rectangles, options.page_size, options.margin);
  }
  if (atlas.pages == 0 && !rectangles.empty())
    throw InputError(
        fmt::format("a chart fits on no page of {} texels: take larger pages or fewer texels a "
                    "metre",
                    options.page_size));

  for (const auto& r : rectangles)
    atlas.places.push_back({static_cast<std::uint32_t>(r.page), r.x + options.margin, r.y + options.margin,
                            r.width - options.margin, r.height - options.margin});
  atlas.chart_of = charts.of_side;
  atlas.corners.resize(charts.of_side.size());
  for (std::size_t c = 0; c < charts.charts.size(); ++c)
    for (const auto side : charts.charts[c].sides)
      atlas.corners[side.index()] = on_page(patches, charts.charts[c], atlas.places[c], side);
  return atlas;
}

}  // namespace luxel
