// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "support/photometric_files.h"

namespace luxel {
namespace {

// `planes` planes of 100 cd/klm down, 10 k at 60 degrees in plane k (from 1), 0 at 90.
std::vector<std::string> numbered(int planes) {
  std::vector<std::string> values;
  for (int k = 1; k <= planes; ++k)
    for (const auto& value : {std::string("100"), std::to_string(10 * k), std::string("0")})
      values.push_back(value);
  return values;
}

const std::vector<std::string> eight = {"0", "45", "90", "135", "180", "225", "270", "315"};

// cd per 20 at 60 degrees, which is the number of the plane: 2000 lm x 10 cd/klm.
std::vector<double> around(const Photometry& p) {
  std::vector<double> values;
  for (int c = 0; c < 360; c += 45) values.push_back(p.intensity.at_angles(60.0, c) / 20.0);
  return values;
}

TEST(ReadEulumdat, scales_by_the_lamps_flux_and_the_conversion_factor) {
  MadeLdt file;
  const auto read = file.read();
  EXPECT_EQ(read.format, "EULUMDAT");
  EXPECT_EQ(read.maker, "Maker");
  EXPECT_EQ(read.luminaire, "Luminaire");
  EXPECT_EQ(read.catalogue, "L1");
  EXPECT_EQ(read.test_report, "R1");
  EXPECT_NEAR(read.intensity.maximum(), 200.0, 1e-12);
  EXPECT_NEAR(read.header_flux, 1600.0, 1e-12);
  EXPECT_EQ(read.lamp()->flux, 2000.0);
  EXPECT_EQ(read.lamp()->colour, "4000");
  EXPECT_EQ(read.lamp()->colour_rendering, "80");
  file.line(24) = "1,5";
  EXPECT_NEAR(file.read().intensity.maximum(), 300.0, 1e-12);
  file.line(24) = "0";
  EXPECT_NEAR(file.read().intensity.maximum(), 200.0, 1e-12);
  EXPECT_NE(warnings_of(file.read()).find("made.ldt:24: the conversion factor is 0"), std::string::npos);
}

TEST(ReadEulumdat, has_all_symmetries) {
  MadeLdt file;
  file.set_planes(0, eight);
  file.values = numbered(8);
  EXPECT_EQ(around(file.read()), (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8}));
  file.set_planes(1, eight);  // Mc > 1
  file.values = numbered(1);
  EXPECT_EQ(around(file.read()), (std::vector<double>(8, 1.0)));
  EXPECT_EQ(file.read().intensity.horizontal().size(), 1u);
  file.set_planes(2, eight);
  file.values = numbered(5);
  EXPECT_EQ(around(file.read()), (std::vector<double>{1, 2, 3, 4, 5, 4, 3, 2}));
  file.set_planes(3, eight);  // the planes stored are C270, C315, C0, C45, C90
  EXPECT_EQ(around(file.read()), (std::vector<double>{3, 4, 5, 4, 3, 2, 1, 2}));
  file.set_planes(4, eight);
  file.values = numbered(3);
  EXPECT_EQ(around(file.read()), (std::vector<double>{1, 2, 3, 2, 1, 2, 3, 2}));
  file.set_planes(0, {"0"});  // as dummy.ldt of photometric-viewer has it
  file.values = numbered(1);
  EXPECT_EQ(around(file.read()), (std::vector<double>(8, 1.0)));
}

TEST(ReadEulumdat, has_unequal_angles) {
  MadeLdt file;
  file.set_planes(3, {"0", "10", "90", "170", "180", "260", "270", "280"});
  file.values = numbered(5);  // C270, C280, C0, C10, C90
  const auto read = file.read();
  EXPECT_NEAR(read.intensity.at_angles(60.0, 280.0), 40.0, 1e-9);
  EXPECT_NEAR(read.intensity.at_angles(60.0, 0.0), 60.0, 1e-9);
  EXPECT_NEAR(read.intensity.at_angles(60.0, 170.0), 80.0, 1e-9);
  EXPECT_NEAR(read.intensity.at_angles(60.0, 260.0), 40.0, 1e-9);
  file.set_planes(2, {"0", "10", "90", "170", "170.5", "260", "270", "280"});
  EXPECT_NE(refusal(file.text()).find("expected C angles whose 5 planes of symmetry 2 end at C180"),
            std::string::npos)
      << refusal(file.text());
}

TEST(ReadEulumdat, has_alternative_sets_of_lamps) {
  MadeLdt file;
  file.line(26) = "2";
  file.lamps = {"1", "A", "2000", "4000", "80", "20", "2", "B", "3000", "3000", "90", "33"};
  const auto first = file.read(), second = file.read({.lamp_set = 2});
  EXPECT_NEAR(first.intensity.maximum(), 200.0, 1e-12) << "sets are not added";
  EXPECT_NEAR(second.intensity.maximum(), 300.0, 1e-12);
  EXPECT_EQ(second.lamps.size(), 2u);
  EXPECT_EQ(second.lamp()->name, "B");
  EXPECT_EQ(second.lamp()->watts, 33.0);
  EXPECT_NEAR(second.header_flux, 2400.0, 1e-12);
  EXPECT_NE(warnings_of(first).find("2 alternative sets of lamps: set 1 is taken"), std::string::npos);
  for (const std::size_t set : {0, 3})
    EXPECT_NE(refusal(file.text(), {.lamp_set = set}).find("made.ies:26: there is no lamp set"),
              std::string::npos);
}

TEST(ReadEulumdat, has_absolute_photometry_where_lamps_are_negative) {
  MadeLdt file;
  file.lamps[0] = "-1";
  const auto read = file.read();
  EXPECT_TRUE(read.absolute);
  EXPECT_NEAR(read.intensity.maximum(), 200.0, 1e-12);
  EXPECT_EQ(read.lamp()->flux, 0.0);
  EXPECT_EQ(read.lamp()->count, 1.0);
  EXPECT_NEAR(read.header_flux, 1600.0, 1e-12);
}

TEST(ReadEulumdat, has_the_luminous_area_with_its_length_along_y) {
  MadeLdt file;
  EXPECT_EQ(file.read().opening.shape, OpeningShape::point);
  EXPECT_NE(warnings_of(file.read()).find("a point is taken"), std::string::npos);
  file.line(16) = "1200";
  file.line(17) = "60,5";
  EXPECT_EQ(file.read().opening.shape, OpeningShape::rectangle);
  EXPECT_NEAR(file.read().opening.size.x, 0.0605, 1e-12);
  EXPECT_NEAR(file.read().opening.size.y, 1.2, 1e-12);
  for (const std::size_t line : {18, 19, 20, 21}) file.line(line) = "40";
  EXPECT_EQ(file.read().opening.shape, OpeningShape::box);
  EXPECT_NEAR(file.read().opening.size.z, 0.04, 1e-12);
  file.line(17) = "0";
  EXPECT_EQ(file.read().opening.shape, OpeningShape::vertical_cylinder);
  file.line(20) = "0";
  EXPECT_NE(warnings_of(file.read()).find("made.ldt:18: the luminous area is 0 to 0.04 m high"),
            std::string::npos);
  for (const std::size_t line : {18, 19, 20, 21}) file.line(line) = "";
  EXPECT_EQ(file.read().opening.shape, OpeningShape::ellipse);
  EXPECT_EQ(file.read().opening.size, Vec3d(1.2, 1.2, 0.0));
}

TEST(ReadEulumdat, takes_decimal_commas_any_line_ends_and_latin_1) {
  MadeLdt file;
  file.values = {"100,25", "50.5", "0"};
  file.line(1) = "M\xFCller";
  for (const char* end : {"\r\n", "\n", "\r", " \n"}) {
    const auto read = read_photometry(file.text(end), "made.ldt");
    EXPECT_NEAR(read.intensity.maximum(), 200.5, 1e-9);
    EXPECT_NEAR(read.intensity.at_angles(60.0, 0.0), 101.0, 1e-9);
    EXPECT_EQ(read.maker, "M\u00FCller");
  }
  const auto text = file.text();
  EXPECT_NEAR(read_photometry(text.substr(0, text.size() - 5), "made.ldt").intensity.maximum(), 200.5, 1e-9);
}

TEST(ReadEulumdat, tolerates_missing_values_at_the_end_of_less_than_a_plane) {
  MadeLdt file;
  file.set_planes(2, {"0", "90", "180", "270"});
  file.values = numbered(3);
  file.values.resize(7);
  const auto read = file.read();
  EXPECT_NE(warnings_of(read).find("the last 2 intensities are missing"), std::string::npos);
  EXPECT_EQ(read.intensity.at_angles(60.0, 180.0), 0.0);
  file.values.resize(6);
  EXPECT_NE(refusal(file.text()).find("expected 16 angles and intensities"), std::string::npos);
  file.values = numbered(3);
  file.c = {"0", "90", "180"};  // without those that are not stored
  EXPECT_NE(warnings_of(file.read()).find("C angles of its stored planes only"), std::string::npos);
  EXPECT_NEAR(file.read().intensity.at_angles(60.0, 180.0), 60.0, 1e-9);
}

TEST(ReadEulumdat, warns_where_header_and_intensities_differ_by_more_than_5_percent) {
  MadeLdt file;
  const auto flux = file.read().intensity.linear_flux() / 20.0;  // % of the lamps
  for (const auto& [change, warns] : {std::pair(1.04, false), {0.96, false}, {1.06, true}, {0.93, true}}) {
    file.line(23) = fmt::format("{}", flux * change);
    const auto read = file.read();
    EXPECT_EQ(warnings_of(read).find("the header states") != std::string::npos, warns) << change;
    EXPECT_NEAR(read.intensity.maximum(), 200.0, 1e-12);
  }
}

TEST(ReadEulumdat, refuses_bad_files_in_one_sentence_with_file_and_line) {
  struct Case {
    std::size_t line;
    const char *text, *message;
  };
  for (const auto& [line, text, message] : {
           Case{3, "5", "made.ies:3: expected the symmetry, a whole number from 0 to 4"},
           Case{4, "0", "made.ies:4: expected the number of C planes"},
           Case{4, "1e9", "made.ies:4: expected the number of C planes"},
           Case{6, "1", "made.ies:6: expected the number of gamma angles"},
           Case{6, "1000001", "made.ies:6: expected the number of gamma angles"},
           Case{16, "wide", "made.ies:16: expected a size of the luminous area, a number, found 'wide'"},
           Case{26, "-1", "made.ies:26: expected the number of lamp sets"},
           Case{26, "3", "made.ies:"},
       }) {
    MadeLdt file;
    file.line(line) = text;
    EXPECT_NE(refusal(file.text()).find(message), std::string::npos) << message << "\n"
                                                                     << refusal(file.text());
  }
  MadeLdt file;
  file.line(4) = file.line(6) = "2000";
  EXPECT_NE(refusal(file.text()).find("at most 1000000 intensities"), std::string::npos);
  MadeLdt odd;
  odd.set_planes(4, {"0", "90", "180"});
  EXPECT_NE(refusal(odd.text()).find("made.ies:4: expected a number of C planes that 4 divides"),
            std::string::npos);
  MadeLdt descending;
  descending.gamma = {"0", "90", "60"};
  EXPECT_NE(
      refusal(descending.text()).find("made.ies:46: expected ascending gamma angles, found 60 after 90"),
      std::string::npos)
      << refusal(descending.text());
  MadeLdt letters;
  letters.values[1] = "a lot";
  EXPECT_NE(refusal(letters.text()).find("made.ies:48: expected a number, found 'a'"), std::string::npos)
      << refusal(letters.text());
  const auto whole = MadeLdt{}.text();
  for (std::size_t cut = 0; cut + 20 < whole.size(); cut += 3)
    EXPECT_NE(refusal(whole.substr(0, cut)), "") << cut;
}

}  // namespace
}  // namespace luxel
