// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/planes.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/photometric_files.h"

namespace luxel {
namespace {

Vec3d direction(double gamma, double around) {
  const auto g = gamma * std::numbers::pi / 180.0, c = around * std::numbers::pi / 180.0;
  return {std::sin(g) * std::cos(c), std::sin(g) * std::sin(c), -std::cos(g)};
}

// A turned luminaire sends in each direction what the other one sends in the direction turned back.
void expect_turned(const Photometry& turned, const Photometry& straight, double turn) {
  for (double gamma = 1.0; gamma < 180.0; gamma += 11.0)
    for (double c = 0.0; c < 360.0; c += 13.0)
      EXPECT_NEAR(turned.intensity.at(direction(gamma, c + turn)), straight.intensity.at(direction(gamma, c)),
                  1e-6)
          << turn << ' ' << gamma << ' ' << c;
}

TEST(TurnLuminaire, turns_the_light_anticlockwise_seen_from_above) {
  MadeIes file;
  file.vertical = "0 60 180";
  for (const auto& [horizontal, candela] :
       {std::pair("0", "9 1 0"), std::pair("0 45 90", "9 1 0 9 2 0 9 4 0"),
        std::pair("0 50 180", "9 1 0 9 2 0 9 4 0"), std::pair("90 100 270", "9 1 0 9 2 0 9 4 0"),
        std::pair("0 100 210", "9 1 0 9 2 0 9 4 0"), std::pair("0 100 360", "9 1 0 9 2 0 9 1 0")}) {
    file.horizontal = horizontal;
    file.candela = candela;
    for (const auto turn : {90.0, -90.0, 180.0, 30.0, 271.5, 720.0})
      expect_turned(file.read({.rotate = turn}), file.read(), turn);
  }
}

TEST(TurnLuminaire, turns_types_a_and_b_by_quarters) {
  MadeIes file;
  file.vertical = "-60 0 70";
  file.horizontal = "-50 0 80";
  file.candela = "0 1 0 2 9 3 0 4 0";
  for (const char* type : {"2", "3"}) {
    file.type = type;
    for (const auto turn : {90.0, 180.0, -90.0}) {
      // Interpolation in angles of the other type differs between the nodes, so the nodes are compared.
      const auto straight = file.read(), turned = file.read({.rotate = turn});
      EXPECT_EQ(turned.intensity.type() == straight.intensity.type(), turn == 180.0);
      expect_turned(turned, straight, turn);
    }
    EXPECT_NE(refusal(file.text(), {.rotate = 45.0}).find("multiple of 90 degrees"), std::string::npos);
  }
  file.horizontal = file.vertical = "0 30 60";  // mirrored
  expect_turned(file.read({.rotate = 90.0}), file.read(), 90.0);
}

TEST(TurnLuminaire, turns_the_opening_by_quarters) {
  MadeIes file;
  file.tag = "IESNA:LM-63-1995\n";
  file.size = "0.1 1.2 0";
  EXPECT_EQ(file.read({.rotate = 90.0}).opening.size, Vec3d(0.1, 1.2, 0.0));
  EXPECT_EQ(file.read({.rotate = 180.0}).opening.size, Vec3d(1.2, 0.1, 0.0));
  EXPECT_EQ(warnings_of(file.read({.rotate = -90.0})), "");
  const auto skew = file.read({.rotate = 50.0});
  EXPECT_EQ(skew.opening.size, Vec3d(0.1, 1.2, 0.0));
  EXPECT_NE(warnings_of(skew).find("the luminous opening is turned by 90 degrees only"), std::string::npos);
  file.size = "0 1.2 -0.03";
  EXPECT_EQ(file.read().opening.shape, OpeningShape::cylinder_along_x);
  EXPECT_EQ(file.read({.rotate = 90.0}).opening.shape, OpeningShape::cylinder_along_y);
  EXPECT_EQ(file.read({.rotate = 90.0}).opening.size, Vec3d(0.03, 1.2, 0.03));
  file.size = "-0.3 0 0";
  EXPECT_EQ(warnings_of(file.read({.rotate = 45.0})), "");
}

TEST(Standardise, completes_or_refuses_ranges_that_no_standard_has) {
  MadeIes file;
  file.candela = "9 1 0 9 2 0 9 4 0";
  for (const char* quadrant : {"90 100 180", "180 190 270", "270 280 360"}) {
    file.horizontal = quadrant;
    EXPECT_NE(warnings_of(file.read()).find("a quadrant of a symmetric luminaire"), std::string::npos);
  }
  file.horizontal = "180 190 270";
  EXPECT_NEAR(file.read().intensity.at_angles(60.0, 10.0), 2.0, 1e-12);
  file.horizontal = "270 280 360";
  EXPECT_NEAR(file.read().intensity.at_angles(60.0, 80.0), 2.0, 1e-12);
  file.horizontal = "10 40 170";
  EXPECT_NEAR(file.read().intensity.at_angles(60.0, 5.0), 1.0, 1e-12);
  EXPECT_NEAR(file.read().intensity.at_angles(60.0, 185.0), 4.0, 1e-12);
  file.horizontal = "0 20 220";
  EXPECT_EQ(warnings_of(file.read()), "");
  file.horizontal = "0 100 200";
  EXPECT_NE(warnings_of(file.read()).find("leave 160 degrees open"), std::string::npos);
  for (const char* bad : {"100 120 140", "-20 0 20", "-200 0 200"}) {
    file.horizontal = bad;
    EXPECT_NE(refusal(file.text()).find("expected horizontal angles"), std::string::npos) << bad;
  }
}

}  // namespace
}  // namespace luxel
