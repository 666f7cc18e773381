// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "luxel/math/vector.h"

namespace luxel {

// Gives one index to each place. Two points are the same place when their coordinates are equal (-0 equals
// 0); indices count up in the order of first asking, so they depend on the input alone.
class VertexWeld {
 public:
  std::uint32_t index_of(const Vec3& position);
  const std::vector<Vec3>& positions() const { return positions_; }
  std::vector<Vec3> take() { return std::move(positions_); }

 private:
  struct Hash {
    std::size_t operator()(const Vec3& p) const;
  };
  std::unordered_map<Vec3, std::uint32_t, Hash>
      index_;  // looked up only, never walked: its order does not matter
  std::vector<Vec3> positions_;
};

}  // namespace luxel
