// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/perez_sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "luxel/core/trig.h"
#include "luxel/photometry/sky_integrals.h"

namespace luxel {
namespace {

constexpr double solar_constant = 1367.0;  // W/m², as Perez has it

// Lower limits of clearness of bins 2 to 8.
constexpr std::array<double, 7> bin_limits = {1.065, 1.23, 1.5, 1.95, 2.8, 4.5, 6.2};

// Perez 1993, table 1: per bin x1 to x4 of the parameters a, b, c, d, e.
constexpr std::array<std::array<std::array<double, 4>, 5>, 8> distribution = {{
    {{{1.3525, -0.2576, -0.2690, -1.4366},
      {-0.7670, 0.0007, 1.2734, -0.1233},
      {2.8000, 0.6004, 1.2375, 1.0000},
      {1.8734, 0.6297, 0.9738, 0.2809},
      {0.0356, -0.1246, -0.5718, 0.9938}}},
    {{{-1.2219, -0.7730, 1.4148, 1.1016},
      {-0.2054, 0.0367, -3.9128, 0.9156},
      {6.9750, 0.1774, 6.4477, -0.1239},
      {-1.5798, -0.5081, -1.7812, 0.1080},
      {0.2624, 0.0672, -0.2190, -0.4285}}},
    {{{-1.1000, -0.2515, 0.8952, 0.0156},
      {0.2782, -0.1812, -4.5000, 1.1766},
      {24.7219, -13.0812, -37.7000, 34.8438},
      {-5.0000, 1.5218, 3.9229, -2.6204},
      {-0.0156, 0.1597, 0.4199, -0.5562}}},
    {{{-0.5484, -0.6654, -0.2672, 0.7117},
      {0.7234, -0.6219, -5.6812, 2.6297},
      {33.3389, -18.3000, -62.2500, 52.0781},
      {-3.5000, 0.0016, 1.1477, 0.1062},
      {0.4659, -0.3296, -0.0876, -0.0329}}},
    {{{-0.6000, -0.3566, -2.5000, 2.3250},
      {0.2937, 0.0496, -5.6812, 1.8415},
      {21.0000, -4.7656, -21.5906, 7.2492},
      {-3.5000, -0.1554, 1.4062, 0.3988},
      {0.0032, 0.0766, -0.0656, -0.1294}}},
    {{{-1.0156, -0.3670, 1.0078, 1.4051},
      {0.2875, -0.5328, -3.8500, 3.3750},
      {14.0000, -0.9999, -7.1406, 7.5469},
      {-3.4000, -0.1078, -1.0750, 1.5702},
      {-0.0672, 0.4016, 0.3017, -0.4844}}},
    {{{-1.0000, 0.0211, 0.5025, -0.5119},
      {-0.3000, 0.1922, 0.7023, -1.6317},
      {19.0000, -5.0000, 1.2438, -1.9094},
      {-4.0000, 0.0250, 0.3844, 0.2656},
      {1.0468, -0.3788, -2.4517, 1.4656}}},
    {{{-1.0500, 0.0289, 0.4260, 0.3590},
      {-0.3250, 0.1156, 0.7781, 0.0025},
      {31.0625, -14.5000, -46.1148, 55.3750},
      {-7.2312, 0.4050, 13.3500, 0.6234},
      {1.5000, -0.6426, 1.8564, 0.5636}}},
}};

struct Efficacy {
  double a, b, c, d;
};

// Perez 1990, table 4, lm/W: of the sky (equation 7) and of the sun (equation 8).
constexpr std::array<Efficacy, 8> diffuse_efficacy = {{{97.24, -0.46, 12.00, -8.91},
                                                       {107.22, 1.15, 0.59, -3.95},
                                                       {104.97, 2.96, -5.53, -8.77},
                                                       {102.39, 5.59, -13.95, -13.90},
                                                       {100.71, 5.94, -22.75, -23.74},
                                                       {106.42, 3.83, -36.15, -28.83},
                                                       {141.88, 1.90, -53.24, -14.03},
                                                       {152.23, 0.35, -45.27, -7.98}}};
constexpr std::array<Efficacy, 8> direct_efficacy = {{{57.20, -4.55, -2.98, 117.12},
                                                      {98.99, -3.46, -1.21, 12.38},
                                                      {109.83, -4.90, -1.71, -8.81},
                                                      {110.34, -5.84, -1.99, -4.56},
                                                      {106.36, -3.97, -1.75, -6.16},
                                                      {107.19, -1.25, -1.51, -26.73},
                                                      {105.75, 0.77, -1.26, -34.44},
                                                      {101.18, 1.58, -1.10, -8.29}}};

// F. Kasten, "A new table and approximation formula for the relative optical air mass", 1966. z: rad.
double air_mass(double z) {
  return 1.0 / (std::cos(z) + 0.15 * std::pow(93.885 - z * 180.0 / std::numbers::pi, -1.253));
}

// Perez 1993, equations 6 to 8. z: zenith angle of the sun, rad.
std::array<double, 5> parameters_of(std::size_t bin, double z, double brightness) {
  std::array<double, 5> parameters = {};
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto& x = distribution[bin][i];
    parameters[i] = x[0] + x[1] * z + brightness * (x[2] + x[3] * z);
  }
  if (bin != 0) return parameters;
  const auto &c = distribution[0][2], &d = distribution[0][3];
  parameters[2] = std::exp(std::pow(brightness * (c[0] + c[1] * z), c[2])) - c[3];
  parameters[3] = -std::exp(brightness * (d[0] + d[1] * z)) + d[2] + brightness * d[3];
  return parameters;
}

// The zenith and the sun have light in all but degenerate distributions; only those need the integral.
bool has_light(const SkyModel& model) {
  return model.relative_luminance({0.0, 0.0, 1.0}) > 0.0 || model.relative_luminance(model.sun()) > 0.0 ||
         relative_illuminances(model).horizontal > 0.0;
}

}  // namespace

