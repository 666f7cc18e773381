// SPDX-License-Identifier: Apache-2.0
#include "luxel/trace/gather_sides.h"

#include <cassert>

#include "luxel/core/none.h"
#include "luxel/patch/side.h"
#include "luxel/trace/patch_emitter.h"

namespace luxel {
namespace {

void add(GatherSides& sides, SideId side, std::uint32_t position) {
  sides.receiver_of_side[side.index()] = static_cast<std::uint32_t>(sides.side.size());
  sides.side.push_back(side);
  sides.position.push_back(position);
}

}  // namespace

GatherSides all_gather_sides(const PatchSet& patches, const PatchTree& tree) {
  GatherSides sides;
  sides.receiver_of_side.assign(side_count(patches.size()), none);
  for (std::size_t i = 0; i < tree.order.size(); ++i)
    add(sides, SideId(tree.order[i], false), tree.position[i]);
  sides.fronts = sides.size();
  for (std::size_t i = 0; i < tree.order.size(); ++i)
    if (patches.material_of(tree.order[i]).two_sided)
      add(sides, SideId(tree.order[i], true), tree.position[i]);
  return sides;
}

std::vector<std::uint32_t> neighbour_begins(const GatherSides& sides, std::uint32_t positions) {
  std::vector<std::uint32_t> begins;
  for (std::uint32_t s = 0; s < sides.size(); ++s)
    if (s == 0 || s == sides.fronts || sides.position[s] / positions != sides.position[s - 1] / positions)
      begins.push_back(s);
  begins.push_back(static_cast<std::uint32_t>(sides.size()));
  return begins;
}

GatherSides restored_gather_sides(const GatherSides& sides, const std::vector<std::uint8_t>& keep) {
  assert(keep.size() == sides.size());
  GatherSides result;
  result.receiver_of_side.assign(sides.receiver_of_side.size(), none);
  for (std::size_t receiver = 0; receiver < sides.size(); ++receiver) {
    if (receiver == sides.fronts) result.fronts = result.size();
    if (keep[receiver]) add(result, sides.side[receiver], sides.position[receiver]);
  }
  if (sides.fronts == sides.size()) result.fronts = result.size();
  return result;
}

}  // namespace luxel
