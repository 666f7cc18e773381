// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/point_tree.h"

#include <algorithm>
#include <numeric>

namespace luxel {
namespace {

constexpr std::uint32_t leaf_points = 8;

// Returns whether the segment from a along d meets the box widened by `distance` on all sides (slab test).
bool meets(const Bounds& box, const Vec3d& a, const Vec3d& d, double distance) {
  double enter = 0.0;
  double leave = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto low = static_cast<double>(box.low[axis]) - distance - a[axis];
    const auto high = static_cast<double>(box.high[axis]) + distance - a[axis];
    if (d[axis] == 0.0) {
      if (low > 0.0 || high < 0.0) return false;
      continue;
    }
    const auto t0 = low / d[axis];
    const auto t1 = high / d[axis];
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
  }
  return enter <= leave;
}

}  // namespace

PointTree::PointTree(std::span<const Vec3> points) : points_(points.begin(), points.end()) {
  order_.resize(points_.size());
  std::iota(order_.begin(), order_.end(), 0u);
  if (points_.empty()) return;
  nodes_.push_back({{}, 0, static_cast<std::uint32_t>(points_.size()), 0});
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    auto node = nodes_[n];
    const auto begin = order_.begin() + node.first;
    const auto end = begin + node.count;
    for (auto i = begin; i != end; ++i) node.box.add(points_[*i]);
    if (node.count > leaf_points) {
      const auto size = node.box.size();
      const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
      const auto half = node.count / 2;
      std::nth_element(begin, begin + half, end, [&](std::uint32_t i, std::uint32_t j) {
        const auto a = points_[i][axis];
        const auto b = points_[j][axis];
        return a != b ? a < b : i < j;
      });
      node.child = static_cast<std::uint32_t>(nodes_.size());
      nodes_.push_back({{}, node.first, half, 0});
      nodes_.push_back({{}, node.first + half, node.count - half, 0});
    }
    nodes_[n] = node;
  }
}

void PointTree::near_segment(const Vec3& a, const Vec3& b, double distance,
                             std::vector<std::uint32_t>& found) const {
  if (nodes_.empty()) return;
  const Vec3d from(a);
  const auto d = Vec3d(b) - from;
  std::vector<std::uint32_t> open = {0};
  while (!open.empty()) {
    const auto& node = nodes_[open.back()];
    open.pop_back();
    if (!meets(node.box, from, d, distance)) continue;
    if (node.child != 0) {
      open.push_back(node.child + 1);
      open.push_back(node.child);
      continue;
    }
    for (auto i = node.first; i < node.first + node.count; ++i)
      if (meets({points_[order_[i]], points_[order_[i]]}, from, d, distance)) found.push_back(order_[i]);
  }
}

}  // namespace luxel
