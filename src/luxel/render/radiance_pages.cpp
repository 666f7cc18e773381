// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/radiance_pages.h"

#include <algorithm>
#include <cstddef>

#include "luxel/patch/colour_patches.h"
#include "luxel/render/dilate.h"
#include "luxel/render/texel_places.h"
#include "luxel/scene/band_colours.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {
namespace {

constexpr std::size_t texels_per_chunk = 1024;

}  // namespace

std::vector<Image> radiance_pages(const PatchSet& patches, const Lightmap& lightmap, const Context& context) {
  check_is_of(patches, lightmap);
  const auto places = find_texel_places(lightmap.atlas, {}, context);
  if (places.empty()) return {};
  const FineColours fine(patches, context);
  const auto colours = patches.colours();
  auto shining = lightmap;
  for (std::size_t p = 0; p < shining.pages.size(); ++p) {
    const auto done = static_cast<double>(p) / static_cast<double>(shining.pages.size());
    if (context.report({"colours", done}) == Next::stop) return {};
    auto& page = shining.pages[p];
    context.for_chunks(places[p].size(), texels_per_chunk, [&](std::size_t begin, std::size_t end, int) {
      for (auto i = begin; i < end; ++i) {
        const auto& place = places[p][i];
        page.texels[i] = place.kind;  // dilated texels are dilated again
        if (place.kind == Texel::empty) continue;
        const auto patch = place.side.patch();
        const auto fraction = texture_ratio_at(patches, fine, patch, place.weights.x, place.weights.y);
        auto& pixel = page.irradiance.pixels[i];
        const auto light = pixel;
        pixel = in_gamut(radiance_of(patches.material_of(patch), place.side.is_back(), {&light.x, &light.x},
                                     colours, fraction));
      }
    });
  }
  if (!dilate(shining, std::max(lightmap.atlas.margin, 1), context)) return {};
  return irradiance_pages(shining);
}

float white_of(const std::vector<Image>& pages) {
  std::vector<float> values;
  for (const auto& page : pages)
    for (const auto& p : page.pixels)
      if (const auto most = std::max({p.r, p.g, p.b}); most > 0.0f) values.push_back(most);
  if (values.empty()) return 1.0f;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() - 1 - values.size() / 1000);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

std::vector<Image> irradiance_pages(const Lightmap& lightmap) {
  std::vector<Image> pages;
  for (const auto& page : lightmap.pages) pages.push_back(page.irradiance);
  return pages;
}

}  // namespace luxel
