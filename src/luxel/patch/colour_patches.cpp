// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/colour_patches.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "luxel/math/barycentric.h"
#include "luxel/patch/texel_sums.h"
#include "luxel/photometry/colour_spectra.h"

namespace luxel {
namespace {

constexpr float smallest_coverage = 1e-4f;  // a patch of holes alone is next to nothing, but it is a patch
constexpr Vec3 darkest_mean(1e-6f);         // below it a texture is black, and no finer than its patch

template <typename T>
T between(const std::array<T, 3>& corners, const Vec3d& weight) {
  return corners[0] * static_cast<float>(weight[0]) + corners[1] * static_cast<float>(weight[1]) +
         corners[2] * static_cast<float>(weight[2]);
}

// Values at the corners of wholes, at the corners of their parts.
template <typename T, typename PointsOf>
std::vector<std::array<T, 3>> at_parts(const std::vector<std::array<T, 3>>& wholes, const PatchSet& parts,
                                       std::span<const std::uint32_t> whole_of, const PointsOf& points_of) {
  std::vector<std::array<T, 3>> result(parts.size());
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const auto whole = whole_of[p];
    const auto triangle = points_of(whole);
    const auto corners = parts.points(p);
    for (std::size_t k = 0; k < 3; ++k)
      result[p][k] = between(wholes[whole], barycentric(triangle, corners[k]));
  }
  return result;
}

// The sums of each texture as it is used, made once.
class SumsOfUses {
 public:
  explicit SumsOfUses(const PatchSet& patches) : patches_(patches) {}

  // With holes where the same texture lies the same way as the cut-out's.
  TexelSums::Mean mean(std::size_t patch, const TextureUse& use, const MaterialTextures& material) {
    const bool has_holes = material.cutout && *material.cutout == use;
    const auto threshold = has_holes ? std::optional(material.cutout_threshold) : std::nullopt;
    const auto key = std::tuple(use.texture, use.wrap, threshold);
    auto found = sums_.find(key);
    if (found == sums_.end())
      found = sums_.emplace(key, TexelSums(patches_.textures[use.texture].raster, use.wrap, threshold)).first;
    std::array<Vec2, 3> places;
    for (std::size_t k = 0; k < 3; ++k) places[k] = use.place(patches_.uv_sets[use.uv_set][patch][k]);
    return found->second.over(places);
  }

 private:
  const PatchSet& patches_;
  std::map<std::tuple<std::uint32_t, std::array<Wrap, 2>, std::optional<float>>, TexelSums> sums_;
};

// From colours to the patches' bands.
class BandsOfColours {
 public:
  explicit BandsOfColours(const PatchSet& patches) {
    if (!patches.wavebands.empty()) spectra_.emplace(patches.wavebands);
  }
  std::vector<float> reflectance(const Vec3& rgb) const {
    return spectra_ ? spectra_->reflectance(rgb) : std::vector<float>{rgb.r, rgb.g, rgb.b};
  }
  std::vector<float> light(const Vec3& rgb) const {
    return spectra_ ? spectra_->light(rgb) : std::vector<float>{rgb.r, rgb.g, rgb.b};
  }

 private:
  std::optional<ColourSpectra> spectra_;
};

void set_shares(std::vector<float>& shares, std::size_t patch, const std::vector<float>& own,
                const std::vector<float>& of_material) {
  for (std::size_t b = 0; b < own.size(); ++b)
    if (of_material[b] > 0.0f) shares[patch * own.size() + b] = own[b] / of_material[b];
}

Vec3 mean_of(const std::array<Vec3, 3>& corners) { return (corners[0] + corners[1] + corners[2]) / 3.0f; }

void colour_patches(PatchSet& patches) {
  const auto any = [&](const auto& has) {
    return std::any_of(patches.materials.begin(), patches.materials.end(),
                       [&](const BandMaterial& m) { return has(m.textures); });
  };
  const auto values = patches.size() * patches.band_count();
  const auto has_corners = !patches.corner_colours.empty();
  if (has_corners || any([](const auto& t) { return t.reflectance.has_value(); }))
    patches.reflectance_share.assign(values, 1.0f);
  if (any([](const auto& t) { return t.emittance.has_value(); }))
    patches.emittance_share.assign(values, 1.0f);
  SumsOfUses sums(patches);
  const BandsOfColours bands(patches);
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto& material = patches.material_of(p);
    const auto& t = material.textures;
    if (t.cutout) patches.area[p] *= std::max(smallest_coverage, sums.mean(p, *t.cutout, t).covered);
    if (t.reflectance || has_corners) {
      auto colour = t.reflectance_factor;
      if (t.reflectance) colour *= sums.mean(p, *t.reflectance, t).colour;
      if (has_corners) colour *= mean_of(patches.corner_colours[p]);
      set_shares(patches.reflectance_share, p,
                 bands.reflectance(glm::clamp(colour, Vec3(0.0f), Vec3(t.most_reflectance))),
                 material.reflectance);
    }
    if (t.emittance)
      set_shares(patches.emittance_share, p,
                 bands.light(t.emittance_factor * sums.mean(p, *t.emittance, t).colour), material.emittance);
  }
}

}  // namespace

