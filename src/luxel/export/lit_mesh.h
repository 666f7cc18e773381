// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/image/tone.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/band_colours.h"
#include "luxel/solution/solution.h"
#include "luxel/surface/smooth_light.h"
#include "luxel/surface/vertex_texture_ratios.h"

namespace luxel {

// The triangles of one side of one material, with separate vertices, as both file formats write them.
struct LitPart {
  std::size_t material = 0;                             // index into PatchSet::materials
  bool back = false;                                    // triangles are wound, normals turned, to face there
  std::vector<std::uint32_t> smooth;                    // [vertex]: index into SmoothLight
  std::vector<std::array<std::uint32_t, 3>> triangles;  // indices into smooth
  VertexTextureRatios ratios;                           // of the vertices
};

// The attributes of a vertex of a part.
struct LitVertex {
  Vec3 position;    // m, counted from the patches' origin
  Vec3 normal;      // unit
  Vec3 colour;      // linear, display-referred, [0, 1]
  Vec3 irradiance;  // W/m² by linear sRGB, of the side shown
};

// Returns one curve for a whole mesh, from all sides that emit or reflect light.
ToneCurve curve_for(const PatchSet& patches, const Solution& solution, const ToneOptions& tone);

// The mesh with its light, and the tone curve that makes the light visible.
class LitMesh {
 public:
  // Throws MismatchError where the three are not of one scene, or the bands have no colour.
  LitMesh(const PatchSet& patches, const Solution& solution, const SmoothLight& light,
          const ToneOptions& tone);

  // By material, front before back; none without triangles. Every front is in one; a back only where light
  // fell on it.
  const std::vector<LitPart>& parts() const { return parts_; }
  LitVertex vertex(const LitPart& part, std::size_t i) const;
  // The tone mapping from radiance to the colours.
  const ToneCurve& curve() const { return curve_; }

 private:
  const PatchSet& patches_;
  const SmoothLight& light_;
  BandColours colours_;
  ToneCurve curve_;
  std::vector<LitPart> parts_;
};

}  // namespace luxel
