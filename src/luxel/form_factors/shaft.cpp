// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/shaft.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "luxel/form_factors/polygon_form_factor.h"

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
  corners_.reserve(a.size() + b.size());
  faces_.reserve(2 * (a.size() + b.size()));
  edges_.reserve(3 * (a.size() + b.size()));
  corners_.assign(a.begin(), a.end());
  corners_.insert(corners_.end(), b.begin(), b.end());
  low_ = high_ = corners_[0];
  for (const auto& p : corners_) {
    low_ = glm::min(low_, p);
    high_ = glm::max(high_, p);
  }
  // A plane through three corners is a face if all other corners lie on one side. There are few corners, so
  // all triples are tested.
  std::vector<bool> is_edge(corners_.size() * corners_.size(), false);
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
        if (highest > slack_ && lowest < -slack_) continue;
        for (const auto& [from, to] : {std::pair(i, j), std::pair(j, k), std::pair(i, k)}) {
          if (is_edge[from * corners_.size() + to]) continue;
          is_edge[from * corners_.size() + to] = true;
          edges_.push_back(corners_[to] - corners_[from]);
        }
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

bool Shaft::is_parted(const Vec3d& axis, std::span<const Vec3d> polygon) const {
  const auto slack = slack_ * glm::length(axis);
  auto low = glm::dot(axis, corners_[0]), high = low;
  for (const auto& p : corners_) {
    const auto at = glm::dot(axis, p);
    low = std::min(low, at);
    high = std::max(high, at);
  }
  auto first = glm::dot(axis, polygon[0]), last = first;
  for (const auto& p : polygon) {
    const auto at = glm::dot(axis, p);
    first = std::min(first, at);
    last = std::max(last, at);
  }
  return first >= high - slack || last <= low + slack;
}

bool Shaft::misses(std::span<const Vec3d> polygon) const {
  for (const auto& face : faces_)
    if (std::all_of(polygon.begin(), polygon.end(),
                    [&](const Vec3d& p) { return face.height(p) >= -slack_; }))
      return true;
  const auto normal = polygon_area_vector(polygon);
  if (!(glm::length(normal) > 0.0) || is_parted(normal, polygon)) return true;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto edge = polygon[(k + 1) % polygon.size()] - polygon[k];
    for (const auto& along : edges_) {
      const auto axis = glm::cross(edge, along);
      const bool is_axis = glm::length(axis) > same_direction * glm::length(edge) * glm::length(along);
      if (is_axis && is_parted(axis, polygon)) return true;
    }
  }
  return false;
}

bool hides_all(std::span<const Vec3d> screen, std::span<const Vec3d> a, std::span<const Vec3d> b,
               double slack) {
  const auto front = polygon_area_vector(screen);
  const Plane plane{screen[0], front / glm::length(front)};
  const auto side = plane.height(a[0]) > 0.0 ? 1.0 : -1.0;
  const auto stands_before = [&](const Vec3d& p) { return side * plane.height(p) > slack; };
  const auto stands_behind = [&](const Vec3d& p) { return side * plane.height(p) < -slack; };
  if (!std::all_of(a.begin(), a.end(), stands_before) || !std::all_of(b.begin(), b.end(), stands_behind))
    return false;
  for (std::size_t k = 0; k < screen.size(); ++k) {
    const auto edge = screen[(k + 1) % screen.size()] - screen[k];
    for (const auto& p : a)
      for (const auto& q : b)
        if (side * glm::dot(glm::cross(edge, p - screen[k]), q - screen[k]) > 0.0) return false;
  }
  return true;
}

}  // namespace luxel
