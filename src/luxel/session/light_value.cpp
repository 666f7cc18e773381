// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/light_value.h"

#include <cmath>
#include <span>
#include <vector>

#include "luxel/scene/band_colours.h"
#include "luxel/surface/smooth_irradiance.h"

namespace luxel {
namespace {

double sum(std::span<const double> values) {
  double all = 0.0;
  for (const auto v : values) all += v;
  return all;
}

std::vector<double> of_patch(const std::vector<float>& values, std::size_t patch, std::size_t bands) {
  const auto* from = values.data() + patch * bands;
  return {from, from + bands};
}

LightValue value_of(const BandColours& colours, std::span<const double> light,
                    std::span<const double> error) {
  LightValue value{.watts = sum(light), .lux = colours.lumens(light), .watts_error = {}, .lux_error = {}};
  if (error.empty()) return value;
  value.watts_error = sum(error);
  double lux = 0.0;
  std::vector<double> one(error.size(), 0.0);
  for (std::size_t b = 0; b < error.size(); ++b) {
    one[b] = error[b];
    lux += std::abs(colours.lumens(one));
    one[b] = 0.0;
  }
  value.lux_error = lux;
  return value;
}

}  // namespace

LightValue irradiance_of(const SessionLight& light, std::size_t patch, bool back) {
  const auto& s = light.solution;
  const auto bands = s.bands.size();
  const auto& error = s.standard_error.of(back);
  return value_of(light.mesh.patches->colours(), of_patch(s.irradiance.of(back), patch, bands),
                  error.empty() ? std::vector<double>() : of_patch(error, patch, bands));
}

LightValue radiosity_of(const SessionLight& light, std::size_t patch, bool back) {
  const auto& s = light.solution;
  const auto bands = s.bands.size();
  const auto& error = s.standard_error.of(back);
  std::vector<double> reflected;
  if (!error.empty()) {
    reflected = of_patch(error, patch, bands);
    const auto& patches = *light.mesh.patches;
    for (std::size_t b = 0; b < bands; ++b) {
      reflected[b] *= patches.reflectance(patch, b);
      if (const double tau = patches.diffuse_transmittance(patch, b); tau > 0.0)
        reflected[b] = std::hypot(reflected[b], tau * s.standard_error.of(!back)[patch * bands + b]);
    }
  }
  return value_of(light.mesh.patches->colours(), of_patch(s.radiosity.of(back), patch, bands), reflected);
}

LightValue smooth_irradiance(const SessionLight& light, std::size_t patch, bool back, float u, float v) {
  const auto bands = light.solution.bands.size();
  std::vector<double> sum(bands);
  for (std::size_t b = 0; b < bands; ++b)
    sum[b] = smooth_irradiance(*light.smooth, SideId(patch, back), {u, v}, b, bands);
  return value_of(light.mesh.patches->colours(), sum, {});
}

}  // namespace luxel
