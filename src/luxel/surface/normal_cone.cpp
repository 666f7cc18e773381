// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/normal_cone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace luxel {
namespace {

constexpr double same_direction = 1.0 - 1e-9;  // cosine; 0.003 degrees
constexpr std::size_t max_normals = 48;        // before the inner ones are left out

double cos_to_farthest(const Vec3d& axis, std::span<const Vec3d> normals) {
  double least = 1.0;
  for (const auto& n : normals) least = std::min(least, glm::dot(axis, n));
  return least;
}

}  // namespace

NormalCone NormalCone::around(const NormalCone& a, const NormalCone& b) {
  const auto& wide = a.cos_half_angle_ <= b.cos_half_angle_ ? a : b;
  const auto& narrow = &wide == &a ? b : a;
  if (cos_to_farthest(wide.axis_, narrow.normals_) >= std::min(same_direction, wide.cos_half_angle_))
    return wide;
  NormalCone cone;
  cone.normals_ = wide.normals_;
  for (const auto& n : narrow.normals_)
    if (std::none_of(cone.normals_.begin(), cone.normals_.end(),
                     [&](const auto& own) { return glm::dot(own, n) > same_direction; }))
      cone.normals_.push_back(n);

  const auto middle = wide.axis_ + narrow.axis_;
  const auto length = glm::length(middle);
  auto axis = length > 0.0 ? middle / length : wide.axis_;
  cone.axis_ = axis;
  cone.cos_half_angle_ = cos_to_farthest(axis, cone.normals_);
  constexpr int steps = 16;
  for (int i = 1; i <= steps && cone.normals_.size() > 2; ++i) {
    const auto farthest = *std::min_element(
        cone.normals_.begin(), cone.normals_.end(),
        [&](const auto& m, const auto& n) { return glm::dot(axis, m) < glm::dot(axis, n); });
    axis = glm::normalize(axis + (farthest - axis) / static_cast<double>(i + 1));
    if (const auto reached = cos_to_farthest(axis, cone.normals_); reached > cone.cos_half_angle_) {
      cone.axis_ = axis;
      cone.cos_half_angle_ = reached;
    }
  }
  cone.prune();
  return cone;
}

// Keeps the normals that lie farthest from the axis in each of 24 directions around it.
void NormalCone::prune() {
  if (normals_.size() <= max_normals) return;
  const auto other = std::abs(axis_.x) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  const auto u = glm::normalize(glm::cross(axis_, other)), v = glm::cross(axis_, u);
  constexpr std::size_t directions = 24;
  std::vector<Vec3d> outer;
  for (std::size_t i = 0; i < directions; ++i) {
    const auto angle = 2.0 * std::numbers::pi * static_cast<double>(i) / directions;
    const auto out = std::cos(angle) * u + std::sin(angle) * v;
    const auto farthest =
        *std::max_element(normals_.begin(), normals_.end(),
                          [&](const auto& m, const auto& n) { return glm::dot(out, m) < glm::dot(out, n); });
    if (std::find(outer.begin(), outer.end(), farthest) == outer.end()) outer.push_back(farthest);
  }
  normals_ = std::move(outer);
}

}  // namespace luxel
