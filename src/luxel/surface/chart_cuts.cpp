// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/chart_cuts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/cross.h"
#include "luxel/core/error.h"
#include "luxel/patch/side.h"
#include "luxel/surface/flat_cover.h"
#include "luxel/surface/flat_fragment.h"

namespace luxel {
namespace {

using Point = glm::dvec2;

constexpr double widest_gap = 2.0;  // texels; a wider gap has at least one texel per border
constexpr float min_jump = 2.0f;    // ratio of the light; a lesser one over the width of a texel shows little
constexpr double shortest_jump = 16.0;  // texels
constexpr double shortest_gap = 8.0;    // texels; a shorter one is the foot of a leg, not of a wall

// Returns whether light that bleeds from one to the other would be visible.
bool is_jump(float one, float other) {
  const auto [low, high] = std::minmax(one, other);
  return high > min_jump * low;
}

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
                     const EdgesOfSides& of_sides, const LightBorders& borders, const ChartOptions& options)
    : patches_(patches),
      edges_(edges),
      of_sides_(of_sides),
      borders_(borders),
      options_(options),
      is_barred_(edges.size(), false),
      fragment_(side_count(patches.size()), 0) {}

std::vector<Chart> ChartCuts::cut(std::vector<SideId> sides, const Vec3d& direction) {
  std::vector<Chart> charts;
  auto open = connected(sides);
  while (!open.empty()) {
    auto chart = flat_chart(patches_, std::move(open.back()), direction);
    open.pop_back();
    label(chart.sides);
    if (const auto cut = cut_of(chart); cut.wanted)
      for (auto& piece : pieces(chart, cut)) open.push_back(std::move(piece));
    else
      charts.push_back(std::move(chart));
  }
  return charts;
}

std::vector<ChartCuts::Sides> ChartCuts::pieces(const Chart& chart, const Cut& cut) {
  std::array<Sides, 2> halves;
  for (const auto side : chart.sides) halves[lies_left(chart, cut.line, side) ? 0 : 1].push_back(side);
  auto by_line = connected(halves[0]);
  for (auto& part : connected(halves[1])) by_line.push_back(std::move(part));
  if (cut.edges.empty() || by_line.size() == 2) return by_line;

  for (const auto e : cut.edges) is_barred_[e] = true;
  auto by_edges = connected(chart.sides);
  for (const auto e : cut.edges) is_barred_[e] = false;
  return by_edges.size() > 1 && by_edges.size() < by_line.size() ? by_edges : by_line;
}

bool ChartCuts::lies_left(const Chart& chart, const Line& line, SideId side) const {
  return cross(line.along, on_chart(chart, patches_.centroid(side.patch())) - line.point) > 0.0;
}

void ChartCuts::label(const Sides& sides) {
  ++fragments_;
  for (const auto side : sides) fragment_[side.index()] = fragments_;
}

std::vector<std::vector<SideId>> ChartCuts::connected(const std::vector<SideId>& sides) {
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
        if (!borders_.is_crossed[e] || is_barred_[e] || fragment_[other.index()] != open) continue;
        fragment_[other.index()] = fragments_;
        part.push_back(other);
      }
    parts.push_back(std::move(part));
  }
  return parts;
}

ChartCuts::Cut ChartCuts::cut_of(const Chart& chart) {
  if (const auto page = across_page(chart); page.wanted) return page;
  if (const auto jump = at_jump(chart); jump.wanted) return jump;
  return at_thin_gap(chart);
}

ChartCuts::Cut ChartCuts::across_page(const Chart& chart) const {
  const auto most = static_cast<double>(options_.max_texels) * static_cast<double>(options_.texel);
  if (chart.stretch * chart.size[0] <= most && chart.stretch * chart.size[1] <= most) return {};
  const Cut across{true, {{0.5 * chart.size[0], 0.0}, {0.0, 1.0}}};
  if (parts(chart, across.line)) return across;
  if (chart.sides.size() > 1) {  // all sides at one place: cut by their order, the only difference
    const auto x = on_chart(chart, patches_.centroid(chart.sides[0].patch())).x;
    for (const auto side : chart.sides)
      if (const auto other = on_chart(chart, patches_.centroid(side.patch())).x; other != x)
        return {true, {{std::max(x, other), 0.0}, {0.0, 1.0}}};
  }
  throw InputError(fmt::format(
      "a patch {:.3g} m long needs more than {} texels of {:.3g} m and fits on no page: take fewer "
      "texels per metre, larger pages, or smaller patches",
      chart.stretch * chart.size[0], options_.max_texels, options_.texel));
}

