// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/figures.h"

#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "luxel/photometry/polar_svg.h"

namespace luxel {
namespace {

// cd from a function of gamma and C, degrees; every degree, every 15 degrees.
IntensityDistribution made(const std::function<double(double, double)>& candela) {
  std::vector<double> vertical, horizontal, values;
  for (int v = 0; v <= 180; ++v) vertical.push_back(v);
  for (int h = 0; h <= 360; h += 15) horizontal.push_back(h);
  for (const auto h : horizontal)
    for (const auto v : vertical) values.push_back(candela(v, h));
  return {GoniometerType::c, vertical, horizontal, values};
}

double cosine(double degrees) { return std::cos(degrees * std::numbers::pi / 180.0); }

TEST(PhotometricFigures, has_the_angles_of_closed_forms) {
  const auto lambert =
      photometric_figures(made([](double v, double) { return std::max(0.0, 800.0 * cosine(v)); }));
  EXPECT_NEAR(lambert.x.beam_angle, 120.0, 0.01);
  EXPECT_NEAR(lambert.x.field_angle, 2.0 * std::acos(0.1) * 180.0 / std::numbers::pi, 0.01);
  EXPECT_EQ(lambert.y.maximum, 800.0);
  EXPECT_NEAR(lambert.downward_fraction, 1.0, 1e-12);
  const auto even = photometric_figures(made([](double, double) { return 5.0; }));
  EXPECT_NEAR(even.x.beam_angle, 360.0, 1e-9);
  EXPECT_NEAR(even.downward_fraction, 0.5, 1e-6);
  // Two lobes with a dip between: the outermost directions count. All light to one side: from edge to edge.
  const auto lobes =
      photometric_figures(made([](double v, double) { return std::abs(v - 30.0) <= 10.0 ? 10.0 : 0.0; }));
  EXPECT_NEAR(lobes.x.beam_angle, 81.0, 0.01);
  const auto side = photometric_figures(made([](double v, double h) {
    return h == 0.0 || h == 360.0 ? std::max(0.0, 20.0 - std::abs(v - 40.0)) : 0.0;
  }));
  EXPECT_NEAR(side.x.beam_angle, 20.0, 0.01);
  EXPECT_NEAR(side.x.field_angle, 36.0, 0.01);
  EXPECT_EQ(side.y.beam_angle, 0.0);
  EXPECT_EQ(side.vertical, 40.0);
  const auto up =
      photometric_figures(made([](double v, double) { return std::max(0.0, -800.0 * cosine(v)); }));
  EXPECT_NEAR(up.y.beam_angle, 120.0, 0.01);
  EXPECT_NEAR(up.downward_fraction, 0.0, 1e-12);
}

// cos³ of the angle from the aim in both angles is the same light in any type of angles.
TEST(PhotometricFigures, divides_the_flux_of_types_a_and_b) {
  for (const auto type : {GoniometerType::a, GoniometerType::b}) {
    std::vector<double> along, around, candela;
    for (int i = -90; i <= 90; i += 5) along.push_back(i);
    for (int i = -180; i <= 180; i += 5) around.push_back(i);
    const auto& vertical = type == GoniometerType::a ? along : around;
    const auto& horizontal = type == GoniometerType::a ? around : along;
    for (const auto h : horizontal)
      for (const auto v : vertical)
        candela.push_back(std::abs(type == GoniometerType::a ? h : v) <= 90.0 ? 3.0 : 1.0);
    const auto figures = photometric_figures({type, vertical, horizontal, candela});
    // 3 cd below, 1 cd above, with a ramp of 5 degrees that lies above.
    EXPECT_NEAR(figures.downward_fraction, 3.0 * 180.0 / (3.0 * 180.0 + 180.0 + 10.0), 1e-9);
    EXPECT_EQ(figures.x.maximum, 3.0);
  }
}

Photometry photometry_of(IntensityDistribution intensity, double lamps) {
  Photometry p;
  p.luminaire = "A <b> & c";
  p.intensity = std::move(intensity);
  p.absolute = lamps == 0.0;
  p.lamps.resize(1);
  p.lamps[0].flux = lamps;
  return p;
}

TEST(PolarSvg, is_one_element_without_ids_that_says_its_unit) {
  const auto half = polar_svg(
      photometry_of(made([](double v, double h) { return std::max(0.0, (100.0 + h) * cosine(v)); }), 2000.0));
  EXPECT_TRUE(half.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 360 ")) << half;
  EXPECT_TRUE(half.ends_with("</svg>\n"));
  EXPECT_EQ(half.find("id="), std::string::npos);
  EXPECT_EQ(half.find("<style"), std::string::npos);
  for (const char* text : {"A &lt;b&gt; &amp; c", ">cd/klm<", ">C0-C180<", ">C90-C270<", ">90°<"})
    EXPECT_NE(half.find(text), std::string::npos) << text;
  EXPECT_EQ(half.find(">120°<"), std::string::npos) << "no light upwards";
  // The largest intensity in the main planes is 370 cd, 185 cd/klm: circles at 50, 100, 150 and 200.
  EXPECT_NE(half.find(">200<"), std::string::npos);
  EXPECT_EQ(half.find(">250<"), std::string::npos);
  const auto whole = polar_svg(photometry_of(made([](double, double) { return 100.0; }), 0.0));
  EXPECT_NE(whole.find(">cd<"), std::string::npos);
  EXPECT_NE(whole.find(">180°<"), std::string::npos);
  EXPECT_NE(polar_svg(Photometry()).find("</svg>"), std::string::npos);
  EXPECT_NE(polar_svg(photometry_of(made([](double, double) { return 0.0; }), 0.0)).find("</svg>"),
            std::string::npos);
}

}  // namespace
}  // namespace luxel
