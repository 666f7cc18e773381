// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/chart_cuts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/patch/side.h"
#include "luxel/surface/cross.h"
#include "luxel/surface/flat_cover.h"
#include "luxel/surface/flat_fragment.h"

namespace luxel {
namespace {

using Point = glm::dvec2;

constexpr double widest_gap = 2.0;    // texels; a wider one has a texel for each of its borders
constexpr double shortest_gap = 4.0;  // texels; less is the foot of a leg, not of a wall

Point on_chart(const Chart& chart, const Vec3& p) {
  const auto place = Charts::place(chart, p);
  return {place[0], place[1]};
}

}  // namespace

EdgesOfSides::EdgesOfSides(std::size_t sides, const std::vector<SideEdge>& edges) : begin_(sides + 1, 0) {
  for (const auto& e : edges)
    for (const auto& half : e.halves) ++begin_[half.side.index() + 1];
  for (std::size_t s = 0; s < sides; ++s) begin_[s + 1] += begin_[s];
  edges_.resize(begin_[sides]);
  auto next = begin_;
  for (std::uint32_t i = 0; i < edges.size(); ++i)
    for (const auto& half : edges[i].halves) edges_[next[half.side.index()]++] = i;
}

ChartCuts::ChartCuts(const PatchSet& patches, const std::vector<SideEdge>& edges,
                     const EdgesOfSides& of_sides, const ChartOptions& options)
    : patches_(patches),
      edges_(edges),
      of_sides_(of_sides),
      options_(options),
      fragment_(side_count(patches.size()), 0),
      cut_in_vain_(edges.size(), false) {}

std::vector<Chart> ChartCuts::cut(std::vector<SideId> sides, const Vec3d& direction) {
  std::vector<Chart> charts;
  auto open = connected(sides);
  while (!open.empty()) {
    auto chart = flat_chart(patches_, std::move(open.back()), direction);
    open.pop_back();
    label(chart.sides);
    const auto [wanted, line] = cut_of(chart);
    if (!wanted) {
      charts.push_back(std::move(chart));
      continue;
    }
    std::array<Sides, 2> halves;
    for (const auto side : chart.sides) halves[lies_left(chart, line, side) ? 0 : 1].push_back(side);
    for (const auto& half : halves)
      for (auto& fragment : connected(half)) open.push_back(std::move(fragment));
  }
  return charts;
}

bool ChartCuts::lies_left(const Chart& chart, const Line& line, SideId side) const {
  return cross(line.along, on_chart(chart, patches_.centroid(side.patch())) - line.point) > 0.0;
}

void ChartCuts::label(const Sides& sides) {
  ++fragments_;
  for (const auto side : sides) fragment_[side.index()] = fragments_;
}

std::vector<ChartCuts::Sides> ChartCuts::connected(const Sides& sides) {
  label(sides);
  const auto open = fragments_;
  std::vector<Sides> parts;
  for (const auto first : sides) {
    if (fragment_[first.index()] != open) continue;
    Sides part = {first};
    fragment_[first.index()] = ++fragments_;
    for (std::size_t i = 0; i < part.size(); ++i)
      for (const auto e : of_sides_.at(part[i])) {
        const auto& halves = edges_[e].halves;
        const auto other = halves[halves[0].side == part[i] ? 1 : 0].side;
        if (!edges_[e].smooth || fragment_[other.index()] != open) continue;
        fragment_[other.index()] = fragments_;
        part.push_back(other);
      }
    parts.push_back(std::move(part));
  }
  return parts;
}

ChartCuts::Cut ChartCuts::cut_of(const Chart& chart) {
  if (const auto page = across_page(chart); page.wanted) return page;
  if (const auto contact = at_contact(chart); contact.wanted) return contact;
  return at_thin_gap(chart);
}

ChartCuts::Cut ChartCuts::across_page(const Chart& chart) const {
  const auto most = static_cast<double>(options_.max_texels) * static_cast<double>(options_.texel);
  if (chart.size[0] <= most && chart.size[1] <= most) return {};
  const Cut across{true, {{0.5 * chart.size[0], 0.0}, {0.0, 1.0}}};
  if (parts(chart, across.line)) return across;
  if (chart.sides.size() > 1) {  // all around one place: by their order, as nothing else tells them apart
    const auto x = on_chart(chart, patches_.centroid(chart.sides[0].patch())).x;
    for (const auto side : chart.sides)
      if (const auto other = on_chart(chart, patches_.centroid(side.patch())).x; other != x)
        return {true, {{std::max(x, other), 0.0}, {0.0, 1.0}}};
  }
  throw InputError(fmt::format(
      "a patch {:.3g} m long needs more than {} texels of {:.3g} m and fits on no page: take fewer "
      "texels a metre, larger pages, or smaller patches",
      chart.size[0], options_.max_texels, options_.texel));
}

ChartCuts::Cut ChartCuts::at_contact(const Chart& chart) {
  for (const auto side : chart.sides)
    for (const auto e : of_sides_.at(side)) {
      const auto& edge = edges_[e];
      const auto a = edge.halves[0].side, b = edge.halves[1].side;
      if (edge.smooth || a != side || fragment_[b.index()] != fragment_[a.index()] || cut_in_vain_[e])
        continue;
      const auto p = on_chart(chart, patches_.vertices[edge.ends[0]]);
      const Line line{p, on_chart(chart, patches_.vertices[edge.ends[1]]) - p};
      if (lies_left(chart, line, a) != lies_left(chart, line, b)) return {true, line};
      cut_in_vain_[e] = true;
    }
  return {};
}

bool ChartCuts::is_border(SideId side, std::uint32_t k) const {
  for (const auto e : of_sides_.at(side)) {
    const auto& halves = edges_[e].halves;
    const auto own = halves[0].side == side ? 0 : 1;
    if (halves[own].edge == k && edges_[e].smooth &&
        fragment_[halves[1 - own].side.index()] == fragment_[side.index()])
      return false;
  }
  return true;
}

bool ChartCuts::parts(const Chart& chart, const Line& line) const {
  const auto is_left = [&](SideId side) { return lies_left(chart, line, side); };
  const auto first = is_left(chart.sides.front());
  return std::any_of(chart.sides.begin(), chart.sides.end(),
                     [&](auto side) { return is_left(side) != first; });
}

// Two borders that face each other so near that they would share texels.
ChartCuts::Cut ChartCuts::at_thin_gap(const Chart& chart) const {
  const auto texel = static_cast<double>(options_.texel);
  struct Border {
    Point from, to;
    double length;
  };
  std::vector<Border> borders;
  for (const auto side : chart.sides)
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (!is_border(side, k)) continue;
      // The side lies to the left.
      const auto& corners = patches_.corners[side.patch()];
      auto a = on_chart(chart, patches_.vertices[corners[k]]);
      auto b = on_chart(chart, patches_.vertices[corners[(k + 1) % 3]]);
      if (side.is_back()) std::swap(a, b);
      if (const auto length = glm::length(b - a); length > 0.0) borders.push_back({a, b, length});
    }

