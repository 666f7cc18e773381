// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/core/bounds.h"
#include "luxel/form_factors/occluders.h"
#include "luxel/form_factors/shaft.h"

namespace luxel {

// Finds the occluders that reach into a shaft, by a binary tree of boxes. Read-only after construction.
class ShaftSearch {
 public:
  // Keeps a reference to the occluders. 1 us per occluder.
  explicit ShaftSearch(const Occluders& occluders);

  // Replaces `found` by those occluders, but not more than `max_found`: beyond that it stops and returns
  // false.
  bool find(const Shaft& shaft, std::size_t max_found, std::vector<std::uint32_t>& found) const;

 private:
  struct Node {
    Bounds box;
    std::uint32_t first = 0, count = 0;  // its occluders: order_[first .. first + count)
    std::uint32_t child = 0;             // its two children are nodes child and child + 1; 0: a leaf
  };

  const Occluders& occluders_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace luxel
