// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/plan_axes.h"

#include <cmath>

namespace luxel {

PlanAxes plan_axes(const Vec3d& up) {
  PlanAxes axes;
  axes.up = glm::normalize(up);
  // The x axis is to the right unless it is the up axis.
  const Vec3d x = std::abs(axes.up.x) < 0.9 ? Vec3d(1.0, 0.0, 0.0) : Vec3d(0.0, 1.0, 0.0);
  axes.right = glm::normalize(x - axes.up * glm::dot(axes.up, x));
  axes.ahead = glm::cross(axes.up, axes.right);
  return axes;
}

}  // namespace luxel
