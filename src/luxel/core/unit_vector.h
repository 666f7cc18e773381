// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "luxel/core/vector.h"

namespace luxel {

// Returns whether v has a length of 1, but for the rounding of floats. For assertions.
inline bool is_unit(const Vec3d& v) { return std::abs(glm::dot(v, v) - 1.0) < 1e-4; }

}  // namespace luxel
