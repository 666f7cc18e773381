// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/floor_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace luxel {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // vertices, in the direction of travel

constexpr double min_area = 0.1;        // m², of a loop that is a room
constexpr double straight_sine = 1e-3;  // of the angle between edges that are one line

double cross(const PlanPoint& a, const PlanPoint& b) { return a.x * b.y - a.y * b.x; }

// Edges of one patch only, anticlockwise seen from above, by their first vertex.
std::multimap<std::uint32_t, std::uint32_t> boundary_of(const PatchSet& patches,
                                                        std::span<const std::uint32_t> floor,
                                                        const PlanAxes& axes) {
  std::map<Edge, int> count;
  std::vector<Edge> edges;
  for (const auto p : floor) {
    auto corners = patches.corners[p];
    if (glm::dot(Vec3d(patches.normal[p]), axes.up) < 0.0) std::swap(corners[1], corners[2]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge edge(corners[k], corners[(k + 1) % 3]);
      edges.push_back(edge);
      ++count[std::minmax(edge.first, edge.second)];
    }
  }
  std::multimap<std::uint32_t, std::uint32_t> next;
  for (const auto& edge : edges)
    if (count[std::minmax(edge.first, edge.second)] == 1) next.emplace(edge.first, edge.second);
  return next;
}

std::vector<PlanPoint> without_straight_vertices(const std::vector<PlanPoint>& loop) {
  std::vector<PlanPoint> kept;
  const auto n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto before = loop[i] - (kept.empty() ? loop[(i + n - 1) % n] : kept.back());
    const auto after = loop[(i + 1) % n] - loop[i];
    if (std::abs(cross(before, after)) > straight_sine * glm::length(before) * glm::length(after))
      kept.push_back(loop[i]);
  }
  return kept;
}

}  // namespace

std::vector<std::vector<PlanPoint>> floor_outline(const PatchSet& patches,
                                                  std::span<const std::uint32_t> floor,
                                                  const PlanAxes& axes) {
  auto next = boundary_of(patches, floor, axes);
  std::vector<std::vector<PlanPoint>> loops;
  while (!next.empty()) {
    std::vector<PlanPoint> loop;
    auto at = next.begin();
    while (at != next.end()) {
      const auto place = axes.in_plan(patches.in_file(patches.vertices[at->first]));
      loop.emplace_back(place.x, place.y);
      const auto to = at->second;
      next.erase(at);
      at = next.find(to);
    }
    loop = without_straight_vertices(loop);
    if (loop.size() >= 3 && area_of(loop) > min_area) loops.push_back(std::move(loop));
  }
  return loops;
}

std::array<PlanPoint, 2> box_of(std::span<const std::vector<PlanPoint>> loops) {
  std::array<PlanPoint, 2> box = {loops[0][0], loops[0][0]};
  for (const auto& loop : loops)
    for (const auto& point : loop) {
      box[0] = glm::min(box[0], point);
      box[1] = glm::max(box[1], point);
    }
  return box;
}

double area_of(std::span<const PlanPoint> loop) {
  double twice = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    twice += cross(loop[i] - loop[0], loop[(i + 1) % loop.size()] - loop[0]);
  return 0.5 * twice;
}

double distance_from(std::span<const PlanPoint> loop, const PlanPoint& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto along = loop[(i + 1) % loop.size()] - loop[i];
    const auto part = std::clamp(glm::dot(point - loop[i], along) / glm::dot(along, along), 0.0, 1.0);
    nearest = std::min(nearest, glm::length(point - loop[i] - part * along));
  }
  return nearest;
}

bool contains(std::span<const PlanPoint> loop, const PlanPoint& point) {
  bool is_inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto& a = loop[i];
    const auto& b = loop[(i + 1) % loop.size()];
    if ((a.y > point.y) == (b.y > point.y)) continue;
    if (point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)) is_inside = !is_inside;
  }
  return is_inside;
}

}  // namespace luxel
