// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/lit_sides.h"

#include <algorithm>
#include <cmath>
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

}  // namespace

LitSides make_lit_sides(const PatchSet& patches, const Solution& solution) {
  const auto irradiance = side_irradiance(patches, solution);
  double area = 0.0;
  double power = 0.0;
  for (std::size_t i = 0; i < irradiance.size(); ++i) {
    const auto a = static_cast<double>(patches.area[SideId::at(i).patch()]);
    area += a;
    power += a * irradiance[i];
  }
  const auto least = area > 0.0 ? dark * power / area : 0.0;

  // Log-average, weighted by power, so that a wide ground around a house has little weight.
  double log_sum = 0.0;
  double weight = 0.0;
  for (std::size_t i = 0; i < irradiance.size(); ++i) {
    if (!(irradiance[i] > least)) continue;
    const auto arriving = static_cast<double>(patches.area[SideId::at(i).patch()]) * irradiance[i];
    log_sum += arriving * std::log(irradiance[i]);
    weight += arriving;
  }
  const auto typical = weight > 0.0 ? std::exp(log_sum / weight) : 1.0;

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