  FlatCover cover({0.0, 0.0}, {chart.size[0], chart.size[1]}, chart.sides.size());
  for (const auto side : chart.sides) {
    FlatCover::Triangle t;
    for (std::size_t k = 0; k < 3; ++k)
      t[k] = on_chart(chart, patches_.vertices[patches_.corners[side.patch()][!side.is_back() ? k : 2 - k]]);
    cover.put(t);
  }
  std::vector<Border> hits;
  for (const auto& border : borders) {
    const auto middle = 0.5 * (border.from + border.to);
    const auto out = Point(border.to.y - border.from.y, border.from.x - border.to.x) / border.length;
    for (const auto away : {0.1, 0.5, 1.0, 1.5, widest_gap})
      if (cover.has(middle + away * texel * out)) {
        hits.push_back(border);
        break;
      }
  }

  // The line with the longest such border on it.
  constexpr std::size_t max_tried = 64;
  std::stable_sort(hits.begin(), hits.end(),
                   [](const auto& a, const auto& b) { return a.length > b.length; });
  double longest = shortest_gap * texel;
  Cut best;
  for (std::size_t i = 0; i < std::min(hits.size(), max_tried); ++i) {
    const auto along = (hits[i].to - hits[i].from) / hits[i].length;
    const auto off = [&](const Point& p) { return std::abs(cross(along, p - hits[i].from)); };
    double length = 0.0;
    for (const auto& other : hits)
      if (std::max(off(other.from), off(other.to)) < 0.1 * texel) length += other.length;
    if (!(length > longest) || !parts(chart, {hits[i].from, along})) continue;
    longest = length;
    best = {true, {hits[i].from, along}};
  }
  return best;
}

}  // namespace luxel
