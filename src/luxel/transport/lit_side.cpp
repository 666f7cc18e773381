// SPDX-License-Identifier: Apache-2.0
#include "luxel/transport/lit_side.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "luxel/transport/clip_triangle.h"
#include "luxel/transport/polygon_irradiance.h"

namespace luxel {
namespace {

constexpr double one_point_error = 1e-3;  // relative, of the centroid rule, that is let pass
constexpr double split_error = 0.004;     // difference of the rules of one and of three points that splits
constexpr int deepest = 7;                // halvings of the edges

using Corners = std::array<Vec3d, 3>;

// The heights of the patch's corners over the lamp's plane.
std::array<double, 3> heights(const LampTriangle& lamp, const Corners& corners) {
  const auto a = Vec3d(lamp.corner[0]);
  return {glm::dot(lamp.normal, corners[0] - a), glm::dot(lamp.normal, corners[1] - a),
          glm::dot(lamp.normal, corners[2] - a)};
}

bool may_light(const LampTriangle& lamp, const Corners& corners, const Vec3d& n) {
  const auto above = std::max({glm::dot(n, Vec3d(lamp.corner[0]) - corners[0]),
                               glm::dot(n, Vec3d(lamp.corner[1]) - corners[0]),
                               glm::dot(n, Vec3d(lamp.corner[2]) - corners[0])});
  const auto a = Vec3d(lamp.corner[0]);
  const auto before = std::max({glm::dot(lamp.normal, corners[0] - a), glm::dot(lamp.normal, corners[1] - a),
                                glm::dot(lamp.normal, corners[2] - a)});
  return above > 0.0 && before > 0.0;
}

// Whether the irradiance of this lamp varies so little over a patch of this radius that its centroid will do:
// half the second derivative of 1/d² (and of two cosines), times the second moment of a triangle, radius² / 8
// an axis.
bool centroid_will_do(const LampTriangle& lamp, const Vec3d& centroid, double radius) {
  const auto to = (Vec3d(lamp.corner[0]) + Vec3d(lamp.corner[1]) + Vec3d(lamp.corner[2])) / 3.0 - centroid;
  const auto distance = glm::length(to) - 0.6 * lamp.longest_edge;
  const auto height = -glm::dot(lamp.normal, to);  // where the lamp's plane cuts the patch there is a kink
  return distance > 0.0 && 0.5 * radius * radius <= one_point_error * distance * distance && height > radius;
}

// The mean over a triangle of the irradiance of the near lamps, by splitting it where rules of one and of
// three points disagree: each lamp only as far as its own needs.
class NearMean {
 public:
  NearMean(const Lamps& lamps, std::vector<SideLamp>& near, const Vec3d& n, double total)
      : lamps_(lamps), near_(near), n_(n), allowed_(split_error * total) {
    active_.resize(near.size());
    std::iota(active_.begin(), active_.end(), std::size_t{0});
  }

  // All of the near lamps over the triangle, which is this share of the patch.
  void add(const Corners& t, double share) { add(t, share, 0, active_.size(), 0); }

 private:
  // The lamps active_[begin, end).
  void add(const Corners& t, double share, std::size_t begin, std::size_t end, int depth) {
    const auto centroid = (t[0] + t[1] + t[2]) / 3.0;
    const auto first = active_.size();
    for (auto i = begin; i < end; ++i) {
      const auto index = active_[i];
      const auto& lamp = lamps_.triangles()[near_[index].lamp];
      const auto one = unit_irradiance(lamp, centroid, n_);
      double three = 0.0;
      for (const auto& corner : t) three += unit_irradiance(lamp, 0.5 * (centroid + corner), n_) / 3.0;
      if (depth < deepest && lamp.weight * std::fabs(three - one) * std::sqrt(share) >
                                 std::max(allowed_, split_error * lamp.weight * three * share))
        active_.push_back(index);
      else
        near_[index].irradiance += share * three;
    }
    const auto last = active_.size();
    if (last > first) {
      const Vec3d ab = 0.5 * (t[0] + t[1]);
      const Vec3d bc = 0.5 * (t[1] + t[2]);
      const Vec3d ca = 0.5 * (t[2] + t[0]);
      for (const auto& child :
           {Corners{t[0], ab, ca}, Corners{ab, t[1], bc}, Corners{ca, bc, t[2]}, Corners{bc, ca, ab}})
        add(child, share / 4.0, first, last, depth + 1);
    }
    active_.resize(first);
  }

  const Lamps& lamps_;
  std::vector<SideLamp>& near_;
  Vec3d n_;
  double allowed_;
  std::vector<std::size_t> active_;  // a stack: those that each depth has left over
};

double doubled_area(const Corners& t) { return glm::length(glm::cross(t[1] - t[0], t[2] - t[0])); }

// Where a lamp's plane cuts the patch, the irradiance may jump from nothing to half of the whole: only the
// part before the lamp is looked at, and that exactly.
void add_cut(const Lamps& lamps, const Corners& corners, const Vec3d& n, double total, SideLamp lamp,
             std::vector<SideLamp>& found) {
  std::vector<SideLamp> alone{lamp};
  std::array<Vec3d, 4> part;
  const auto count = clip_triangle(corners, heights(lamps.triangles()[lamp.lamp], corners), part);
  for (int i = 2; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Corners piece = {part[0], part[at - 1], part[at]};
    const auto share = doubled_area(piece) / doubled_area(corners);
    if (share > 0.0) NearMean(lamps, alone, n, total).add(piece, share);
  }
  found.push_back(alone[0]);
}

}  // namespace

void find_side_lamps(const Lamps& lamps, std::span<const std::uint32_t> candidates,
                     const std::array<Vec3, 3>& corners_in, const Vec3& normal, bool mean,
                     std::vector<SideLamp>& found) {
  found.clear();
  const Corners corners = {Vec3d(corners_in[0]), Vec3d(corners_in[1]), Vec3d(corners_in[2])};
  const auto n = Vec3d(normal);
  const auto centroid = (corners[0] + corners[1] + corners[2]) / 3.0;
  const auto radius = std::max({glm::length(corners[0] - centroid), glm::length(corners[1] - centroid),
                                glm::length(corners[2] - centroid)});
  std::vector<SideLamp> near;
  std::vector<SideLamp> cut;
  double total = 0.0;
  for (const auto i : candidates) {
    const auto& lamp = lamps.triangles()[i];
    if (!may_light(lamp, corners, n)) continue;
    const auto irradiance = unit_irradiance(lamp, centroid, n);
    total += lamp.weight * irradiance;
    if (!mean || centroid_will_do(lamp, centroid, radius)) {
      found.push_back({i, irradiance});
    } else {
      const auto height = heights(lamp, corners);
      (std::min({height[0], height[1], height[2]}) < 0.0 ? cut : near).push_back({i, 0.0});
    }
  }
  if (!near.empty()) NearMean(lamps, near, n, total).add(corners, 1.0);
  found.insert(found.end(), near.begin(), near.end());
  for (const auto& lamp : cut) add_cut(lamps, corners, n, total, lamp, found);
}

}  // namespace luxel
