// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/patch_set.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/scene/band_colours.h"

namespace luxel {

namespace {

bool any_above_zero(const std::vector<float>& bands) {
  return std::any_of(bands.begin(), bands.end(), [](float x) { return x > 0.0f; });
}

}  // namespace

bool BandMaterial::is_lamp() const { return any_above_zero(emittance); }

std::vector<Vec3> PatchSet::eyes() const {
  std::vector<Vec3> eyes;
  for (const auto& camera : cameras) eyes.push_back(camera.eye);
  return eyes;
}

bool PatchSet::has_colours() const {
  static const std::vector<std::string> rgb = {"red", "green", "blue"};
  return wavebands.empty() ? bands == rgb : wavebands.size() == bands.size();
}

BandColours PatchSet::colours() const {
  if (!has_colours())
    throw with_hints(MismatchError(fmt::format(
                         "colours need the bands red, green, blue in this order, or wavelengths, but there "
                         "are {}: solve the scene with plain colour or by wavelength",
                         bands.empty() ? "none" : fmt::format("{}", fmt::join(bands, ", ")))),
                     {{Setting::spectral}});
  return BandColours(wavebands);
}

bool PatchSet::has_sky() const { return any_above_zero(sky); }

}  // namespace luxel
