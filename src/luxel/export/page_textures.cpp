// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/page_textures.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "luxel/image/codec.h"
#include "luxel/image/raster.h"

namespace luxel {
namespace {

constexpr int max_pixels = 1024, min_pixels = 64;  // per side
constexpr double farthest = 2e9;                   // place on a picture, in parts: within 32 bits
constexpr int jpeg_quality = 85;                   // no blocks are visible at it; half the size of 95

float brightest(const Raster& raster) {
  float most = 1.0f;
  for (const auto& colour : raster.linear) most = std::max({most, colour.r, colour.g, colour.b});
  return most;
}

// Codes of the raster over its brightest value, reduced by a whole factor so that no side is longer than
// `side`: means of rectangles of pixels, of linear light.
Raster reduced(const Raster& raster, int side, bool is_mask) {
  const auto factor = std::max(1, (std::max(raster.width, raster.height) + side - 1) / side);
  Raster small{std::max(1, raster.width / factor), std::max(1, raster.height / factor), {}, {}};
  const auto scale = 1.0f / brightest(raster);
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x) {
      const auto left = x * raster.width / small.width, right = (x + 1) * raster.width / small.width;
      const auto top = y * raster.height / small.height, bottom = (y + 1) * raster.height / small.height;
      Vec3 sum(0.0f);
      float alpha = 0.0f;
      for (int v = top; v < bottom; ++v)
        for (int u = left; u < right; ++u) {
          sum += raster.colour(raster.index(u, v));
          alpha += raster.alpha(raster.index(u, v));
        }
      const auto count = static_cast<float>((right - left) * (bottom - top));
      const auto grey = static_cast<std::uint8_t>(std::lround(255.0f * alpha / count));
      const auto code = [&](float c) { return is_mask ? grey : srgb_code(scale * c / count); };
      small.codes.push_back({code(sum.r), code(sum.g), code(sum.b), 255});
    }
  return small;
}

// The smaller of the two; a mask keeps its edges.
std::string encoded(const Raster& raster, bool is_mask) {
  auto png = encode_png(raster);
  if (is_mask) return png;
  auto jpeg = encode_jpeg(raster, jpeg_quality);
  return png.size() <= jpeg.size() ? png : jpeg;
}

std::string_view word(Wrap wrap) {
  switch (wrap) {
    case Wrap::mirror:
      return "mirror";
    case Wrap::clamp:
      return "clamp";
    default:
      return "repeat";
  }
}

}  // namespace

PageTextures::PageTextures(const PatchSet& patches, std::size_t max_bytes)
    : patches_(patches), materials_(patches.materials.size()) {
  std::vector<bool> is_used(patches.materials.size(), false);
  for (const auto m : patches.material) is_used[static_cast<std::size_t>(m)] = true;
  for (std::size_t m = 0; m < is_used.size(); ++m) {
    if (!is_used[m]) continue;
    const auto& textures = patches.materials[m].textures;
    auto& material = materials_[m];
    material.reflectance = use_of(textures.reflectance, false, material);
    material.emittance = use_of(textures.emittance, false, material);
    material.cutout = use_of(textures.cutout, true, material);
  }
  for (int side = max_pixels;; side /= 2) {
    pictures_.clear();
    std::size_t bytes = 0;
    for (const auto& source : sources_) {
      pictures_.push_back(
          encoded(reduced(*patches.textures[source.texture].raster, side, source.is_mask), source.is_mask));
      bytes += pictures_.back().size();
    }
    if (bytes <= max_bytes || side <= min_pixels) return;
  }
}

std::optional<PageTextures::Use> PageTextures::use_of(const std::optional<TextureUse>& use, bool is_mask,
                                                      OfMaterial& material) {
  if (!use) return std::nullopt;
  const auto has = [&](const Source& s) { return s.texture == use->texture && s.is_mask == is_mask; };
  const auto picture = std::find_if(sources_.begin(), sources_.end(), has);
  const auto number = static_cast<std::size_t>(picture - sources_.begin());
  if (picture == sources_.end()) sources_.push_back({use->texture, is_mask});
  const auto lies_alike = [&](const TextureUse& s) {
    return s.uv_set == use->uv_set && s.placement == use->placement;
  };
  const auto placement = std::find_if(material.placements.begin(), material.placements.end(), lies_alike);
  const auto place = static_cast<std::size_t>(placement - material.placements.begin());
  if (placement == material.placements.end()) material.placements.push_back(*use);
  return Use{number, place, use->wrap, is_mask ? 1.0f : brightest(*patches_.textures[use->texture].raster)};
}

std::size_t PageTextures::uv_sets() const {
  std::size_t most = 0;
  for (const auto& m : materials_) most = std::max(most, m.placements.size());
  return most;
}

PagePlaces PageTextures::places(std::size_t patch, const Vec3& weight) const {
  PagePlaces places{};
  const auto& placements = materials_[static_cast<std::size_t>(patches_.material[patch])].placements;
  for (std::size_t s = 0; s < placements.size(); ++s) {
    const auto& uv = patches_.uv_sets[placements[s].uv_set][patch];
    const auto place = placements[s].place(weight[0] * uv[0] + weight[1] * uv[1] + weight[2] * uv[2]);
    for (std::size_t i = 0; i < 2; ++i) {
      const auto parts = static_cast<double>(place[static_cast<int>(i)]) * page_place_parts;
      places[s][i] = static_cast<std::int32_t>(std::lround(std::clamp(parts, -farthest, farthest)));
    }
  }
  return places;
}

Json PageTextures::description(std::size_t material) const {
  Json json = Json::object();
  const auto& m = materials_[material];
  const auto add = [&](const char* name, const std::optional<Use>& use) {
    if (use)
      json[name] = {{"picture", use->picture},
                    {"set", use->uv_set},
                    {"wrap", {word(use->wrap[0]), word(use->wrap[1])}},
                    {"scale", use->scale}};
  };
  add("reflectance", m.reflectance);
  add("emittance", m.emittance);
  add("cutout", m.cutout);
  if (m.cutout) json["cutout"]["threshold"] = patches_.materials[material].textures.cutout_threshold;
  return json;
}

}  // namespace luxel
