// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/lit_sides.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "luxel/patch/side.h"

namespace luxel {
namespace {

constexpr double dark = 1e-4;  // fraction of the mean irradiance below which a side counts as unlit
constexpr double glare = 3.0;  // multiple of the typical irradiance above which an emitter glares

double mean(std::span<const float> bands) {
  double sum = 0.0;
  for (const auto b : bands) sum += static_cast<double>(b);
  return bands.empty() ? 0.0 : sum / static_cast<double>(bands.size());
}

// Irradiance of every side, averaged over bands; 1 everywhere if there is no light.
std::vector<double> side_irradiance(const PatchSet& patches, const Solution& solution) {
  const auto bands = patches.band_count();
  const auto solved = solution.irradiance.front.size() == patches.size() * bands &&
                      solution.irradiance.back.size() == patches.size() * bands;
  std::vector<double> irradiance(side_count(patches.size()), 0.0);
  double total = 0.0;
  for (std::size_t p = 0; solved && p < patches.size(); ++p) {
    const SideId front(p, false), back(p, true);
    for (const auto side : {front, back})
      irradiance[side.index()] = mean(std::span(solution.irradiance.of(side)).subspan(p * bands, bands));
    total += irradiance[front.index()] + irradiance[back.index()];
  }
  if (!(total > 0.0)) irradiance.assign(side_count(patches.size()), 1.0);
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (!patches.material_of(p).two_sided) irradiance[SideId(p, true).index()] = 0.0;
  return irradiance;
}

// The log-average, weighted by power, so that a wide ground around a house has little weight.
double typical_by_power(const PatchSet& patches, const std::vector<double>& irradiance, double least) {
  double log_sum = 0.0;
  double weight = 0.0;
  for (std::size_t i = 0; i < irradiance.size(); ++i) {
    if (!(irradiance[i] > least)) continue;
    const auto arriving = static_cast<double>(patches.area[SideId::at(i).patch()]) * irradiance[i];
    log_sum += arriving * std::log(irradiance[i]);
    weight += arriving;
  }
  return weight > 0.0 ? std::exp(log_sum / weight) : 1.0;
}

// The log-average of what views see, and of this over the views, weighted by itself, so that dim rooms have
// little weight. Nothing where no view sees light.
std::optional<double> typical_of_views(const Views& views, const std::vector<double>& irradiance,
                                       double least) {
  double log_sum = 0.0;
  double weight = 0.0;
  for (std::size_t v = 0; v < views.size(); ++v) {
    double sum = 0.0;
    double lit = 0.0;
    for (const auto code : views.seen_by(v)) {
      const auto at = code & ~Views::unfocused;
      const auto light = at == Views::sky ? 0.0 : irradiance[views.sides[at].index()];
      if (!(light > least)) continue;
      sum += std::log(light);
      lit += 1.0;
    }
    if (lit == 0.0) continue;
    const auto of_view = static_cast<double>(views.weight[v]) * std::exp(sum / lit);
    log_sum += of_view * sum / lit;
    weight += of_view;
  }
  return weight > 0.0 ? std::optional(std::exp(log_sum / weight)) : std::nullopt;
}

}  // namespace

LitSides make_lit_sides(const PatchSet& patches, const Solution& solution, const Views& views) {
  const auto irradiance = side_irradiance(patches, solution);
  double area = 0.0;
  double power = 0.0;
  for (std::size_t i = 0; i < irradiance.size(); ++i) {
    const auto a = static_cast<double>(patches.area[SideId::at(i).patch()]);
    area += a;
    power += a * irradiance[i];
  }
  const auto least = area > 0.0 ? dark * power / area : 0.0;

  const auto of_views = typical_of_views(views, irradiance, least);
  const auto typical = of_views ? *of_views : typical_by_power(patches, irradiance, least);

  LitSides sides;
  sides.brightness.assign(irradiance.size(), 0.0f);
  sides.glaring.assign(irradiance.size(), false);
  for (std::size_t i = 0; i < irradiance.size(); ++i) {
    const auto side = SideId::at(i);
    const auto emittance = side.is_back() ? 0.0 : mean(patches.material_of(side.patch()).emittance);
    sides.glaring[i] = emittance > glare * typical;
    const auto light = irradiance[i] + std::min(emittance, typical);
    if (!(light > least)) continue;
    const auto brightness = light / (light + typical);
    sides.brightness[i] = static_cast<float>(brightness);
    sides.lit_area += static_cast<double>(patches.area[side.patch()]) * brightness;
  }
  return sides;
}

}  // namespace luxel
