// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/own_lighting.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/address.h"
#include "luxel/core/error.h"

namespace luxel {
namespace {

void check(const std::vector<float>& values, std::size_t count, bool (*is_fine)(float), const char* what) {
  if (values.size() != count || !std::all_of(values.begin(), values.end(), is_fine))
    throw InputError(fmt::format("expected {} {}", count, what));
}

std::uint64_t changed_fingerprint(std::uint64_t key, const PatchSet& patches) {
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

OwnLighting::OwnLighting(const PatchSet& patches)
    : sky_(patches.sky), fingerprint_(patches.scene_fingerprint) {
  for (const auto& material : patches.materials) {
    emittance_.push_back(material.emittance);
    reflectance_.insert(reflectance_.end(), material.reflectance.begin(), material.reflectance.end());
  }
  for (const auto& light : patches.point_lights) intensity_.push_back(light.intensity);
}

void OwnLighting::set_lamps(const std::vector<float>& weight, PatchSet& patches) const {
  const auto bands = patches.band_count();
  const auto groups = patches.group_count();
  check(
      weight, groups * bands, [](float w) { return w >= 0.0f && std::isfinite(w); },
      "numbers, at least 0, one for each light group and band");
  const auto set = [&](std::vector<float>& values, const std::vector<float>& own, std::size_t group) {
    for (std::size_t b = 0; b < own.size(); ++b) values[b] = weight[group * bands + b] * own[b];
  };
  for (std::size_t m = 0; m < emittance_.size(); ++m)
    set(patches.materials[m].emittance, emittance_[m], patches.materials[m].light_group);
  for (std::size_t i = 0; i < intensity_.size(); ++i)
    set(patches.point_lights[i].intensity, intensity_[i], patches.point_lights[i].light_group);
  set(patches.sky, sky_, groups - 1);
  patches.scene_fingerprint = changed_fingerprint(fingerprint_, patches);
}

void OwnLighting::set_reflectance(const std::vector<float>& reflectance, PatchSet& patches) const {
  const auto bands = patches.band_count();
  check(
      reflectance, patches.materials.size() * bands, [](float r) { return r >= 0.0f && r < 1.0f; },
      "reflectances from 0 to below 1, one for each material and band");
  for (std::size_t m = 0; m < patches.materials.size(); ++m)
    std::copy_n(&reflectance[m * bands], bands, patches.materials[m].reflectance.begin());
  patches.scene_fingerprint = changed_fingerprint(fingerprint_, patches);
}

}  // namespace luxel
