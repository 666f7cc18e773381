// SPDX-License-Identifier: Apache-2.0
#include "scenes/luminaires/luminaires.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "luxel/photometry/photometry.h"

namespace luxel::scenes {
namespace {

double sine(double degrees) { return std::sin(degrees * std::numbers::pi / 180.0); }
double cosine(double degrees) { return std::max(0.0, std::cos(degrees * std::numbers::pi / 180.0)); }

std::vector<double> range(double first, double last, double step) {
  std::vector<double> all;
  for (double angle = first; angle <= last + 1e-9; angle += step) all.push_back(angle);
  return all;
}

// Fills per_klm from a shape, whose scale does not matter; arguments: vertical and horizontal angle. Rounded
// to 0.01 cd.
void fill(MadeLuminaire& made, const std::function<double(double, double)>& shape) {
  for (const auto h : made.horizontal)
    for (const auto v : made.vertical) made.per_klm.push_back(shape(v, h));
  const IntensityDistribution unscaled(GoniometerType::c, made.vertical, made.horizontal, made.per_klm);
  const auto scale = 1000.0 * made.efficiency / unscaled.zonal_flux();
  for (auto& value : made.per_klm) value = std::round(100.0 * scale * value) / 100.0;
}

// Prisms take light from steep angles; a little more along the tubes of light than across.
MadeLuminaire led_panel() {
  MadeLuminaire made{.name = "led-panel", .about = "recessed LED panel, 0.6 x 0.6 m, 4000 lm"};
  made.vertical = range(0.0, 90.0, 5.0);
  made.horizontal = range(0.0, 90.0, 15.0);
  made.lamp_flux = 4000.0;
  made.watts = 32.0;
  made.size = {0.6, 0.6, 0.0};
  fill(made, [](double v, double h) {
    const auto cut = 1.0 / (1.0 + std::exp((v - 62.0 - 4.0 * cosine(h) * sine(v)) / 7.0));
    return cosine(v) * (0.25 + 0.75 * cut);
  });
  return made;
}

// Two lobes downwards across the length, and light on the ceiling.
MadeLuminaire linear_pendant() {
  MadeLuminaire made{.name = "linear-pendant",
                     .about = "linear pendant, 1.2 m, direct and indirect, 5000 lm"};
  made.vertical = range(0.0, 180.0, 5.0);
  made.horizontal = range(0.0, 90.0, 15.0);
  made.lamp_flux = 5000.0;
  made.watts = 38.0;
  made.size = {1.2, 0.06, 0.04};
  fill(made, [](double v, double h) {
    const auto across = sine(h) * sine(h);
    if (v < 90.0)
      return cosine(v) * (1.0 + 1.6 * across * sine(v) * sine(v)) / (1.0 + std::exp((v - 60.0) / 6.0));
    const auto up = 180.0 - v;
    return 0.55 * cosine(up) * (0.6 + (0.4 + 0.9 * across) * sine(up));
  });
  return made;
}

// A Gaussian beam of 16 degrees at half of the maximum, and a faint halo.
MadeLuminaire spotlight() {
  MadeLuminaire made{.name = "spotlight", .about = "round spotlight, beam of 16 degrees, 1800 lm"};
  made.vertical = range(0.0, 30.0, 1.0);
  for (const auto v : range(35.0, 90.0, 5.0)) made.vertical.push_back(v);
  made.horizontal = {0.0};
  made.lamp_flux = 1800.0;
  made.watts = 18.0;
  made.size = {0.08, 0.08, 0.0};
  made.round = true;
  fill(made, [](double v, double) {
    return std::exp(-std::numbers::ln2 * v * v / 64.0) + 0.02 * std::pow(cosine(v), 4.0);
  });
  return made;
}

// The lamp's light goes to one side, at most 35 degrees from straight down.
MadeLuminaire wall_washer() {
  MadeLuminaire made{.name = "wall-washer", .about = "asymmetric wall washer, 0.9 m, lamps of 3600 lm"};
  made.vertical = range(0.0, 90.0, 2.5);
  made.horizontal = range(90.0, 270.0, 15.0);
  made.lamp_flux = 3600.0;
  made.efficiency = 0.8;
  made.absolute = false;
  made.watts = 30.0;
  made.size = {0.9, 0.08, 0.0};
  fill(made, [](double v, double h) {
    // Angle of the direction in the plane across the length, towards the wall; and along the length.
    const auto x = sine(v) * std::cos(h * std::numbers::pi / 180.0), y = sine(v) * sine(h), z = cosine(v);
    const auto across = std::atan2(y, z) * 180.0 / std::numbers::pi;
    const auto along = std::atan2(x, std::hypot(y, z)) * 180.0 / std::numbers::pi;
    const auto spread = across > 35.0 ? 18.0 : 30.0;
    const auto beam = std::exp(-0.5 * (across - 35.0) * (across - 35.0) / (spread * spread));
    return beam * cosine(along) * std::min(1.0, 8.0 * z);
  });
  return made;
}

}  // namespace

std::span<const MadeLuminaire> luminaire_list() {
  static const std::vector<MadeLuminaire> list = {led_panel(), linear_pendant(), spotlight(), wall_washer()};
  return list;
}

}  // namespace luxel::scenes
