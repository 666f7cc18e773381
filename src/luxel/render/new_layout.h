// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/progress.h"
#include "luxel/core/workers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/render/make_lightmap.h"
#include "luxel/solution/solution.h"
#include "luxel/surface/given_layout.h"

namespace luxel {

// Where all lit surfaces lie on pages: in charts that are made and packed. After the monitor's stop there is
// none: no charts, no pages. Throws what make_charts() and pack_charts() throw.
LaidOut lay_out(const PatchSet& patches, const Solution& solution, const LightmapOptions& options,
                const Workers& workers, const Monitor& monitor = {});

}  // namespace luxel
