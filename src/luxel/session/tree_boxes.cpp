// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/tree_boxes.h"

#include "luxel/patch/patch_tree.h"

namespace luxel {

std::vector<std::vector<Bounds>> tree_boxes(const PatchSet& patches, const PatchTree& tree) {
  std::vector<Bounds> boxes(tree.nodes.size());
  for (auto n = tree.nodes.size(); n-- > 0;) {  // children come after their parents
    const auto& node = tree.nodes[n];
    auto& box = boxes[n];
    if (node.child != 0) {
      for (const auto child : {node.child, node.child + 1}) {
        box.add(boxes[child].low);
        box.add(boxes[child].high);
      }
      continue;
    }
    for (auto place = node.first; place < node.first + node.count; ++place)
      for (const auto& point : patches.points(tree.order[place])) box.add(point);
  }
  std::vector<std::vector<Bounds>> levels;
  for (std::size_t k = 0; k + 1 < tree.level_begin.size(); ++k)
    levels.emplace_back(boxes.begin() + tree.level_begin[k], boxes.begin() + tree.level_begin[k + 1]);
  return levels;
}

}  // namespace luxel
