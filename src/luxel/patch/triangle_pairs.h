// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "luxel/core/bounds.h"
#include "luxel/core/context.h"

namespace luxel {

// The pairs of boxes that overlap or touch, in parts that several threads can walk. The parts are the same on
// every host and for any number of threads. Cost: n log n to sort the boxes into a tree, and what the pairs
// cost; about half a second of processor time for a million triangles of a mesh. 60 bytes a box.
class OverlappingPairs {
 public:
  using Visit = std::function<void(std::uint32_t, std::uint32_t)>;

  // Up to 2^31 boxes, none of them empty.
  OverlappingPairs(std::span<const Bounds> boxes, const Context& context);

  std::size_t parts() const { return parts_.size(); }
  // Calls visit(i, j), i < j, for each pair of a part; a pair is in one part. Thread-safe.
  void for_pairs(std::size_t part, const Visit& visit) const;

 private:
  // The left child stands right behind its parent.
  struct Node {
    Bounds box;
    std::uint32_t first = 0, count = 0;
    std::uint32_t right = 0;  // 0: a leaf
    bool is_leaf() const { return right == 0; }
  };
  // While the tree is built.
  struct Item {
    Bounds box;
    std::uint32_t index = 0;
  };
  // Two nodes apart, or a node with itself.
  struct NodePair {
    std::uint32_t a = 0, b = 0;
  };

  void build(std::span<Item> items, const Context& context);
  void cut_in_half(std::uint32_t number, std::span<Item> items);
  void build_below(std::uint32_t number, std::span<Item> items);
  void part_the_pairs();
  void descend(const NodePair& pair, std::vector<NodePair>& open) const;
  void meet_in_leaf(const Node& leaf, const Visit& visit) const;
  void meet_in_leaves(const Node& a, const Node& b, const Visit& visit) const;
  void meet(std::uint32_t i, std::uint32_t j, const Visit& visit) const;

  std::vector<Node> nodes_;
  // In the order of the tree, where neighbours stand together.
  std::vector<Bounds> boxes_;
  std::vector<std::uint32_t> index_;  // of the box given
  std::vector<NodePair> parts_;
};

}  // namespace luxel
