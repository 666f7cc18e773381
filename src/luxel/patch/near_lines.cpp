// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/near_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "luxel/core/triangle.h"
#include "luxel/patch/flat_triangle.h"
#include "luxel/patch/line_search.h"
#include "luxel/patch/vertex_triangles.h"

namespace luxel {
namespace {

// Distance up to which things before a triangle cut it, over its height, where that is below `distance`: a
// patch shows the shadows of wider gaps as well as its size allows.
constexpr double reach_of_small = 0.1;
// Shortest edge of an outline, in heights before the triangle; at least, in distances or in heights of the
// triangle where those are smaller: what is small beside a patch darkens little of it; and at most, in
// distances.
constexpr double shortest_in_heights = 3.0, min_shortest = 0.1, max_shortest = 0.25;
constexpr double steepest = 0.2;        // difference of an edge's heights over its length
constexpr double level_cosine = 0.7;    // of a triangle whose edges count, to the plane, at least
constexpr double standing_reach = 0.2;  // of a surface that stands on the plane, in distances
constexpr double goes_on_cosine = 0.1;  // of a neighbour's direction, away from the outline
// A line so near to an edge would make slivers: in distances, or in heights before the triangle where those
// are smaller.
constexpr double beside_edge = 0.1, beside_in_heights = 0.05;
constexpr std::size_t grain = 8192;

class Finder {
 public:
  Finder(const std::vector<CleanTriangle>& triangles, const std::vector<Vec3>& positions, double gap,
         double distance, std::size_t most, const Context& context)
      : triangles_(triangles),
        positions_(positions),
        gap_(gap),
        distance_(distance),
        max_lines_(most),
        context_(context),
        neighbours_(triangles, positions.size()),
        height_(triangles.size()) {}

  std::vector<ContactLine> find() {
    const auto all = boxes();  // before a pair asks for the height of a triangle
    return lines_of_pairs(all, max_lines_, context_,
                          [this](std::uint32_t i, std::uint32_t j, std::vector<ContactLine>& lines) {
                            add_lines(i, j, lines);
                            add_lines(j, i, lines);
                          });
  }

 private:
  std::array<Vec3, 3> points(std::uint32_t i) const {
    const auto& c = triangles_[i].corners;
    return {positions_[c[0]], positions_[c[1]], positions_[c[2]]};
  }

  // Distance up to which things before a triangle cut it.
  double reach(std::size_t i) const {
    return height_[i] > distance_ ? distance_ : reach_of_small * height_[i];
  }

  // m, of the edges that cut a triangle from that height before it.
  double shortest_edge(std::size_t on, double height) const {
    return std::clamp(shortest_in_heights * height, min_shortest * std::min(distance_, height_[on]),
                      max_shortest * distance_);
  }

  std::vector<Bounds> boxes() {
    std::vector<Bounds> result(triangles_.size());
    context_.for_chunks(triangles_.size(), grain, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin; i < end; ++i) {
        const auto p = points(static_cast<std::uint32_t>(i));
        const auto longest =
            std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
        height_[i] = 2.0 * triangle_area(p[0], p[1], p[2]) / static_cast<double>(longest);
        const auto around = static_cast<float>(reach(i));
        for (const auto& corner : p) {
          result[i].add(corner - around);
          result[i].add(corner + around);
        }
      }
    });
    return result;
  }

