// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/triangle_pairs.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace luxel {
namespace {

constexpr std::uint32_t leaf_size = 4;

bool overlap(const Bounds& a, const Bounds& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

Bounds join(const Bounds& a, const Bounds& b) { return {glm::min(a.low, b.low), glm::max(a.high, b.high)}; }

class BoxTree {
 public:
  using Visit = std::function<void(std::uint32_t, std::uint32_t)>;

  explicit BoxTree(std::span<const Bounds> boxes) : boxes_(boxes.begin(), boxes.end()), index_(boxes.size()) {
    std::iota(index_.begin(), index_.end(), 0u);
    if (!index_.empty()) build(0, static_cast<std::uint32_t>(index_.size()));
    // In the order of the tree, where neighbours stand together.
    for (std::size_t i = 0; i < index_.size(); ++i) boxes_[i] = boxes[index_[i]];
  }

  // Walks pairs of nodes from the top, each pair once: a node with itself, or two nodes apart.
  void for_pairs(const Visit& visit) const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> open;
    if (!nodes_.empty()) open.emplace_back(0, 0);
    while (!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      const auto& a = nodes_[i];
      const auto& b = nodes_[j];
      if (i == j) {
        if (a.is_leaf()) {
          for_leaf(a, visit);
        } else {
          open.emplace_back(i + 1, i + 1);
          open.emplace_back(a.right, a.right);
          open.emplace_back(i + 1, a.right);
        }
      } else if (overlap(a.box, b.box)) {
        if (a.is_leaf() && b.is_leaf()) {
          for_leaves(a, b, visit);
        } else if (b.is_leaf() || (!a.is_leaf() && a.count >= b.count)) {
          open.emplace_back(i + 1, j);
          open.emplace_back(a.right, j);
        } else {
          open.emplace_back(i, j + 1);
          open.emplace_back(i, b.right);
        }
      }
    }
  }

 private:
  // The left child stands right behind its parent.
  struct Node {
    Bounds box;
    std::uint32_t first = 0, count = 0;
    std::uint32_t right = 0;  // 0: a leaf
    bool is_leaf() const { return right == 0; }
  };

  std::uint32_t build(std::uint32_t first, std::uint32_t count) {
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({});
    Bounds box, centers;
    for (auto i = first; i < first + count; ++i) {
      const auto& b = boxes_[index_[i]];
      box = join(box, b);
      centers.add(b.center());
    }
    std::uint32_t right = 0;
    if (count > leaf_size) {
      const auto size = centers.size();
      const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
      const auto half = count / 2;
      const auto begin = index_.begin() + first;
      // Ties go by number, so that the halves are the same sets with every library's nth_element.
      std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t i, std::uint32_t j) {
        const auto a = boxes_[i].low[axis] + boxes_[i].high[axis];
        const auto b = boxes_[j].low[axis] + boxes_[j].high[axis];
        return a != b ? a < b : i < j;
      });
      build(first, half);
      right = build(first + half, count - half);
    } else {
      std::sort(index_.begin() + first, index_.begin() + first + count);
    }
    nodes_[number] = {box, first, count, right};
    return number;
  }

  void for_leaf(const Node& leaf, const Visit& visit) const {
    for (auto i = leaf.first; i < leaf.first + leaf.count; ++i)
      for (auto j = i + 1; j < leaf.first + leaf.count; ++j) meet(i, j, visit);
  }

  void for_leaves(const Node& a, const Node& b, const Visit& visit) const {
    for (auto i = a.first; i < a.first + a.count; ++i)
      if (overlap(boxes_[i], b.box))
        for (auto j = b.first; j < b.first + b.count; ++j) meet(i, j, visit);
  }

  void meet(std::uint32_t i, std::uint32_t j, const Visit& visit) const {
    if (overlap(boxes_[i], boxes_[j])) visit(std::min(index_[i], index_[j]), std::max(index_[i], index_[j]));
  }

  std::vector<Bounds> boxes_;
  std::vector<std::uint32_t> index_;  // place in the tree -> box
  std::vector<Node> nodes_;
};

}  // namespace

void for_overlapping_pairs(std::span<const Bounds> boxes,
                           const std::function<void(std::uint32_t, std::uint32_t)>& visit) {
  BoxTree(boxes).for_pairs(visit);
}

}  // namespace luxel
