// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/edge_points.h"

#include <algorithm>
#include <tuple>

#include "luxel/core/none.h"
#include "luxel/patch/contact_lines.h"
#include "luxel/patch/flat_triangle.h"

namespace luxel {
namespace {

std::uint64_t key(std::uint32_t low, std::uint32_t high) { return (std::uint64_t{low} << 32) | high; }

}  // namespace

std::uint32_t EdgePoints::ask(std::uint32_t a, std::uint32_t b, double fraction, std::uint32_t vertex) {
  const auto [low, high] = std::minmax(a, b);
  const auto [entry, is_new] = number_.try_emplace(key(low, high), static_cast<std::uint32_t>(edges_.size()));
  if (is_new) {
    edges_.push_back({{low, high}, {}, {}});
    if (is_end_.size() <= high) is_end_.resize(high + 1, false);
    is_end_[low] = is_end_[high] = true;
  }
  const auto number = static_cast<std::uint32_t>(answers_.size());
  edges_[entry->second].requests.push_back({a < b ? fraction : 1.0 - fraction, vertex, number});
  answers_.push_back({});
  return number;
}

void EdgePoints::settle(VertexWeld& weld) {
  for (auto& edge : edges_) settle(edge, weld);
}

void EdgePoints::settle(Edge& edge, VertexWeld& weld) {
  const auto start = weld.positions()[edge.ends[0]];
  const auto end = weld.positions()[edge.ends[1]];
  const auto way = Vec3d(end) - Vec3d(start);
  const auto near = slack_roundings * coordinate_rounding({start, end, end}) / glm::length(way);
  auto& requests = edge.requests;
  // Sorts coincident points such that the one at a vertex comes first.
  std::sort(requests.begin(), requests.end(), [](const Request& a, const Request& b) {
    return std::tuple(a.fraction, a.vertex, a.number) < std::tuple(b.fraction, b.vertex, b.number);
  });
  for (auto first = requests.begin(); first != requests.end();) {
    const auto last = std::find_if(first, requests.end(),
                                   [&](const Request& r) { return r.fraction > first->fraction + near; });
    const auto chosen =
        std::min_element(first, last, [](const Request& a, const Request& b) { return a.vertex < b.vertex; });
    Station station{chosen->fraction, chosen->vertex};
    if (station.fraction <= near) {
      station = {0.0, edge.ends[0]};
    } else if (station.fraction >= 1.0 - near) {
      station = {1.0, edge.ends[1]};
    } else if (station.vertex == none) {
      station.vertex = weld.index_of(Vec3(Vec3d(start) + station.fraction * way));
    }
    if (station.vertex == edge.ends[0]) station.fraction = 0.0;
    if (station.vertex == edge.ends[1]) station.fraction = 1.0;
    for (auto r = first; r != last; ++r) answers_[r->number] = station;
    const bool is_between = station.fraction > 0.0 && station.fraction < 1.0;
    if (is_between && (edge.stations.empty() || edge.stations.back().vertex != station.vertex))
      edge.stations.push_back(station);
    first = last;
  }
}

std::span<const EdgePoints::Station> EdgePoints::on(std::uint32_t a, std::uint32_t b) const {
  const auto [low, high] = std::minmax(a, b);
  if (high >= is_end_.size() || !is_end_[low] || !is_end_[high]) return {};
  const auto found = number_.find(key(low, high));
  if (found == number_.end()) return {};
  return edges_[found->second].stations;
}

}  // namespace luxel
