// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/colour_patches.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <numeric>
#include <tuple>

#include "luxel/core/barycentric.h"
#include "luxel/patch/texel_sums.h"
#include "luxel/scene/colour_spectra.h"

namespace luxel {
namespace {

constexpr std::size_t patches_grain = 1024;  // patches per chunk of a thread
constexpr float smallest_coverage =
    1e-4f;  // a patch that is only holes has almost no area, but stays a patch
constexpr Vec3 darkest_mean(
    1e-6f);  // a texture whose mean is darker counts as black, and constant over the patch

template <typename T>
T between(const std::array<T, 3>& corners, const Vec3d& weight) {
  return corners[0] * static_cast<float>(weight[0]) + corners[1] * static_cast<float>(weight[1]) +
         corners[2] * static_cast<float>(weight[2]);
}

// Interpolates values at the corners of wholes to the corners of their parts.
template <typename T, typename PointsOf>
std::vector<std::array<T, 3>> at_parts(const std::vector<std::array<T, 3>>& wholes, const PatchSet& parts,
                                       std::span<const std::uint32_t> whole_of, const PointsOf& points_of,
                                       const Context& context) {
  std::vector<std::array<T, 3>> result(parts.size());
  context.for_chunks(parts.size(), patches_grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto p = begin; p < end; ++p) {
      const auto whole = whole_of[p];
      const auto triangle = points_of(whole);
      const auto corners = parts.points(p);
      if (corners == triangle) {
        result[p] = wholes[whole];
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k)
        result[p][k] = between(wholes[whole], barycentric(triangle, corners[k]));
    }
  });
  return result;
}

// Means of textures over some patches: one table per texture and per way their materials use it.
class PatchMeans {
 public:
  PatchMeans(const PatchSet& patches, std::span<const std::uint32_t> some, const Context& context)
      : patches_(patches), of_material_(patches.materials.size()) {
    std::vector<std::uint8_t> is_used(patches.materials.size(), 0);
    for (const auto p : some) is_used[static_cast<std::size_t>(patches.material[p])] = 1;
    for (std::size_t m = 0; m < is_used.size(); ++m) {
      if (!is_used[m]) continue;
      const auto& t = patches.materials[m].textures;
      of_material_[m] = {sums(t.reflectance, t, context), sums(t.emittance, t, context),
                         sums(t.cutout, t, context)};
    }
  }

  // The patch's material must have the texture.
  Vec3 reflectance(std::size_t p) const {
    return over(p, *of(p).reflectance, *patches_.material_of(p).textures.reflectance).colour;
  }
  Vec3 emittance(std::size_t p) const {
    return over(p, *of(p).emittance, *patches_.material_of(p).textures.emittance).colour;
  }
  float covered(std::size_t p) const {
    return over(p, *of(p).cutout, *patches_.material_of(p).textures.cutout).covered;
  }

 private:
  struct OfMaterial {
    const TexelSums* reflectance = nullptr;
    const TexelSums* emittance = nullptr;
    const TexelSums* cutout = nullptr;
  };

  // The table has holes where the texture has the same placement as the cut-out's.
  const TexelSums* sums(const std::optional<TextureUse>& use, const MaterialTextures& material,
                        const Context& context) {
    if (!use) return nullptr;
    const bool has_holes = material.cutout && *material.cutout == *use;
    const auto threshold = has_holes ? std::optional(material.cutout_threshold) : std::nullopt;
    const auto key = std::tuple(use->texture, use->wrap, threshold);
    auto found = made_.find(key);
    if (found == made_.end())
      found =
          made_.emplace(key, TexelSums(patches_.textures[use->texture].raster, use->wrap, threshold, context))
              .first;
    return &found->second;
  }
  const OfMaterial& of(std::size_t p) const {
    return of_material_[static_cast<std::size_t>(patches_.material[p])];
  }
  TexelSums::Mean over(std::size_t p, const TexelSums& sums, const TextureUse& use) const {
    std::array<Vec2, 3> places;
    for (std::size_t k = 0; k < 3; ++k) places[k] = use.place(patches_.uv_sets[use.uv_set][p][k]);
    return sums.over(places);
  }

