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

constexpr double narrowest = 1.0;       // height of a triangle that is cut, in distances
constexpr double shortest = 0.25;       // edge of an outline, in distances
constexpr double steepest = 0.2;        // difference of an edge's heights over its length
constexpr double level_cosine = 0.7;    // of a triangle whose edges count, to the plane, at least
constexpr double standing_reach = 0.2;  // of a surface that stands on the plane, in distances
constexpr double goes_on_cosine = 0.1;  // of a neighbour's direction, away from the outline
constexpr double beside_edge = 0.1;     // in distances: a line so near to an edge would make slivers
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
        is_wide_(triangles.size()) {}

  std::vector<ContactLine> find() {
    const auto all = boxes();  // before a pair asks which triangles are wide
    return lines_of_pairs(all, max_lines_, context_,
                          [this](std::uint32_t i, std::uint32_t j, std::vector<ContactLine>& lines) {
                            if (is_wide_[i]) add_lines(i, j, lines);
                            if (is_wide_[j]) add_lines(j, i, lines);
                          });
  }

 private:
  std::array<Vec3, 3> points(std::uint32_t i) const {
    const auto& c = triangles_[i].corners;
    return {positions_[c[0]], positions_[c[1]], positions_[c[2]]};
  }

  // Wide triangles reach as far as the distance, others only to themselves.
  std::vector<Bounds> boxes() {
    std::vector<Bounds> result(triangles_.size());
    context_.for_chunks(triangles_.size(), grain, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin; i < end; ++i) {
        const auto p = points(static_cast<std::uint32_t>(i));
        const auto longest =
            std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
        const auto height = 2.0 * triangle_area(p[0], p[1], p[2]) / static_cast<double>(longest);
        is_wide_[i] = height > narrowest * distance_ ? 1 : 0;
        const auto reach = is_wide_[i] ? static_cast<float>(distance_) : 0.0f;
        for (const auto& corner : p) {
          result[i].add(corner - reach);
          result[i].add(corner + reach);
        }
      }
    });
    return result;
  }

  void add_lines(std::uint32_t on, std::uint32_t other, std::vector<ContactLine>& lines) const {
    const FlatTriangle plane(points(on));
    const auto& corners = triangles_[other].corners;
    std::array<double, 3> height{};
    for (std::size_t k = 0; k < 3; ++k) height[k] = plane.height(Vec3d(positions_[corners[k]]));
    const auto slack =
        slack_roundings * std::max(coordinate_rounding(points(on)), coordinate_rounding(points(other)));
    const auto is_near = [&](double h) { return h > gap_ + slack && h <= distance_; };
    for (std::size_t k = 0; k < 3; ++k) {
      const auto l = (k + 1) % 3;
      if (!is_near(height[k]) || !is_near(height[l])) continue;
      const Vec3d a(positions_[corners[k]]), b(positions_[corners[l]]);
      const auto length = glm::distance(a, b);
      if (length < shortest * distance_ || std::fabs(height[l] - height[k]) > steepest * length) continue;
      const auto is_close = std::max(height[k], height[l]) <= standing_reach * distance_;
      if (!is_outline(plane.normal, other, k) && !(is_close && is_foot(plane.normal, other, k))) continue;
      if (const auto line = line_on(plane, plane.foot_point(a), plane.foot_point(b), slack))
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
                                              double slack) const {
    const auto interval = interval_on(plane, p, q, slack);
    if (!interval) return std::nullopt;
    const std::array ends{p + interval->begin * (q - p), p + interval->end * (q - p)};
    if (glm::distance(ends[0], ends[1]) <= beside_edge * distance_) return std::nullopt;
    if (interval_on_edge(plane, ends[0], ends[1], beside_edge * distance_)) return std::nullopt;
    return ends;
  }

  const std::vector<CleanTriangle>& triangles_;
  const std::vector<Vec3>& positions_;
  double gap_, distance_;  // m
  std::size_t max_lines_;
  const Context& context_;
  VertexTriangles neighbours_;
  std::vector<char> is_wide_;
};

}  // namespace

std::vector<ContactLine> find_near_lines(const std::vector<CleanTriangle>& triangles,
                                         const std::vector<Vec3>& positions, double gap, double distance,
                                         std::size_t most, const Context& context) {
  return Finder(triangles, positions, gap, distance, most, context).find();
}

}  // namespace luxel
