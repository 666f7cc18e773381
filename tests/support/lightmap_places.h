// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/image/image.h"
#include "luxel/render/texel_places.h"
#include "luxel/surface/make_charts.h"
#include "luxel/surface/pack_charts.h"

namespace luxel::test {

// New charts of the patches, packed.
inline Atlas new_atlas(const PatchSet& patches, const Solution& solution, const PackOptions& pack) {
  const auto charts =
      make_charts(patches, solution, {.texel = pack.texel, .max_texels = max_texels(pack)}, Context(2));
  return pack_charts(patches, charts, pack);
}

// Pages whose texels hold the place that they are of, so that what is looked up at a corner is known.
inline std::vector<Image> pages_of_places(const PatchSet& patches, const Atlas& atlas) {
  std::vector<Image> pages;
  for (const auto& of_page : find_texel_places(atlas, {}, Context(2))) {
    auto& page = pages.emplace_back(atlas.page_size, atlas.page_size);
    for (std::size_t i = 0; i < of_page.size(); ++i) {
      if (of_page[i].kind == Texel::empty) continue;
      const auto p = patches.points(of_page[i].side.patch());
      const auto& w = of_page[i].weights;
      page.pixels[i] = p[0] + w.x * (p[1] - p[0]) + w.y * (p[2] - p[0]);
    }
  }
  return pages;
}

}  // namespace luxel::test
