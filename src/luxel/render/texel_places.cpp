// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/texel_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "luxel/core/none.h"
#include "luxel/patch/side.h"
#include "luxel/surface/cross.h"

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

// Whether the open square of two by two texels around p, the support of its bilinear weight, overlaps the
// triangle.
bool is_read_from(const Triangle& t, const Point& p) {
  constexpr double reach = 1.0 - 1e-4;
  const auto low = glm::min(glm::min(t[0], t[1]), t[2]) - p;
  const auto high = glm::max(glm::max(t[0], t[1]), t[2]) - p;
  if (low.x >= reach || low.y >= reach || high.x <= -reach || high.y <= -reach) return false;
  // Looks for an edge of the triangle that separates the square from the third corner.
  for (std::size_t k = 0; k < 3; ++k) {
    const auto a = t[k] - p, edge = t[(k + 1) % 3] - t[k];
    const auto middle = cross(edge, -a);
    const auto corner = cross(edge, t[(k + 2) % 3] - t[k]);
    const auto half = reach * (std::abs(edge.x) + std::abs(edge.y));
    if (corner != 0.0 && (corner > 0.0 ? middle + half <= 0.0 : middle - half >= 0.0)) return false;
  }
  return true;
}

// The texels of a chart, row by row.
class ChartTexels {
 public:
  explicit ChartTexels(const Atlas::Place& place)
      : place_(place),
        nearest_(static_cast<std::size_t>(place.width) * static_cast<std::size_t>(place.height),
                 std::numeric_limits<double>::infinity()) {}

  void add(const Atlas& atlas, SideId side, std::vector<TexelPlace>& page) {
    Triangle t;
    for (std::size_t k = 0; k < 3; ++k) t[k] = Point(atlas.corners[side.index()][k]) - 0.5;
    const auto low = glm::floor(glm::min(glm::min(t[0], t[1]), t[2]));
    const auto high = glm::ceil(glm::max(glm::max(t[0], t[1]), t[2]));
    const auto first = [](double v, int least) { return std::max(static_cast<int>(v), least); };
    const auto last = [](double v, int most) { return std::min(static_cast<int>(v), most - 1); };
    for (auto y = first(low.y, place_.y); y <= last(high.y, place_.y + place_.height); ++y)
      for (auto x = first(low.x, place_.x); x <= last(high.x, place_.x + place_.width); ++x) {
        const Point middle(x, y);
        auto& best = nearest_[static_cast<std::size_t>((y - place_.y) * place_.width + x - place_.x)];
        if (!(best > 0.0) || !is_read_from(t, middle)) continue;
        const auto near = nearest_point(t, middle);
        if (!(near.distance2 < best)) continue;
        best = near.distance2;
        constexpr double rounding = 1e-6;  // texels²: a border may coincide with texel centres
        page[static_cast<std::size_t>(y) * static_cast<std::size_t>(atlas.page_size) + x] = {
            side, Vec2(near.weights), best < rounding ? Texel::inside : Texel::beside};
      }
  }

 private:
  Atlas::Place place_;
  std::vector<double> nearest_;
};

}  // namespace

std::vector<std::vector<TexelPlace>> find_texel_places(const Atlas& atlas, const Context& context) {
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
        for (const auto side : sides[c]) texels.add(atlas, side, pages[atlas.places[c].page]);
      }
    });
  }
  return pages;
}

}  // namespace luxel
