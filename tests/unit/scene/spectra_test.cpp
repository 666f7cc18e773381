// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/scene/colour_spectra.h"
#include "luxel/scene/observer.h"

namespace luxel {
namespace {

double value(const Spectrum::Sample& sample) { return sample.value; }

double sum(const Spectrum& spectrum) {
  double total = 0.0;
  for (const auto& sample : spectrum.samples()) total += value(sample);
  return total;
}

std::vector<Waveband> every(double step, double first = 400.0, double last = 700.0) {
  std::vector<double> wavelengths;
  for (double w = first; w <= last; w += step) wavelengths.push_back(w);
  return make_wavebands(wavelengths);
}

// Light of a spectrum, W/m² nm, as W/m² by band.
template <typename Of>
std::vector<double> by_band(const std::vector<Waveband>& bands, const Of& of) {
  std::vector<double> light;
  for (const auto& band : bands) light.push_back(band.width * of(band.wavelength));
  return light;
}

Vec3d colour_of(const std::vector<Waveband>& bands, const std::vector<double>& light) {
  return BandColours(bands).rgb(light);
}

// CIE 15: the integrals are 106.865, 106.857 and 106.892 nm, which is what makes equal energy colourless.
TEST(Observer, the_curves_have_their_known_integrals_and_peaks) {
  const auto& eye = cie_1931_observer();
  EXPECT_NEAR(5.0 * sum(eye.x), 106.865, 0.002);
  EXPECT_NEAR(5.0 * sum(eye.y), 106.857, 0.001);
  EXPECT_NEAR(5.0 * sum(eye.z), 106.892, 0.002);
  EXPECT_EQ(eye.y.at(555.0, Beyond::zero), 1.0);
  EXPECT_EQ(eye.x.at(600.0, Beyond::zero), 1.0622);
  EXPECT_EQ(eye.z.at(445.0, Beyond::zero), 1.7826);
  EXPECT_EQ(eye.y.front().wavelength, first_visible);
  EXPECT_EQ(eye.y.back().wavelength, last_visible);
  EXPECT_EQ(eye.y.at(359.0, Beyond::zero), 0.0);
}

// CIE 15: D65 has the chromaticity 0.31272, 0.32903.
TEST(Observer, daylight_has_its_known_colour) {
  const auto& eye = cie_1931_observer();
  Vec3d xyz(0.0);
  for (const auto& [wavelength, power] : daylight_d65().samples())
    xyz += power * Vec3d(eye.x.at(wavelength, Beyond::zero), eye.y.at(wavelength, Beyond::zero),
                         eye.z.at(wavelength, Beyond::zero));
  const auto whole = xyz.x + xyz.y + xyz.z;
  EXPECT_NEAR(xyz.x / whole, 0.31272, 2e-5);
  EXPECT_NEAR(xyz.y / whole, 0.32903, 3e-5);
  EXPECT_EQ(daylight_d65().at(560.0, Beyond::holds), 100.0);
}

TEST(Wavebands, widths_add_up_to_the_range_and_means_to_the_whole_spectrum) {
  const auto bands = make_wavebands({400.0, 404.0, 410.0, 500.0, 700.0});
  double range = 0.0;
  for (const auto& band : bands) range += band.width;
  EXPECT_DOUBLE_EQ(range, 300.0);
  // A line much narrower than the bands keeps its power: a triangle of area 2 nm.
  const Spectrum line({{450.0, 0.0}, {452.0, 1.0}, {454.0, 0.0}});
  double power = 0.0;
  for (std::size_t i = 0; i < bands.size(); ++i)
    power += bands[i].width * mean_around(bands, i, line, Beyond::zero);
  EXPECT_NEAR(power, 2.0, 1e-12);
  // Spectra that jump to zero at their end, and spectra that continue.
  const Spectrum step({{420.0, 3.0}, {480.0, 3.0}});
  double inside = 0.0;
  double everywhere = 0.0;
  for (std::size_t i = 0; i < bands.size(); ++i) {
    inside += bands[i].width * mean_around(bands, i, step, Beyond::zero);
    everywhere += bands[i].width * mean_around(bands, i, step, Beyond::holds);
  }
  EXPECT_NEAR(inside, 180.0, 1e-9);
  EXPECT_NEAR(everywhere, 900.0, 1e-9);
}

TEST(BandColours, plain_colour_is_what_it_was) {
  const BandColours plain({});
  const std::vector<float> light = {0.1f, 0.7f, 0.3f};
  EXPECT_EQ(Vec3(plain.rgb(light)), Vec3(0.1f, 0.7f, 0.3f));
  EXPECT_NEAR(plain.lumens(std::vector{1.0, 1.0, 1.0}), 179.0, 1e-9);
}

// 1 W/m² nm over the whole range of the observer: 683 lm/W times 106.857 nm. sRGB shows it a little red.
TEST(BandColours, equal_energy_has_its_known_lumens_and_colour) {
  const auto bands = every(5.0, 360.0, 830.0);
  const auto light = by_band(bands, [](double) { return 1.0; });
  EXPECT_NEAR(BandColours(bands).lumens(light), 683.0 * 106.857, 5.0);
  const auto colour = colour_of(bands, light);
  const auto grey = 683.0 * 106.857 / 179.0;
  EXPECT_NEAR(colour.r / grey, 1.2048, 5e-4);
  EXPECT_NEAR(colour.g / grey, 0.9484, 5e-4);
  EXPECT_NEAR(colour.b / grey, 0.9087, 5e-4);
}

TEST(BandColours, a_line_at_555_nm_gives_683_lumens_per_watt) {
  const auto bands = make_wavebands({400.0, 554.9, 555.0, 555.1, 700.0});
  const std::vector<double> light = {0.0, 0.0, 1.0, 0.0, 0.0};
  EXPECT_NEAR(BandColours(bands).lumens(light), 683.0, 0.5);
}

// A piecewise linear spectrum has the same colour for any wavelengths that include its samples.
TEST(BandColours, colours_do_not_depend_on_how_finely_a_linear_spectrum_is_cut) {
  const Spectrum lamp({{400.0, 0.0}, {500.0, 8.0}, {600.0, 15.6}, {700.0, 18.4}});
  const auto of = [&](double w) { return lamp.at(w, Beyond::zero); };
  const auto coarse = every(100.0);
  const auto fine = every(0.5);
  const auto a = colour_of(coarse, by_band(coarse, of));
  const auto b = colour_of(fine, by_band(fine, of));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i] / b[i], 1.0, 1e-9);
  // The colour that others find for the lamp of the Cornell box, 20.7 10.8 2.8, from tables of their own.
  const auto scale = 179.0 / (683.0 * 106.857);
  EXPECT_NEAR(b.r * scale, 20.7, 0.1);
  EXPECT_NEAR(b.g * scale, 10.85, 0.1);
  EXPECT_NEAR(b.b * scale, 2.77, 0.1);
}

