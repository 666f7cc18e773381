// SPDX-License-Identifier: Apache-2.0
// UGR tables against Relux, DIALux and CIE 190, and against closed forms.
#include "luxel/lighting/ugr_table.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/lighting/position_index.h"

#include "support/luminaires.h"

namespace luxel {
namespace {

const std::filesystem::path samples = LUXEL_SOURCE_DIR "/../shared/scenes/ies/eulumdat-ugr";

// The numbers of a table, NaN where it has "<10.0": ten per line, crosswise first.
std::vector<double> reference(const std::string& file) {
  std::vector<double> numbers;
  std::string text = read_file(samples / file);
  for (auto& c : text)
    if (c == ',' || c == '\r' || c == '\n') c = ' ';
  for (std::size_t at = 0; at < text.size();) {
    const auto begin = text.find_first_not_of(' ', at);
    if (begin == std::string::npos) break;
    const auto end = std::min(text.find(' ', begin), text.size());
    const auto word = text.substr(begin, end - begin);
    numbers.push_back(word.front() == '<' ? std::numeric_limits<double>::quiet_NaN() : std::stod(word));
    at = end;
  }
  return numbers;
}

struct Difference {
  double max = 0.0, mean = 0.0;
};

Difference difference(const UgrTable& table, const std::vector<double>& expected) {
  Difference d;
  int count = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (std::isnan(expected[i])) continue;
    const auto& values = i % 10 < 5 ? table.crosswise : table.endwise;
    const auto delta = values[i / 10][i % 5] - expected[i];
    d.max = std::max(d.max, std::abs(delta));
    d.mean += delta;
    ++count;
  }
  d.mean /= count;
  return d;
}

class UgrTableOfSamples : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(samples)) GTEST_SKIP() << samples << " is not there";
  }
};

// The bounds are the measured differences of docs/glare.md, rounded up.
TEST_F(UgrTableOfSamples, agree_with_relux_and_dialux) {
  for (const auto& [sample, relux, dialux] : {std::tuple("01", 0.15, 0.85),
                                              {"02", 0.2, 0.75},
                                              {"04", 0.2, 0.5},
                                              {"05", 0.25, 0.4},
                                              {"11", 0.15, 0.4}}) {
    const auto table = ugr_table(load_photometry(samples / fmt::format("sample_{}.ldt", sample)));
    const auto to_relux = difference(table, reference(fmt::format("ugr_table_{}_Relux.csv", sample)));
    const auto to_dialux = difference(table, reference(fmt::format("ugr_table_{}_Dialux.csv", sample)));
    EXPECT_LE(to_relux.max, relux) << sample;
    EXPECT_LE(std::abs(to_relux.mean), 0.07) << sample;
    EXPECT_LE(to_dialux.max, dialux) << sample;
    RecordProperty(fmt::format("sample_{}", sample),
                   fmt::format("Relux {:.3f} {:+.3f}, DIALux {:.3f} {:+.3f}", to_relux.max, to_relux.mean,
                               to_dialux.max, to_dialux.mean));
  }
}

// CIE 190's worked example has its luminaires 1 H apart. It is printed to one digit.
TEST_F(UgrTableOfSamples, agree_with_the_example_of_cie_190) {
  const auto table = ugr_table(load_photometry(samples / "sample_11.ldt"), 1.0);
  const auto d = difference(table, reference("ugr_table_11_cie190.csv"));
  EXPECT_LE(d.max, 0.13);
  EXPECT_LE(std::abs(d.mean), 0.03);
  RecordProperty("sample_11", fmt::format("CIE 190 {:.3f} {:+.3f}", d.max, d.mean));
}

Photometry cosine_panel(const std::string& format, const Vec3d& size) {
  Photometry photometry;
  photometry.file = "test";
  photometry.format = format;
  photometry.intensity = test::cosine_distribution(300.0);
  photometry.opening = {OpeningShape::rectangle, size};
  return photometry;
}

