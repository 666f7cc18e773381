// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace luxel {

// Numbered things in sets that grow together (union-find with path halving; Tarjan and van Leeuwen 1984). A
// set is identified by its lowest member, which does not depend on the order of joining. Not for several
// threads at once: of() shortens paths.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count = 0) { reset(count); }

  // Each thing is a set of its own again. Keeps its memory.
  void reset(std::size_t count) {
    parent_.resize(count);
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  std::uint32_t of(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void join(std::uint32_t i, std::uint32_t j) {
    i = of(i);
    j = of(j);
    if (i != j) parent_[i < j ? j : i] = i < j ? i : j;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace luxel
