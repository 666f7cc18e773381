// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/patch_set.h"

#include <algorithm>
#include <numeric>

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

bool PatchSet::has_diffusers() const {
  return std::any_of(materials.begin(), materials.end(), [](const auto& m) { return m.is_diffuser(); });
}

bool PatchSet::has_sky() const { return any_above_zero(sky); }

std::vector<double> PatchSet::open_irradiance() const {
  std::vector<double> sum(sky.empty() ? 0 : bands.size(), 0.0);
  if (has_even_sky())
    for (std::size_t b = 0; b < sum.size(); ++b) sum[b] = sky_radiosity(0, b);
  else
    for (std::size_t i = 0; i < sky.size(); ++i)
      sum[i % bands.size()] +=
          std::max(0.0, sky_patches.projected_solid_angle(i / bands.size())) * static_cast<double>(sky[i]);
  return sum;
}

std::vector<float> PatchSet::mean_sky() const {
  if (sky.empty() || has_even_sky()) return sky;
  const bool whole = sky_patches.lower_half() == LowerHalf::mirrored;
  std::vector<double> sum(bands.size(), 0.0);
  double angle = 0.0;
  for (std::size_t p = whole ? 0 : 1; p < sky_patches.size(); ++p) {
    const auto own = sky_patches.solid_angle(p);
    angle += own;
    for (std::size_t b = 0; b < sum.size(); ++b) sum[b] += own * static_cast<double>(sky[p * sum.size() + b]);
  }
  std::vector<float> mean;
  for (const auto s : sum) mean.push_back(static_cast<float>(s / angle));
  return mean;
}

double PatchSet::ground_over_sky() const {
  if (!has_sky() || has_even_sky() || sky_patches.lower_half() == LowerHalf::mirrored) return 1.0;
  const auto above = mean_sky();
  const auto of_sky = std::accumulate(above.begin(), above.end(), 0.0);
  const auto ground = sky.begin();
  const auto of_ground = std::accumulate(ground, ground + static_cast<std::ptrdiff_t>(above.size()), 0.0);
  return of_sky > 0.0 ? of_ground / of_sky : 1.0;
}

}  // namespace luxel