void lay_textures(PatchSet& patches, const Scene& scene) {
  const bool has_textures = std::any_of(scene.materials.begin(), scene.materials.end(),
                                        [](const Material& m) { return m.textures.any(); });
  if (!has_textures && scene.corner_colours.empty()) return;
  const auto points_of = [&](std::uint32_t triangle) {
    const auto& c = scene.triangles[triangle];
    return std::array{scene.positions[c[0]], scene.positions[c[1]], scene.positions[c[2]]};
  };
  if (has_textures) {
    patches.textures = scene.textures;
    for (const auto& set : scene.uv_sets)
      patches.uv_sets.push_back(at_parts(set, patches, patches.triangle, points_of));
  }
  if (!scene.corner_colours.empty())
    patches.corner_colours = at_parts(scene.corner_colours, patches, patches.triangle, points_of);
  colour_patches(patches);
}

void inherit_textures(PatchSet& parts, const PatchSet& whole, std::span<const std::uint32_t> parent) {
  if (whole.uv_sets.empty() && whole.corner_colours.empty()) return;
  const auto points_of = [&](std::uint32_t patch) { return whole.points(patch); };
  parts.textures = whole.textures;
  for (const auto& set : whole.uv_sets) parts.uv_sets.push_back(at_parts(set, parts, parent, points_of));
  if (!whole.corner_colours.empty())
    parts.corner_colours = at_parts(whole.corner_colours, parts, parent, points_of);
  colour_patches(parts);
}

FineColours::FineColours(const PatchSet& patches) : patches_(patches) {
  SumsOfUses sums(patches);
  const auto fill = [&](std::vector<Vec3>& means, const auto& use_of) {
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const auto& textures = patches.material_of(p).textures;
      if (!use_of(textures)) continue;
      if (means.empty()) means.assign(patches.size(), Vec3(0.0f));
      means[p] = sums.mean(p, *use_of(textures), textures).colour;
    }
  };
  fill(reflectance_mean_, [](const MaterialTextures& t) { return t.reflectance; });
  fill(emittance_mean_, [](const MaterialTextures& t) { return t.emittance; });
}

Vec3 FineColours::reflectance(std::size_t patch, float u, float v) const {
  if (reflectance_mean_.empty()) return Vec3(1.0f);
  return at(patches_.material_of(patch).textures.reflectance, reflectance_mean_, patch, u, v);
}

Vec3 FineColours::emittance(std::size_t patch, float u, float v) const {
  if (emittance_mean_.empty()) return Vec3(1.0f);
  return at(patches_.material_of(patch).textures.emittance, emittance_mean_, patch, u, v);
}

Vec3 FineColours::at(const std::optional<TextureUse>& use, const std::vector<Vec3>& mean, std::size_t patch,
                     float u, float v) const {
  if (!use) return Vec3(1.0f);
  const auto& uv = patches_.uv_sets[use->uv_set][patch];
  const auto place = use->place((1.0f - u - v) * uv[0] + u * uv[1] + v * uv[2]);
  const auto colour = colour_at(*patches_.textures[use->texture].raster, *use, place);
  Vec3 ratio(1.0f);
  for (int c = 0; c < 3; ++c)
    if (mean[patch][c] > darkest_mean[c]) ratio[c] = colour[c] / mean[patch][c];
  return ratio;
}

}  // namespace luxel