// A flat cosine luminaire has the same luminance everywhere: L = I / A. The sum is then L² A H sum of 1/(r³
// p²), here of the one luminaire of a grid as wide as the room: (2H, 2H) has it 1 H in front of the eye at
// T = 0, with p(0, 1) = 7.
TEST(UgrTable, has_the_closed_form_of_a_cosine_luminaire) {
  const auto photometry = cosine_panel("EULUMDAT", {0.3, 0.4, 0.0});
  const auto terms = ugr_terms(photometry, 2.0, 0, 0, false);
  const double area = 0.12, luminance = 300.0 / area, distance = 2.0 * std::numbers::sqrt2;
  const double solid_angle = area * std::numbers::sqrt2 / 2.0 / (distance * distance);
  EXPECT_NEAR(terms.glare, luminance * luminance * solid_angle / 49.0, 1e-4 * terms.glare);
  EXPECT_NEAR(terms.ugr(), 8.0 * std::log10(0.25 * terms.glare / terms.background), 1e-12);
  // Twice the light is twice the luminance of both: UGR rises by 8 log10 2.
  auto brighter = photometry;
  brighter.intensity = test::cosine_distribution(600.0);
  EXPECT_NEAR(ugr_terms(brighter, 2.0, 0, 0, false).ugr() - terms.ugr(), 8.0 * std::log10(2.0), 1e-9);
}

// Half of the flux of a luminaire that shines evenly all around goes onto the ceiling, which receives nothing
// of a cosine luminaire.
TEST(UgrTable, has_the_background_of_its_flux) {
  auto photometry = cosine_panel("EULUMDAT", {0.3, 0.3, 0.0});
  photometry.intensity = {GoniometerType::c, {0.0, 90.0, 180.0}, {0.0}, {100.0, 100.0, 100.0}};
  const auto even = ugr_terms(photometry, 1.0, 8, 0, false);  // 4H x 4H
  const auto transfer = wall_transfer(4.0, 4.0, ugr_reflectances[0]);
  // The floor receives 0.338, 0.257, 0.351 and -0.018 of the flux within 41.1, 60, 75.5 and 90 degrees.
  const auto within = [](double degrees) {
    return 2.0 * std::numbers::pi * 100.0 * (1.0 - std::cos(degrees * std::numbers::pi / 180.0));
  };
  const auto zone = [&](double last) { return within(last) - within(last - 10.0); };
  const auto floor = 0.338 * (within(40) + 0.130 * zone(50)) + 0.257 * within(60) +
                     0.351 * (within(70) + 0.547 * zone(80)) - 0.018 * within(90);
  const auto expected = 16.0 / 64.0 / std::numbers::pi *
                        (floor * transfer.from_floor + (within(90) - floor) * transfer.from_wall +
                         within(90) * transfer.from_ceiling);
  EXPECT_NEAR(even.background, expected, 2e-3 * expected);  // zones by their middles
}

// The length of IES files lies along X, that of EULUMDAT along Y: the same panel has the same table.
TEST(UgrTable, sees_ies_and_eulumdat_along_the_same_axis) {
  std::vector<double> gamma, candela, turned;
  for (int i = 0; i <= 18; ++i) gamma.push_back(5.0 * i);
  for (int c = 0; c <= 6; ++c)
    for (int i = 0; i <= 18; ++i) candela.push_back((18.0 - i) * (10.0 + c));
  for (int c = 6; c >= 0; --c)
    for (int i = 0; i <= 18; ++i) turned.push_back(candela[static_cast<std::size_t>(19 * c + i)]);
  const std::vector<double> planes = {0, 15, 30, 45, 60, 75, 90};
  auto ldt = cosine_panel("EULUMDAT", {0.2, 1.2, 0.05});
  ldt.opening.shape = OpeningShape::box;
  ldt.intensity = {GoniometerType::c, gamma, planes, candela};
  auto ies = ldt;
  ies.format = "IES LM-63-2002";
  ies.opening.size = {1.2, 0.2, 0.05};
  ies.intensity = {GoniometerType::c, gamma, planes, turned};
  const auto a = ugr_table(ldt), b = ugr_table(ies);
  for (std::size_t r = 0; r < 19; ++r) {
    EXPECT_NEAR(a.crosswise[r][0], b.crosswise[r][0], 1e-9);
    EXPECT_NEAR(a.endwise[r][0], b.endwise[r][0], 1e-9);
  }
  EXPECT_GT(std::abs(a.crosswise[10][0] - a.endwise[10][0]), 0.5);
}