PerezSky perez_sky(const PerezInput& input, const Vec3d& sun) {
  const auto direct = std::max(0.0, input.direct_normal), diffuse = std::max(0.0, input.diffuse_horizontal);
  const auto z = arc_cosine(std::max(0.0, sun.z));
  const auto cubed = 1.041 * z * z * z;
  PerezSky sky;
  // Where only the sun shines, the sky is as clear as can be.
  if (diffuse > 0.0)
    sky.clearness = std::max(1.0, ((diffuse + direct) / diffuse + cubed) / (1.0 + cubed));
  else if (direct > 0.0)
    sky.clearness = 12.0;
  sky.brightness = std::clamp(diffuse * air_mass(z) / (solar_constant * input.orbit_factor), 0.01, 0.6);
  const auto limit = std::upper_bound(bin_limits.begin(), bin_limits.end(), sky.clearness);
  const auto bin = static_cast<std::size_t>(limit - bin_limits.begin());
  sky.bin = static_cast<int>(bin) + 1;

  const auto water = std::exp(0.07 * input.dew_point - 0.075);  // precipitable, cm
  const auto &e = diffuse_efficacy[bin], &s = direct_efficacy[bin];
  sky.diffuse_illuminance =
      diffuse * std::max(0.0, e.a + e.b * water + e.c * std::cos(z) + e.d * std::log(sky.brightness));
  sky.direct_normal_illuminance =
      direct * std::max(0.0, s.a + s.b * water + s.c * std::exp(5.73 * z - 5.0) + s.d * sky.brightness);

  const bool is_intermediate = sky.clearness > 1.065 && sky.clearness < 2.8;
  sky.parameters = parameters_of(bin, z, is_intermediate ? std::max(0.2, sky.brightness) : sky.brightness);
  if (diffuse > 0.0) {
    const auto model = SkyModel::perez(sky.parameters, sun);
    if (has_light(model)) sky.model = model;
  }
  return sky;
}

}  // namespace luxel
