// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/transport/gather_sides.h"

namespace luxel {

// Neighbouring sides whose rays are traced together. Rays that share the stratum of their direction follow
// each other, patch after patch: they meet the same things, so the tracer finds its nodes, and a sweep finds
// its radiosities, in the cache.
//
// A ray is a point of the sequence: index = position * n + sample. The last k bits of the index decide which
// of 2^k elementary boxes the point's first two numbers fall into, for every scrambling alike. So walking the
// indices with a stride of 2^k walks one stratum of directions at a time.
class GatherBlock {
 public:
  static constexpr std::uint32_t positions = 1024;

  // The slots, rising, lie in one block of positions and are all fronts or all backs.
  GatherBlock(const GatherSides& sides, std::span<const std::uint32_t> slots)
      : size_(static_cast<std::uint32_t>(slots.size())) {
    if (slots.empty()) return;
    base_ = sides.position[slots.front()] / positions * positions;
    last_ = sides.position[slots.back()] - base_;
    slot_at_.fill(GatherSides::none);
    for (const auto s : slots) slot_at_[sides.position[s] - base_] = s;
  }

  std::uint32_t size() const { return size_; }

  // Calls body(slot, index of the point in the sequence) for the n points of each slot, in the order of
  // tracing. n: a power of two.
  template <typename Body>
  void for_each_point(std::uint32_t n, Body body) const {
    if (size_ == 0) return;
    const auto strata = std::max(n, least_strata);
    const auto points = (last_ + 1) * n;
    const auto shift = std::countr_zero(n);
    for (std::uint32_t stratum = 0; stratum < strata; ++stratum)
      for (auto i = stratum; i < points; i += strata) {
        const auto slot = slot_at_[i >> shift];
        if (slot != GatherSides::none) body(slot, base_ * n + i);
      }
  }

 private:
  static constexpr std::uint32_t least_strata = 64;

  std::uint32_t size_;
  std::uint32_t base_ = 0;  // position
  std::uint32_t last_ = 0;  // position of the last slot, from base
  std::array<std::uint32_t, positions> slot_at_;
};

// Where blocks begin: slots, and at the end the number of slots.
std::vector<std::uint32_t> gather_block_begins(const GatherSides& sides);

}  // namespace luxel
