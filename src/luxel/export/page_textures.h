// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "luxel/core/json.h"
#include "luxel/core/vector.h"
#include "luxel/patch/patch_set.h"

namespace luxel {

inline constexpr std::size_t page_uv_sets = 3;  // sets of texture coordinates of a vertex

// Place of a vertex on the pictures of its material, [set][x, y]: TextureUse::place(), in these parts of a
// picture's side. A sixteenth of a pixel of the largest pictures.
inline constexpr int page_place_parts = 16384;
using PagePlaces = std::array<std::array<std::int32_t, 2>, page_uv_sets>;

// Maximum bytes of all pictures of a page together; larger pictures are reduced until they fit.
inline constexpr std::size_t page_picture_bytes = std::size_t{2} << 20;

// The textures of a page: pictures as files, and how materials use them.
class PageTextures {
 public:
  // Keeps a reference. Pictures that no patch shows are left out; the others are reduced to at most 1024
  // pixels per side, and further where all of them have more than `max_bytes`.
  explicit PageTextures(const PatchSet& patches, std::size_t max_bytes = page_picture_bytes);

  // A texture of a material.
  struct Use {
    std::size_t picture = 0, uv_set = 0;
    std::array<Wrap, 2> wrap{};
    float scale = 1.0f;  // of a picture whose values are above 1
  };
  struct OfMaterial {
    std::optional<Use> reflectance, emittance, cutout;
    std::vector<TextureUse> placements;  // one for each placement
  };

  const std::vector<std::string>& pictures() const { return pictures_; }  // files, JPEG or PNG
  const OfMaterial& of(std::size_t material) const { return materials_[material]; }
  std::size_t uv_sets() const;  // of the material that has most
  // Places of a point of the patch on its pictures. weight: of the patch's corners.
  PagePlaces places(std::size_t patch, const Vec3& weight) const;
  // {"reflectance":{"picture":...,"set":...,"wrap":[...],"scale":...},...} as the page reads it.
  Json description(std::size_t material) const;

 private:
  struct Source {
    std::uint32_t texture = 0;
    bool is_mask = false;  // its alpha, as grey
  };
  std::optional<Use> use_of(const std::optional<TextureUse>& use, bool is_mask, OfMaterial& material);

  const PatchSet& patches_;
  std::vector<Source> sources_;        // [picture]
  std::vector<std::string> pictures_;  // [picture]
  std::vector<OfMaterial> materials_;  // [material]
};

}  // namespace luxel