  void add_lines(std::uint32_t on, std::uint32_t other, std::vector<ContactLine>& lines) const {
    if (reach(on) <= gap_) return;
    const FlatTriangle plane(points(on));
    const auto& corners = triangles_[other].corners;
    std::array<double, 3> height{};
    for (std::size_t k = 0; k < 3; ++k) height[k] = plane.height(Vec3d(positions_[corners[k]]));
    const auto slack =
        slack_roundings * std::max(coordinate_rounding(points(on)), coordinate_rounding(points(other)));
    const auto is_near = [&](double h) { return h > gap_ + slack && h <= reach(on); };
    for (std::size_t k = 0; k < 3; ++k) {
      const auto l = (k + 1) % 3;
      if (!is_near(height[k]) || !is_near(height[l])) continue;
      const Vec3d a(positions_[corners[k]]), b(positions_[corners[l]]);
      const auto length = glm::distance(a, b);
      const auto higher = std::max(height[k], height[l]);
      if (length < shortest_edge(on, higher) || std::fabs(height[l] - height[k]) > steepest * length)
        continue;
      const auto beside = std::min(beside_edge * distance_, beside_in_heights * higher);
      const auto is_close = higher <= standing_reach * distance_;
      if (!is_outline(plane.normal, other, k) && !(is_close && is_foot(plane.normal, other, k))) continue;
      if (const auto line = line_on(plane, plane.foot_point(a), plane.foot_point(b), beside, slack))
        lines.push_back({.on = on, .other = other, .ends = *line, .into = {plane.normal, Vec3d(0.0)}});
    }
  }

  // Returns whether the surface of `other` ends at its edge k, as seen along the normal: all triangles at the
  // edge lie on one side of it, or are seen from their edges.
  bool is_outline(const Vec3d& normal, std::uint32_t other, std::size_t k) const {
    const auto& c = triangles_[other].corners;
    const auto a = c[k], b = c[(k + 1) % 3];
    const auto across = glm::normalize(glm::cross(normal, Vec3d(positions_[b]) - Vec3d(positions_[a])));
    const auto inward = glm::dot(across, away_from_edge(positions_, a, b, c[(k + 2) % 3]));
    if (std::fabs(inward) < level_cosine) return false;
    return !neighbours_.any_across(a, b, other, [&](std::uint32_t apex) {
      return glm::dot(across, away_from_edge(positions_, a, b, apex)) * (inward > 0.0 ? 1.0 : -1.0) <
             -goes_on_cosine;
    });
  }

  // Returns whether `other` stands on its edge k, as seen along the plane: the gap below is small, and light
  // differs on its two sides. No triangle at the edge goes on towards the plane.
  bool is_foot(const Vec3d& normal, std::uint32_t other, std::size_t k) const {
    const auto& c = triangles_[other].corners;
    const auto a = c[k], b = c[(k + 1) % 3];
    const auto rise = [&](std::uint32_t apex) {
      return glm::dot(normal, away_from_edge(positions_, a, b, apex));
    };
    return rise(c[(k + 2) % 3]) >= level_cosine &&
           !neighbours_.any_across(a, b, other,
                                   [&](std::uint32_t apex) { return rise(apex) < -goes_on_cosine; });
  }

  // The part of a segment in the plane that lies on the triangle, and not along an edge of it.
  std::optional<std::array<Vec3d, 2>> line_on(const FlatTriangle& plane, const Vec3d& p, const Vec3d& q,
                                              double beside, double slack) const {
    const auto interval = interval_on(plane, p, q, slack);
    if (!interval) return std::nullopt;
    const std::array ends{p + interval->begin * (q - p), p + interval->end * (q - p)};
    if (glm::distance(ends[0], ends[1]) <= beside) return std::nullopt;
    if (interval_on_edge(plane, ends[0], ends[1], beside)) return std::nullopt;
    return ends;
  }

  const std::vector<CleanTriangle>& triangles_;
  const std::vector<Vec3>& positions_;
  double gap_, distance_;  // m
  std::size_t max_lines_;
  const Context& context_;
  VertexTriangles neighbours_;
  std::vector<double> height_;  // m, of each triangle on its longest edge
};

}  // namespace

std::vector<ContactLine> find_near_lines(const std::vector<CleanTriangle>& triangles,
                                         const std::vector<Vec3>& positions, double gap, double distance,
                                         std::size_t most, const Context& context) {
  return Finder(triangles, positions, gap, distance, most, context).find();
}

}  // namespace luxel
