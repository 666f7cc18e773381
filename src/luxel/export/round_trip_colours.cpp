// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/round_trip_colours.h"

#include <optional>
#include <span>

#include "luxel/core/none.h"
#include "luxel/export/round_trip_attribute.h"
#include "luxel/import/gltf_array.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {
namespace {

// The vertex colours of the file at vertex `v` of a surface, which may lie inside a triangle of the file.
Vec3 tint_at(const RoundTripAttribute& tints, const RoundTripSurface& surface, std::size_t v) {
  const auto count = surface.own.size();
  const auto tint = v < count ? tints.at(surface.own[v]) : tints.between(surface.added[v - count]);
  return Vec3(Vec3d(tint[0], tint[1], tint[2]));
}

}  // namespace

VertexColours vertex_colours(GltfFile& file, const RoundTripPart& part, const RoundTripSurface& surface,
                             const SurfaceColour& colour, const SideValues& light,
                             const BandColours& colours) {
  const auto bands = colours.bands();
  std::optional<GltfArray> tints;
  if (const auto own = part.drawn.primitive["attributes"]["COLOR_0"]) tints.emplace(file, own, 3, 4);
  VertexColours vertices;
  for (std::size_t v = 0; v < surface.light.size(); ++v) {
    if (surface.light[v] == none) {
      vertices.radiance.emplace_back(0.0f);
      vertices.irradiance.emplace_back(0.0f);
      continue;
    }
    const auto* here = &light.of(surface.back)[surface.light[v] * bands];
    const SeenIrradiance seen{here, &light.of(!surface.back)[surface.light[v] * bands]};
    const TextureRatio ratio{
        .fine_reflectance =
            colour.picture *
            (tints ? tint_at({*tints, part, RoundTripAttribute::Kind::other}, surface, v) : Vec3(1.0f))};
    vertices.radiance.push_back(in_gamut(radiance_of(colour.material, surface.back, seen, colours, ratio)));
    vertices.irradiance.push_back(Vec3(colours.rgb(std::span(here, bands))));
  }
  return vertices;
}

}  // namespace luxel
