// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/light_mixer.h"

#include <algorithm>
#include <optional>

#include "luxel/patch/luminaire_groups.h"
#include "luxel/scene/colour_spectra.h"

namespace luxel {
namespace {

// The colour of a surface in white light.
Vec3 colour_of(const std::vector<float>& reflectance, const PatchSet& patches) {
  const auto colours = patches.colours();
  const std::vector<float> white(reflectance.size(), 1.0f);
  const auto seen = colours.rgb(reflectance), full = colours.rgb(white);
  return glm::clamp(Vec3(seen / glm::max(full, Vec3d(1e-9))), Vec3(0.0f), Vec3(max_reflectance));
}

// Factor on the tint of a light group: the colour of luminaires does not change their lumens.
float lumens_kept(const PatchSet& patches, std::size_t group, const std::vector<float>& tint) {
  const auto relative = relative_lumens(patches, group, tint);
  return relative > 0.0 ? static_cast<float>(1.0 / relative) : 1.0f;
}

}  // namespace

LightMixer::LightMixer(const PatchSet& patches) {
  for (const auto& name : patches.light_groups) lamps.push_back({name});
  if (lamps.empty()) lamps.push_back({"all light"});
  if (!patches.has_colours()) return;
  for (const auto& material : patches.materials) {
    const auto colour = colour_of(material.reflectance, patches);
    materials.push_back({material.name, colour, colour, material.is_lamp()});
  }
}

bool LightMixer::is_untouched() const {
  return std::all_of(lamps.begin(), lamps.end(),
                     [](const Lamps& l) { return l.factor == 1.0f && l.tint == Vec3(1.0f); }) &&
         std::all_of(materials.begin(), materials.end(), [](const Surface& s) { return s.colour == s.own; });
}

Lighting LightMixer::lighting(const PatchSet& patches) const {
  Lighting lighting;
  if (is_untouched()) return lighting;
  const auto bands = patches.band_count();
  std::optional<ColourSpectra> spectra;
  if (!patches.wavebands.empty()) spectra.emplace(patches.wavebands);
  const auto rgb_values = [](const Vec3& rgb) { return std::vector<float>{rgb.r, rgb.g, rgb.b}; };
  for (std::size_t g = 0; g < lamps.size(); ++g) {
    const auto tint = spectra ? spectra->tint(lamps[g].tint) : rgb_values(lamps[g].tint);
    const auto factor = lamps[g].factor * lumens_kept(patches, g, tint);
    for (std::size_t b = 0; b < bands; ++b) lighting.lamps.push_back(factor * tint[b]);
  }
  for (std::size_t m = 0; m < materials.size(); ++m) {
    const auto& surface = materials[m];
    auto values = surface.colour == surface.own ? patches.materials[m].reflectance
                  : spectra                     ? spectra->reflectance(surface.colour)
                                                : rgb_values(surface.colour);
    for (auto& value : values) value = std::clamp(value, 0.0f, max_reflectance);
    lighting.reflectance.insert(lighting.reflectance.end(), values.begin(), values.end());
  }
  return lighting;
}

}  // namespace luxel