  const PatchSet& patches_;
  std::map<std::tuple<std::uint32_t, std::array<Wrap, 2>, std::optional<float>>, TexelSums> made_;
  std::vector<OfMaterial> of_material_;  // [material]
};

// Converts colours to the patches' bands.
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

void set_texture_ratios(std::vector<float>& ratios, std::size_t patch, const std::vector<float>& own,
                        const std::vector<float>& of_material) {
  for (std::size_t b = 0; b < own.size(); ++b)
    if (of_material[b] > 0.0f) ratios[patch * own.size() + b] = own[b] / of_material[b];
}

Vec3 mean_of(const std::array<Vec3, 3>& corners) { return (corners[0] + corners[1] + corners[2]) / 3.0f; }

void colour_patch(PatchSet& patches, std::size_t p, const PatchMeans& means, const BandsOfColours& bands) {
  const auto has_corners = !patches.corner_colours.empty();
  const auto& material = patches.material_of(p);
  const auto& t = material.textures;
  if (t.cutout) patches.area[p] *= std::max(smallest_coverage, means.covered(p));
  if (t.reflectance || has_corners) {
    auto colour = t.reflectance_factor;
    if (t.reflectance) colour *= means.reflectance(p);
    if (has_corners) colour *= mean_of(patches.corner_colours[p]);
    set_texture_ratios(patches.reflectance_ratio, p,
                       bands.reflectance(glm::clamp(colour, Vec3(0.0f), Vec3(t.max_reflectance))),
                       material.reflectance);
  }
  if (t.emittance)
    set_texture_ratios(patches.emittance_ratio, p, bands.light(t.emittance_factor * means.emittance(p)),
                       material.emittance);
}

// Makes room for the colours of patches that differ from those of their materials.
void make_ratios(PatchSet& patches) {
  const auto any = [&](const auto& has) {
    return std::any_of(patches.materials.begin(), patches.materials.end(),
                       [&](const BandMaterial& m) { return has(m.textures); });
  };
  const auto values = patches.size() * patches.band_count();
  if (!patches.corner_colours.empty() || any([](const auto& t) { return t.reflectance.has_value(); }))
    patches.reflectance_ratio.assign(values, 1.0f);
  if (any([](const auto& t) { return t.emittance.has_value(); }))
    patches.emittance_ratio.assign(values, 1.0f);
}

void colour_patches(PatchSet& patches, std::span<const std::uint32_t> some, const Context& context) {
  const PatchMeans means(patches, some, context);
  const BandsOfColours bands(patches);
  context.for_chunks(some.size(), patches_grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto i = begin; i < end; ++i) colour_patch(patches, some[i], means, bands);
  });
}

