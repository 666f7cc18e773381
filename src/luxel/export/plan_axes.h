// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/vector.h"

namespace luxel {

// A point of a plan: m to the right and m upwards on the sheet.
using PlanPoint = glm::dvec2;

// The axes of a plan drawing in a scene. Where z is up: x to the right, y upwards on the sheet. Where y is
// up: x to the right, -z upwards on the sheet. Heights are along the up axis.
struct PlanAxes {
  Vec3d right{1.0, 0.0, 0.0}, ahead{0.0, 1.0, 0.0}, up{0.0, 0.0, 1.0};  // unit, at right angles

  // Plan coordinates (right, ahead, height), m, of a point of the scene, m; and back.
  Vec3d in_plan(const Vec3d& point) const {
    return {glm::dot(right, point), glm::dot(ahead, point), glm::dot(up, point)};
  }
  Vec3d in_scene(const Vec3d& plan) const { return right * plan.x + ahead * plan.y + up * plan.z; }
};

// up: of the scene, any length above 0.
PlanAxes plan_axes(const Vec3d& up);

}  // namespace luxel
