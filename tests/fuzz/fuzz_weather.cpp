// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "luxel/photometry/sky_integrals.h"
#include "luxel/photometry/weather.h"
#include "luxel/photometry/weather_figures.h"

#include "fuzz/answered.h"

namespace luxel {
namespace {

// A file that was read has instants, light that is not negative, and skies of it.
void expect_sound_weather(const Weather& weather) {
  const auto figures = weather_figures(weather);
  expect(figures.global >= 0.0 && std::isfinite(figures.global + figures.direct_normal + figures.diffuse));
  expect(figures.bright_half_median >= figures.bright_half_min && figures.bright_half_min >= 0.0);
  expect(!figures.brightest.empty());
  for (std::size_t i = 0; i < weather.hours.size(); i += 1 + weather.hours.size() / 16) {
    const auto& hour = weather.hours[i];
    expect(hour.duration > 0.0 && hour.duration <= 1.0 && hour.end > 0.0 && hour.end <= 24.5);
    const auto sun = sun_of(weather, i);
    const auto sky = perez_sky(weather, i, sun);
    expect(std::isfinite(sky.diffuse_illuminance) && std::isfinite(sky.direct_normal_illuminance));
    const auto part = relative_illuminances(sky.model);
    expect(part.horizontal > 0.0 && std::isfinite(part.horizontal));
  }
}

}  // namespace
}  // namespace luxel

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return luxel::answered(data, size, [](std::string_view bytes) {
    luxel::expect_sound_weather(luxel::read_weather(bytes, "nowhere/weather.epw"));
  });
}
