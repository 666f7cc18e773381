// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/set_bands.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/scene/colour_spectra.h"

namespace luxel {
namespace {

// Measured spectra override textures. Without a texture, the vertex colour multiplies the material's own
// colour.
MaterialTextures textures_of(const Material& m) {
  auto textures = m.textures;
  if (!m.reflectance_spectrum.empty()) textures.reflectance.reset();
  if (!m.emittance_spectrum.empty()) textures.emittance.reset();
  if (!textures.reflectance) textures.reflectance_factor = m.reflectance;
  return textures;
}

// Panes that let all light pass have none: they are not there.
bool absorbs(const Material& m) { return !m.opaque && m.transmittance != Vec3(1.0f); }

void set_plain_bands(PatchSet& patches, const Scene& scene) {
  const auto three = [](const Vec3& rgb) { return std::vector<float>{rgb.r, rgb.g, rgb.b}; };
  patches.bands = {"red", "green", "blue"};
  for (const auto& m : scene.materials)
    patches.materials.push_back(
        {m.name, m.two_sided || m.is_diffuser(), three(m.reflectance), three(m.emittance), 0, textures_of(m),
         absorbs(m) ? three(m.transmittance) : std::vector<float>(),
         m.is_diffuser() ? three(glm::min(m.diffuse_transmittance, Vec3(max_reflectance)))
                         : std::vector<float>()});
  for (const auto& light : scene.point_lights)
    patches.point_lights.push_back({light, three(light.intensity)});
  if (scene.sky != Vec3(0.0f)) patches.sky = three(scene.sky);
  for (const auto& radiance : scene.sky_radiance)
    patches.sky.insert(patches.sky.end(), {radiance.r, radiance.g, radiance.b});
}

// Spectra of measured materials and of those given by a colour, at the bands.
class SpectraAtBands {
 public:
  explicit SpectraAtBands(const Scene& scene) : scene_(scene), bands_(make_wavebands(scene.wavelengths)) {}

  const std::vector<Waveband>& bands() const { return bands_; }

  std::vector<float> reflectance(const Material& m) {
    if (m.reflectance_spectrum.empty()) return of_colours().reflectance(m.reflectance);
    return at_bands([&](std::size_t b) { return value(m.reflectance_spectrum, b, Beyond::holds); });
  }
  std::vector<float> transmittance(const Material& m) {
    return absorbs(m) ? fraction(m.transmittance) : std::vector<float>();
  }
  std::vector<float> diffuse_transmittance(const Material& m) {
    return m.is_diffuser() ? fraction(glm::min(m.diffuse_transmittance, Vec3(max_reflectance)))
                           : std::vector<float>();
  }
  std::vector<float> light(const Vec3& rgb, const Spectrum& measured) {
    if (!measured.empty())
      return at_bands([&](std::size_t b) { return bands_[b].width * value(measured, b, Beyond::zero); });
    return rgb == Vec3(0.0f) ? std::vector<float>(bands_.size(), 0.0f) : of_colours().light(rgb);
  }

 private:
  std::vector<float> fraction(const Vec3& rgb) {
    if (rgb == Vec3(rgb.r)) return std::vector<float>(bands_.size(), rgb.r);
    return of_colours().reflectance(glm::min(rgb, Vec3(max_reflectance)));
  }
  double value(const Spectrum& spectrum, std::size_t band, Beyond beyond) const {
    return scene_.averages_spectra ? mean_around(bands_, band, spectrum, beyond)
                                   : spectrum.at(bands_[band].wavelength, beyond);
  }
  template <typename Of>
  std::vector<float> at_bands(const Of& of) const {
    std::vector<float> values;
    for (std::size_t b = 0; b < bands_.size(); ++b) values.push_back(static_cast<float>(of(b)));
    return values;
  }
  const ColourSpectra& of_colours() {
    try {
      if (!of_colours_) of_colours_.emplace(bands_);
    } catch (const InputError& error) {
      throw InputError(scene_.source, error.what());
    }
    return *of_colours_;
  }

  const Scene& scene_;
  std::vector<Waveband> bands_;
  std::optional<ColourSpectra> of_colours_;
};

}  // namespace

void set_bands(PatchSet& patches, const Scene& scene) {
  patches.sky_patches = scene.sky_patches;
  if (scene.wavelengths.empty()) return set_plain_bands(patches, scene);
  SpectraAtBands spectra(scene);
  patches.wavebands = spectra.bands();
  for (const auto& band : patches.wavebands) patches.bands.push_back(fmt::format("{} nm", band.wavelength));
  for (const auto& m : scene.materials)
    patches.materials.push_back({m.name, m.two_sided || m.is_diffuser(), spectra.reflectance(m),
                                 spectra.light(m.emittance, m.emittance_spectrum), 0, textures_of(m),
                                 spectra.transmittance(m), spectra.diffuse_transmittance(m)});
  for (const auto& light : scene.point_lights)
    patches.point_lights.push_back({light, spectra.light(light.intensity, {})});
  std::vector<float> sky;
  if (scene.sky_radiance.empty()) sky = spectra.light(scene.sky, scene.sky_spectrum);
  for (const auto& radiance : scene.sky_radiance) {
    const auto at_bands = spectra.light(radiance, {});
    sky.insert(sky.end(), at_bands.begin(), at_bands.end());
  }
  if (std::any_of(sky.begin(), sky.end(), [](float x) { return x > 0.0f; })) patches.sky = std::move(sky);
}

}  // namespace luxel
