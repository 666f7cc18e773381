// SPDX-License-Identifier: Apache-2.0
#include "luxel/form_factors/shaft_search.h"

namespace luxel {

ShaftSearch::ShaftSearch(const PatchSet& patches, const Context& context)
    : patches_(patches), tree_(make_patch_tree(patches, context)), boxes_(tree_.nodes.size()) {
  for (auto k = tree_.nodes.size(); k-- > 0;) {  // children follow their parents
    const auto& node = tree_.nodes[k];
    if (node.child != 0) {
      for (const auto child : {node.child, node.child + 1}) {
        boxes_[k].add(boxes_[child].low);
        boxes_[k].add(boxes_[child].high);
      }
    } else {
      for (auto i = node.first; i < node.first + node.count; ++i)
        for (const auto& p : patches.points(tree_.order[i])) boxes_[k].add(p);
    }
  }
}

bool ShaftSearch::find(const Shaft& shaft, std::size_t most, std::vector<std::uint32_t>& found) const {
  found.clear();
  if (tree_.nodes.empty()) return true;
  std::vector<std::uint32_t> open = {0};
  while (!open.empty()) {
    const auto k = open.back();
    open.pop_back();
    if (shaft.misses(boxes_[k])) continue;
    const auto& node = tree_.nodes[k];
    if (node.child != 0) {
      open.push_back(node.child + 1);
      open.push_back(node.child);
      continue;
    }
    for (auto i = node.first; i < node.first + node.count; ++i) {
      const auto points = patches_.points(tree_.order[i]);
      if (shaft.misses(std::array{Vec3d(points[0]), Vec3d(points[1]), Vec3d(points[2])})) continue;
      if (found.size() == most) return false;
      found.push_back(tree_.order[i]);
    }
  }
  return true;
}

}  // namespace luxel
