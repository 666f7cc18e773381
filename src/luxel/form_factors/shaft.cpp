// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/shaft.h"

#include <algorithm>
#include <cmath>

namespace luxel {
namespace {

constexpr double same_direction = 1e-9;  // sine below which two axes count as one

void add_face(std::vector<Plane>& faces, const Plane& face) {
  for (const auto& other : faces)
    if (glm::dot(other.normal, face.normal) > 1.0 - 1e-12) return;
  faces.push_back(face);
}

}  // namespace

Shaft::Shaft(std::span<const Vec3d> a, std::span<const Vec3d> b, double slack) : slack_(slack) {
  corners_.assign(a.begin(), a.end());
  corners_.insert(corners_.end(), b.begin(), b.end());
  low_ = high_ = corners_[0];
  for (const auto& p : corners_) {
    low_ = glm::min(low_, p);
    high_ = glm::max(high_, p);
  }
  // A plane through three corners is a face if all other corners lie on one side. There are few corners, so
  // all triples are tested.
  for (std::size_t i = 0; i < corners_.size(); ++i)
    for (std::size_t j = i + 1; j < corners_.size(); ++j)
      for (std::size_t k = j + 1; k < corners_.size(); ++k) {
        const auto u = corners_[j] - corners_[i], v = corners_[k] - corners_[i];
        const auto across = glm::cross(u, v);
        const auto length = glm::length(across);
        if (!(length > same_direction * glm::length(u) * glm::length(v))) continue;
        Plane face{corners_[i], across / length};
        auto lowest = 0.0, highest = 0.0;
        for (const auto& p : corners_) {
          lowest = std::min(lowest, face.height(p));
          highest = std::max(highest, face.height(p));
        }
        if (highest <= slack_) add_face(faces_, face);
        if (lowest >= -slack_) add_face(faces_, {face.point, -face.normal});
      }
}

bool Shaft::misses(const Bounds& box) const {
  const Vec3d low(box.low), high(box.high);
  for (glm::length_t d = 0; d < 3; ++d)
    if (low[d] > high_[d] - slack_ || high[d] < low_[d] + slack_) {
      // A flat shaft that is perpendicular to an axis is thinner than the slack.
      if (high_[d] - low_[d] > 4.0 * slack_) return true;
    }
  return std::any_of(faces_.begin(), faces_.end(), [&](const Plane& face) {
    Vec3d nearest;
    for (glm::length_t d = 0; d < 3; ++d) nearest[d] = face.normal[d] > 0.0 ? low[d] : high[d];
    return face.height(nearest) >= -slack_;
  });
}

bool Shaft::parted(const Vec3d& axis, const std::array<Vec3d, 3>& triangle) const {
  const auto [first, last] =
      std::minmax({glm::dot(axis, triangle[0]), glm::dot(axis, triangle[1]), glm::dot(axis, triangle[2])});
  auto low = 1e300, high = -1e300;
  for (const auto& p : corners_) {
    const auto at = glm::dot(axis, p);
    low = std::min(low, at);
    high = std::max(high, at);
  }
  return first >= high - slack_ || last <= low + slack_;
}

bool Shaft::misses(const std::array<Vec3d, 3>& triangle) const {
  for (const auto& face : faces_)
    if (std::all_of(triangle.begin(), triangle.end(),
                    [&](const Vec3d& p) { return face.height(p) >= -slack_; }))
      return true;
  const std::array<Vec3d, 3> edges = {triangle[1] - triangle[0], triangle[2] - triangle[1],
                                      triangle[0] - triangle[2]};
  const auto normal = glm::cross(edges[0], edges[1]);
  const auto area2 = glm::length(normal);
  if (!(area2 > 0.0) || parted(normal / area2, triangle)) return true;
  for (std::size_t i = 0; i < corners_.size(); ++i)
    for (std::size_t j = i + 1; j < corners_.size(); ++j)
      for (const auto& edge : edges) {
        const auto along = corners_[j] - corners_[i];
        const auto axis = glm::cross(edge, along);
        const auto length = glm::length(axis);
        if (length > same_direction * glm::length(edge) * glm::length(along) &&
            parted(axis / length, triangle))
          return true;
      }
  return false;
}

}  // namespace luxel
