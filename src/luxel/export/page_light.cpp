// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/page_light.h"

#include <algorithm>
#include <cmath>

#include "luxel/core/half.h"
#include "luxel/patch/colour_patches.h"
#include "luxel/scene/band_colours.h"
#include "luxel/scene/luminous_efficacy.h"
#include "luxel/surface/vertex_texture_ratios.h"

namespace luxel {
namespace {

constexpr float largest_half = 32768.0f;  // the brightest light is scaled to this: far below a half's limit
constexpr float half_limit = 65504.0f;

const std::vector<float>& irradiance_of(const SmoothLight& light, bool back) {
  return light.irradiance.of(back);
}

// The texture ratios of the page's vertices, found through its triangles, as vertices do not store their
// place.
VertexTextureRatios ratios_of(const PatchSet& patches, const PageMesh& mesh) {
  VertexTextureRatios ratios(patches);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const auto v : mesh.triangles[t]) ratios.add(v, mesh.patch[t]);
  return ratios;
}

// Appends what a vertex stores of an irradiance [band].
void append(std::vector<float>& out, const PatchSet& patches, const BandColours& colours,
            std::size_t material, const TextureRatio& ratio, const std::vector<float>& irradiance) {
  if (patches.wavebands.empty()) {
    out.insert(out.end(), irradiance.begin(), irradiance.end());
    return;
  }
  auto reflected = irradiance;
  double watts = 0.0;
  for (std::size_t b = 0; b < irradiance.size(); ++b) {
    watts += static_cast<double>(irradiance[b]);
    reflected[b] *= albedo_at(patches.materials[material], ratio, b);
  }
  const auto rgb = colours.rgb(reflected);
  for (int c = 0; c < 3; ++c) out.push_back(static_cast<float>(rgb[c]));
  out.push_back(static_cast<float>(colours.lumens(irradiance) / luminous_efficacy));
  out.push_back(static_cast<float>(watts));
}

// The irradiance of a vertex in a group's light, scaled so that the groups sum up to the whole.
class RatioLight {
 public:
  RatioLight(const SmoothLight& whole, std::span<const GroupLight> groups, std::size_t bands)
      : whole_(whole), groups_(groups), bands_(bands) {}

  std::vector<float> at(std::size_t group, bool back, const DrawnPoint& point) const {
    std::vector<float> light(bands_);
    for (std::size_t b = 0; b < bands_; ++b) {
      light[b] = point.at(irradiance_of(whole_, back), b, bands_);
      if (!groups_.empty()) light[b] *= ratio(group, back, point, b);
    }
    return light;
  }

 private:
  float ratio(std::size_t group, bool back, const DrawnPoint& point, std::size_t band) const {
    const auto of = [&](const GroupLight& g) {
      return static_cast<double>(point.at(irradiance_of(g.light, back), band, bands_));
    };
    double sum = 0.0;
    for (const auto& g : groups_) sum += of(g);
    if (!(sum > 0.0)) return group == 0 ? 1.0f : 0.0f;  // no group's light: counted as the first one's
    return static_cast<float>(of(groups_[group]) / sum);
  }

  const SmoothLight& whole_;
  std::span<const GroupLight> groups_;
  std::size_t bands_;
};

// Lux of a side's standard error; the errors of bands are added as if fully correlated.
double lux_error(const BandColours& colours, const std::vector<float>& error, std::size_t patch) {
  double lux = 0.0;
  for (std::size_t b = 0; b < colours.bands(); ++b) {
    const auto of_band = colours.of(b) * static_cast<double>(error[patch * colours.bands() + b]);
    lux += std::abs(lumens(of_band.r, of_band.g, of_band.b));
  }
  return lux;
}

}  // namespace

