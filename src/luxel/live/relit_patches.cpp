// SPDX-License-Identifier: Apache-2.0
#include "luxel/live/relit_patches.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "luxel/random/address.h"
#include "luxel/report/error.h"

namespace luxel {
namespace {

void check(const std::vector<float>& values, std::size_t count, bool (*is_fine)(float), const char* what) {
  if (!values.empty() && (values.size() != count || !std::all_of(values.begin(), values.end(), is_fine)))
    throw InputError(fmt::format("expected {} {}", count, what));
}

void dim(PatchSet& patches, const std::vector<float>& weight) {
  const auto bands = patches.band_count();
  const auto by = [&](std::vector<float>& values, std::size_t group) {
    for (std::size_t b = 0; b < values.size(); ++b) values[b] = weight[group * bands + b] * values[b];
  };
  for (auto& material : patches.materials) by(material.emittance, material.light_group);
  for (auto& light : patches.point_lights) by(light.intensity, light.light_group);
  by(patches.sky, patches.group_count() - 1);
}

std::uint64_t fingerprint_of(const PatchSet& patches) {
  auto key = patches.scene_fingerprint;
  const auto add = [&](const std::vector<float>& values) {
    for (const auto v : values) key = stream_key(key, 0, std::bit_cast<std::uint32_t>(v + 0.0f));
  };
  for (const auto& material : patches.materials) {
    add(material.reflectance);
    add(material.emittance);
  }
  add(patches.sky);
  for (const auto& light : patches.point_lights) add(light.intensity);
  return key;
}

}  // namespace

PatchSet relit_patches(PatchSet patches, const Lighting& lighting) {
  const auto bands = patches.band_count();
  check(
      lighting.lamps, patches.group_count() * bands, [](float w) { return w >= 0.0f && std::isfinite(w); },
      "numbers, at least 0, one for each light group and band");
  check(
      lighting.reflectance, patches.materials.size() * bands, [](float r) { return r >= 0.0f && r < 1.0f; },
      "reflectances from 0 to below 1, one for each material and band");
  if (!lighting.lamps.empty()) dim(patches, lighting.lamps);
  if (!lighting.reflectance.empty())
    for (std::size_t m = 0; m < patches.materials.size(); ++m)
      std::copy_n(&lighting.reflectance[m * bands], bands, patches.materials[m].reflectance.begin());
  patches.scene_fingerprint = fingerprint_of(patches);
  return patches;
}

}  // namespace luxel
