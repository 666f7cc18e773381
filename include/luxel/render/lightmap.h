// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/image/image.h"
#include "luxel/surface/atlas.h"

namespace luxel {

struct PatchSet;

/// What a texel is to its chart.
enum class Texel : std::uint8_t {
  empty,   ///< nothing
  inside,  ///< its middle lies on it
  beside,  ///< its middle does not, but it is read where the chart is looked up between texels
  dilated  ///< it is neither; it took its light from its neighbours
};

struct LightmapPage {
  Image irradiance;      ///< W/m² by linear sRGB; of the side that faces the reader
  Image standard_error;  ///< of it, likewise; 0 where the solution knows none
  /// Of a directional lightmap: the light vector (Gershun 1939), the integral of radiance times direction
  /// over what the texel sees, W/m², its x, y and z in the scene's axes; else empty. A surface whose normal n
  /// is bent from the side's own gets (irradiance + n . vector) / 2, to the first order of spherical
  /// harmonics, and exactly the irradiance where it is not.
  std::vector<Image> light_vector;
  std::vector<Texel> texels;  ///< width * height, row by row from the top left
};

/// Light on pages, and where each patch corner looks it up. What a surface sends back to the eye is
/// reflectance / pi times the irradiance, and a lamp's own light on top.
struct Lightmap {
  Atlas atlas;
  std::vector<LightmapPage> pages;  ///< each atlas.page_size wide and high
};

/// Throws MismatchError where the lightmap is of other patches.
void check_is_of(const PatchSet& patches, const Lightmap& lightmap);

/// The irradiance that a reader sees: between the middles of texels it runs bilinearly. at: texels, from the
/// top left of the page. Beyond the page's edge its last texels go on.
Vec3 look_up(const Image& page, const Vec2& at);

}  // namespace luxel
