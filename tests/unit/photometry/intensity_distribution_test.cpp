// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/photometry/photometry.h"

namespace luxel {
namespace {

constexpr double exact_pi = std::numbers::pi;

std::vector<double> angles(double first, double last, std::size_t count) {
  std::vector<double> all(count);
  for (std::size_t i = 0; i < count; ++i)
    all[i] = first + (last - first) * static_cast<double>(i) / static_cast<double>(count - 1);
  return all;
}

// A cosine distribution of 1000 cd has exact_pi * 1000 lm; interpolated at 1 degree it loses 2.5e-5.
TEST(IntensityDistribution, has_the_flux_of_a_cosine) {
  const auto gamma = angles(0.0, 90.0, 91);
  std::vector<double> candela;
  for (const auto g : gamma) candela.push_back(std::max(0.0, 1000.0 * std::cos(g * exact_pi / 180.0)));
  const IntensityDistribution cosine(GoniometerType::c, gamma, {0.0}, candela);
  EXPECT_NEAR(cosine.linear_flux(), 1000.0 * exact_pi, 0.1);
  EXPECT_NEAR(cosine.zonal_flux(), 1000.0 * exact_pi, 0.2);
  EXPECT_DOUBLE_EQ(cosine.maximum(), 1000.0);
  EXPECT_NEAR(cosine.at({1.0, 0.0, -1.0}), 1000.0 * std::sqrt(0.5), 0.05);
  EXPECT_EQ(cosine.at({0.0, 0.1, 1.0}), 0.0);
}

// The same constant intensity in all directions has 4 pi lm per cd whatever the type and symmetry.
TEST(IntensityDistribution, of_even_intensity_has_4_pi_lumens_per_candela) {
  const auto even = [](GoniometerType type, std::vector<double> v, std::vector<double> h) {
    const std::vector<double> candela(v.size() * h.size(), 2.0);
    return IntensityDistribution(type, std::move(v), std::move(h), candela);
  };
  using enum GoniometerType;
  const auto whole = angles(0.0, 180.0, 37);
  for (const auto& d :
       {even(c, whole, {0.0}), even(c, whole, angles(0.0, 90.0, 5)), even(c, whole, angles(0.0, 180.0, 5)),
        even(c, whole, angles(90.0, 270.0, 5)), even(c, whole, angles(0.0, 360.0, 9)),
        even(c, whole, angles(0.0, 345.0, 24)), even(a, angles(-90.0, 90.0, 19), angles(-180.0, 180.0, 37)),
        even(b, angles(-180.0, 180.0, 37), angles(-90.0, 90.0, 19))}) {
    EXPECT_NEAR(d.linear_flux(), 8.0 * exact_pi, 1e-6);
    EXPECT_NEAR(d.zonal_flux(), 8.0 * exact_pi, 1e-6);
    EXPECT_NEAR(d.at({0.3, -0.2, -0.4}), 2.0, 1e-12);
    EXPECT_NEAR(d.at({-0.3, 0.2, 0.4}), 2.0, 1e-12);
  }
}

TEST(IntensityDistribution, repeats_what_symmetry_leaves_out) {
  const std::vector<double> gamma = {0.0, 90.0};
  const auto at = [](const IntensityDistribution& d, double around) {
    return d.at({std::cos(around * exact_pi / 180.0), std::sin(around * exact_pi / 180.0), -1e-9});
  };
  const IntensityDistribution quadrant(GoniometerType::c, gamma, {0.0, 45.0, 90.0}, {0, 1, 0, 2, 0, 4});
  for (const auto angle : {30.0, 150.0, 210.0, 330.0})
    EXPECT_NEAR(at(quadrant, angle), 1.0 + 2.0 / 3.0, 1e-6);
  const IntensityDistribution half(GoniometerType::c, gamma, {0.0, 90.0, 180.0}, {0, 1, 0, 2, 0, 4});
  for (const auto angle : {135.0, 225.0}) EXPECT_NEAR(at(half, angle), 3.0, 1e-6);
  const IntensityDistribution other(GoniometerType::c, gamma, {90.0, 180.0, 270.0}, {0, 1, 0, 2, 0, 4});
  for (const auto angle : {45.0, 135.0}) EXPECT_NEAR(at(other, angle), 1.5, 1e-6);
  for (const auto angle : {225.0, 315.0}) EXPECT_NEAR(at(other, angle), 3.0, 1e-6);
  const IntensityDistribution open(GoniometerType::c, gamma, {0.0, 120.0, 240.0}, {0, 1, 0, 2, 0, 4});
  EXPECT_NEAR(at(open, 300.0), 2.5, 1e-6);
  EXPECT_NEAR(at(open, 60.0), 1.5, 1e-6);
}

// A damaged file had 0 and 6e-29 degrees.
TEST(IntensityDistribution, has_the_flux_of_angles_however_close) {
  for (const auto gap : {1e-9, 1e-6, 1e-3, 0.006, 0.02}) {
    const IntensityDistribution close(GoniometerType::c, {0.0, 60.0, 60.0 + gap, 90.0}, {0.0},
                                      {10.0, 10.0, 10.0, 10.0});
    EXPECT_NEAR(close.linear_flux(), 20.0 * exact_pi, 1e-7) << gap;
  }
  const IntensityDistribution b(GoniometerType::b, {-60.0, 0.0, 60.0}, {-60.0, 0.0, 1e-28},
                                std::vector(9, 1.0));
  EXPECT_NEAR(b.linear_flux(), 2.0 * exact_pi / 3.0 * std::sin(exact_pi / 3.0), 1e-9);
}

// As a file of ours stores them.
TEST(IntensityDistribution, is_the_same_when_made_of_its_own_fields) {
  const std::vector<double> gamma = {0.0, 60.0, 120.0};
  for (const auto& planes :
       {std::vector{0.0, 120.0, 240.0}, {10.0, 130.0, 350.0}, {90.0, 100.0, 270.0}, {0.0, 50.0, 180.0}}) {
    const IntensityDistribution first(GoniometerType::c, gamma, planes, {9, 1, 0, 8, 2, 0, 7, 4, 0});
    const IntensityDistribution second(first.type(), first.vertical(), first.horizontal(), first.candela());
    EXPECT_EQ(second.horizontal(), first.horizontal());
    EXPECT_EQ(second.candela(), first.candela());
    EXPECT_EQ(second.linear_flux(), first.linear_flux());
    EXPECT_EQ(second.zonal_flux(), first.zonal_flux());
  }
  const IntensityDistribution open(GoniometerType::c, gamma, {10.0, 130.0, 350.0},
                                   {9, 1, 0, 8, 2, 0, 7, 4, 0});
  EXPECT_NEAR(open.at_angles(60.0, 0.0), 2.5, 1e-12);
  EXPECT_NEAR(open.at_angles(60.0, 355.0), 3.25, 1e-12);
  EXPECT_NEAR(open.at_angles(60.0, 10.0), 1.0, 1e-12);
}

// Angles grow from +X to +Y (type C); types A and B: horizontal towards +X, vertical towards +Y.
TEST(IntensityDistribution, has_the_stated_axes) {
  const IntensityDistribution c(GoniometerType::c, {0.0, 90.0}, {0.0, 90.0, 180.0, 270.0},
                                {0, 1, 0, 2, 0, 3, 0, 4});
  EXPECT_NEAR(c.at({1.0, 0.0, 0.0}), 1.0, 1e-12);
  EXPECT_NEAR(c.at({0.0, 1.0, 0.0}), 2.0, 1e-12);
  EXPECT_NEAR(c.at({-1.0, 0.0, 0.0}), 3.0, 1e-12);
  EXPECT_NEAR(c.at({0.0, -1.0, 0.0}), 4.0, 1e-12);
  for (const auto type : {GoniometerType::a, GoniometerType::b}) {
    const IntensityDistribution d(type, {-60.0, 0.0, 60.0}, {-60.0, 0.0, 60.0}, {0, 1, 0, 2, 9, 3, 0, 4, 0});
    const auto tangent = std::tan(exact_pi / 3.0);
    EXPECT_NEAR(d.at({0.0, 0.0, -1.0}), 9.0, 1e-9);
    EXPECT_NEAR(d.at({tangent, 0.0, -1.0}), 4.0, 1e-9);
    EXPECT_NEAR(d.at({-tangent, 0.0, -1.0}), 1.0, 1e-9);
    EXPECT_NEAR(d.at({0.0, tangent, -1.0}), 3.0, 1e-9);
    EXPECT_NEAR(d.at({0.0, -tangent, -1.0}), 2.0, 1e-9);
    EXPECT_EQ(d.at({0.0, 0.0, 1.0}), 0.0);
  }
}

// Equal steps, also those that a double rounds, and unequal ones: the file's own values at its angles, their
// mean between two, and the outermost ones beyond.
TEST(IntensityDistribution, finds_the_interval_of_equal_and_of_unequal_steps) {
  std::vector<double> equal, squares;
  for (int i = 0; i <= 145; ++i) equal.push_back(360.0 * i / 145.0);
  for (int i = 0; i <= 12; ++i) squares.push_back(180.0 * i * i / 144.0);
  std::vector<double> candela;
  for (std::size_t j = 0; j < equal.size(); ++j)
    for (std::size_t i = 0; i < squares.size(); ++i)
      candela.push_back(static_cast<double>((7 * i + 3 * (j % 145)) % 50));
  const IntensityDistribution d(GoniometerType::c, squares, equal, candela);
  const auto rows = squares.size();
  for (std::size_t j = 0; j + 1 < equal.size(); ++j)
    for (std::size_t i = 0; i + 1 < rows; ++i) {
      const auto* values = &candela[j * rows + i];
      EXPECT_NEAR(d.at_angles(squares[i], equal[j]), values[0], 1e-9);
      EXPECT_NEAR(d.at_angles(0.5 * (squares[i] + squares[i + 1]), 0.5 * (equal[j] + equal[j + 1])),
                  0.25 * (values[0] + values[1] + values[rows] + values[rows + 1]), 1e-9);
    }
  EXPECT_NEAR(d.at_angles(180.0, 360.0), candela.back(), 1e-9);
}

TEST(IntensityDistribution, refuses_angles_and_values_that_make_no_sense) {
  using enum GoniometerType;
  EXPECT_THROW(IntensityDistribution(c, {0.0, 0.0}, {0.0}, {1.0, 1.0}), InputError);
  EXPECT_THROW(IntensityDistribution(c, {0.0, 90.0}, {0.0}, {1.0}), InputError);
  EXPECT_THROW(IntensityDistribution(c, {0.0, 190.0}, {0.0}, {1.0, 1.0}), InputError);
  EXPECT_THROW(IntensityDistribution(c, {0.0, 90.0}, {0.0}, {1.0, -1.0}), InputError);
  EXPECT_THROW(IntensityDistribution(c, {}, {0.0}, {}), InputError);
  EXPECT_THROW(IntensityDistribution(c, {0.0}, {0.0}, {1.0}), InputError);
  EXPECT_THROW(IntensityDistribution(c, {0.0, 90.0}, {-90.0, 90.0}, {1.0, 1.0, 1.0, 1.0}), InputError);
  EXPECT_THROW(IntensityDistribution(b, {0.0, 90.0}, {0.0}, {1.0, 1.0}), InputError);
  EXPECT_THROW(IntensityDistribution(b, {0.0, 90.0}, {0.0, 91.0}, {1.0, 1.0, 1.0, 1.0}), InputError);
  EXPECT_THROW(IntensityDistribution(a, {0.0, 91.0}, {0.0, 90.0}, {1.0, 1.0, 1.0, 1.0}), InputError);
}

}  // namespace
}  // namespace luxel
