// SPDX-License-Identifier: Apache-2.0
#include "luxel/image/image.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace luxel {
namespace {

double decode(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

// The linear values at which the code steps from k to k + 1: where 255 encode equals k + 1/2.
std::array<float, 255> make_steps() {
  std::array<float, 255> steps;
  for (std::size_t k = 0; k < steps.size(); ++k)
    steps[k] = static_cast<float>(decode((static_cast<double>(k) + 0.5) / 255.0));
  return steps;
}

}  // namespace

float srgb_encode(float linear) {
  if (!(linear > 0.0f)) return 0.0f;
  if (linear >= 1.0f) return 1.0f;
  const double v = linear;
  return static_cast<float>(v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055);
}

float srgb_decode(float encoded) {
  if (!(encoded > 0.0f)) return 0.0f;
  return encoded < 1.0f ? static_cast<float>(decode(encoded)) : 1.0f;
}

std::uint8_t srgb_code(float linear) {
  static const auto steps = make_steps();
  if (std::isnan(linear)) return 0;
  return static_cast<std::uint8_t>(std::upper_bound(steps.begin(), steps.end(), linear) - steps.begin());
}

Vec3 mean_color(const Image& image) {
  Vec3d sum(0.0);
  for (const auto& pixel : image.pixels) sum += Vec3d(pixel);
  return image.pixels.empty() ? Vec3(0.0f) : Vec3(sum / static_cast<double>(image.pixels.size()));
}

}  // namespace luxel
