// SPDX-License-Identifier: Apache-2.0
#include "scenes/luminaires/luminaires.h"

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "luxel/core/output_file.h"
#include "luxel/photometry/figures.h"
#include "luxel/photometry/read_photometry.h"

namespace luxel::scenes {
namespace {

const auto folder = std::filesystem::path(LUXEL_SOURCE_DIR) / "scenes/luminaires";

Photometry read(const std::string& name, const std::string& ending, double rotate = 0.0) {
  return read_photometry(luminaire_file(name, ending), name + ending, {.lamp_set = 1, .rotate = rotate});
}

TEST(Luminaires, are_committed_as_they_are_generated) {
  for (const auto& luminaire : luminaire_list()) {
    const auto name = std::string(luminaire.name);
    EXPECT_EQ(read_file(folder / (name + ".ies")), luminaire_file(name, ".ies")) << name;
  }
  for (const std::string name : {"led-panel", "wall-washer"})
    EXPECT_EQ(read_file(folder / (name + ".ldt")), luminaire_file(name, ".ldt")) << name;
}

TEST(Luminaires, have_the_flux_and_the_size_of_their_descriptions) {
  for (const auto& made : luminaire_list())
    for (const char* ending : {".ies", ".ldt"}) {
      const auto luminaire = read(made.name, ending);
      SCOPED_TRACE(luminaire.file);
      EXPECT_TRUE(luminaire.warnings.empty()) << luminaire.warnings[0];
      EXPECT_NEAR(luminaire.intensity.zonal_flux() / (made.efficiency * made.lamp_flux), 1.0, 2e-4);
      EXPECT_EQ(luminaire.absolute, made.absolute);
      EXPECT_EQ(luminaire.lamp()->flux, made.absolute ? 0.0 : made.lamp_flux);
      const auto along = std::string(ending) == ".ies" ? luminaire.opening.size.x : luminaire.opening.size.y;
      EXPECT_NEAR(along, made.size.x, 1e-9);
    }
}

TEST(Luminaires, are_what_they_are_called) {
  const auto spot = photometric_figures(read("spotlight", ".ies").intensity);
  EXPECT_NEAR(spot.x.beam_angle, 16.0, 0.5);
  EXPECT_EQ(read("spotlight", ".ies").opening.shape, OpeningShape::ellipse);
  const auto panel = photometric_figures(read("led-panel", ".ies").intensity);
  EXPECT_GT(panel.x.beam_angle, 80.0);
  EXPECT_LT(panel.x.beam_angle, 110.0);
  const auto pendant = photometric_figures(read("linear-pendant", ".ies").intensity);
  EXPECT_GT(pendant.downward_fraction, 0.5);
  EXPECT_LT(pendant.downward_fraction, 0.7);
  // The wall of the IES file is at 90 degrees, +Y.
  const auto washer = read("wall-washer", ".ies");
  EXPECT_GT(washer.intensity.at({0.0, 1.0, -1.0}), 4.0 * washer.intensity.at({0.0, -1.0, -1.0}));
}

// The length lies along 0-180 in IES files and along C90-C270 in EULUMDAT: a quarter turn apart.
TEST(Luminaires, are_the_same_in_both_formats_but_for_a_quarter_turn) {
  for (const auto& made : luminaire_list()) {
    const auto ies = read(made.name, ".ies", -90.0), ldt = read(made.name, ".ldt");
    SCOPED_TRACE(made.name);
    EXPECT_EQ(ies.opening.shape, ldt.opening.shape);
    EXPECT_NEAR(length(ies.opening.size - ldt.opening.size), 0.0, 1e-9);
    for (double v = 0.5; v < 180.0; v += 7.0)
      for (double h = 0.0; h < 360.0; h += 10.0) {
        const auto g = v * std::numbers::pi / 180.0, c = h * std::numbers::pi / 180.0;
        const Vec3d d(std::sin(g) * std::cos(c), std::sin(g) * std::sin(c), -std::cos(g));
        EXPECT_NEAR(ies.intensity.at(d), ldt.intensity.at(d), 1e-4) << v << ' ' << h;
      }
  }
}

}  // namespace
}  // namespace luxel::scenes
