// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/render/default_light.h"
#include "luxel/solve/solve_light.h"

namespace luxel {

// The sky of a scene without light that this method solves.
inline DefaultSky default_sky(Method method) {
  return takes_uneven_sky(method) ? DefaultSky::over_ground : DefaultSky::all_around;
}

}  // namespace luxel
