// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/triangle_pairs.h"

#include <algorithm>
#include <utility>

namespace luxel {
namespace {

constexpr std::uint32_t leaf_size = 4;
constexpr std::size_t items_grain = 1 << 14;
constexpr std::uint32_t task_boxes = 1 << 13;  // a node of at most this many boxes is one task

Bounds joined(Bounds a, const Bounds& b) {
  a.add(b);
  return a;
}

// The nodes of a tree over this many boxes.
std::uint32_t tree_size(std::uint32_t count) {
  if (count <= leaf_size) return 1;
  const auto half = count / 2;
  return 1 + (count % 2 == 0 ? 2 * tree_size(half) : tree_size(half) + tree_size(half + 1));
}

}  // namespace

OverlappingPairs::OverlappingPairs(std::span<const Bounds> boxes, const Context& context)
    : boxes_(boxes.size()), index_(boxes.size()) {
  if (boxes.empty()) return;
  std::vector<Item> items(boxes.size());
  context.for_chunks(boxes.size(), items_grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto i = begin; i < end; ++i) items[i] = {boxes[i], static_cast<std::uint32_t>(i)};
  });
  build(items, context);
  part_the_pairs();
}

void OverlappingPairs::for_pairs(std::size_t part, const Visit& visit) const {
  std::vector<NodePair> open = {parts_[part]};
  while (!open.empty()) {
    const auto pair = open.back();
    open.pop_back();
    const auto& a = nodes_[pair.a];
    const auto& b = nodes_[pair.b];
    if (!a.is_leaf() || !b.is_leaf()) {
      descend(pair, open);
    } else if (pair.a == pair.b) {
      meet_in_leaf(a, visit);
    } else {
      meet_in_leaves(a, b, visit);
    }
  }
}

void OverlappingPairs::build(std::span<Item> items, const Context& context) {
  const auto count = static_cast<std::uint32_t>(items.size());
  nodes_.resize(tree_size(count));
  nodes_[0].count = count;
  // Large nodes level by level, then each small one with its whole subtree.
  std::vector<std::uint32_t> tasks, large_nodes, level = {0};
  while (!level.empty()) {
    std::vector<std::uint32_t> large;
    for (const auto n : level) (nodes_[n].count > task_boxes ? large : tasks).push_back(n);
    context.for_chunks(large.size(), 1,
                       [&](std::size_t i, std::size_t, int) { cut_in_half(large[i], items); });
    level.clear();
    for (const auto n : large) level.insert(level.end(), {n + 1, nodes_[n].right});
    large_nodes.insert(large_nodes.end(), large.begin(), large.end());
  }
  context.for_chunks(tasks.size(), 1, [&](std::size_t i, std::size_t, int) { build_below(tasks[i], items); });
  for (auto n = large_nodes.rbegin(); n != large_nodes.rend(); ++n)
    nodes_[*n].box = joined(nodes_[*n + 1].box, nodes_[nodes_[*n].right].box);
}

// Creates the node's children and their boxes; the children's tree sizes are set later.
void OverlappingPairs::cut_in_half(std::uint32_t number, std::span<Item> items) {
  auto& node = nodes_[number];
  const auto own = items.subspan(node.first, node.count);
  Bounds centers;
  for (const auto& item : own) centers.add(item.box.center());
  const auto size = centers.size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  const auto half = node.count / 2;
  // Ties are ordered by index, so that the halves are the same sets with every library's nth_element.
  std::nth_element(own.begin(), own.begin() + half, own.end(), [axis](const Item& a, const Item& b) {
    const auto c = a.box.low[axis] + a.box.high[axis];
    const auto d = b.box.low[axis] + b.box.high[axis];
    return c != d ? c < d : a.index < b.index;
  });
  node.right = number + 1 + tree_size(half);
  nodes_[number + 1].first = node.first;
  nodes_[number + 1].count = half;
  nodes_[node.right].first = node.first + half;
  nodes_[node.right].count = node.count - half;
}

void OverlappingPairs::build_below(std::uint32_t number, std::span<Item> items) {
  auto& node = nodes_[number];
  if (node.count > leaf_size) {
    cut_in_half(number, items);
    build_below(number + 1, items);
    build_below(node.right, items);
    node.box = joined(nodes_[number + 1].box, nodes_[node.right].box);
    return;
  }
  const auto own = items.subspan(node.first, node.count);
  std::sort(own.begin(), own.end(), [](const Item& a, const Item& b) { return a.index < b.index; });
  for (std::uint32_t i = 0; i < node.count; ++i) {
    index_[node.first + i] = own[i].index;
    boxes_[node.first + i] = own[i].box;
    node.box.add(boxes_[node.first + i]);
  }
}

// From the root, each pair once, until no node of a pair has more boxes than one task.
void OverlappingPairs::part_the_pairs() {
  std::vector<NodePair> open = {{0, 0}};
  while (!open.empty()) {
    std::vector<NodePair> below;
    for (const auto& pair : open) {
      const bool is_large = std::max(nodes_[pair.a].count, nodes_[pair.b].count) > task_boxes;
      is_large ? descend(pair, below) : parts_.push_back(pair);
    }
    open = std::move(below);
  }
}

// Adds the pairs one level below a pair that is not of two leaves.
void OverlappingPairs::descend(const NodePair& pair, std::vector<NodePair>& open) const {
  const auto [i, j] = pair;
  const auto& a = nodes_[i];
  const auto& b = nodes_[j];
  const auto push = [&](std::uint32_t k, std::uint32_t l) {
    if (k == l || nodes_[k].box.meets(nodes_[l].box)) open.push_back({k, l});
  };
  if (i == j) {
    push(i + 1, i + 1);
    push(a.right, a.right);
    push(i + 1, a.right);
  } else if (b.is_leaf() || (!a.is_leaf() && a.count >= b.count)) {
    push(i + 1, j);
    push(a.right, j);
  } else {
    push(i, j + 1);
    push(i, b.right);
  }
}

void OverlappingPairs::meet_in_leaf(const Node& leaf, const Visit& visit) const {
  for (auto i = leaf.first; i < leaf.first + leaf.count; ++i)
    for (auto j = i + 1; j < leaf.first + leaf.count; ++j) meet(i, j, visit);
}

void OverlappingPairs::meet_in_leaves(const Node& a, const Node& b, const Visit& visit) const {
  for (auto i = a.first; i < a.first + a.count; ++i)
    if (boxes_[i].meets(b.box))
      for (auto j = b.first; j < b.first + b.count; ++j) meet(i, j, visit);
}

void OverlappingPairs::meet(std::uint32_t i, std::uint32_t j, const Visit& visit) const {
  if (boxes_[i].meets(boxes_[j])) visit(std::min(index_[i], index_[j]), std::max(index_[i], index_[j]));
}

}  // namespace luxel
