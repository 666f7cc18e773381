// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/lit_sides.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace luxel {
namespace {

constexpr double dark = 1e-4;  // of the mean irradiance: less is not lit but noise
constexpr double glare = 3.0;  // of the typical irradiance

double mean(std::span<const float> bands) {
  double sum = 0.0;
  for (const auto b : bands) sum += static_cast<double>(b);
  return bands.empty() ? 0.0 : sum / static_cast<double>(bands.size());
}

// Mean irradiance over bands of every side; ones where there is no light at all.
std::vector<double> side_irradiance(const PatchSet& patches, const Solution& solution) {
  const auto bands = patches.band_count();
  const auto solved = solution.irradiance_front.size() == patches.size() * bands &&
                      solution.irradiance_back.size() == patches.size() * bands;
  std::vector<double> irradiance(2 * patches.size(), 0.0);
  double total = 0.0;
  for (std::size_t i = 0; solved && i < patches.size(); ++i) {
    irradiance[2 * i] = mean(std::span(solution.irradiance_front).subspan(i * bands, bands));
    irradiance[2 * i + 1] = mean(std::span(solution.irradiance_back).subspan(i * bands, bands));
    total += irradiance[2 * i] + irradiance[2 * i + 1];
  }
  if (!(total > 0.0)) irradiance.assign(2 * patches.size(), 1.0);
  for (std::size_t i = 0; i < patches.size(); ++i)
    if (!patches.material_of(i).two_sided) irradiance[2 * i + 1] = 0.0;
  return irradiance;
}

}  // namespace

LitSides make_lit_sides(const PatchSet& patches, const Solution& solution) {
  const auto irradiance = side_irradiance(patches, solution);
  double area = 0.0;
  double power = 0.0;
  for (std::size_t side = 0; side < irradiance.size(); ++side) {
    const auto a = static_cast<double>(patches.area[side / 2]);
    area += a;
    power += a * irradiance[side];
  }
  const auto least = area > 0.0 ? dark * power / area : 0.0;

  // Log-average, weighted by power: what falls on a wide ground around a house has little to say in it.
  double log_sum = 0.0;
  double weight = 0.0;
  for (std::size_t side = 0; side < irradiance.size(); ++side) {
    if (!(irradiance[side] > least)) continue;
    const auto arriving = static_cast<double>(patches.area[side / 2]) * irradiance[side];
    log_sum += arriving * std::log(irradiance[side]);
    weight += arriving;
  }
  const auto typical = weight > 0.0 ? std::exp(log_sum / weight) : 1.0;

  LitSides sides;
  sides.brightness.assign(irradiance.size(), 0.0f);
  sides.glaring.assign(irradiance.size(), false);
  for (std::size_t side = 0; side < irradiance.size(); ++side) {
    const auto emittance = side % 2 == 0 ? mean(patches.material_of(side / 2).emittance) : 0.0;
    sides.glaring[side] = emittance > glare * typical;
    const auto light = irradiance[side] + std::min(emittance, typical);
    if (!(light > least)) continue;
    const auto brightness = light / (light + typical);
    sides.brightness[side] = static_cast<float>(brightness);
    sides.lit_area += static_cast<double>(patches.area[side / 2]) * brightness;
  }
  return sides;
}

}  // namespace luxel
