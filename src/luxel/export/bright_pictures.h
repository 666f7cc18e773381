// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/export/round_trip_parts.h"
#include "luxel/export/round_trip_surfaces.h"
#include "luxel/image/tone.h"
#include "luxel/import/gltf_writer.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"

namespace luxel {

// The mean by area, linear sRGB, of the picture that colours a part; 1 where no patch is left of it. The
// material has a picture for reflectance; bands are red, green and blue.
Vec3 mean_of_picture(const PatchSet& patches, const PatchesOfTriangles& of_triangles,
                     const RoundTripPart& part);

// Returns whether the curve's colours are proportional to light, up to a limit: they contain the light.
bool is_proportional(const ToneCurve& curve);

// The channel of a vertex colour, at most 1, for light that needs up to `largest`: as it is up to 0.85, then
// ever flatter, so that no contour shows where light is too bright. As it is everywhere if largest is 1 or
// less.
float soft_limit(float channel, float largest);

// The vertex colour by which a picture of this mean looks like the colour: of the same hue, at most 1 by
// soft_limit() of its largest channel.
Vec3 colour_over_picture(const Vec3& colour, const Vec3& mean);

// Vertex colours are at most 1, so a picture that they multiply is never shown brighter than it is, though
// light may be. So pictures are brightened as far as their brightest pixels allow, where light on a
// thousandth of their area needs it. They stay as they are for curves that are proportional to light.
class BrightPictures {
 public:
  // Keeps a reference to the copy.
  BrightPictures(GltfWriter& copy, const PatchSet& patches, const Solution& solution, const ToneCurve& curve);

  // Factor of the picture's linear colour, per channel, 1 or more.
  Vec3 gain(std::uint32_t texture) const { return gains_[texture]; }
  // Makes the base colour's picture of a material the brighter one, if it is. Materials of the same picture
  // have it in common: PNG, or JPEG where the file has JPEG.
  void put(const std::string& material, std::uint32_t texture);

 private:
  std::size_t add_brighter(const std::string& old, std::uint32_t texture);

  GltfWriter& copy_;
  const std::vector<Texture>& textures_;
  std::vector<Vec3> gains_;                      // [texture]
  std::map<std::uint32_t, std::size_t> copies_;  // [texture]: its brighter one in the copy
};

}  // namespace luxel
