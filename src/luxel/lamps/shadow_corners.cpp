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

constexpr double shortest_line = 4.0;  // in reach
constexpr double same_plane = 0.9999;  // cosine between normals

// An end of a line that is the shadow of a corner.
struct CornerShadow {
  std::uint32_t penumbra, corner, light;
  std::uint32_t part, end;  // of parts; 0 or 1

  auto order() const { return std::tuple(penumbra, corner, light, part, end); }
};

class Joiner {
 public:
  Joiner(const PatchSet& triangles, std::span<const EdgeShadow> parts, double reach)
      : triangles_(triangles), parts_(parts), shortest_(shortest_line * reach) {}

  std::vector<EdgeShadow> join() {
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
      if (second != end && (end - 1)->light == second->light) connect(*first, *second);
      first = end;
    }
    return std::move(lines_);
  }

 private:
  void connect(const CornerShadow& a, const CornerShadow& b) {
    const auto &from = parts_[a.part], &to = parts_[b.part];
    if (glm::dot(from.lit_side, to.lit_side) < same_plane) return;
    add(from, from.ends[a.end], to.ends[b.end]);
    if (to.triangle != from.triangle) add(to, from.ends[a.end], to.ends[b.end]);
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
  double shortest_;  // m
  std::vector<EdgeShadow> lines_;
};

}  // namespace

std::vector<EdgeShadow> corner_lines(const PatchSet& triangles, std::span<const EdgeShadow> parts,
                                     double reach) {
  return Joiner(triangles, parts, reach).join();
}

}  // namespace luxel
