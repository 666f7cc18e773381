// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/bounds.h"

namespace luxel {

// Points, halved along the longer extent down to a few: finds those near a line without looking at all.
class PointTree {
 public:
  // Keeps its own copy. n log n.
  explicit PointTree(std::span<const Vec3> points);

  // Appends the indices of the points whose distance from the segment is at most `distance` (m), and perhaps
  // of some that are a little farther. In an order that depends on the points alone.
  void near_segment(const Vec3& a, const Vec3& b, double distance, std::vector<std::uint32_t>& found) const;

 private:
  struct Node {
    Bounds box;
    std::uint32_t first = 0, count = 0;
    std::uint32_t child = 0;  // children are child and child + 1; 0: a leaf
  };
  std::vector<Vec3> points_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace luxel