TEST(UgrTable, knows_symmetry) {
  EXPECT_TRUE(is_symmetric(test::cosine_distribution(100.0)));
  EXPECT_FALSE(is_symmetric(test::lopsided_distribution()));
  // Symmetric about one plane only.
  EXPECT_FALSE(is_symmetric(
      {GoniometerType::c, {0.0, 90.0}, {0.0, 90.0, 180.0}, {100.0, 50.0, 100.0, 80.0, 100.0, 90.0}}));
}

TEST(UgrTable, refuses_what_has_no_luminance) {
  auto photometry = cosine_panel("EULUMDAT", {0.3, 0.3, 0.0});
  photometry.opening = {};
  EXPECT_THROW(ugr_table(photometry), InputError);
  photometry = cosine_panel("EULUMDAT", {0.3, 0.3, 0.0});
  EXPECT_THROW(ugr_table(photometry, 0.0), InputError);
  EXPECT_THROW(ugr_table(photometry, std::numeric_limits<double>::quiet_NaN()), InputError);
}

// No light above 45 degrees: nothing dazzles in the small room, whose luminaires are seen flatter.
TEST(UgrTable, has_no_number_where_nothing_shines_at_the_eye) {
  auto photometry = cosine_panel("EULUMDAT", {0.3, 0.3, 0.0});
  photometry.intensity = {GoniometerType::c, {0.0, 20.0, 25.0}, {0.0}, {100.0, 100.0, 0.0}};
  const auto table = ugr_table(photometry);
  EXPECT_TRUE(std::isinf(table.crosswise[0][0]));
  EXPECT_NE(text_of(table).find(" -"), std::string::npos);
  EXPECT_EQ(csv_of(table).find("inf"), std::string::npos);
}

TEST(PositionIndex, has_the_values_of_cie_117) {
  for (const auto& [t, h, p] : {std::tuple(0.0, 0.5, 2.86),
                                {0.5, 0.5, 2.91},
                                {1.0, 1.0, 7.0},
                                {3.0, 1.9, 16.0},
                                {0.0, 0.0, 1.0},
                                {0.0, 1.7, 16.2},
                                {2.7, 0.6, 7.5},
                                {3.0, 0.0, 4.22}})
    EXPECT_NEAR(guth_index(t, h).value_or(0.0), p, 1e-9) << t << " " << h;
  // Halfway between four numbers of the table: 1, 1.26, 1.05, 1.22.
  EXPECT_NEAR(guth_index(0.05, 0.05).value_or(0.0), 1.1325, 1e-9);
}

TEST(PositionIndex, ends_with_the_table) {
  EXPECT_FALSE(guth_index(3.01, 0.5));
  EXPECT_FALSE(guth_index(0.0, 1.75)) << "beside a missing number";
  EXPECT_FALSE(guth_index(0.5, 1.91));
  EXPECT_FALSE(position_index(-1.0, 0.0, 0.5)) << "behind";
  EXPECT_TRUE(guth_index(0.95, 1.85));
}

// The formula for below the line of sight continues the table's 1 on it.
TEST(PositionIndex, has_the_formula_below_the_line_of_sight) {
  EXPECT_NEAR(position_index(2.0, 0.0, -1e-9).value_or(0.0), 1.0, 1e-8);
  EXPECT_NEAR(position_index(2.0, 0.6, -0.8).value_or(0.0), 1.4, 1e-12);
  EXPECT_NEAR(position_index(1.0, 0.6, -0.8).value_or(0.0), 2.2, 1e-12);
  EXPECT_EQ(position_index(2.0, -1.0, 1.0), position_index(2.0, 1.0, 1.0));
}

}  // namespace
}  // namespace luxel
