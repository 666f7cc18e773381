// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/image/raster.h"

namespace luxel {

/// A picture that colours surfaces.
struct Texture {
  std::string name;  ///< as the file has it, for people
  std::shared_ptr<const Raster> raster;
};

/// Continuation of a picture beyond its border.
enum class Wrap : std::uint8_t { repeat, mirror, clamp };

/// Texture coordinates of the corners of triangles, before TextureUse::placement.
using UvSet = std::vector<std::array<Vec2, 3>>;  ///< [triangle][corner]; finite

/// Placement of a texture on a surface. A place on the picture is (x, y), x from 0 at its left border to 1 at
/// its right, y from 0 at its top to 1 at its bottom: glTF's convention; OBJ's v counts from the bottom.
struct TextureUse {
  std::uint32_t texture = 0;  ///< index into the scene's textures
  std::uint32_t uv_set = 0;   ///< index into the scene's sets
  /// x = p[0] u + p[1] v + p[2], y = p[3] u + p[4] v + p[5]
  std::array<float, 6> placement = {1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f};
  std::array<Wrap, 2> wrap = {Wrap::repeat, Wrap::repeat};  ///< of x and of y

  Vec2 place(const Vec2& uv) const {
    const auto& p = placement;
    return {p[0] * uv.x + p[1] * uv.y + p[2], p[3] * uv.x + p[4] * uv.y + p[5]};
  }
  bool operator==(const TextureUse&) const = default;
};

/// Textures of a material.
struct MaterialTextures {
  /// Reflectance of the surface, and its emittance, W/m² per band: the texture's linear colour times the
  /// factor.
  std::optional<TextureUse> reflectance = {}, emittance = {};
  Vec3 reflectance_factor = Vec3(1.0f), emittance_factor = Vec3(1.0f);
  float max_reflectance = 0.98f;  ///< of the mean over a patch; higher means are lowered to it

  /// Holes: where this texture's alpha is below the threshold there is no surface, for light and eyes.
  std::optional<TextureUse> cutout = {};
  float cutout_threshold = 0.5f;  ///< [0, 1]

  bool any() const { return reflectance || emittance || cutout; }
};

/// The pixel of a column or a row counted without end, of `count` there are.
std::int64_t wrapped(std::int64_t pixel, std::int64_t count, Wrap wrap);

/// Returns the pixel that covers a place on the picture (no interpolation); a place not finite counts as 0.
std::size_t pixel_at(const Raster& raster, const TextureUse& use, const Vec2& place);

/// Colour between the middles of the four nearest pixels (bilinear), linear sRGB.
Vec3 colour_at(const Raster& raster, const TextureUse& use, const Vec2& place);

}  // namespace luxel
