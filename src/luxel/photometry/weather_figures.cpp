// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/weather_figures.h"

#include <algorithm>
#include <functional>

namespace luxel {
namespace {

bool lacks_illuminances(const Weather& weather) {
  return std::any_of(weather.hours.begin(), weather.hours.end(), [](const WeatherHour& hour) {
    return !hour.diffuse_illuminance && hour.diffuse_horizontal.value_or(0.0) > 0.0;
  });
}

bool has_direct(const WeatherHour& hour) {
  return hour.direct_normal.value_or(0.0) > 0.0 || hour.direct_normal_illuminance.value_or(0.0) > 0.0;
}

BrightHour light_of(const Weather& weather, std::size_t index, bool is_modelled) {
  const auto& hour = weather.hours[index];
  BrightHour light{index, hour.global_illuminance.value_or(0.0), hour.diffuse_illuminance.value_or(0.0)};
  if (!is_modelled && hour.global_illuminance) return light;
  if (!(hour.diffuse_horizontal.value_or(0.0) > 0.0) && !(light.diffuse_illuminance > 0.0) &&
      !has_direct(hour))
    return light;
  const auto sun = sun_of(weather, index);
  const auto sky = perez_sky(weather, index, sun);
  light.diffuse_illuminance = is_modelled ? sky.diffuse_illuminance : light.diffuse_illuminance;
  light.global_illuminance =
      light.diffuse_illuminance + sky.direct_normal_illuminance * std::max(0.0, sun.direction.z);
  return light;
}

void add_sums(const Weather& weather, std::size_t index, WeatherFigures& figures) {
  const auto& hour = weather.hours[index];
  const auto direct = hour.direct_normal.value_or(0.0), diffuse = hour.diffuse_horizontal.value_or(0.0);
  auto global = hour.global_horizontal.value_or(0.0);
  if (!hour.global_horizontal && (direct > 0.0 || diffuse > 0.0)) {
    global = diffuse + direct * std::max(0.0, sun_of(weather, index).direction.z);
    figures.has_global = false;
  }
  figures.global += global * hour.duration;
  figures.direct_normal += direct * hour.duration;
  figures.diffuse += diffuse * hour.duration;
  const bool is_lit = global > 0.0 || hour.diffuse_illuminance.value_or(0.0) > 0.0;
  figures.light_hours += is_lit ? hour.duration : 0.0;
  figures.sun_hours += has_direct(hour) ? hour.duration : 0.0;
}

void find_bright_half(const std::vector<BrightHour>& lights, double duration, WeatherFigures& figures) {
  std::vector<double> diffuse;
  diffuse.reserve(lights.size());
  for (const auto& light : lights) diffuse.push_back(light.diffuse_illuminance);
  std::sort(diffuse.begin(), diffuse.end(), std::greater<>());
  const auto count = std::max<std::size_t>(1, diffuse.size() / 2);
  figures.bright_half_hours = static_cast<double>(count) * duration;
  figures.bright_half_min = diffuse[count - 1];
  figures.bright_half_median = 0.5 * (diffuse[(count - 1) / 2] + diffuse[count / 2]);
}

}  // namespace

WeatherFigures weather_figures(const Weather& weather) {
  constexpr std::size_t shown_hours = 5;
  WeatherFigures figures;
  figures.is_modelled = lacks_illuminances(weather);
  std::vector<BrightHour> lights;
  lights.reserve(weather.hours.size());
  for (std::size_t i = 0; i < weather.hours.size(); ++i) {
    add_sums(weather, i, figures);
    lights.push_back(light_of(weather, i, figures.is_modelled));
  }
  if (lights.empty()) return figures;
  find_bright_half(lights, weather.hours.front().duration, figures);
  std::stable_sort(lights.begin(), lights.end(), [](const BrightHour& a, const BrightHour& b) {
    return a.global_illuminance > b.global_illuminance;
  });
  lights.resize(std::min(lights.size(), shown_hours));
  figures.brightest = std::move(lights);
  return figures;
}

}  // namespace luxel
