// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/colour_spectra.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/scene/observer.h"

namespace luxel {
namespace {

constexpr double middle = 550.0;      // nm
constexpr double half_range = 150.0;  // nm
constexpr float below_one = 0x1.fffffep-1f;

double sigmoid(double x) { return 0.5 + 0.5 * x / std::sqrt(1.0 + x * x); }
double slope_of_sigmoid(double x) { return 0.5 / ((1.0 + x * x) * std::sqrt(1.0 + x * x)); }
double inverse_sigmoid(double y) {
  const auto t = 2.0 * y - 1.0;
  return t / std::sqrt(1.0 - t * t);
}

bool is_grey(const Vec3d& rgb) { return rgb.r == rgb.g && rgb.g == rgb.b; }

// Finds the parabola whose sigmoid has the colour, by Levenberg-Marquardt steps from the grey of the same
// mean. colour_of(parabola, derivative): the colour of that surface, and its derivative.
template <typename ColourOf>
Vec3d find_parabola(const Vec3d& rgb, const ColourOf& colour_of) {
  constexpr int max_steps = 200;
  constexpr double near_enough = 1e-9;
  Vec3d best(inverse_sigmoid(std::clamp((rgb.r + rgb.g + rgb.b) / 3.0, 0.01, 0.99)), 0.0, 0.0);
  glm::dmat3 derivative;
  auto miss = rgb - colour_of(best, derivative);
  double damping = 1e-3;
  for (int step = 0; step < max_steps && glm::length(miss) > near_enough; ++step) {
    const auto transposed = glm::transpose(derivative);
    auto normal = transposed * derivative;
    for (int i = 0; i < 3; ++i) normal[i][i] += damping * normal[i][i] + 1e-18;
    const auto tried = best + glm::inverse(normal) * (transposed * miss);
    glm::dmat3 derivative_there;
    const auto miss_there = rgb - colour_of(tried, derivative_there);
    if (glm::length(miss_there) < glm::length(miss)) {
      best = tried;
      miss = miss_there;
      derivative = derivative_there;
      damping *= 0.1;
    } else {
      damping *= 10.0;
    }
  }
  return best;
}

}  // namespace

ColourSpectra::ColourSpectra(const std::vector<Waveband>& wavebands) : colours_(wavebands) {
  if (wavebands.empty() || wavebands.front().wavelength > spectra_begin ||
      wavebands.back().wavelength < spectra_end)
    throw InputError(
        fmt::format("the wavelengths reach from {:g} to {:g} nm, but colours need {:g} to {:g} nm or more",
                    wavebands.empty() ? 0.0 : wavebands.front().wavelength,
                    wavebands.empty() ? 0.0 : wavebands.back().wavelength, spectra_begin, spectra_end));
  std::vector<double> daylight;
  glm::dmat3 fractions(0.0);  // the colours of daylight times each power
  for (std::size_t b = 0; b < wavebands.size(); ++b) {
    const auto u = (wavebands[b].wavelength - middle) / half_range;
    powers_.emplace_back(1.0, u, u * u);
    daylight.push_back(wavebands[b].width * daylight_d65().at(wavebands[b].wavelength, Beyond::holds));
    for (int k = 0; k < 3; ++k) fractions[k] += powers_[b][k] * daylight[b] * colours_.of(b);
  }
  const auto bend = glm::inverse(fractions) * Vec3d(1.0);
  for (std::size_t b = 0; b < wavebands.size(); ++b)
    white_.push_back(daylight[b] * std::max(0.0, glm::dot(bend, powers_[b])));
}

std::vector<double> ColourSpectra::surface(const Vec3d& rgb) const {
  if (is_grey(rgb)) return std::vector<double>(white_.size(), rgb.r);
  const auto parabola = find_parabola(rgb, [this](const Vec3d& at, glm::dmat3& derivative) {
    Vec3d colour(0.0);
    derivative = glm::dmat3(0.0);
    for (std::size_t b = 0; b < white_.size(); ++b) {
      const auto x = glm::dot(at, powers_[b]);
      const auto shown = white_[b] * colours_.of(b);
      colour += sigmoid(x) * shown;
      for (int k = 0; k < 3; ++k) derivative[k] += slope_of_sigmoid(x) * powers_[b][k] * shown;
    }
    return colour;
  });
  std::vector<double> reflected;
  for (const auto& power : powers_) reflected.push_back(sigmoid(glm::dot(parabola, power)));
  return reflected;
}

std::vector<float> ColourSpectra::reflectance(const Vec3& rgb) const {
  std::vector<float> result;
  for (const auto r : surface(Vec3d(rgb))) result.push_back(std::min(below_one, static_cast<float>(r)));
  return result;
}

// As a surface of half the maximum brightness, where spectra are smoothest, scaled up afterwards.
std::vector<float> ColourSpectra::tint(const Vec3& rgb) const {
  const auto scale = 2.0 * static_cast<double>(std::max({rgb.r, rgb.g, rgb.b}));
  std::vector<float> result(white_.size(), 0.0f);
  if (!(scale > 0.0)) return result;
  const auto colour = surface(Vec3d(rgb) / scale);
  for (std::size_t b = 0; b < white_.size(); ++b) result[b] = static_cast<float>(scale * colour[b]);
  return result;
}

std::vector<float> ColourSpectra::light(const Vec3& rgb) const {
  auto result = tint(rgb);
  for (std::size_t b = 0; b < white_.size(); ++b)
    result[b] = static_cast<float>(static_cast<double>(result[b]) * white_[b]);
  return result;
}

}  // namespace luxel
