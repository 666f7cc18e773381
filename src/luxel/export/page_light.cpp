// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/page_light.h"

#include <algorithm>
#include <cmath>

#include "luxel/core/half.h"
#include "luxel/scene/band_colours.h"
#include "luxel/scene/luminous_efficacy.h"
#include "luxel/surface/vertex_texture_ratios.h"

namespace luxel {
namespace {

constexpr float largest_half = 32768.0f;  // what the brightest light is preserved as: far from a half's end

const std::vector<float>& irradiance_of(const SmoothLight& light, bool back) {
  return light.irradiance.of(back);
}

// The shares of the page's vertices; of its triangles, for nothing else knows where a vertex lies.
VertexTextureRatios ratios_of(const PatchSet& patches, const PageMesh& mesh) {
  VertexTextureRatios ratios(patches);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const auto v : mesh.triangles[t]) ratios.add(v, mesh.patch[t]);
  return ratios;
}

// What a vertex holds of an irradiance [band].
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
    reflected[b] *= reflectance_at(patches.materials[material], ratio, b);
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

  std::vector<float> at(std::size_t group, bool back, std::size_t smooth) const {
    const auto* whole = &irradiance_of(whole_, back)[smooth * bands_];
    std::vector<float> light(whole, whole + bands_);
    if (groups_.empty()) return light;
    for (std::size_t b = 0; b < bands_; ++b) light[b] *= ratio(group, back, smooth * bands_ + b);
    return light;
  }

 private:
  float ratio(std::size_t group, bool back, std::size_t at) const {
    double sum = 0.0;
    for (const auto& g : groups_) sum += static_cast<double>(irradiance_of(g.light, back)[at]);
    if (!(sum > 0.0)) return group == 0 ? 1.0f : 0.0f;  // nobody's: as if it were of the first
    return static_cast<float>(static_cast<double>(irradiance_of(groups_[group].light, back)[at]) / sum);
  }

  const SmoothLight& whole_;
  std::span<const GroupLight> groups_;
  std::size_t bands_;
};

// Lux that a side's standard error makes, its bands' errors added as if they went together.
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
  std::vector<float> values;
  for (std::size_t g = 0; g < std::max<std::size_t>(1, groups.size()); ++g)
    for (const bool back : {false, true})
      for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const auto& v = mesh.vertices[i];
        append(values, patches, colours, v.material, ratios.at(i), shared.at(g, back, v.smooth));
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

PageTextureRatios make_page_texture_ratios(const PatchSet& patches, const PageMesh& mesh) {
  PageTextureRatios page;
  if (patches.reflectance_ratio.empty() && patches.emittance_ratio.empty()) return page;
  const auto colours = patches.colours();
  const auto ratios = ratios_of(patches, mesh);
  const auto over = [](double here, double of_material) {
    return half_of(of_material > 0.0 ? static_cast<float>(here / of_material) : 1.0f);
  };
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const auto& material = patches.materials[mesh.vertices[i].material];
    const auto ratio = ratios.at(i);
    auto emittance = material.emittance;
    for (std::size_t b = 0; b < emittance.size() && ratio.emittance; ++b) emittance[b] *= ratio.emittance[b];
    const auto emitted = colours.rgb(emittance), of_material = colours.rgb(material.emittance);
    for (int c = 0; c < 3; ++c) {
      page.emittance.push_back(over(emitted[c], of_material[c]));
      page.reflectance.push_back(patches.wavebands.empty()
                                     ? over(reflectance_at(material, ratio, c), material.reflectance[c])
                                     : half_of(1.0f));
    }
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
    for (const auto* side : {&layer->standard_error.front, &layer->standard_error.back})
      for (const auto patch : mesh.patch)
        errors.push_back(side->empty() ? 0.0 : lux_error(colours, *side, patch));
  PageErrors page;
  for (const auto e : errors) page.largest = std::max(page.largest, e);
  for (const auto e : errors) {
    const auto below = e > 0.0 ? std::lround(12.0 * std::log2(page.largest / e)) : 255l;
    page.codes.push_back(static_cast<std::uint8_t>(255l - std::min(below, e > 0.0 ? 254l : 255l)));
  }
  return page;
}

}  // namespace luxel
