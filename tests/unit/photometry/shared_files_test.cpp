// SPDX-License-Identifier: Apache-2.0
// Photometric files of other projects, which are not part of this repository: the tests are skipped where
// they do not lie beside it.
#include <cmath>
#include <filesystem>
#include <numbers>

#include <gtest/gtest.h>

#include "luxel/photometry/figures.h"

#include "support/photometric_files.h"

namespace luxel {
namespace {

const auto folder = std::filesystem::path(LUXEL_SOURCE_DIR) / "../shared/scenes/ies";

struct Case {
  const char* file;
  double zonal, linear;  // lm, or lm per 1000 lm of the lamps, to 0.01
  double lamps;          // lm; 0: absolute
  bool per_klm, warns;
};

constexpr Case cases[] = {
    {"examp1.ies", 5297.39, 5296.65, 5800.0, false, true},
    {"ASA_15M_R2.ies", 9560.97, 9560.83, 13000.0, false, false},
    {"dummy.ies", 906.57, 904.52, 0.0, false, false},
    {"absolute_photometry.ies", 906.57, 904.52, 0.0, false, false},
    {"round_opening.ies", 906.57, 904.52, 0.0, false, false},
    {"rectangular_opening_with_height.ies", 906.57, 904.52, 0.0, false, false},
    {"imperial_units.ies", 906.57, 904.52, 0.0, false, false},
    {"relative_photometry_with_multiplier.ies", 1359.86, 1356.79, 500.0, false, true},
    {"optixapps-TypeC.ies", 628.32, 628.32, 0.0, false, false},
    {"optixapps-test.ies", 144.36, 143.66, 0.0, false, false},
    {"dummy.ldt", 906.57, 904.52, 0.0, false, true},
    {"eulumdat-ugr/sample_04.ldt", 1002.39, 1001.13, 2376.0, true, false},
    {"eulumdat-ugr/sample_05.ldt", 1045.09, 1025.45, 1014.0, true, false},
    {"eulumdat-ugr/sample_11.ldt", 650.37, 649.73, 1000.0, true, false},
};

TEST(PhotometricFiles, have_the_fluxes_that_were_measured_apart_from_this_program) {
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << folder << " is not there";
  for (const auto& c : cases) {
    SCOPED_TRACE(c.file);
    const auto read = load_photometry((folder / c.file).string());
    ASSERT_NE(read.lamp(), nullptr);
    EXPECT_EQ(read.lamp()->flux, c.lamps);
    const auto unit = c.per_klm ? c.lamps / 1000.0 : 1.0;
    EXPECT_NEAR(read.intensity.zonal_flux() / unit, c.zonal, 0.0051);
    EXPECT_NEAR(read.intensity.linear_flux() / unit, c.linear, 0.0051);
    EXPECT_EQ(!read.warnings.empty(), c.warns) << warnings_of(read);
  }
}

// lm by the midpoint rule over the directions that a scene receives, on a grid that has the files' angles as
// boundaries.
double sampled_flux(const IntensityDistribution& intensity) {
  constexpr int thetas = 1440, phis = 96;
  double flux = 0.0;
  for (int i = 0; i < thetas; ++i) {
    const auto theta = (i + 0.5) * std::numbers::pi / thetas;
    for (int j = 0; j < phis; ++j) {
      const auto phi = (j + 0.5) * 2.0 * std::numbers::pi / phis;
      flux += std::sin(theta) * intensity.at({std::sin(theta) * std::cos(phi),
                                              std::sin(theta) * std::sin(phi), -std::cos(theta)});
    }
  }
  return flux * std::numbers::pi / thetas * 2.0 * std::numbers::pi / phis;
}

TEST(PhotometricFiles, send_their_linear_flux_into_a_scene_turned_or_not) {
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << folder << " is not there";
  for (const auto& c : cases)
    for (const double turn : {0.0, 90.0, 37.0}) {
      SCOPED_TRACE(c.file);
      const auto read = load_photometry((folder / c.file).string(), {.rotate = turn});
      const auto linear = read.intensity.linear_flux();
      EXPECT_NEAR(sampled_flux(read.intensity) / linear, 1.0, 2e-4) << turn;
      EXPECT_NEAR(
          read.intensity.zonal_flux() / load_photometry((folder / c.file).string()).intensity.zonal_flux(),
          1.0, 1e-9);
    }
}

// The header's downward flux fraction, in %.
TEST(PhotometricFiles, have_the_downward_fraction_of_their_headers) {
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << folder << " is not there";
  const auto fraction = [](const char* file) {
    return 100.0 * photometric_figures(load_photometry((folder / file).string()).intensity).downward_fraction;
  };
  EXPECT_NEAR(fraction("eulumdat-ugr/sample_04.ldt"), 95.83, 0.02);
  EXPECT_NEAR(fraction("eulumdat-ugr/sample_01.ldt"), 100.0, 0.01);
}

TEST(PhotometricFiles, of_one_luminaire_in_two_formats_give_one_distribution) {
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << folder << " is not there";
  const auto ies = load_photometry((folder / "dummy.ies").string());
  const auto ldt = load_photometry((folder / "dummy.ldt").string());
  ASSERT_EQ(ies.intensity.candela().size(), ldt.intensity.candela().size());
  for (std::size_t i = 0; i < ies.intensity.candela().size(); ++i)
    EXPECT_NEAR(ies.intensity.candela()[i], ldt.intensity.candela()[i], 1e-9);
  EXPECT_EQ(ies.opening.shape, ldt.opening.shape);
  EXPECT_EQ(ies.opening.size, ldt.opening.size);
}

}  // namespace
}  // namespace luxel
