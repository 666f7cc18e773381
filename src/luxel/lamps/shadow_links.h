// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "luxel/lamps/shadow_receivers.h"

namespace luxel {

// Returns the links (EdgeShadow::is_link) that join two parts of the same edge, alone or in a row: a gap in a
// line lets light through to the patches around both its ends. parts: as true_parts() found them. reach: m;
// pieces nearer to each other than four times this are joined. Cost: a sort.
std::vector<EdgeShadow> joining_links(std::span<const EdgeShadow> links, std::span<const EdgeShadow> parts,
                                      double reach);

}  // namespace luxel
