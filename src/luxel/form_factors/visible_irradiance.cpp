// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/visible_irradiance.h"

#include <algorithm>
#include <cmath>

#include "luxel/form_factors/polygon_form_factor.h"
#include "luxel/lamps/polygon_irradiance.h"

namespace luxel {

void VisibleIrradiance::keep(const Polygon& fragment) {
  if (fragment.size() < 3) return;
  if (visible_count_ == visible_.size()) visible_.emplace_back();
  visible_[visible_count_++].assign(fragment.begin(), fragment.end());
}

void VisibleIrradiance::hide(const Vec3d& x, OccludingPolygon screen) {
  // Above the far plane lies the part behind the screen; above the side planes lies the inside of the
  // pyramid.
  auto normal = polygon_area_vector(screen);
  const auto height = glm::dot(normal, x - screen[0]);
  if (std::fabs(height) <= slack_ * glm::length(normal)) return;
  if (height > 0.0) normal = -normal;
  const auto sign = height > 0.0 ? -1.0 : 1.0;
  planes_.assign({{screen[0], normal}});
  for (std::size_t k = 0; k < screen.size(); ++k)
    planes_.push_back({x, sign * glm::cross(screen[k] - x, screen[(k + 1) % screen.size()] - x)});

  if (cut_off_.size() < planes_.size()) cut_off_.resize(planes_.size());
  visible_count_ = 0;
  for (std::size_t i = 0; i < fragment_count_; ++i) {
    const auto pieces = cut(fragments_[i]);
    if (pieces == none_behind) {
      keep(fragments_[i]);
    } else {
      for (std::size_t k = 0; k < pieces; ++k) keep(cut_off_[k]);
    }
  }
  fragments_.swap(visible_);
  fragment_count_ = visible_count_;
}

std::size_t VisibleIrradiance::cut(const Polygon& fragment) {
  std::size_t pieces = 0;
  behind_ = fragment;
  for (const auto& plane : planes_) {
    heights_.clear();
    for (const auto& p : behind_) heights_.push_back(plane.height(p));
    const auto [lowest, highest] = std::minmax_element(heights_.begin(), heights_.end());
    if (!(*highest > 0.0)) return none_behind;
    if (*lowest >= 0.0) continue;
    split_polygon(behind_, heights_, rest_, cut_off_[pieces++]);
    if (rest_.size() < 3) return none_behind;
    behind_.swap(rest_);
  }
  return pieces;
}

double VisibleIrradiance::at(const Vec3d& x, const Vec3d& n, std::span<const Vec3d> polygon,
                             std::span<const OccludingPolygon> screens) {
  if (fragments_.empty()) fragments_.emplace_back();
  fragments_[0].assign(polygon.begin(), polygon.end());
  fragment_count_ = 1;
  for (const auto& screen : screens) {
    hide(x, screen);
    if (fragment_count_ == 0) return 0.0;
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < fragment_count_; ++i) sum += unit_irradiance(fragments_[i], x, n);
  return sum > 0.0 ? sum : 0.0;
}

}  // namespace luxel
