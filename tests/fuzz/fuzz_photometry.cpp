// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "luxel/photometry/figures.h"
#include "luxel/photometry/polar_svg.h"
#include "luxel/photometry/read_photometry.h"

#include "fuzz/answered.h"

namespace luxel {
namespace {

// A file that was read has finite fluxes, gives no negative light, and can be drawn.
void expect_sound_light(const Photometry& photometry) {
  const auto& intensity = photometry.intensity;
  const auto flux = intensity.linear_flux() + intensity.zonal_flux();
  const auto figures = photometric_figures(intensity);
  const auto sum = figures.downward_fraction + figures.x.beam_angle + figures.y.field_angle;
  expect(flux >= 0.0 && std::isfinite(flux) && sum >= 0.0 && std::isfinite(sum));
  expect(intensity.at({0.3, -0.2, -1.0}) >= 0.0);
  expect(!polar_svg(photometry).empty());
}

}  // namespace
}  // namespace luxel

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  for (const double turn : {0.0, 90.0, 33.0})
    luxel::answered(data, size, [turn](std::string_view bytes) {
      luxel::expect_sound_light(
          luxel::read_photometry(bytes, "nowhere/lamp.ies", {.lamp_set = 1, .rotate = turn}));
    });
  return 0;
}