// Where light differs across an edge at which another surface stands, or which is a crease.
ChartCuts::Cut ChartCuts::at_jump(const Chart& chart) const {
  std::vector<Border> jumps;
  for (const auto side : chart.sides)
    for (const auto e : of_sides_.at(side)) {
      const auto& edge = edges_[e];
      const auto a = edge.halves[0].side, b = edge.halves[1].side;
      if (edge.smooth || a != side || fragment_[b.index()] != fragment_[a.index()]) continue;
      if (!is_jump(borders_.light[a.index()], borders_.light[b.index()])) continue;
      const auto from = on_chart(chart, patches_.vertices[edge.ends[0]]);
      const auto to = on_chart(chart, patches_.vertices[edge.ends[1]]);
      if (const auto length = glm::length(to - from); length > 0.0)
        jumps.push_back({from, to, length, 0.0f, e});
    }
  return along_longest(chart, std::move(jumps), shortest_jump * static_cast<double>(options_.texel));
}

bool ChartCuts::is_border(SideId side, std::uint32_t k) const {
  for (const auto e : of_sides_.at(side)) {
    const auto& halves = edges_[e].halves;
    const auto own = halves[0].side == side ? 0 : 1;
    const auto other = halves[1 - own].side.index();
    if (halves[own].edge == k && borders_.is_crossed[e] && !borders_.is_dark(halves[1 - own].side) &&
        fragment_[other] == fragment_[side.index()])
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

// Finds two facing borders that are so near that they would share texels.
ChartCuts::Cut ChartCuts::at_thin_gap(const Chart& chart) const {
  const auto texel = static_cast<double>(options_.texel);
  std::vector<Border> borders;
  for (const auto side : chart.sides)
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (borders_.is_dark(side) || !is_border(side, k)) continue;
      // The side is on the left.
      const auto& corners = patches_.corners[side.patch()];
      auto a = on_chart(chart, patches_.vertices[corners[k]]);
      auto b = on_chart(chart, patches_.vertices[corners[(k + 1) % 3]]);
      if (side.is_back()) std::swap(a, b);
      if (const auto length = glm::length(b - a); length > 0.0)
        borders.push_back({a, b, length, borders_.light[side.index()]});
    }

  std::vector<float> light;  // [triangle of the cover]
  FlatCover cover({0.0, 0.0}, {chart.size[0], chart.size[1]}, chart.sides.size());
  for (const auto side : chart.sides) {
    if (borders_.is_dark(side)) continue;
    FlatCover::Triangle t;
    for (std::size_t k = 0; k < 3; ++k)
      t[k] = on_chart(chart, patches_.vertices[patches_.corners[side.patch()][!side.is_back() ? k : 2 - k]]);
    cover.put(t);
    light.push_back(borders_.light[side.index()]);
  }
  std::vector<Border> hits;
  for (const auto& border : borders) {
    const auto middle = 0.5 * (border.from + border.to);
    const auto out = Point(border.to.y - border.from.y, border.from.x - border.to.x) / border.length;
    for (const auto away : {0.1, 0.5, 1.0, 1.5, widest_gap})
      if (const auto other = cover.at(middle + away * texel * out); other != none) {
        if (is_jump(border.light, light[other])) hits.push_back(border);
        break;
      }
  }

  return along_longest(chart, std::move(hits), shortest_gap * texel);
}

ChartCuts::Cut ChartCuts::along_longest(const Chart& chart, std::vector<Border> borders,
                                        double shortest) const {
  constexpr std::size_t max_tried = 64;
  std::stable_sort(borders.begin(), borders.end(),
                   [](const auto& a, const auto& b) { return a.length > b.length; });
  auto longest = shortest;
  Cut best;
  for (std::size_t i = 0; i < std::min(borders.size(), max_tried); ++i) {
    const auto along = (borders[i].to - borders[i].from) / borders[i].length;
    const auto on_line = [&](const Border& other) {
      const auto off = [&](const Point& p) { return std::abs(cross(along, p - borders[i].from)); };
      return std::max(off(other.from), off(other.to)) < 0.1 * static_cast<double>(options_.texel);
    };
    double length = 0.0;
    for (const auto& other : borders)
      if (on_line(other)) length += other.length;
    if (!(length > longest) || !parts(chart, {borders[i].from, along})) continue;
    longest = length;
    best = {true, {borders[i].from, along}};
    for (const auto& other : borders)
      if (other.edge != none && on_line(other)) best.edges.push_back(other.edge);
  }
  return best;
}

}  // namespace luxel
