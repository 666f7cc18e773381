// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/shadow_corners.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>

#include "luxel/core/none.h"
#include "luxel/patch/contact_lines.h"
#include "luxel/patch/flat_triangle.h"

namespace luxel {
namespace {

constexpr double shortest_line = 4.0;    // in reach
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
  // An end of a part, in the order of lights and of x.
  struct End {
    std::uint32_t light;
    double x;
    std::uint32_t part, end;

    auto order() const { return std::tuple(light, x, part, end); }
  };
  const Vec3d& point(const End& e) const { return parts_[e.part].ends[e.end]; }

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
    std::vector<End> ends;
    for (std::uint32_t i = 0; i < parts_.size(); ++i)
      for (const auto end : {0u, 1u}) ends.push_back({parts_[i].light, parts_[i].ends[end].x, i, end});
    std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.order() < b.order(); });
    std::vector<std::uint8_t> is_open(ends.size(), 1);
    for_near(ends, shortest_, [&](std::size_t i, std::size_t j, double) { is_open[i] = is_open[j] = 0; });
    std::vector<std::size_t> nearest(ends.size(), ends.size());
    std::vector<double> gap(ends.size(), widest_gap_);
    for_near(ends, widest_gap_, [&](std::size_t i, std::size_t j, double distance) {
      if (is_open[i] == 0 || is_open[j] == 0) return;
      if (distance < gap[i]) gap[i] = distance, nearest[i] = j;
      if (distance < gap[j]) gap[j] = distance, nearest[j] = i;
    });
    for (std::size_t i = 0; i < ends.size(); ++i)
      if (i < nearest[i] && nearest[i] < ends.size() && nearest[nearest[i]] == i)
        connect(ends[i].part, ends[i].end, ends[nearest[i]].part, ends[nearest[i]].end);
  }

  // Calls body(i, j, distance) for ends of different parts of one light, i < j.
  template <typename Body>
  void for_near(const std::vector<End>& ends, double distance, const Body& body) const {
    for (std::size_t i = 0; i < ends.size(); ++i)
      for (auto j = i + 1; j < ends.size() && ends[j].light == ends[i].light; ++j) {
        if (ends[j].x - ends[i].x > distance) break;
        const auto apart = glm::distance(point(ends[i]), point(ends[j]));
        if (ends[i].part != ends[j].part && apart <= distance) body(i, j, apart);
      }
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
