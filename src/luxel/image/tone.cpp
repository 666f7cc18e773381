// SPDX-License-Identifier: Apache-2.0
#include "luxel/image/tone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/image/curve.h"

namespace luxel {
namespace {

constexpr std::array<std::pair<ToneOperator, std::string_view>, tone_operators> names = {{
    {ToneOperator::neutral, "neutral"},
    {ToneOperator::maximum, "maximum"},
    {ToneOperator::clamp, "clamp"},
    {ToneOperator::reinhard, "reinhard"},
    {ToneOperator::reinhard_local, "reinhard-local"},
}};

constexpr double usual_key = 0.18;
constexpr float brightest = 1e30f;  // in place of infinity

void check(const ToneOptions& options) {
  if (!(std::abs(options.exposure) <= 64.0f))
    throw InputError(fmt::format("the exposure is {} stops, expected -64 to 64", options.exposure));
  if (!(options.key >= 0.0f && options.key <= 1.0f))
    throw InputError(fmt::format("the key is {}, expected 0 (automatic) to 1", options.key));
  if (options.scale && !(*options.scale > 0.0f && std::isfinite(*options.scale)))
    throw InputError(fmt::format("the scale of the tone curve is {}, expected more than 0", *options.scale));
  if (!(options.white >= 0.0f && std::isfinite(options.white)))
    throw InputError(fmt::format("the white is {}, expected 0 (none) or a luminance", options.white));
}

double max_channel(std::span<const Vec3> radiance, std::span<const float> weights) {
  float largest = 0.0f;
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    const auto& v = radiance[i];
    if (is_finite(v) && weights[i] > 0.0f) largest = std::max({largest, v.r, v.g, v.b});
  }
  return largest;
}

// Reinhard et al. 2002, equation 1 with areas for pixel counts. Their small delta, which avoids the logarithm
// of zero at black pixels, also lowers the mean by an amount that depends on its value; leaving black pixels
// out needs no such constant.
double log_average(std::span<const Vec3> radiance, std::span<const float> weights, double darkest = 0.0) {
  double sum = 0.0;
  double area = 0.0;
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    const double L = luminance(radiance[i]);
    const double weight = weights[i];
    if (!(L > 0.0 && L >= darkest && std::isfinite(L) && weight > 0.0 && std::isfinite(weight))) continue;
    sum += weight * std::log(L);
    area += weight;
  }
  return area > 0.0 ? std::exp(sum / area) : 0.0;
}

// The smallest luminance that is not below `fraction` of the weight of all lit colours; 0 where none is lit.
double quantile(std::span<const Vec3> radiance, std::span<const float> weights, double fraction) {
  std::vector<std::pair<float, double>> lit;
  double total = 0.0;
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    const float L = luminance(radiance[i]);
    const double weight = weights[i];
    if (!(L > 0.0f && std::isfinite(L) && weight > 0.0 && std::isfinite(weight))) continue;
    lit.emplace_back(L, weight);
    total += weight;
  }
  std::sort(lit.begin(), lit.end());
  double below = 0.0;
  for (const auto& [L, weight] : lit) {
    below += weight;
    if (below >= fraction * total) return L;
  }
  return lit.empty() ? 0.0 : lit.back().first;
}

// The scale of neutral, without the exposure. See automatic_key.
double neutral_scale(const ToneOptions& options, std::span<const Vec3> radiance,
                     std::span<const float> weights) {
  constexpr double bright_part = 0.9, bright = 0.6, dark = 0.01, darkest_average = 0.25,
                   brightest_average = 0.5;
  const double top = quantile(radiance, weights, bright_part);
  const double average = log_average(radiance, weights, dark * top);
  if (!(average > 0.0)) return 1.0;
  const double key = options.key != automatic_key
                         ? static_cast<double>(options.key)
                         : std::clamp(bright * average / top, darkest_average, brightest_average);
  return key / average;
}

}  // namespace

std::string_view name(ToneOperator op) {
  const auto found = std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.first == op; });
  return found->second;
}

std::optional<ToneOperator> tone_operator(std::string_view word) {
  for (const auto& [op, its_name] : names)
    if (its_name == word) return op;
  return std::nullopt;
}

Vec3 clean_color(const Vec3& radiance) {
  const auto clean = [](float v) { return v > 0.0f ? std::min(v, brightest) : 0.0f; };
  return {clean(radiance.r), clean(radiance.g), clean(radiance.b)};
}

double reinhard_key(const ToneOptions& options) {
  return options.key == automatic_key ? usual_key : static_cast<double>(options.key);
}

double reinhard(double L, double surround, double white) {
  const double burn_out = white > 0.0 ? 1.0 + L / (white * white) : 1.0;
  return L * burn_out / (1.0 + surround);
}

Vec3 with_luminance(const Vec3& clean, double scale, double L, double display) {
  const double factor = L > 0.0 ? scale * (display / L) : 0.0;
  return Vec3(glm::min(factor * Vec3d(clean), Vec3d(1.0)));
}

Vec3 neutral(const Vec3d& scaled) {
  constexpr double start = 0.76, room = 1.0 - start, desaturation = 0.15;
  const double peak = std::max({scaled.r, scaled.g, scaled.b});
  if (peak <= start) return Vec3(scaled);
  const double shown = 1.0 - room * room / (peak + room - start);
  const double to_white = 1.0 - 1.0 / (desaturation * (peak - shown) + 1.0);
  return Vec3(glm::mix(scaled * (shown / peak), Vec3d(shown), to_white));
}

Vec3 ToneCurve::operator()(const Vec3& radiance) const {
  const auto clean = clean_color(radiance);
  if (options.op == ToneOperator::neutral) return neutral(static_cast<double>(scale) * Vec3d(clean));
  const double L = static_cast<double>(scale) * luminance(clean);
  const bool is_curved = options.op == ToneOperator::reinhard || options.op == ToneOperator::reinhard_local;
  return with_luminance(clean, scale, L, is_curved ? reinhard(L, L, options.white) : L);
}

ToneCurve fit_curve(std::span<const Vec3> radiance, std::span<const float> weights,
                    const ToneOptions& options) {
  check(options);
  if (options.scale) return {.options = options, .scale = *options.scale * std::exp2(options.exposure)};
  const double largest = max_channel(radiance, weights);
  if (!(largest > 0.0)) return {.options = options};
  double scale = std::exp2(options.exposure);
  if (options.op == ToneOperator::maximum) scale /= largest;
  if (options.op == ToneOperator::neutral) scale *= neutral_scale(options, radiance, weights);
  if (options.op == ToneOperator::reinhard || options.op == ToneOperator::reinhard_local) {
    const double average = log_average(radiance, weights);
    if (average > 0.0) scale *= reinhard_key(options) / average;
  }
  constexpr double most = std::numeric_limits<float>::max();
  return {.options = options, .scale = static_cast<float>(std::min(scale, most))};
}

}  // namespace luxel
