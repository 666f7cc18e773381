// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/lamps/shadow_receivers.h"
#include "luxel/patch/contact_lines.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Reduces the shadows of edges on one triangle to the parts along which light does end: on the outer side a
// point sees the light, on the inner side it does not. Each shadow is cut where others of the same light and
// contacts cross it, and each part is tested with pairs of points at `reach` from the line; where the answers
// along a part differ, its end is found by bisection. Of parts that lie within twice `reach` of each other
// one remains.
//
// shadows: those of one triangle. contacts: lines on it. lengths: of ShadowReceivers. Thread-safe. Cost:
// about 30 rays per part.
std::vector<EdgeShadow> true_parts(const PatchSet& triangles, const Tracer& tracer,
                                   std::span<const EdgeShadow> shadows, std::span<const ContactLine> contacts,
                                   const ShadowReceivers::Lengths& lengths);

}  // namespace luxel
