// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/vector.h"
#include "luxel/scene/point_light.h"

namespace luxel {

// How a lamp without a surface is seen from a point.
struct PointSight {
  double irradiance = 0.0;       // of the point's surface at unit intensity, nothing between; 0: none
  Vec3d direction = Vec3d(0.0);  // unit, towards the lamp
  float distance = 0.0f;         // m, of where a shadow ray ends; infinite for directional lamps
};

// normal: unit, of the side that is lit. E = I cos / d² (inverse square law); a spot fades as defined by
// KHR_lights_punctual. Distances below a thousandth of a millimetre are clamped to it.
PointSight sight_of(const PointLight& light, const Vec3d& point, const Vec3d& normal);

// Returns the ratio of emitted power to intensity along the axis, sr: 4 pi for points, 0 for directional
// ones, whose power is not finite.
double emitting_angle(const PointLight& light);

}  // namespace luxel
