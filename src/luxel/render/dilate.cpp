// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/dilate.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace luxel {
namespace {

struct Filling {
  std::size_t texel;
  Vec3 irradiance, standard_error;
  std::array<Vec3, 3> light_vector;
};

// The mean of the lit texels around (x, y); returns their number.
int mean_around(const LightmapPage& page, int x, int y, Filling& filling) {
  const auto width = page.irradiance.width, height = page.irradiance.height;
  Vec3 irradiance(0.0f), standard_error(0.0f);
  filling.light_vector.fill(Vec3(0.0f));
  int lit = 0;
  for (auto j = std::max(0, y - 1); j <= std::min(height - 1, y + 1); ++j)
    for (auto i = std::max(0, x - 1); i <= std::min(width - 1, x + 1); ++i) {
      const auto texel = static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + i;
      if (page.texels[texel] == Texel::empty) continue;
      irradiance += page.irradiance.pixels[texel];
      standard_error += page.standard_error.pixels[texel];
      for (std::size_t axis = 0; axis < page.light_vector.size(); ++axis)
        filling.light_vector[axis] += page.light_vector[axis].pixels[texel];
      ++lit;
    }
  const auto fraction = 1.0f / static_cast<float>(std::max(1, lit));
  filling.irradiance = fraction * irradiance;
  filling.standard_error = fraction * standard_error;
  for (auto& of_axis : filling.light_vector) of_axis *= fraction;
  return lit;
}

// Fills one ring of texels; returns whether there were any to fill.
bool add_ring(LightmapPage& page) {
  std::vector<Filling> ring;
  Filling filling{};
  for (int y = 0; y < page.irradiance.height; ++y)
    for (int x = 0; x < page.irradiance.width; ++x) {
      filling.texel = static_cast<std::size_t>(y) * static_cast<std::size_t>(page.irradiance.width) + x;
      if (page.texels[filling.texel] == Texel::empty && mean_around(page, x, y, filling) > 0)
        ring.push_back(filling);
    }
  for (const auto& f : ring) {
    page.irradiance.pixels[f.texel] = f.irradiance;
    page.standard_error.pixels[f.texel] = f.standard_error;
    for (std::size_t axis = 0; axis < page.light_vector.size(); ++axis)
      page.light_vector[axis].pixels[f.texel] = f.light_vector[axis];
    page.texels[f.texel] = Texel::dilated;
  }
  return !ring.empty();
}

}  // namespace

bool dilate(Lightmap& lightmap, int rings, const Context& context) {
  auto& pages = lightmap.pages;
  for (std::size_t p = 0; p < pages.size(); ++p)
    for (int ring = 0; ring < rings; ++ring) {
      const auto done = static_cast<double>(p) / static_cast<double>(pages.size());
      if (context.report({"margins", done}) == Next::stop) return false;
      if (!add_ring(pages[p])) break;
    }
  return true;
}

}  // namespace luxel
