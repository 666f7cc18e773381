// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/pack_charts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/image/pack_shapes.h"
#include "luxel/patch/side.h"
#include "luxel/surface/texel_support.h"

namespace luxel {
namespace {

constexpr int smallest_page = 8;  // texels
constexpr int max_page = 16384;
constexpr int widest_margin = 64;

void check_texels(double count) {
  constexpr auto most = max_texels_of_pages;
  if (count > most)
    throw with_hints(
        InputError(fmt::format("the surfaces need {:.0f} million texels, expected at most {:.0f}: "
                               "take fewer texels per metre",
                               1e-6 * count, 1e-6 * most)),
        {{Setting::texels_per_metre}});
}

// Number of steps from the first texel to the last, at least one.
int steps(double length, double texel) {
  constexpr double rounding = 1e-4;  // of a texel
  return std::max(1, static_cast<int>(std::ceil(length / texel - rounding)));
}

int texels_along(const Chart& chart, std::size_t axis, double texel) {
  return steps(chart.stretch * chart.size[axis], texel) + 1;
}

// Corners of a side in its chart's box, in texels: the middle of the first is 0.
std::array<glm::dvec2, 3> in_box(const PatchSet& patches, const Chart& chart, int width, int height,
                                 SideId side) {
  const auto along = [&](std::size_t axis, int count, double at) {
    const auto fraction = chart.size[axis] > 0.0 ? std::clamp(at / chart.size[axis], 0.0, 1.0) : 0.0;
    return fraction * (count - 1);
  };
  std::array<glm::dvec2, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = Charts::place(chart, patches.vertices[patches.corners[side.patch()][k]]);
    corners[k] = {along(0, width, at[0]), along(1, height, at[1])};
  }
  return corners;
}

// The texels that lookups within a chart read.
PixelShape shape_of(const PatchSet& patches, const Chart& chart, double texel) {
  PixelShape shape(texels_along(chart, 0, texel), texels_along(chart, 1, texel));
  for (const auto side : chart.sides) {
    const auto t = in_box(patches, chart, shape.width(), shape.height(), side);
    const auto low = glm::floor(glm::min(glm::min(t[0], t[1]), t[2]));
    const auto high = glm::ceil(glm::max(glm::max(t[0], t[1]), t[2]));
    for (auto y = static_cast<int>(low.y); y <= std::min(shape.height() - 1, static_cast<int>(high.y)); ++y)
      for (auto x = static_cast<int>(low.x); x <= std::min(shape.width() - 1, static_cast<int>(high.x)); ++x)
        if (!shape.has(x, y) && is_read_from(t, {x, y}, layout_rounding)) shape.add(x, y);
  }
  return shape;
}

int rounded_up(double size) {
  constexpr int multiple = 4;  // texels, the blocks of compressed textures
  return multiple * static_cast<int>(std::ceil(size / multiple));
}

// The smallest square pages found that hold all charts on as few of them as their area allows.
PackedShapes pack(const std::vector<PixelShape>& shapes, const PackOptions& options, int& page_size) {
  const auto margin = options.margin;
  double area = 0.0;
  int longest = 0;
  for (const auto& shape : shapes) {
    area += static_cast<double>(shape.width() + margin) * (shape.height() + margin) *
            static_cast<double>(shape.count()) / (static_cast<double>(shape.width()) * shape.height());
    longest = std::max({longest, shape.width(), shape.height()});
  }
  constexpr double densest = 0.97;  // of a page, with margins: first tried
  constexpr double growth = 1.015;
  const auto most = static_cast<double>(options.page_size);
  for (auto pages = std::max(1.0, std::ceil(area / (most * most)));; ++pages) {
    auto size = std::max<double>(smallest_page, std::sqrt(area / pages / densest) + margin);
    if (longest + 2 * margin > size) size = longest + 2 * margin;
    for (page_size = rounded_up(size); page_size < options.page_size;
         page_size = std::max(page_size + 4, rounded_up(growth * page_size)))
      if (auto packed = pack_shapes(shapes, page_size, margin, static_cast<int>(pages)); packed.pages > 0)
        return packed;
    page_size = options.page_size;
    if (auto packed = pack_shapes(shapes, page_size, margin, static_cast<int>(pages)); packed.pages > 0)
      return packed;
    if (longest + 2 * margin > options.page_size) return {};
  }
}

std::array<Vec2, 3> on_page(const PatchSet& patches, const Chart& chart, const Atlas::Place& place,
                            int quarters, SideId side) {
  const auto width = quarters % 2 == 0 ? place.width : place.height;
  const auto height = quarters % 2 == 0 ? place.height : place.width;
  const auto in = in_box(patches, chart, width, height, side);
  std::array<Vec2, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [x, y] = turned_place<double>(quarters, in[k].x, in[k].y, width - 1, height - 1);
    corners[k] = {static_cast<float>(place.x + 0.5 + x), static_cast<float>(place.y + 0.5 + y)};
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
  const auto texel = static_cast<double>(options.texel);
  double area = 0.0;
  for (const auto& chart : charts.charts)
    area += static_cast<double>(texels_along(chart, 0, texel)) * texels_along(chart, 1, texel);
  check_texels(area);
  std::vector<PixelShape> shapes;
  for (const auto& chart : charts.charts) shapes.push_back(shape_of(patches, chart, texel));

  Atlas atlas;
  atlas.margin = options.margin;
  const auto packed = pack(shapes, options, atlas.page_size);
  atlas.pages = packed.pages;
  if (atlas.pages == 0 && !shapes.empty())
    throw InputError(
        fmt::format("a chart fits on no page of {} texels: take larger pages or fewer texels per "
                    "metre",
                    options.page_size));

  atlas.chart_of = charts.of_side;
  atlas.corners.resize(charts.of_side.size());
  for (std::size_t c = 0; c < charts.charts.size(); ++c) {
    const auto& at = packed.shapes[c];
    const auto width = shapes[c].width(), height = shapes[c].height();
    atlas.places.push_back({static_cast<std::uint32_t>(at.page), at.x, at.y,
                            at.quarters % 2 == 0 ? width : height, at.quarters % 2 == 0 ? height : width});
    for (const auto side : charts.charts[c].sides)
      atlas.corners[side.index()] = on_page(patches, charts.charts[c], atlas.places[c], at.quarters, side);
  }
  return atlas;
}

}  // namespace luxel
