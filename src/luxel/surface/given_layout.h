// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "luxel/core/workers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/scene.h"
#include "luxel/scene/texture.h"
#include "luxel/surface/make_charts.h"
#include "luxel/surface/pack_charts.h"

namespace luxel {

// Where a scene itself says that its surfaces lie on the pages of a lightmap.
struct GivenLayout {
  UvSet uvs;                        // [triangle of the scene]: from the top left of its page, [0, 1]
  std::vector<std::uint32_t> page;  // [triangle of the scene]
  std::uint32_t pages = 1;
};

// Whether texels are claimed by triangles of two places: of pages of so many texels per side, judged by the
// middles of texels, where more than a thousandth of those taken are. Triangles without patches do not count.
bool overlaps(const Scene& scene, const PatchSet& patches, const GivenLayout& given, int page_size);

// The pages as charts: of fronts alone, a page one chart, so that each texel is of the nearest surface; edges
// where light runs on but the layout does not are seams. page_size: texels. Throws MismatchError where the
// patches are not cut from the scene or the layout is not of its triangles.
struct LaidOut {
  Charts charts;
  Atlas atlas;
};
LaidOut lay_out(const Scene& scene, const PatchSet& patches, const GivenLayout& given, float crease_angle,
                int page_size, int margin, const Workers& workers);

// The smallest power of two, at most `most`, at which the triangles of each page have so many texels per
// metre in the mean over their area.
int page_size_for(const Scene& scene, const GivenLayout& given, double texels_per_metre, int most);

}  // namespace luxel
