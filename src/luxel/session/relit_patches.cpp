// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/relit_patches.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "luxel/patch/luminaire_groups.h"
#include "luxel/solve/own_lighting.h"

namespace luxel {

PatchSet relit_patches(PatchSet patches, const Lighting& lighting) {
  const OwnLighting own(patches);
  if (!lighting.lamps.empty()) own.set_lamps(lighting.lamps, patches);
  if (!lighting.reflectance.empty()) own.set_reflectance(lighting.reflectance, patches);
  return patches;
}

void describe_lighting(const PatchSet& patches, const Lighting& lighting, Provenance& provenance) {
  const auto bands = patches.band_count();
  std::string flags;
  const auto note = [&](const char* option, const std::string& name, std::span<const float> values) {
    const bool is_grey = std::all_of(values.begin(), values.end(), [&](float v) { return v == values[0]; });
    const auto value = fmt::format("{}={}", name, fmt::join(is_grey ? values.first(1) : values, ","));
    provenance.options.emplace_back(option, value);
    flags += fmt::format(" --{} {}", option, value);
  };
  for (std::size_t g = 0; g < lighting.lamps.size() / bands; ++g) {
    const auto weight = std::span(lighting.lamps).subspan(g * bands, bands);
    const auto name = patches.light_groups.empty() ? std::string("all") : patches.light_groups[g];
    // A tint does not change the lumens of luminaires: these are named by themselves.
    const auto lumens = static_cast<float>(relative_lumens(patches, g, weight));
    const bool is_dimmed = std::abs(lumens - 1.0f) > 1e-5f;
    if (is_dimmed) note("light", name, {&lumens, 1});
    if (std::any_of(weight.begin(), weight.end(), [&](float w) { return w != (is_dimmed ? lumens : 1.0f); }))
      note("tint", name, weight);
  }
  for (std::size_t m = 0; m < lighting.reflectance.size() / bands; ++m) {
    const auto reflectance = std::span(lighting.reflectance).subspan(m * bands, bands);
    const auto& own = patches.materials[m].reflectance;
    if (!std::equal(own.begin(), own.end(), reflectance.begin()))
      note("reflectance", patches.materials[m].name, reflectance);
  }
  provenance.command_line += fmt::format("; luxel relight{}", flags);
}

}  // namespace luxel
