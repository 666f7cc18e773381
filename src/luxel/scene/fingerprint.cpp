// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>

#include "luxel/scene/scene.h"

namespace luxel {
namespace {

// Hashes 32-bit words one after the other; each step is the output function of SplitMix64 (Steele, Lea,
// Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014), a bijection of the state, so that
// two scenes that differ in exactly one word never collide. Only integer arithmetic: the same on every host.
class WordHash {
 public:
  void add(std::uint32_t word) {
    auto z = (state_ ^ word) + 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    state_ = z ^ (z >> 31);
  }
  // -0 and +0 are the same light, so they have the same hash.
  void add(float value) { add(value == 0.0f ? 0u : std::bit_cast<std::uint32_t>(value)); }
  void add(const Vec3& v) {
    add(v.x);
    add(v.y);
    add(v.z);
  }
  void add(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value + 0.0);  // -0 becomes +0
    add(static_cast<std::uint32_t>(bits));
    add(static_cast<std::uint32_t>(bits >> 32));
  }
  // The length precedes the array, so that words cannot move unnoticed from one array to the next.
  void add_length(std::size_t length) {
    add(static_cast<std::uint32_t>(length));
    add(static_cast<std::uint32_t>(std::uint64_t{length} >> 32));
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0;
};

void add_spectrum(WordHash& hash, const Spectrum& spectrum) {
  hash.add_length(spectrum.samples().size());
  for (const auto& sample : spectrum.samples()) {
    hash.add(sample.wavelength);
    hash.add(sample.value);
  }
}

void add_spectra(WordHash& hash, const Scene& scene) {
  hash.add_length(scene.wavelengths.size());
  for (const auto wavelength : scene.wavelengths) hash.add(wavelength);
  hash.add(std::uint32_t{scene.averages_spectra});
  for (const auto& material : scene.materials) {
    add_spectrum(hash, material.reflectance_spectrum);
    add_spectrum(hash, material.emittance_spectrum);
  }
  add_spectrum(hash, scene.sky_spectrum);
}

void add_sky(WordHash& hash, const Scene& scene) {
  const auto& patches = scene.sky_patches;
  hash.add(static_cast<std::uint32_t>(patches.subdivision()));
  hash.add(std::uint32_t{patches.lower_half() == LowerHalf::mirrored});
  for (int axis = 0; axis < 3; ++axis) hash.add(patches.zenith()[axis]);
  for (int axis = 0; axis < 3; ++axis) hash.add(patches.north()[axis]);
  for (const auto& radiance : scene.sky_radiance) hash.add(radiance);
}

void add_use(WordHash& hash, const std::optional<TextureUse>& use) {
  hash.add(std::uint32_t{use.has_value()});
  if (!use) return;
  hash.add(use->texture);
  hash.add(use->uv_set);
  for (const auto number : use->placement) hash.add(number);
  for (const auto wrap : use->wrap) hash.add(static_cast<std::uint32_t>(wrap));
}

void add_raster(WordHash& hash, const Raster& raster) {
  hash.add(static_cast<std::uint32_t>(raster.width));
  hash.add(static_cast<std::uint32_t>(raster.height));
  for (const auto& code : raster.codes)
    hash.add(std::uint32_t{code[0]} | std::uint32_t{code[1]} << 8 | std::uint32_t{code[2]} << 16 |
             std::uint32_t{code[3]} << 24);
  for (const auto& pixel : raster.linear) hash.add(pixel);
}

void add_textures(WordHash& hash, const Scene& scene) {
  hash.add_length(scene.textures.size());
  for (const auto& texture : scene.textures) add_raster(hash, *texture.raster);
  hash.add_length(scene.uv_sets.size());
  for (const auto& set : scene.uv_sets)
    for (const auto& corners : set)
      for (const auto& uv : corners) {
        hash.add(uv.x);
        hash.add(uv.y);
      }
  for (const auto& material : scene.materials) {
    add_use(hash, material.textures.reflectance);
    add_use(hash, material.textures.emittance);
    add_use(hash, material.textures.cutout);
    hash.add(material.textures.reflectance_factor);
    hash.add(material.textures.emittance_factor);
    hash.add(material.textures.max_reflectance);
    hash.add(material.textures.cutout_threshold);
  }
}

void add_colours(WordHash& hash, const Scene& scene) {
  hash.add_length(scene.corner_colours.size());
  for (const auto& corners : scene.corner_colours)
    for (const auto& colour : corners) hash.add(colour);
}

void add_luminaire(WordHash& hash, const PointLight& light) {
  hash.add(light.local_x);
  hash.add(light.local_y);
  const auto& [shape, size] = light.photometry->opening;
  hash.add(static_cast<std::uint32_t>(shape));
  for (int axis = 0; axis < 3; ++axis) hash.add(size[axis]);
  const auto& intensity = light.photometry->intensity;
  hash.add(static_cast<std::uint32_t>(intensity.type()));
  for (const auto* values : {&intensity.vertical(), &intensity.horizontal(), &intensity.candela()}) {
    hash.add_length(values->size());
    for (const auto value : *values) hash.add(value);
  }
}

void add_lights(WordHash& hash, const Scene& scene) {
  hash.add_length(scene.point_lights.size());
  for (const auto& light : scene.point_lights) {
    hash.add(static_cast<std::uint32_t>(light.kind));
    hash.add(light.position);
    hash.add(light.direction);
    hash.add(light.intensity);
    hash.add(light.cos_inner);
    hash.add(light.cos_outer);
    if (light.angular_radius > 0.0f) hash.add(light.angular_radius);
    if (light.kind == PointLightKind::luminaire) add_luminaire(hash, light);
  }
}

bool is_diffuser(const Material& material) { return material.is_diffuser(); }
bool absorbs(const Material& material) { return !material.opaque && material.transmittance != Vec3(1.0f); }

void add_transmittances(WordHash& hash, const Scene& scene) {
  for (const auto& material : scene.materials)
    hash.add(absorbs(material) ? material.transmittance : Vec3(1.0f));
}

}  // namespace

std::uint64_t fingerprint(const Scene& scene) {
  WordHash hash;
  hash.add_length(scene.positions.size());
  for (const auto& position : scene.positions) hash.add(position);
  hash.add_length(scene.triangles.size());
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    for (const auto corner : scene.triangles[i]) hash.add(corner);
    hash.add(static_cast<std::uint32_t>(scene.triangle_material[i]));
  }
  hash.add_length(scene.materials.size());
  for (const auto& material : scene.materials) {
    hash.add(material.reflectance);
    hash.add(material.emittance);
    hash.add(std::uint32_t{material.two_sided} | std::uint32_t{!material.opaque} << 1);
  }
  if (scene.sky != Vec3(0.0f)) hash.add(scene.sky);
  if (!scene.sky_radiance.empty()) add_sky(hash, scene);
  if (scene.origin != Vec3d(0.0))
    for (int axis = 0; axis < 3; ++axis) hash.add(scene.origin[axis]);
  if (!scene.wavelengths.empty()) add_spectra(hash, scene);
  if (!scene.textures.empty()) add_textures(hash, scene);
  if (!scene.corner_colours.empty()) add_colours(hash, scene);
  if (!scene.point_lights.empty()) add_lights(hash, scene);
  if (std::any_of(scene.materials.begin(), scene.materials.end(), absorbs)) add_transmittances(hash, scene);
  if (std::any_of(scene.materials.begin(), scene.materials.end(), is_diffuser))
    for (const auto& material : scene.materials) hash.add(material.diffuse_transmittance);
  return hash.value();
}

}  // namespace luxel
