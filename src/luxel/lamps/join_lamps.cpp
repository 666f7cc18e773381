// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/join_lamps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "luxel/core/none.h"
#include "luxel/core/triangle.h"

namespace luxel {
namespace {

// Maximum distance of the facets' corners from their common plane, relative to the largest coordinate of each
// replacement triangle. Shadow rays are lifted by 32 roundings at either end, and origin_lift is bounded by
// 26; the difference of 6, divided by two sides, is 3. No ray therefore ends behind the facet it should
// reach.
constexpr double flatness = 3 * 0x1p-24;
constexpr double straightness = 0x1p-20;  // of edges, relative as above
constexpr double parallel = 1.0 - 5e-7;   // cosine between normals above which facets are tried
constexpr double area_tolerance = 1e-4;   // relative

using Point = std::array<float, 3>;  // ordered, so that it can be a key
using Edge = std::array<Point, 2>;   // from, to
Point key(const Vec3& v) { return {v.x, v.y, v.z}; }

double max_coordinate(const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto largest = glm::max(glm::max(glm::abs(a), glm::abs(b)), glm::abs(c));
  return static_cast<double>(std::max({largest.x, largest.y, largest.z}));
}

Vec3d area2_of(const LampFacet& facet) {
  return area_vector2(facet.corner[0], facet.corner[1], facet.corner[2]);
}

// The closed line made of these edges; empty where there are several, or where it meets itself.
std::vector<Vec3> outline(const std::map<Point, Point>& next, std::size_t edges) {
  std::vector<Vec3> line;
  if (next.size() != edges || next.empty()) return line;
  auto at = next.begin();
  do {
    line.emplace_back(at->first[0], at->first[1], at->first[2]);
    at = next.find(at->second);
  } while (at != next.end() && at != next.begin() && line.size() <= edges);
  if (at != next.begin() || line.size() != edges) line.clear();
  return line;
}

double distance_to_line(const Vec3d& p, const Vec3d& a, const Vec3d& b) {
  return glm::length(glm::cross(p - a, b - a)) / glm::length(b - a);
}

// The line without the points on straight edges; empty if it is not convex.
std::vector<Vec3> convex_corners(const std::vector<Vec3>& line, const Vec3d& normal) {
  std::vector<Vec3> corners;
  const auto n = line.size();
  for (std::size_t i = 0; i < n; ++i) {
    // Measured from the last corner, not from the last point: a curve of many short edges is not straight.
    const auto before = corners.empty() ? line[(i + n - 1) % n] : corners.back();
    const auto after = line[(i + 1) % n];
    const auto tolerance = straightness * max_coordinate(before, line[i], after);
    if (distance_to_line(Vec3d(line[i]), Vec3d(before), Vec3d(after)) <= tolerance) continue;
    if (glm::dot(normal, area_vector2(before, line[i], after)) <= 0.0) return {};
    corners.push_back(line[i]);
  }
  return corners;
}

class Joining {
 public:
  explicit Joining(std::span<const LampFacet> facets) : facets_(facets), lamp_of_(facets.size(), none) {
    for (std::uint32_t i = 0; i < facets.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [at, is_new] = facet_of_.emplace(edge(i, k), i);
        if (!is_new) at->second = none;  // facets that coincide
      }
  }

  std::vector<JoinedLamp> go() {
    std::vector<JoinedLamp> lamps;
    for (std::uint32_t i = 0; i < facets_.size(); ++i) {
      if (lamp_of_[i] != none) continue;
      auto group = flat_group(i);
      if (auto corners = polygon(group); !corners.empty()) {
        lamps.push_back({std::move(corners), std::move(group)});
        continue;
      }
      for (const auto p : group) lamps.push_back({{facets_[p].corner.begin(), facets_[p].corner.end()}, {p}});
    }
    return lamps;
  }

 private:
  Edge edge(std::uint32_t facet, std::size_t k) const {
    const auto& corner = facets_[facet].corner;
    return {key(corner[k]), key(corner[(k + 1) % 3])};
  }
  // The facet across an edge.
  std::uint32_t neighbour(const Edge& edge) const {
    const auto other = facet_of_.find({edge[1], edge[0]});
    return other == facet_of_.end() ? none : other->second;
  }

  // The facets of one orientation that are connected with the first by edges, ascending; marks them as its
  // lamp.
  std::vector<std::uint32_t> flat_group(std::uint32_t first) {
    const auto normal = glm::normalize(area2_of(facets_[first]));
    std::vector<std::uint32_t> group = {first};
    lamp_of_[first] = first;
    for (std::size_t i = 0; i < group.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto other = neighbour(edge(group[i], k));
        if (other == none || lamp_of_[other] != none || facets_[other].surface != facets_[first].surface ||
            glm::dot(normal, glm::normalize(area2_of(facets_[other]))) < parallel)
          continue;
        lamp_of_[other] = first;
        group.push_back(other);
      }
    std::sort(group.begin(), group.end());
    return group;
  }

  // The convex polygon that the group fills, if it needs at most half as many triangles.
  std::vector<Vec3> polygon(const std::vector<std::uint32_t>& group) const {
    std::map<Point, Point> next;
    std::size_t edges = 0;
    Vec3d normal(0.0);
    for (const auto p : group) {
      normal += area2_of(facets_[p]);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto e = edge(p, k);
        const auto other = neighbour(e);
        if (other != none && lamp_of_[other] == lamp_of_[p]) continue;
        next.emplace(e[0], e[1]);
        ++edges;
      }
    }
    const auto area2 = glm::length(normal);
    normal /= area2;
    auto corners = convex_corners(outline(next, edges), normal);
    if (corners.size() < 3 || 2 * (corners.size() - 2) > group.size()) return {};
    double filled2 = 0.0;
    auto coordinate = std::numeric_limits<double>::infinity();
    for (std::size_t i = 2; i < corners.size(); ++i) {
      filled2 += glm::length(area_vector2(corners[0], corners[i - 1], corners[i]));
      coordinate = std::min(coordinate, max_coordinate(corners[0], corners[i - 1], corners[i]));
    }
    if (std::fabs(filled2 - area2) > area_tolerance * area2) return {};
    return is_flat(group, normal, flatness * coordinate) ? corners : std::vector<Vec3>();
  }

  // Returns whether the corners lie between two planes at most `apart` apart.
  bool is_flat(const std::vector<std::uint32_t>& group, const Vec3d& normal, double apart) const {
    const Vec3d from(facets_[group[0]].corner[0]);
    double low = 0.0;
    double high = 0.0;
    for (const auto p : group)
      for (const auto& v : facets_[p].corner) {
        const auto height = glm::dot(normal, Vec3d(v) - from);
        low = std::min(low, height);
        high = std::max(high, height);
      }
    return high - low <= 2.0 * apart;
  }

  std::span<const LampFacet> facets_;
  std::map<Edge, std::uint32_t> facet_of_;
  std::vector<std::uint32_t> lamp_of_;  // [facet]; a lamp is identified by its first facet
};

}  // namespace

std::vector<JoinedLamp> join_lamps(std::span<const LampFacet> facets) { return Joining(facets).go(); }

}  // namespace luxel
