// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "luxel/image/image.h"
#include "luxel/surface/atlas.h"

namespace luxel {

struct PatchSet;

/// Relation of a texel to its chart.
enum class Texel : std::uint8_t {
  empty,   ///< nothing
  inside,  ///< its middle lies on it
  beside,  ///< its middle does not, but it is read where the chart is looked up between texels
  dilated  ///< it is neither; it took its light from its neighbours
};

struct LightmapPage {
  Image irradiance;      ///< W/m² by linear sRGB; of the side that faces the reader
  Image standard_error;  ///< of the irradiance, W/m²; 0 where the solution has none
  /// Light vector of a directional lightmap (Gershun 1939), the integral of radiance times direction over the
  /// visible hemisphere, W/m², x, y and z in the scene's axes; else empty. A surface whose normal n is bent
  /// from the side's own gets (irradiance + n . vector) / 2, to the first order of spherical harmonics, and
  /// exactly the irradiance where n is the side's own.
  std::vector<Image> light_vector;
  std::vector<Texel> texels;  ///< width * height, row by row from the top left
};

/// Light on pages, and where each patch corner looks it up. The radiance of a surface is reflectance / pi
/// times the irradiance, plus the emission of a lamp.
struct Lightmap {
  Atlas atlas;
  std::vector<LightmapPage> pages;  ///< each atlas.page_size wide and high
};

/// Throws MismatchError where the lightmap is of other patches.
void check_is_of(const PatchSet& patches, const Lightmap& lightmap);

/// Returns the irradiance at a place, interpolated bilinearly between the centres of texels. at: texels, from
/// the top left of the page. Beyond the page's edge its last texels continue.
Vec3 look_up(const Image& page, const Vec2& at);

struct TexelOptions {
  double error = 0.02;            ///< target relative standard error of a texel; 0: no final gather
  std::uint32_t max_rays = 4096;  ///< cosine rays per texel, and as many to lamps; 64 and more
  bool directional = false;       ///< the light vector too, and so all texels by final gather
  double dark = 0.1;              ///< of the mean light: below, the error is of this much
  std::uint64_t seed = 1;
};

struct LightmapOptions {
  std::optional<double> texels_per_metre = {};  ///< nothing: as many as cover 131,000 texels, or 40 per chart
  int page_size = 1024;                         ///< texels, the most a page is wide and high
  int margin = 2;                               ///< texels between charts; filled from both sides
  float crease_angle = 30.0f;                   ///< degrees, as in SmoothOptions
  TexelOptions texels = {};
};

/// Report of the gathering of texels.
struct TexelReport {
  std::uint64_t texels = 0;       ///< with light of their own
  std::uint64_t gathered = 0;     ///< of them, by final gather
  std::uint64_t short_of_it = 0;  ///< of these, with max_rays and still a larger error than requested
  std::uint64_t rays = 0;         ///< traced
  /// Stopped by the monitor in the stage "texels": the remaining texels hold the interpolated light.
  bool stopped = false;
};

/// Report of the solution of seams.
struct SeamReport {
  std::size_t places = 0;                                  ///< along seams where two charts are compared
  double difference_before = 0.0, difference_after = 0.0;  ///< relative, root mean square over the places
  int steps = 0;                                           ///< of conjugate gradients, the most of a colour
  bool stopped = false;                                    ///< by the monitor: not all texels are changed
};

struct LightmapReport {
  std::size_t charts = 0;
  TexelReport texels;
  SeamReport seams;
};

}  // namespace luxel
