// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/scene/scene.h"

namespace luxel {

// Lays the scene's textures and the colours of its corners on patches that were cut from its triangles
// (PatchSet::triangle), and colours them. Nothing is done where the scene has neither. With plain_reflectance
// they set emittance and holes only. Cost: that of a mean per patch and texture (TexelSums). The same bits
// for any number of threads.
void lay_textures(PatchSet& patches, const Scene& scene, bool plain_reflectance, const Context& context);

// Does the same for patches that are parts of others, given by `parent`. Their areas are still those of the
// whole triangles. Means are computed for parts only, not for patches that remained whole.
void inherit_textures(PatchSet& parts, const PatchSet& whole, std::span<const std::uint32_t> parent,
                      const Context& context);

// Texture detail within patches: colours of points over the mean of the patch, so that pictures show more
// than patches. Immutable once made; memory 24 bytes per patch where there are textures, else none.
class FineColours {
 public:
  // Keeps a reference to the patches. Cost: that of lay_textures().
  FineColours(const PatchSet& patches, const Context& context);

  // Linear sRGB factor of reflectance and emittance at (1-u-v) a + u b + v c. 1 without textures.
  Vec3 reflectance(std::size_t patch, float u, float v) const;
  Vec3 emittance(std::size_t patch, float u, float v) const;

  // Linear sRGB: the means of the textures over a patch. Where there is no texture, or a channel is black: 1.
  Vec3 mean_reflectance(std::size_t patch) const;
  Vec3 mean_emittance(std::size_t patch) const;

 private:
  Vec3 at(const std::optional<TextureUse>& use, const std::vector<Vec3>& mean, std::size_t patch, float u,
          float v) const;

  const PatchSet& patches_;
  std::vector<Vec3> reflectance_mean_, emittance_mean_;  // [patch], of the texture; empty where there is none
};

}  // namespace luxel
