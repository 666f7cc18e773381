// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/surface/side_edges.h"

namespace luxel {

// Connected sides whose normals lie within a cone.
struct SideCluster {
  std::vector<SideId> sides;  // ascending
  Vec3d direction{0.0};       // unit, the axis of the cone
};

struct ClusterInput {
  const PatchSet& patches;
  const std::vector<SideEdge>& edges;
  const std::vector<bool>& is_crossed;  // [edge]: whether a cluster may go on across it
  const std::vector<bool>& is_wanted;   // [side]
  double cos_max_angle = 0.7;           // of the cone's half angle
};

// Groups sides by hierarchical clustering (Garland, Willmott and Heckbert 2001): neighbours are joined in the
// order of a cost, as long as the cone is not wider than the limit. The cost is low where the cone stays
// narrow and where the shared border is a large part of the smaller one's border, so flat regions join first
// and small ones end as parts of their neighbours. Clusters stand in the order of their first sides. Cost: a
// sort of the edges; each is looked at a few times. After the monitor's stop there are none.
std::vector<SideCluster> cluster_sides(const ClusterInput& input, const Context& context);

}  // namespace luxel
