// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "luxel/image/image.h"

namespace luxel {
namespace {

// sRGB codes at equal steps: "inferno" of N. Smith and S. van der Walt (CC0), and "RdBu" of C. Brewer,
// reversed.
using Anchors = std::array<std::uint32_t, 9>;
constexpr Anchors heat = {0x000004, 0x210c4a, 0x57106e, 0x8a226a, 0xbc3754,
                          0xe45a31, 0xf98e09, 0xf9cb35, 0xfcffa4};
constexpr Anchors difference = {0x053061, 0x2166ac, 0x4393c3, 0x92c5de, 0xf7f7f7,
                                0xf4a582, 0xd6604d, 0xb2182b, 0x67001f};

Vec3 codes(std::uint32_t rgb) { return Vec3(rgb >> 16u & 0xffu, rgb >> 8u & 0xffu, rgb & 0xffu) / 255.0f; }

}  // namespace

Vec3 map_colour(ColourMap map, float fraction) {
  if (std::isnan(fraction)) return Vec3(0.2f);
  const auto& anchors = map == ColourMap::heat ? heat : difference;
  const float place = std::clamp(fraction, 0.0f, 1.0f) * static_cast<float>(anchors.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(place), anchors.size() - 2);
  const auto mixed =
      glm::mix(codes(anchors[first]), codes(anchors[first + 1]), place - static_cast<float>(first));
  return {srgb_decode(mixed.r), srgb_decode(mixed.g), srgb_decode(mixed.b)};
}

float ValueScale::fraction(float value) const {
  if (!logarithmic) return (value - low) / (high - low);
  return value > 0.0f ? std::log(value / low) / std::log(high / low) : 0.0f;
}

float ValueScale::value_at(float fraction) const {
  return logarithmic ? low * std::pow(high / low, fraction) : low + fraction * (high - low);
}

float round_up(float value) {
  const float power = std::pow(10.0f, std::floor(std::log10(value)));
  for (const float step : {1.0f, 2.0f, 5.0f})
    if (step * power >= value * 0.9999f) return step * power;
  return 10.0f * power;
}

ValueScale automatic_value_scale(const std::vector<float>& values, bool logarithmic, ColourMap map) {
  std::vector<float> some;
  const std::size_t step = values.size() / 20'000 + 1;
  for (std::size_t i = 0; i < values.size(); i += step) {
    const float v = map == ColourMap::difference ? std::abs(values[i]) : values[i];
    if (std::isfinite(v) && (v > 0.0f || !logarithmic)) some.push_back(v);
  }
  ValueScale scale{.logarithmic = logarithmic, .map = map};
  const auto quantile = [&](double fraction) {
    const auto at =
        some.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(some.size() - 1));
    std::nth_element(some.begin(), at, some.end());
    return *at;
  };
  const float high = some.empty() ? 0.0f : quantile(0.98);
  scale.high = high > 0.0f ? round_up(high) : 1.0f;
  if (map == ColourMap::difference) scale.low = -scale.high;
  if (logarithmic) {
    const float low = some.empty() ? 0.0f : quantile(0.02);
    scale.low = low > 0.0f ? std::max(0.5f * round_up(low), scale.high * 1e-6f) : scale.high * 1e-3f;
    if (scale.low >= scale.high) scale.low = scale.high * 0.1f;
  }
  return scale;
}

std::string scale_text(float value) {
  if (value == 0.0f) return "0";
  const float size = std::abs(value);
  return size >= 1e5f || size < 1e-3f ? fmt::format("{:.2e}", value) : fmt::format("{:.3g}", value);
}

}  // namespace luxel
