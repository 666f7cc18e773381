// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/render/make_lightmap.h"
#include "luxel/solution/solution.h"
#include "luxel/surface/given_layout.h"

namespace luxel {

// Lays out all lit surfaces on pages: makes charts and packs them. After the monitor's stop the layout is
// empty: no charts, no pages. Throws the errors of make_charts() and pack_charts().
LaidOut lay_out(const PatchSet& patches, const Solution& solution, const LightmapOptions& options,
                const Context& context = {});

}  // namespace luxel
