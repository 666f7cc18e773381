// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/lamps/shadow_receivers.h"
#include "luxel/patch/flat_triangle.h"

namespace luxel {

// The part of a shadow within an interval of its line.
EdgeShadow part_of(const EdgeShadow& shadow, const Interval& interval);

// Returns the lines without those that lie on others: of two that are nearly parallel and nearer to each
// other than twice `reach` (m) the one of more weight remains, and the parts of the other beyond its ends.
// parts: all on one triangle.
std::vector<EdgeShadow> without_doubles(std::vector<EdgeShadow> parts, double reach);

}  // namespace luxel