std::vector<std::uint32_t> all_of(const PatchSet& patches) {
  std::vector<std::uint32_t> all(patches.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

void copy_bands(const std::vector<float>& from, std::size_t whole, std::vector<float>& to, std::size_t part,
                std::size_t bands) {
  if (!to.empty()) std::copy_n(from.begin() + whole * bands, bands, to.begin() + part * bands);
}

}  // namespace

void lay_textures(PatchSet& patches, const Scene& scene, bool plain_reflectance, const Context& context) {
  if (plain_reflectance)
    for (auto& m : patches.materials) m.textures.reflectance.reset();
  const bool has_textures = std::any_of(patches.materials.begin(), patches.materials.end(),
                                        [](const BandMaterial& m) { return m.textures.any(); });
  const bool has_corners = !plain_reflectance && !scene.corner_colours.empty();
  if (!has_textures && !has_corners) return;
  const auto points_of = [&](std::uint32_t triangle) {
    const auto& c = scene.triangles[triangle];
    return std::array{scene.positions[c[0]], scene.positions[c[1]], scene.positions[c[2]]};
  };
  if (has_textures) {
    patches.textures = scene.textures;
    for (const auto& set : scene.uv_sets)
      patches.uv_sets.push_back(at_parts(set, patches, patches.triangle, points_of, context));
  }
  if (has_corners)
    patches.corner_colours = at_parts(scene.corner_colours, patches, patches.triangle, points_of, context);
  make_ratios(patches);
  colour_patches(patches, all_of(patches), context);
}

void inherit_textures(PatchSet& parts, const PatchSet& whole, std::span<const std::uint32_t> parent,
                      const Context& context) {
  assert(parent.size() == parts.size());
  if (whole.uv_sets.empty() && whole.corner_colours.empty()) return;
  const auto points_of = [&](std::uint32_t patch) { return whole.points(patch); };
  parts.textures = whole.textures;
  for (const auto& set : whole.uv_sets)
    parts.uv_sets.push_back(at_parts(set, parts, parent, points_of, context));
  if (!whole.corner_colours.empty())
    parts.corner_colours = at_parts(whole.corner_colours, parts, parent, points_of, context);
  make_ratios(parts);
  std::vector<std::uint32_t> cut;
  for (std::uint32_t p = 0; p < parts.size(); ++p) {
    if (parts.corners[p] != whole.corners[parent[p]]) {
      cut.push_back(p);
      continue;
    }
    parts.area[p] = whole.area[parent[p]];
    copy_bands(whole.reflectance_ratio, parent[p], parts.reflectance_ratio, p, parts.band_count());
    copy_bands(whole.emittance_ratio, parent[p], parts.emittance_ratio, p, parts.band_count());
  }
  colour_patches(parts, cut, context);
}

FineColours::FineColours(const PatchSet& patches, const Context& context) : patches_(patches) {
  const PatchMeans means(patches, all_of(patches), context);
  const auto fill = [&](std::vector<Vec3>& filled, const auto& use_of, const auto& mean) {
    const auto has = [&](const BandMaterial& m) { return use_of(m.textures).has_value(); };
    if (std::none_of(patches.materials.begin(), patches.materials.end(), has)) return;
    filled.assign(patches.size(), Vec3(0.0f));
    context.for_chunks(patches.size(), patches_grain, [&](std::size_t begin, std::size_t end, int) {
      for (auto p = begin; p < end; ++p)
        if (has(patches.material_of(p))) filled[p] = mean(p);
    });
  };
  fill(
      reflectance_mean_, [](const auto& t) { return t.reflectance; },
      [&](std::size_t p) { return means.reflectance(p); });
  fill(
      emittance_mean_, [](const auto& t) { return t.emittance; },
      [&](std::size_t p) { return means.emittance(p); });
}

Vec3 FineColours::reflectance(std::size_t patch, float u, float v) const {
  if (reflectance_mean_.empty()) return Vec3(1.0f);
  return at(patches_.material_of(patch).textures.reflectance, reflectance_mean_, patch, u, v);
}

Vec3 FineColours::emittance(std::size_t patch, float u, float v) const {
  if (emittance_mean_.empty()) return Vec3(1.0f);
  return at(patches_.material_of(patch).textures.emittance, emittance_mean_, patch, u, v);
}

namespace {

Vec3 or_one(const std::optional<TextureUse>& use, const std::vector<Vec3>& means, std::size_t patch) {
  Vec3 mean(1.0f);
  for (int c = 0; use && !means.empty() && c < 3; ++c)
    if (means[patch][c] > darkest_mean[c]) mean[c] = means[patch][c];
  return mean;
}

}  // namespace

Vec3 FineColours::mean_reflectance(std::size_t patch) const {
  return or_one(patches_.material_of(patch).textures.reflectance, reflectance_mean_, patch);
}

Vec3 FineColours::mean_emittance(std::size_t patch) const {
  return or_one(patches_.material_of(patch).textures.emittance, emittance_mean_, patch);
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
