// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "luxel/image/blur.h"
#include "luxel/image/curve.h"
#include "luxel/image/local_scales.h"
#include "luxel/image/tone.h"

namespace luxel {
namespace {

GreyPicture curve_inputs(const Image& radiance, float scale) {
  GreyPicture plane{radiance.width, radiance.height, {}};
  plane.values.reserve(radiance.pixels.size());
  for (const auto& pixel : radiance.pixels)
    plane.values.push_back(std::min(scale * luminance(clean_color(pixel)), LocalScales::brightest));
  return plane;
}

// V1 at the largest scale around each pixel that shows no edge: equations 5 to 8. The surround of one scale
// is the centre of the next, as both grow by the same ratio, so nine blurs serve eight scales.
GreyPicture local_adaptation(const GreyPicture& inputs, double key) {
  using S = LocalScales;
  auto centre = gaussian_blur(inputs, static_cast<float>(S::smallest));
  auto adaptation = centre;
  std::vector<char> is_open(inputs.values.size(), 1);
  double s = 1.0;
  for (int i = 0; i < S::count; ++i, s *= S::ratio) {
    auto surround = gaussian_blur(inputs, static_cast<float>(S::smallest * s * S::ratio));
    const auto level = static_cast<float>(std::exp2(S::phi) * key / (s * s));  // equation 7
    for (std::size_t p = 0; p < is_open.size(); ++p) {
      const float V1 = centre.values[p];
      is_open[p] = is_open[p] && std::abs(V1 - surround.values[p]) < S::epsilon * (level + V1);
      if (is_open[p]) adaptation.values[p] = V1;
    }
    centre = std::move(surround);
  }
  return adaptation;
}

// Maps every pixel by map(radiance, pixel), those on edges part by part.
template <typename Map>
Image mapped(const Image& radiance, const EdgePixels& edges, const Map& map) {
  Image display(radiance.width, radiance.height);
  for (std::size_t p = 0; p < display.pixels.size(); ++p) display.pixels[p] = map(radiance.pixels[p], p);
  for (std::size_t e = 0; e < edges.pixels.size(); ++e) {
    const auto p = edges.pixels[e];
    Vec3d sum(0.0);
    for (std::size_t part = 0; part < edges.parts; ++part)
      sum += Vec3d(map(edges.radiance[e * edges.parts + part], p));
    display.pixels[p] = Vec3(sum / static_cast<double>(edges.parts));
  }
  return display;
}

Image map_local(const Image& radiance, const ToneCurve& curve, const EdgePixels& edges) {
  const auto inputs = curve_inputs(radiance, curve.scale);
  const auto key = reinhard_key(curve.options) * std::exp2(static_cast<double>(curve.options.exposure));
  const auto adaptation = local_adaptation(inputs, key);
  return mapped(radiance, edges, [&](const Vec3& colour, std::size_t p) {
    const auto clean = clean_color(colour);
    const double L = static_cast<double>(curve.scale) * luminance(clean);
    return with_luminance(clean, curve.scale, L, reinhard(L, adaptation.values[p], curve.options.white));
  });
}

}  // namespace

std::vector<float> exposure_weights(const Image& radiance, const SkyPixels& sky) {
  constexpr double fewest = 0.02;
  std::vector<float> weights(radiance.pixels.size(), 1.0f);
  double covered = 0.0;
  for (std::size_t i = 0; i < sky.pixels.size(); ++i) {
    weights[sky.pixels[i]] = 1.0f - sky.fraction[i];
    covered += static_cast<double>(sky.fraction[i]);
  }
  const auto all = static_cast<double>(weights.size());
  if (all - covered < fewest * all) std::fill(weights.begin(), weights.end(), 1.0f);
  return weights;
}

ToneCurve fit_curve(const Image& radiance, const SkyPixels& sky, const ToneOptions& options) {
  return fit_curve(radiance.pixels, exposure_weights(radiance, sky), options);
}

Image tone_map(const Image& radiance, const ToneOptions& options, const EdgePixels& edges,
               const SkyPixels& sky) {
  const auto curve = fit_curve(radiance, sky, options);
  auto shown = radiance;
  for (std::size_t i = 0; i < sky.pixels.size(); ++i) shown.pixels[sky.pixels[i]] = sky.radiance[i];
  if (options.op == ToneOperator::reinhard_local) return map_local(shown, curve, edges);
  return mapped(shown, edges, [&](const Vec3& colour, std::size_t) { return curve(colour); });
}

}  // namespace luxel
