// SPDX-License-Identifier: Apache-2.0
#include "luxel/image/tone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/image/curve.h"

namespace luxel {
namespace {

constexpr std::array<std::pair<ToneOperator, std::string_view>, 4> names = {{
    {ToneOperator::maximum, "maximum"},
    {ToneOperator::clamp, "clamp"},
    {ToneOperator::reinhard, "reinhard"},
    {ToneOperator::reinhard_local, "reinhard-local"},
}};

constexpr float brightest = 1e30f;  // in place of infinity

void check(const ToneOptions& options) {
  if (!(std::abs(options.exposure) <= 64.0f))
    throw InputError(fmt::format("the exposure is {} stops, expected -64 to 64", options.exposure));
  if (!(options.key > 0.0f && options.key <= 1.0f))
    throw InputError(fmt::format("the key is {}, expected more than 0 and at most 1", options.key));
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
double log_average(std::span<const Vec3> radiance, std::span<const float> weights) {
  double sum = 0.0;
  double area = 0.0;
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    const double L = luminance(radiance[i]);
    const double weight = weights[i];
    if (!(L > 0.0 && std::isfinite(L) && weight > 0.0 && std::isfinite(weight))) continue;
    sum += weight * std::log(L);
    area += weight;
  }
  return area > 0.0 ? std::exp(sum / area) : 0.0;
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

double reinhard(double L, double surround, double white) {
  const double burn_out = white > 0.0 ? 1.0 + L / (white * white) : 1.0;
  return L * burn_out / (1.0 + surround);
}

Vec3 with_luminance(const Vec3& clean, double scale, double L, double display) {
  const double factor = L > 0.0 ? scale * (display / L) : 0.0;
  return Vec3(glm::min(factor * Vec3d(clean), Vec3d(1.0)));
}

Vec3 ToneCurve::operator()(const Vec3& radiance) const {
  const auto clean = clean_color(radiance);
  const double L = static_cast<double>(scale) * luminance(clean);
  const bool is_curved = options.op == ToneOperator::reinhard || options.op == ToneOperator::reinhard_local;
  return with_luminance(clean, scale, L, is_curved ? reinhard(L, L, options.white) : L);
}

ToneCurve fit_curve(std::span<const Vec3> radiance, std::span<const float> weights,
                    const ToneOptions& options) {
  check(options);
  const double largest = max_channel(radiance, weights);
  if (!(largest > 0.0)) return {.options = options};
  double scale = std::exp2(options.exposure);
  if (options.op == ToneOperator::maximum) scale /= largest;
  if (options.op == ToneOperator::reinhard || options.op == ToneOperator::reinhard_local) {
    const double average = log_average(radiance, weights);
    if (average > 0.0) scale *= options.key / average;
  }
  constexpr double most = std::numeric_limits<float>::max();
  return {.options = options, .scale = static_cast<float>(std::min(scale, most))};
}

}  // namespace luxel
