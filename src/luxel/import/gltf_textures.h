// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/import/gltf_file.h"
#include "luxel/import/texel_budget.h"
#include "luxel/scene/texture.h"

namespace luxel {

// The pictures of a glTF file that materials use, each decoded once, and their placement on surfaces.
class GltfTextures {
 public:
  // A picture where a material names one. Its texture lacks where it cannot be had.
  struct Picture {
    std::optional<std::uint32_t> texture;
    TextureUse use;  // but for its uv_set
  };

  explicit GltfTextures(GltfFile& file) : file_(file) {}

  // info: a textureInfo, with KHR_texture_transform or without. Unsupported textures are collected for one
  // warning. Throws InputError where an index is out of range.
  Picture picture(const JsonValue& info);

  const Raster& raster(std::uint32_t texture) const { return *textures_[texture].raster; }

  // A texture with the colours of `base` (white where there is none), lowered to max_metal_reflectance where
  // they are of metal: by factor times the blue of `metal`.
  std::uint32_t with_metal(std::optional<std::uint32_t> base, std::uint32_t metal, float factor);

  const std::vector<Texture>& textures() const { return textures_; }

  void say_warnings(const Context& context) const;

 private:
  std::optional<std::uint32_t> decoded(const JsonValue& texture);

  GltfFile& file_;
  std::vector<Texture> textures_;
  TexelBudget budget_;
  std::map<std::size_t, std::optional<std::uint32_t>> images_;  // those that were requested
  std::map<std::tuple<std::int64_t, std::uint32_t, float>, std::uint32_t> with_metal_;
  std::size_t unreadable_ = 0;
  std::string first_reason_;
  std::vector<Hint> first_hints_;
};

}  // namespace luxel
