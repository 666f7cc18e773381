// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/shaft_search.h"

#include <algorithm>
#include <numeric>

namespace luxel {
namespace {

constexpr std::uint32_t leaf_occluders = 2;  // at most, in a leaf

}  // namespace

ShaftSearch::ShaftSearch(const Occluders& occluders) : occluders_(occluders), order_(occluders.size()) {
  std::vector<Bounds> boxes(occluders.size());
  for (std::size_t k = 0; k < boxes.size(); ++k)
    for (const auto& p : occluders.polygon(k)) boxes[k].add(Vec3(p));
  std::iota(order_.begin(), order_.end(), 0u);
  if (order_.empty()) return;
  nodes_.push_back({{}, 0, static_cast<std::uint32_t>(order_.size())});
  for (std::size_t k = 0; k < nodes_.size(); ++k) {  // children stand behind
    auto node = nodes_[k];
    Bounds centres;
    for (auto i = node.first; i < node.first + node.count; ++i) {
      node.box.add(boxes[order_[i]].low);
      node.box.add(boxes[order_[i]].high);
      centres.add(boxes[order_[i]].center());
    }
    if (node.count > leaf_occluders) {
      const auto size = centres.size();
      const glm::length_t widest = size.x >= std::max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
      const auto half = node.count / 2;
      const auto begin = order_.begin() + node.first;
      std::nth_element(begin, begin + half, begin + node.count, [&](std::uint32_t a, std::uint32_t b) {
        const auto of_a = boxes[a].center()[widest], of_b = boxes[b].center()[widest];
        return of_a != of_b ? of_a < of_b : a < b;
      });
      node.child = static_cast<std::uint32_t>(nodes_.size());
      nodes_.push_back({{}, node.first, half});
      nodes_.push_back({{}, node.first + half, node.count - half});
    }
    nodes_[k] = node;
  }
}

bool ShaftSearch::find(const Shaft& shaft, std::size_t max_found, std::vector<std::uint32_t>& found) const {
  found.clear();
  if (nodes_.empty()) return true;
  std::vector<std::uint32_t> open = {0};
  while (!open.empty()) {
    const auto& node = nodes_[open.back()];
    open.pop_back();
    if (shaft.misses(node.box)) continue;
    if (node.child != 0) {
      open.push_back(node.child + 1);
      open.push_back(node.child);
      continue;
    }
    for (auto i = node.first; i < node.first + node.count; ++i) {
      if (shaft.misses(occluders_.polygon(order_[i]))) continue;
      if (found.size() == max_found) return false;
      found.push_back(order_[i]);
    }
  }
  return true;
}

}  // namespace luxel
