// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel {

// Gives one index to each place. Two points are the same place when their coordinates are equal (-0 equals
// 0); indices count up in the order of first asking, so they depend on the input alone. About 50 ns a
// question where the places fill the caches.
class VertexWeld {
 public:
  std::uint32_t index_of(const Vec3& position);
  const std::vector<Vec3>& positions() const { return positions_; }
  std::vector<Vec3> take() { return std::move(positions_); }

 private:
  void grow();
  // Hash table with open addressing, at most half full: an index, or `none`. A power of two long.
  std::vector<std::uint32_t> receivers_;
  std::vector<Vec3> positions_;
};

}  // namespace luxel
