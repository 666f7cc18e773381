// SPDX-License-Identifier: Apache-2.0
#include "luxel/trace/seen_error.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "luxel/patch/side.h"

namespace luxel {
namespace {

constexpr double adaptation_fraction = 0.05;  // of a, below which differences of light are invisible
constexpr double max_of_median = 10.0;        // limit of the brightness of lamps
constexpr double floor_of_median_view = 0.1;  // of the median of a over views
constexpr double stated_quantile = 0.95;
// A view that adapts to less than this part of what nine views of ten stay below is in the dark.
constexpr double dark_part = 1e-4, bright_quantile = 0.9;

double median(std::vector<double>& values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double squared(double x) { return x * x; }

// The value that the fraction q of the weight stays below; 0 without values.
double quantile(const std::vector<double>& values, std::span<const float> weight, double q) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return values[a] < values[b]; });
  double below = 0.0;
  for (const auto v : order) {
    below += static_cast<double>(weight[v]);
    if (below >= q - 1e-6) return values[v];
  }
  return order.empty() ? 0.0 : values[order.back()];
}

// The level that an eye adapts to, from the radiances in its view.
double adaptation_to(std::vector<double> radiance) {
  const auto most = max_of_median * median(radiance);
  double sum = 0.0;
  for (const auto L : radiance) sum += std::min(L, most);
  return sum / static_cast<double>(std::max<std::size_t>(1, radiance.size()));
}

// 1 / (L + 0.05 a)², 0 without any light.
double sensitivity(double radiance, double adaptation) {
  const auto seen = radiance + adaptation;
  return seen > 0.0 ? 1.0 / squared(seen) : 0.0;
}

}  // namespace

bool reflects_nothing(const PatchSet& patches, const Views& views) {
  return std::none_of(views.sides.begin(), views.sides.end(), [&](SideId side) {
    for (std::size_t b = 0; b < patches.band_count(); ++b)
      if (patches.albedo(side.patch(), b) > 0.0f) return true;
    return false;
  });
}

SeenSide light_of_side(const PatchSet& patches, SideId side, const SideEstimate& here,
                       const SideEstimate& far, bool black) {
  const auto bands = patches.band_count();
  double squared_light = 0.0;
  double squared_error_sum = 0.0;
  for (std::size_t b = 0; b < bands; ++b) {
    const auto rho = black ? 1.0 : static_cast<double>(patches.reflectance(side.patch(), b));
    const auto emitted = !side.is_back() ? static_cast<double>(patches.emittance(side.patch(), b)) : 0.0;
    auto sent = rho * std::max(0.0, static_cast<double>(here.irradiance[b]));
    squared_error_sum += squared(rho) * here.squared_error[b];
    if (const auto tau = static_cast<double>(patches.diffuse_transmittance(side.patch(), b)); tau > 0.0) {
      sent += tau * std::max(0.0, static_cast<double>(far.irradiance[b]));
      squared_error_sum += squared(tau) * far.squared_error[b];
    }
    squared_light += squared(emitted + sent);
  }
  const auto scale = 1.0 / (squared(std::numbers::pi) * static_cast<double>(bands));
  return {static_cast<float>(std::sqrt(scale * squared_light)),
          static_cast<float>(scale * squared_error_sum)};
}

float sky_radiance(const PatchSet& patches) {
  double sum = 0.0;
  const auto sky = patches.mean_sky();
  for (const auto radiance : sky) sum += squared(static_cast<double>(radiance));
  return sky.empty() ? 0.0f : static_cast<float>(std::sqrt(sum / static_cast<double>(sky.size())));
}

SeenError::SeenError(const Views& views, const SeenLight& light)
    : views_(views), light_(light), weight_(views.weight) {
  for (std::size_t v = 0; v < views.size(); ++v) adaptation_.push_back(adaptation_to(radiances(v, 0.0)));
  leave_out_dark_views();
  std::vector<double> lit;
  for (std::size_t v = 0; v < views.size(); ++v)
    if (weight_[v] > 0.0f) lit.push_back(adaptation_[v]);
  const auto least = floor_of_median_view * median(lit);
  for (auto& a : adaptation_) a = adaptation_fraction * std::max(a, least);
  error_ = errors(light.squared_error);
}

std::vector<double> SeenError::radiances(std::size_t view, double errors_added) const {
  std::vector<double> result;
  for (const auto code : views_.seen_by(view)) {
    if (code == Views::sky) {
      result.push_back(static_cast<double>(light_.sky));
      continue;
    }
    const auto s = code & ~Views::unfocused;
    const auto error = std::sqrt(std::max(0.0, static_cast<double>(light_.squared_error[s])));
    result.push_back(static_cast<double>(light_.radiance[s]) + errors_added * error);
  }
  return result;
}

void SeenError::leave_out_dark_views() {
  const auto limit = dark_part * quantile(adaptation_, weight_, bright_quantile);
  for (std::size_t v = 0; v + views_.cameras < weight_.size(); ++v)
    if (adaptation_[v] < limit && adaptation_to(radiances(v, 1.0)) < limit) weight_[v] = 0.0f;
  const auto sum = std::accumulate(weight_.begin(), weight_.end(), 0.0);
  for (auto& w : weight_) w = static_cast<float>(static_cast<double>(w) / sum);
}

std::vector<double> SeenError::errors(std::span<const float> squared_error) const {
  std::vector<double> result(views_.size());
  for (std::size_t v = 0; v < result.size(); ++v) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const auto s : views_.seen_by(v)) {
      if (s >= Views::sky) continue;  // sky, or outside of the focus
      ++count;
      sum += static_cast<double>(squared_error[s]) *
             sensitivity(static_cast<double>(light_.radiance[s]), adaptation_[v]);
    }
    result[v] = count > 0 ? std::sqrt(std::max(0.0, sum) / static_cast<double>(count)) : 0.0;
  }
  return result;
}

double SeenError::percentile_95() const { return quantile(error_, weight_, stated_quantile); }

double SeenError::percentile_95(std::span<const float> squared_error) const {
  return quantile(errors(squared_error), weight_, stated_quantile);
}

std::vector<Attention> SeenError::attention() const {
  const auto worst = percentile_95();
  std::vector<Attention> result(views_.sides.size());
  std::vector<double> importance(views_.sides.size(), 0.0);
  double sum = 0.0;
  for (std::size_t v = 0; v < views_.size(); ++v) {
    const auto seen = views_.seen_by(v);
    const auto count = std::count_if(seen.begin(), seen.end(), [](auto s) { return s < Views::sky; });
    const auto pressure = static_cast<double>(weight_[v]) * squared(squared(std::min(error_[v], worst)));
    sum += pressure * squared(error_[v]);
    for (const auto s : seen) {
      if (s >= Views::sky) continue;
      const auto weight = pressure / static_cast<double>(count);
      result[s].weight += weight;
      importance[s] += weight * sensitivity(static_cast<double>(light_.radiance[s]), adaptation_[v]);
    }
  }
  // The mean of the adaptations that gives the importance at the radiance of the side.
  const auto scale = sum > 0.0 ? squared(worst) / sum : 0.0;
  for (std::size_t s = 0; s < result.size(); ++s) {
    if (!(importance[s] > 0.0)) continue;
    result[s].adaptation =
        std::max(0.0, std::sqrt(result[s].weight / importance[s]) - static_cast<double>(light_.radiance[s]));
    result[s].weight *= scale;
  }
  return result;
}

}  // namespace luxel
