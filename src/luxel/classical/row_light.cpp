// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/row_light.h"

#include <algorithm>
#include <cmath>

#include "luxel/classical/stochastic_jacobi.h"

namespace luxel {

RowLight::RowLight(const RowOperator& transport)
    : scattering(scattering_of(transport.patches(), transport.sides(), Context(1))) {
  const auto& patches = transport.patches();
  for (std::size_t receiver = 0; receiver < transport.size(); ++receiver) {
    const auto side = transport.sides().side[receiver];
    const auto escaped = std::max(0.0, transport.losses().escaped[receiver]);
    area.push_back(patches.area[side.patch()]);
    for (std::size_t b = 0; b < patches.band_count(); ++b) {
      emittance.push_back(!side.is_back() ? patches.emittance(side.patch(), b) : 0.0f);
      from_sky.push_back(static_cast<float>(escaped * patches.sky_radiosity(0, b)));
    }
  }
  before.assign(emittance.size(), 0.0f);
  irradiance.assign(emittance.size(), 0.0f);
  radiosity = emittance;
}

void write_light(const RowOperator& transport, const RowLight& light,
                 const std::vector<float>& standard_error, Solution& solution) {
  const auto& patches = transport.patches();
  const auto bands = patches.band_count();
  solution.bands = patches.bands;
  for (auto* array : {&solution.irradiance.front, &solution.irradiance.back, &solution.radiosity.front,
                      &solution.radiosity.back})
    array->assign(patches.size() * bands, 0.0f);
  for (auto* array : {&solution.standard_error.front, &solution.standard_error.back})
    array->assign(standard_error.empty() ? 0 : patches.size() * bands, 0.0f);
  for (std::size_t i = 0; i < light.irradiance.size(); ++i) {
    const auto side = transport.sides().side[i / bands];
    const bool back = side.is_back();
    const auto at = side.patch() * bands + i % bands;
    solution.irradiance.of(back)[at] = light.irradiance[i];
    solution.radiosity.of(back)[at] = light.radiosity[i];
    if (!standard_error.empty()) solution.standard_error.of(back)[at] = standard_error[i];
  }
}

EnergyAccount energy_of(const RowOperator& transport, const RowLight& light) {
  const auto& patches = transport.patches();
  const auto bands = patches.band_count();
  const auto materials = patches.materials.size();
  const auto& losses = transport.losses();
  EnergyAccount energy(emitted_power(patches), materials);
  auto& balance = energy.balance;
  for (std::size_t i = 0; i < light.irradiance.size(); ++i) {
    const auto receiver = i / bands;
    const auto b = i % bands;
    const double area = light.area[receiver];
    const auto sent = area * double{light.before[i]};
    const auto albedo =
        double{light.scattering.reflectance[i]} +
        (light.scattering.transmittance.empty() ? 0.0 : double{light.scattering.transmittance[i]});
    balance.absorbed[b] += area * (1.0 - albedo) * double{light.irradiance[i]};
    balance.escaped[b] += sent * losses.escaped[receiver];
    // The irradiance includes the sky's light from the first step on.
    const auto on_its_way = double{light.from_sky[i]} - std::min(light.from_sky[i], light.irradiance[i]);
    balance.from_sky[b] += area * double{light.from_sky[i]};
    balance.unshot[b] += area * (double{light.radiosity[i]} - double{light.before[i]} + on_its_way);
    for (std::size_t m = 0; m < materials; ++m) {
      const auto lost = sent * losses.at_backs[receiver * materials + m];
      balance.lost_at_backs[b] += lost;
      energy.back_loss[m] += lost;
    }
  }
  return energy;
}

double whole_error(const RowLight& light, const std::vector<float>& standard_error) {
  const auto bands = light.irradiance.size() / light.area.size();
  double squared_error = 0.0;
  double squared_light = 0.0;
  for (std::size_t i = 0; i < standard_error.size(); ++i) {
    const double area = light.area[i / bands];
    squared_error += area * double{standard_error[i]} * double{standard_error[i]};
    squared_light += area * double{light.irradiance[i]} * double{light.irradiance[i]};
  }
  return squared_light > 0.0 ? std::sqrt(squared_error / squared_light) : 0.0;
}

}  // namespace luxel
