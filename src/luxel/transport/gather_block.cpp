// SPDX-License-Identifier: Apache-2.0
#include "luxel/transport/gather_block.h"

namespace luxel {

std::vector<std::uint32_t> gather_block_begins(const GatherSides& sides) {
  std::vector<std::uint32_t> begins;
  for (std::uint32_t s = 0; s < sides.size(); ++s) {
    const bool opens =
        s == 0 || s == sides.fronts ||
        sides.position[s] / gather_block_positions != sides.position[s - 1] / gather_block_positions;
    if (opens) begins.push_back(s);
  }
  begins.push_back(static_cast<std::uint32_t>(sides.size()));
  return begins;
}

}  // namespace luxel
