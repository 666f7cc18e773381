// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/visible_irradiance.h"

#include <cmath>

#include "luxel/form_factors/clip_polygon.h"
#include "luxel/lamps/polygon_irradiance.h"

namespace luxel {

void VisibleIrradiance::keep(const Polygon& fragment) {
  if (fragment.size() < 3) return;
  if (visible_count_ == visible_.size()) visible_.emplace_back();
  visible_[visible_count_++].assign(fragment.begin(), fragment.end());
}

void VisibleIrradiance::hide(const Vec3d& x, const std::array<Vec3d, 3>& screen) {
  // Above the far plane lies the part behind the screen; above the side planes lies the inside of the
  // pyramid.
  auto normal = glm::cross(screen[1] - screen[0], screen[2] - screen[0]);
  const auto height = glm::dot(normal, x - screen[0]);
  if (std::fabs(height) <= slack_ * glm::length(normal)) return;
  if (height > 0.0) normal = -normal;
  const auto sign = height > 0.0 ? -1.0 : 1.0;
  std::array<Plane, 4> planes;
  planes[0] = {screen[0], normal};
  for (std::size_t k = 0; k < 3; ++k)
    planes[k + 1] = {x, sign * glm::cross(screen[k] - x, screen[(k + 1) % 3] - x)};

  cut_off_.resize(4);
  visible_count_ = 0;
  for (std::size_t i = 0; i < fragment_count_; ++i) {
    behind_ = fragments_[i];
    for (std::size_t k = 0; k < planes.size(); ++k) {
      clip_polygon(behind_, planes[k], rest_);
      clip_polygon(behind_, {planes[k].point, -planes[k].normal}, cut_off_[k]);
      behind_.swap(rest_);
      if (behind_.size() < 3) break;
    }
    if (behind_.size() < 3) {
      keep(fragments_[i]);  // not clipped
    } else {
      for (const auto& fragment : cut_off_) keep(fragment);
    }
  }
  fragments_.swap(visible_);
  fragment_count_ = visible_count_;
}

double VisibleIrradiance::at(const Vec3d& x, const Vec3d& n, std::span<const Vec3d> polygon,
                             std::span<const std::array<Vec3d, 3>> screens) {
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
