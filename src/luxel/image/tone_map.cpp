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

Image map_local(const Image& radiance, const ToneCurve& curve) {
  const auto inputs = curve_inputs(radiance, curve.scale);
  const auto key = reinhard_key(curve.options) * std::exp2(static_cast<double>(curve.options.exposure));
  const auto adaptation = local_adaptation(inputs, key);
  Image display(radiance.width, radiance.height);
  for (std::size_t p = 0; p < display.pixels.size(); ++p) {
    const auto clean = clean_color(radiance.pixels[p]);
    const double L = static_cast<double>(curve.scale) * luminance(clean);
    const double shown = reinhard(L, adaptation.values[p], curve.options.white);
    display.pixels[p] = with_luminance(clean, curve.scale, L, shown);
  }
  return display;
}

}  // namespace

Image tone_map(const Image& radiance, const ToneOptions& options) {
  const std::vector<float> weights(radiance.pixels.size(), 1.0f);
  const auto curve = fit_curve(radiance.pixels, weights, options);
  if (options.op == ToneOperator::reinhard_local) return map_local(radiance, curve);
  Image display(radiance.width, radiance.height);
  std::transform(radiance.pixels.begin(), radiance.pixels.end(), display.pixels.begin(), curve);
  return display;
}

}  // namespace luxel
