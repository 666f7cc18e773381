// SPDX-License-Identifier: Apache-2.0
// Which observers judge an area, on both up axes.
#include "luxel/lighting/glare_verdict.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace luxel {
namespace {

NamedGlare observer(const char* name, const Vec3d& eye, double ugr) {
  NamedGlare o;
  o.name = name;
  o.eye = eye;
  o.glare.ugr = ugr;
  o.glare.low = ugr - 0.1;
  o.glare.high = ugr + 0.1;
  return o;
}

// An L, so that the parity of crossings matters: 4 x 4 m without its upper right quarter.
CalculationArea area_of_l(bool y_is_up) {
  CalculationArea area;
  for (const auto& [a, b] : {std::pair{0.0, 0.0}, {4.0, 0.0}, {4.0, 2.0}, {2.0, 2.0}, {2.0, 4.0}, {0.0, 4.0}})
    area.polygon.push_back(y_is_up ? Vec3d(a, 0.75, b) : Vec3d(a, b, 0.75));
  area.requirement.ugr = 19.0;
  return area;
}

TEST(GlareVerdict, is_that_of_the_observers_in_the_area) {
  for (const bool y_is_up : {false, true}) {
    const auto up = y_is_up ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1);
    const auto at = [&](double a, double b) { return y_is_up ? Vec3d(a, 1.2, b) : Vec3d(a, b, 1.2); };
    const std::vector<NamedGlare> observers = {observer("A", at(1, 3), 17.0), observer("B", at(3, 1), 18.0),
                                               observer("C", at(3, 3), 25.0)};
    const auto inside = judge_glare(area_of_l(y_is_up), observers, up);
    ASSERT_TRUE(inside);
    EXPECT_EQ(inside->compliance, Compliance::met);
    EXPECT_EQ(inside->note, "highest of the observers in this area: B");
    EXPECT_EQ(inside->measured.value, 18.0);
    const auto all = judge_glare(area_of_l(y_is_up), std::span(observers).subspan(2), up);
    EXPECT_EQ(all->compliance, Compliance::not_met);
    EXPECT_EQ(all->note, "highest of all observers: C");
  }
}

TEST(GlareVerdict, is_met_without_glare_and_not_known_without_observers) {
  const Vec3d up(0, 0, 1);
  const auto area = area_of_l(false);
  const std::vector<NamedGlare> nobody_dazzled = {observer("A", {1, 1, 1.2}, ObservedGlare::nothing)};
  EXPECT_EQ(judge_glare(area, nobody_dazzled, up)->compliance, Compliance::met);
  EXPECT_EQ(judge_glare(area, {}, up)->compliance, Compliance::not_known);
  const std::vector<NamedGlare> dark = {observer("A", {1, 1, 1.2}, std::numeric_limits<double>::infinity())};
  EXPECT_EQ(judge_glare(dark, 19.0).compliance, Compliance::not_known);
  const std::vector<NamedGlare> near = {observer("A", {1, 1, 1.2}, 18.95)};
  const auto open = judge_glare(near, 19.0);
  EXPECT_EQ(open.compliance, Compliance::cannot_be_told);
  EXPECT_EQ(remedy_of(open), "4 times as many rays would tell if the value stays");
  auto by_solution = near;
  by_solution[0].glare.sampling = 0.0;
  EXPECT_EQ(remedy_of(judge_glare(by_solution, 19.0)),
            "the error of the solution is too large: it must fall to 0.5 of what it is");
  auto free = area;
  free.requirement.ugr.reset();
  EXPECT_FALSE(judge_glare(free, near, up));
}

}  // namespace
}  // namespace luxel
