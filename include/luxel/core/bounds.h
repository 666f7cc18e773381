// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "luxel/core/vector.h"

namespace luxel {

/// An axis-aligned box, in the units of its points; empty until a point is added.
template <typename Point>
struct Box {
  using Scalar = typename Point::value_type;

  Point low = Point(std::numeric_limits<Scalar>::infinity());
  Point high = Point(-std::numeric_limits<Scalar>::infinity());

  void add(const Point& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  void add(const Box& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  bool empty() const { return !(low.x <= high.x); }
  Point size() const { return empty() ? Point(Scalar(0)) : high - low; }
  Point center() const { return Scalar(0.5) * (low + high); }
  /// Returns whether the boxes have a point in common.
  bool meets(const Box& other) const {
    for (int axis = 0; axis < Point::length(); ++axis)
      if (!(low[axis] <= other.high[axis] && other.low[axis] <= high[axis])) return false;
    return true;
  }
};

/// A box in space, m.
using Bounds = Box<Vec3>;

}  // namespace luxel