PageLight make_page_light(const PatchSet& patches, const PageMesh& mesh, const SmoothLight& light,
                          std::span<const GroupLight> groups) {
  const auto colours = patches.colours();
  const RatioLight shared(light, groups, patches.band_count());
  const auto ratios = ratios_of(patches, mesh);
  std::vector<std::uint8_t> shows_back(mesh.vertices.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const auto v : mesh.triangles[t]) shows_back[v] |= mesh.back_is_lit[t];
  std::vector<float> values;
  for (std::size_t g = 0; g < std::max<std::size_t>(1, groups.size()); ++g)
    for (const bool back : {false, true})
      for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const auto& v = mesh.vertices[i];
        const auto ratio = ratios.at(i);
        auto light = shared.at(g, back, v.point);
        if (const auto& material = patches.materials[v.material]; material.is_diffuser()) {
          const auto behind = shared.at(g, !back, v.point);
          for (std::size_t b = 0; b < light.size(); ++b)
            light[b] = effective_irradiance(material, {light.data(), behind.data()}, ratio, b);
        }
        if (back && shows_back[i] == 0) std::fill(light.begin(), light.end(), 0.0f);
        append(values, patches, colours, v.material, ratio, light);
      }
  float largest = 0.0f;
  for (const auto v : values) largest = std::max(largest, std::abs(v));
  PageLight page;
  page.components = patches.wavebands.empty() ? 3 : 5;
  if (largest > 0.0f) page.unit = largest / largest_half;
  page.halves.reserve(values.size());
  for (const auto v : values) page.halves.push_back(half_of(v / page.unit));
  return page;
}

PageColours make_page_colours(const PatchSet& patches, const PageMesh& mesh) {
  PageColours page;
  if (patches.reflectance_ratio.empty() && patches.emittance_ratio.empty()) return page;
  const bool is_spectral = !patches.wavebands.empty();
  const auto colours = patches.colours();
  const FineColours fine(patches, Context(1));
  std::vector<Vec3d> reflectance(mesh.vertices.size(), Vec3d(0.0)), emittance = reflectance;
  std::vector<double> areas(mesh.vertices.size(), 0.0);
  const auto emitted = [&](std::size_t patch, bool is_of_patch) {
    std::vector<float> light;
    for (std::size_t b = 0; b < patches.band_count(); ++b)
      light.push_back(is_of_patch ? patches.emittance(patch, b) : patches.material_of(patch).emittance[b]);
    return colours.rgb(light);
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto patch = mesh.patch[t];
    const auto ratio = texture_ratio_of_patch(patches, patch);
    const auto& material = patches.material_of(patch);
    const auto of_patch = emitted(patch, true), of_material = emitted(patch, false);
    const auto reflected_mean = fine.mean_reflectance(patch), emitted_mean = fine.mean_emittance(patch);
    const auto area = static_cast<double>(patches.area[patch]);
    for (const auto v : mesh.triangles[t]) {
      areas[v] += area;
      for (int c = 0; c < 3; ++c) {
        const auto own = is_spectral ? 1.0f : albedo_at(material, ratio, static_cast<std::size_t>(c));
        const auto whole = is_spectral ? 1.0f : albedo_at(material, {}, static_cast<std::size_t>(c));
        reflectance[v][c] +=
            area * static_cast<double>(own / (whole > 0.0f ? whole : 1.0f) / reflected_mean[c]);
        emittance[v][c] += area * (of_material[c] > 0.0 ? of_patch[c] / of_material[c] : 1.0) /
                           static_cast<double>(emitted_mean[c]);
      }
    }
  }
  for (std::size_t v = 0; v < areas.size(); ++v)
    for (int c = 0; c < 3; ++c) {
      const auto half = [&](double sum) {
        return half_of(std::min(half_limit, static_cast<float>(areas[v] > 0.0 ? sum / areas[v] : 1.0)));
      };
      page.reflectance.push_back(half(reflectance[v][c]));
      page.emittance.push_back(half(emittance[v][c]));
    }
  return page;
}

PageErrors make_page_errors(const PatchSet& patches, const PageMesh& mesh, const Solution& solution,
                            std::span<const GroupLight> groups) {
  const auto colours = patches.colours();
  std::vector<const Solution*> layers = {&solution};
  for (const auto& g : groups) layers.push_back(&g.solution);
  std::vector<double> errors;
  for (const auto* layer : layers)
    for (const bool back : {false, true})
      for (std::size_t t = 0; t < mesh.patch.size(); ++t) {
        const auto& of_side = layer->standard_error.of(back);
        const bool is_shown = !of_side.empty() && (!back || mesh.back_is_lit[t] != 0);
        errors.push_back(is_shown ? lux_error(colours, of_side, mesh.patch[t]) : 0.0);
      }
  PageErrors page;
  for (const auto e : errors) page.largest = std::max(page.largest, e);
  for (const auto e : errors) {
    const auto below = e > 0.0 ? std::lround(12.0 * std::log2(page.largest / e)) : 255l;
    page.codes.push_back(static_cast<std::uint8_t>(255l - std::min(below, e > 0.0 ? 254l : 255l)));
  }
  return page;
}

}  // namespace luxel
