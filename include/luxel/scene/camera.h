// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/vector.h"

namespace luxel {

/// A pinhole camera.
struct Camera {
  Vec3 eye = Vec3(0.0f, 0.0f, 1.0f);  ///< m
  Vec3 target = Vec3(0.0f);           ///< m, what the middle of the picture shows
  Vec3 up = Vec3(0.0f, 1.0f, 0.0f);   ///< any length, not along the view
  float vertical_fov = 50.0f;         ///< degrees, in (0, 180)
  float aspect = 0.0f;                ///< width over height of the picture it is meant for; 0: of any
};

}  // namespace luxel