TEST(InGamut, keeps_the_luminance_and_leaves_what_can_be_shown) {
  EXPECT_EQ(in_gamut({0.5, 0.2, 0.0}), Vec3(0.5f, 0.2f, 0.0f));
  const auto shown = in_gamut({1.0, 0.3, -0.2});
  EXPECT_NEAR(luminance(shown), 0.2126 + 0.3 * 0.7152 - 0.2 * 0.0722, 1e-6);
  EXPECT_NEAR(shown.b, 0.0f, 1e-7f);
  EXPECT_EQ(in_gamut({-1.0, 0.0, 0.0}), Vec3(0.0f));
}

TEST(ColourSpectra, white_light_is_smooth_and_looks_white_at_any_wavebands) {
  for (const auto& bands :
       {every(4.0), every(10.0, 420.0, 680.0), every(5.0, 360.0, 830.0),
        make_wavebands({400.0, 430.0, 450.0, 500.0, 520.0, 550.0, 600.0, 640.0, 700.0})}) {
    const ColourSpectra spectra(bands);
    const auto light = spectra.light(Vec3(1.0f));
    const auto colour = BandColours(bands).rgb(light);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(colour[i], 1.0, 1e-6);
    for (const auto power : light) EXPECT_GE(power, 0.0f);
  }
}

TEST(ColourSpectra, daylight_is_bent_by_less_than_two_per_cent_over_the_whole_range) {
  const auto bands = every(5.0, 380.0, 780.0);
  const auto light = ColourSpectra(bands).light(Vec3(1.0f));
  const auto at_560 = static_cast<double>(light[36]) / bands[36].width;
  for (std::size_t b = 4; b < 65; ++b)
    EXPECT_NEAR(static_cast<double>(light[b]) / bands[b].width / at_560,
                daylight_d65().at(bands[b].wavelength, Beyond::holds) / 100.0, 0.02)
        << bands[b].wavelength;
}

TEST(ColourSpectra, a_grey_reflects_all_wavelengths_alike) {
  for (const float grey : {0.0f, 0.18f, 0.73f, 0.98f})
    for (const auto r : ColourSpectra(every(4.0)).reflectance(Vec3(grey))) EXPECT_EQ(r, grey);
}

// Every colour of a grid over the cube, in white light: what is deep and bright at once, no surface can be.
TEST(ColourSpectra, a_surface_has_its_colour_in_white_light) {
  const auto bands = every(4.0);
  const BandColours colours(bands);
  const ColourSpectra spectra(bands);
  const auto white = spectra.light(Vec3(1.0f));
  double worst_usual = 0.0;
  double worst = 0.0;
  for (const float r : {0.0f, 0.05f, 0.2f, 0.5f, 0.8f})
    for (const float g : {0.0f, 0.05f, 0.2f, 0.5f, 0.8f})
      for (const float b : {0.0f, 0.05f, 0.2f, 0.5f, 0.8f}) {
        auto light = spectra.reflectance({r, g, b});
        for (std::size_t i = 0; i < light.size(); ++i) {
          EXPECT_GE(light[i], 0.0f);
          EXPECT_LT(light[i], 1.0f);
          light[i] *= white[i];
        }
        const auto miss = glm::length(colours.rgb(light) - Vec3d(r, g, b));
        worst = std::max(worst, miss);
        if (std::min({r, g, b}) > 0.0f) worst_usual = std::max(worst_usual, miss);
      }
  EXPECT_LT(worst_usual, 2e-6);
  EXPECT_LT(worst, 0.01);
}

TEST(ColourSpectra, a_lamp_has_its_colour_and_lumens) {
  const auto bands = every(4.0);
  const BandColours colours(bands);
  for (const Vec3 rgb : {Vec3(16.5f, 12.0f, 5.5f), Vec3(1e-6f), Vec3(0.2f, 3.0f, 900.0f)}) {
    const auto light = ColourSpectra(bands).light(rgb);
    const auto colour = colours.rgb(light);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(colour[i] / static_cast<double>(rgb[i]), 1.0, 1e-4);
    EXPECT_NEAR(colours.lumens(light) / (179.0 * luminance(rgb)), 1.0, 1e-6);
  }
}

TEST(ColourSpectra, wavebands_that_carry_no_blue_are_refused) {
  EXPECT_THROW(ColourSpectra(every(10.0, 500.0, 700.0)), InputError);
  EXPECT_THROW(ColourSpectra(every(10.0, 400.0, 600.0)), InputError);
  EXPECT_THROW(ColourSpectra({}), InputError);
}

}  // namespace
}  // namespace luxel
