// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "luxel/core/vector.h"

namespace luxel {

/// An axis-aligned box in metres; empty until a point is added.
struct Bounds {
  Vec3 low = Vec3(std::numeric_limits<float>::infinity());
  Vec3 high = Vec3(-std::numeric_limits<float>::infinity());

  void add(const Vec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  bool empty() const { return !(low.x <= high.x); }
  Vec3 size() const { return empty() ? Vec3(0.0f) : high - low; }
  Vec3 center() const { return 0.5f * (low + high); }
};

}  // namespace luxel
