// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/core/none.h"
#include "luxel/core/vector.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/surface/atlas.h"
#include "luxel/surface/make_charts.h"

namespace luxel {

// Maximum number of texels of all pages together: some 40 bytes each.
inline constexpr double max_texels_of_pages = 0x1p28;

struct PackOptions {
  float texel = 0.05f;   // m
  int page_size = 1024;  // texels, the most a page is wide and high; 8 to 16384
  int margin = 2;        // texels between charts, and at the edge of a page; 0 to 64
};

// Packs charts on pages. Every chart gets the whole texels its box needs and is stretched to fill them, from
// the middle of the first to that of the last. Interpolation between texels therefore stays within the
// chart's own texels, and straight borders lie on texel centres. The distance between two texels is at most
// `texel`. The page is the smallest power of two that holds all charts, or page_size and as many of these as
// needed.
//
// Throws the errors of check_pack_options(), with the margins counted too, and InputError where a chart fits
// on no page.
Atlas pack_charts(const PatchSet& patches, const Charts& charts, const PackOptions& options);

// Throws InputError where an option is out of its range, or the patches need more than 268 million texels.
void check_pack_options(const PatchSet& patches, const PackOptions& options);

// Texels that a chart may be wide so that it fits on a page, as in ChartOptions.
inline int max_texels(const PackOptions& options) { return options.page_size - 2 * options.margin - 1; }

}  // namespace luxel
