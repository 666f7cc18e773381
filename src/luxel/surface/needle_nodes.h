// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/none.h"
#include "luxel/core/vector.h"
#include "luxel/patch/patch_set.h"
#include "luxel/surface/side_nodes.h"

namespace luxel {

// The sides beyond the needles at a node. Meshes of walls and ceilings are full of needles, left by bevels
// and by polygons with holes. A needle's mean hardly determines the light at its ends, but the patches on
// either side of it do, and light on a flat surface cannot change over its width.
//
// The two ends of a needle's short edge, and all nodes that such edges connect, are a group: flat within 1
// degree but for a tenth of the area around a node, such as the bevel of a window's edge, and no wider than
// 1/10 of the longest edge of each needle in it. A node's far sides are those at the other nodes of its group
// that are no needles themselves and lie in its plane.
class NeedleNodes {
 public:
  struct FarSide {
    SideId side;
    Vec3d weights{0.0};  // barycentric, of the node's vertex in the side's patch, which it is outside of
  };

  // Cost: about 50 ns per patch.
  NeedleNodes(const PatchSet& patches, const SideNodes& nodes);

  std::span<const FarSide> at(std::uint32_t node) const {
    if (list_of_[node] == none) return {};
    return lists_[list_of_[node]];
  }

 private:
  std::vector<std::uint32_t> list_of_;  // [node]
  std::vector<std::vector<FarSide>> lists_;
};

}  // namespace luxel
