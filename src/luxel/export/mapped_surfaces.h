// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/export/kept_surfaces.h"
#include "luxel/lightmap/pack_charts.h"

namespace luxel {

// The file's own triangles where a chart has the whole of one, else patches; a surface for each page.
std::vector<KeptSurface> mapped_surfaces(const KeptScene& kept, const KeptPart& part, const Atlas& atlas);

}  // namespace luxel
