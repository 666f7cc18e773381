// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/texel_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "luxel/core/cross.h"
#include "luxel/core/none.h"
#include "luxel/patch/side.h"
#include "luxel/surface/texel_support.h"

namespace luxel {
namespace {

using Point = glm::dvec2;
using Triangle = std::array<Point, 3>;

struct Nearest {
  double distance2 = std::numeric_limits<double>::infinity();
  Point weights{0.0};  // of the corners 1 and 2
};

Nearest nearest_on_edge(const Triangle& t, std::size_t k, const Point& p) {
  const auto j = (k + 1) % 3;
  const auto edge = t[j] - t[k];
  const auto length2 = glm::dot(edge, edge);
  const auto fraction = length2 > 0.0 ? std::clamp(glm::dot(p - t[k], edge) / length2, 0.0, 1.0) : 0.0;
  const auto d = p - (t[k] + fraction * edge);
  std::array<double, 3> weight{};
  weight[k] += 1.0 - fraction;
  weight[j] += fraction;
  return {glm::dot(d, d), {weight[1], weight[2]}};
}

// The point of a triangle, including its edges, that is nearest to p.
Nearest nearest_point(const Triangle& t, const Point& p) {
  const auto area = cross(t[1] - t[0], t[2] - t[0]);
  if (area != 0.0) {
    const auto b = cross(p - t[0], t[2] - t[0]) / area;
    const auto c = cross(t[1] - t[0], p - t[0]) / area;
    if (b >= 0.0 && c >= 0.0 && b + c <= 1.0) return {0.0, {b, c}};
  }
  auto best = nearest_on_edge(t, 0, p);
  for (std::size_t k = 1; k < 3; ++k)
    if (const auto other = nearest_on_edge(t, k, p); other.distance2 < best.distance2) best = other;
  return best;
}

// The texels of a chart, row by row.
class ChartTexels {
 public:
  explicit ChartTexels(const Atlas::Place& place)
      : place_(place),
        nearest_(static_cast<std::size_t>(place.width) * static_cast<std::size_t>(place.height),
                 std::numeric_limits<double>::infinity()),
        is_dark_(nearest_.size(), false) {}

  // Dark sides are to be added after all others.
  void add(const Atlas& atlas, SideId side, bool is_dark, std::vector<TexelPlace>& page) {
    Triangle t;
    for (std::size_t k = 0; k < 3; ++k) t[k] = Point(atlas.corners[side.index()][k]) - 0.5;
    const auto low = glm::floor(glm::min(glm::min(t[0], t[1]), t[2]));
    const auto high = glm::ceil(glm::max(glm::max(t[0], t[1]), t[2]));
    const auto first = [](double v, int least) { return std::max(static_cast<int>(v), least); };
    const auto last = [](double v, int most) { return std::min(static_cast<int>(v), most - 1); };
    for (auto y = first(low.y, place_.y); y <= last(high.y, place_.y + place_.height); ++y)
      for (auto x = first(low.x, place_.x); x <= last(high.x, place_.x + place_.width); ++x) {
        const Point middle(x, y);
        const auto at = static_cast<std::size_t>((y - place_.y) * place_.width + x - place_.x);
        auto& best = nearest_[at];
        if (!(best > 0.0) || !is_read_from(t, middle, filling_rounding)) continue;
        const auto near = nearest_point(t, middle);
        if (!(near.distance2 < best)) continue;
        auto& place = page[static_cast<std::size_t>(y) * static_cast<std::size_t>(atlas.page_size) + x];
        if (is_dark && place.kind != Texel::empty && !is_dark_[at]) continue;
        is_dark_[at] = is_dark;
        best = near.distance2;
        constexpr double rounding = 1e-6;  // texels²: a border may coincide with texel centres
        place = {side, Vec2(near.weights), best < rounding ? Texel::inside : Texel::beside};
      }
  }

 private:
  Atlas::Place place_;
  std::vector<double> nearest_;
  std::vector<bool> is_dark_;  // whether the nearest is
};

}  // namespace

std::vector<std::vector<TexelPlace>> find_texel_places(const Atlas& atlas, const std::vector<bool>& is_dark,
                                                       const Context& context) {
  const auto dark = [&](SideId side) { return !is_dark.empty() && is_dark[side.index()]; };
  std::vector<std::vector<SideId>> sides(atlas.places.size());
  for (std::size_t i = 0; i < atlas.chart_of.size(); ++i)
    if (atlas.chart_of[i] != none) sides[atlas.chart_of[i]].push_back(SideId::at(i));
  const auto size = static_cast<std::size_t>(atlas.page_size);
  std::vector<std::vector<TexelPlace>> pages(static_cast<std::size_t>(atlas.pages),
                                             std::vector<TexelPlace>(size * size));
  constexpr std::size_t texels_between_calls = 1 << 18;
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    if (context.report({"places", static_cast<double>(first) / static_cast<double>(sides.size())}) ==
        Next::stop)
      return {};
    for (std::size_t texels = 0; last < sides.size() && texels < texels_between_calls; ++last)
      texels += static_cast<std::size_t>(atlas.places[last].width) *
                static_cast<std::size_t>(atlas.places[last].height);
    // Charts do not share texels, so threads do not conflict.
    context.for_chunks(last - first, 1, [&](std::size_t begin, std::size_t end, int) {
      for (auto c = first + begin; c < first + end; ++c) {
        ChartTexels texels(atlas.places[c]);
        for (const bool of_dark : {false, true})
          for (const auto side : sides[c])
            if (dark(side) == of_dark) texels.add(atlas, side, of_dark, pages[atlas.places[c].page]);
      }
    });
  }
  return pages;
}

}  // namespace luxel
