// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/shadow_corners.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>

#include "luxel/core/none.h"
#include "luxel/core/point_cells.h"
#include "luxel/patch/contact_lines.h"
#include "luxel/patch/flat_triangle.h"

namespace luxel {
namespace {

constexpr double edges_of_corner = 3.0;  // short ones that round a corner
constexpr double same_plane = 0.9999;    // cosine between normals

// An end of a line that is the shadow of a corner.
struct CornerShadow {
  std::uint32_t penumbra, corner, light;
  std::uint32_t part, end;  // of parts; 0 or 1

  auto order() const { return std::tuple(penumbra, corner, light, part, end); }
};

class Joiner {
 public:
  Joiner(const PatchSet& triangles, std::span<const EdgeShadow> parts,
         const ShadowReceivers::Lengths& lengths)
      : triangles_(triangles),
        parts_(parts),
        shortest_(shortest_line * lengths.reach),
        widest_gap_(edges_of_corner * shortest_shadow * lengths.detail) {}

  std::vector<EdgeShadow> join() {
    join_penumbras();
    close_gaps();
    return std::move(lines_);
  }

 private:
  // Ends of parts are numbered: 2 * part + end.
  const Vec3d& point(std::uint32_t end) const { return parts_[end / 2].ends[end % 2]; }

  void join_penumbras() {
    std::vector<CornerShadow> ends;
    for (std::uint32_t i = 0; i < parts_.size(); ++i)
      for (const auto end : {0u, 1u})
        if (parts_[i].penumbra != none && parts_[i].corner[end] != none)
          ends.push_back({parts_[i].penumbra, parts_[i].corner[end], parts_[i].light, i, end});
    std::sort(ends.begin(), ends.end(), [](const auto& a, const auto& b) { return a.order() < b.order(); });
    for (auto first = ends.begin(); first != ends.end();) {
      const auto same_corner = [&](const CornerShadow& e) {
        return e.penumbra == first->penumbra && e.corner == first->corner;
      };
      const auto end = std::find_if_not(first, ends.end(), same_corner);
      const auto second =
          std::find_if(first, end, [&](const CornerShadow& e) { return e.light != first->light; });
      if (second != end && (end - 1)->light == second->light)
        connect(first->part, first->end, second->part, second->end);
      first = end;
    }
  }

  // Joins ends that nothing continues with the nearest of these, if that is so from both.
  void close_gaps() {
    std::vector<PointCells::Point> points;
    for (std::uint32_t e = 0; e < 2 * parts_.size(); ++e) points.push_back({point(e), e});
    const PointCells cells(points, widest_gap_);
    std::vector<std::uint8_t> is_open(points.size(), 1);
    for (std::uint32_t e = 0; e < points.size(); ++e)
      for_near(cells, e, shortest_, [&](std::uint32_t, double) { is_open[e] = 0; });
    std::vector<std::uint32_t> nearest(points.size(), none);
    for (std::uint32_t e = 0; e < points.size(); ++e) {
      if (is_open[e] == 0) continue;
      auto gap = widest_gap_;
      for_near(cells, e, widest_gap_, [&](std::uint32_t other, double distance) {
        if (is_open[other] != 0 && distance < gap) gap = distance, nearest[e] = other;
      });
    }
    for (std::uint32_t e = 0; e < points.size(); ++e)
      if (nearest[e] != none && e < nearest[e] && nearest[nearest[e]] == e)
        connect(e / 2, e % 2, nearest[e] / 2, nearest[e] % 2);
  }

  // Calls body(other, distance) for ends of other parts of the same light.
  template <typename Body>
  void for_near(const PointCells& cells, std::uint32_t end, double within, const Body& body) const {
    const auto& at = point(end);
    cells.for_each_in(at - within, at + within, [&](std::uint32_t other) {
      if (other / 2 == end / 2 || parts_[other / 2].light != parts_[end / 2].light) return;
      const auto distance = glm::distance(at, point(other));
      if (distance <= within) body(other, distance);
    });
  }

  void connect(std::uint32_t part, std::uint32_t end, std::uint32_t other, std::uint32_t other_end) {
    const auto &from = parts_[part], &to = parts_[other];
    if (glm::dot(from.lit_side, to.lit_side) < same_plane) return;
    add(from, from.ends[end], to.ends[other_end]);
    if (to.triangle != from.triangle) add(to, from.ends[end], to.ends[other_end]);
  }

  // The part of a line from p to q on the triangle of a shadow.
  void add(const EdgeShadow& shadow, const Vec3d& p, const Vec3d& q) {
    const auto points = triangles_.points(shadow.triangle);
    const FlatTriangle plane(points);
    const auto slack = slack_roundings * coordinate_rounding(points);
    if (std::max(std::abs(plane.height(p)), std::abs(plane.height(q))) > shortest_) return;
    const auto a = plane.foot_point(p), b = plane.foot_point(q);
    const auto interval = interval_on(plane, a, b, slack);
    if (!interval) return;
    auto line = shadow;
    line.ends = {a + interval->begin * (b - a), a + interval->end * (b - a)};
    if (glm::distance(line.ends[0], line.ends[1]) <= shortest_) return;
    line.corner = {none, none};
    line.on_edge = false;
    lines_.push_back(line);
  }

  const PatchSet& triangles_;
  std::span<const EdgeShadow> parts_;
  double shortest_, widest_gap_;  // m
  std::vector<EdgeShadow> lines_;
};

}  // namespace

std::vector<EdgeShadow> corner_lines(const PatchSet& triangles, std::span<const EdgeShadow> parts,
                                     const ShadowReceivers::Lengths& lengths) {
  return Joiner(triangles, parts, lengths).join();
}

}  // namespace luxel
