// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/scene.h"
#include "luxel/scene/texture.h"
#include "luxel/surface/make_charts.h"
#include "luxel/surface/pack_charts.h"

namespace luxel {

// The layout of surfaces on the pages of a lightmap that a scene's own texture coordinates define.
struct GivenLayout {
  UvSet uvs;                        // [triangle of the scene]: from the top left of its page, [0, 1]
  std::vector<std::uint32_t> page;  // [triangle of the scene]
  std::uint32_t pages = 1;
};

// Returns whether triangles of two places overlap in texels: at the given number of texels per side of a
// page, tested at the centres of texels, true where more than a thousandth of the covered ones overlap.
// Triangles without patches do not count.
bool overlaps(const Scene& scene, const PatchSet& patches, const GivenLayout& given, int page_size);

// The pages as charts: of fronts alone, a page one chart, so that each texel is of the nearest surface; edges
// where light runs on but the layout does not are seams. Throws MismatchError where the
// patches are not cut from the scene or the layout is not of its triangles.
struct LaidOut {
  Charts charts;
  Atlas atlas;
};
struct GivenPageOptions {
  float crease_angle = 30.0f;  // degrees, of SmoothOptions
  int page_size = 1024;        // texels
  int margin = 2;              // texels
};
LaidOut lay_out(const Scene& scene, const PatchSet& patches, const GivenLayout& given,
                const GivenPageOptions& options, const Context& context);

// Returns the smallest power of two, at most `most`, at which the triangles of each page have the required
// texels per metre in the mean over their area.
int page_size_for(const Scene& scene, const GivenLayout& given, double texels_per_metre, int most);

}  // namespace luxel
