// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include <gtest/gtest.h>

#include "support/photometric_files.h"

namespace luxel {
namespace {

TEST(ReadIes, knows_the_versions_and_which_factors_they_multiply) {
  struct Case {
    const char *tag, *format;
    double maximum;  // cd: 1000 x multiplier 2 x ballast factor 0.9 x, until 1991, ballast-lamp factor 0.8
    bool warns;
  };
  for (const auto& [tag, format, maximum, warns] : {
           Case{"Some luminaire\n", "IES LM-63-1986", 1440.0, false},
           Case{"IESNA91\r\n", "IES LM-63-1991", 1440.0, false},
           Case{"IESNA:LM-63-1995\n", "IES LM-63-1995", 1800.0, false},
           Case{"IESNA:LM-63-2002 \n", "IES LM-63-2002", 1800.0, false},
           Case{"IES:LM-63-2019\n", "IES LM-63-2019", 1800.0, false},
           Case{"IESNA95\n", "IES LM-63-1995", 1800.0, true},
           Case{"IES:LM-63-2027\n", "IES LM-63-2019", 1800.0, true},
           Case{"IESNA\n", "IES LM-63-2002", 1800.0, true},
       }) {
    MadeIes file;
    file.tag = tag;
    file.lamps = "1 1000 2";
    file.ballast = "0.9 0.8 20";
    const auto read = file.read();
    EXPECT_EQ(read.format, format);
    EXPECT_NEAR(read.intensity.maximum(), maximum, 1e-9) << tag;
    EXPECT_EQ(warnings_of(read).find("made.ies:1:") != std::string::npos, warns) << warnings_of(read);
  }
}

TEST(ReadIes, has_absolute_and_relative_photometry) {
  MadeIes file;
  file.lamps = "2 1200 1";
  const auto relative = file.read();
  EXPECT_FALSE(relative.absolute);
  ASSERT_NE(relative.lamp(), nullptr);
  EXPECT_EQ(relative.lamp()->count, 2.0);
  EXPECT_EQ(relative.lamp()->flux, 2400.0);
  EXPECT_EQ(relative.lamp()->watts, 20.0);
  EXPECT_EQ(relative.intensity.maximum(), 1000.0) << "candela are not scaled by lumens";
  file.lamps = "1 -1 1";
  const auto absolute = file.read();
  EXPECT_TRUE(absolute.absolute);
  EXPECT_EQ(absolute.lamp()->flux, 0.0);
  EXPECT_EQ(absolute.intensity.maximum(), 1000.0);
}

// 1000 cd in the lower half are 2000 pi lm.
TEST(ReadIes, warns_where_the_lamps_cannot_give_the_light_and_changes_nothing) {
  MadeIes file;
  file.candela = "1000 1000 1000";
  file.lamps = "1 6000 1";
  EXPECT_EQ(warnings_of(file.read()), "");  // 6283 lm, 4.7 % more
  file.lamps = "1 5900 1";
  const auto read = file.read();
  EXPECT_NE(warnings_of(read).find("integrate to 6283.2 lm, an efficiency of 1.06"), std::string::npos)
      << warnings_of(read);
  EXPECT_NEAR(read.intensity.linear_flux(), 2000.0 * std::numbers::pi, 1e-3);
}

TEST(ReadIes, takes_blanks_commas_and_line_ends_as_separators) {
  const auto plain = MadeIes{}.read();
  for (const char* text :
       {"IESNA:LM-63-2002\r\n[MANUFAC] Maker\r\nTILT=NONE\r\n1 10000\r\n1 3,1 1 2 0,0\r\n0 "
        "1,1 , 20\r\n0,60\r\n90\r\n"
        "0 1000,\r\n500\t0\r\n",
        "IESNA:LM-63-2002\r[MANUFAC] Maker\rTILT=NONE\r1.0 10000. +1 3.0 1 1 2 0 0 0 1 1 "
        "20 0 60 90 0 1e3 5.E2 0",
        "\xEF\xBB\xBF\n iesna:lm-63-2002\n[manufac]Maker\n tilt = none "
        "\n1,10000,1,3,1,1,2,0,0,0\n1,1,20\n0,60,90\n0\n"
        "1000,500,0\n\x1A garbage"}) {
    const auto read = read_photometry(text, "made.ies");
    EXPECT_EQ(read.format, plain.format);
    EXPECT_EQ(read.maker, "Maker");
    EXPECT_EQ(read.intensity.candela(), plain.intensity.candela());
    EXPECT_EQ(read.intensity.vertical(), plain.intensity.vertical());
    EXPECT_EQ(warnings_of(read), "");
  }
}

TEST(ReadIes, reads_keywords_with_their_continuations_as_utf8) {
  MadeIes file;
  file.labels =
      "[TEST] T 1\n[MANUFAC] M\xFCller \x96 S\xF6hne\n[LUMCAT] C-3\n[LUMINAIRE] Pendant\n[MORE] "
      "direct/indirect\n"
      "[LAMP] LED \xC2\xB5\n[_OTHER] x\n[MORE] y\n[LUMINAIRE] Another\n";
  const auto read = file.read();
  EXPECT_EQ(read.test_report, "T 1");
  EXPECT_EQ(read.maker, "M\u00FCller \u2013 S\u00F6hne");
  EXPECT_EQ(read.catalogue, "C-3");
  EXPECT_EQ(read.luminaire, "Pendant direct/indirect");
  EXPECT_EQ(read.lamp()->name, "LED \u00B5");
  MadeIes old;
  old.tag = "Wall washer 150 W\nsecond line\n";
  old.labels = "";
  EXPECT_EQ(old.read().luminaire, "Wall washer 150 W");
}

TEST(ReadIes, has_every_range_of_angles) {
  const auto at = [](const Photometry& p, double around) { return p.intensity.at_angles(60.0, around); };
  MadeIes file;
  file.candela = "9 1 0 9 2 0 9 4 0";
  file.horizontal = "0 45 90";
  for (const auto around : {45.0, 135.0, 225.0, 315.0}) EXPECT_NEAR(at(file.read(), around), 2.0, 1e-12);
  file.horizontal = "0 90 180";
  EXPECT_NEAR(at(file.read(), 270.0), 2.0, 1e-12);
  file.horizontal = "90 180 270";
  EXPECT_NEAR(at(file.read(), 0.0), 2.0, 1e-12);
  file.horizontal = "-90 0 90";
  EXPECT_NEAR(at(file.read(), 90.0), 4.0, 1e-12);
  EXPECT_NEAR(at(file.read(), 180.0), 2.0, 1e-12);
  EXPECT_NEAR(at(file.read(), 225.0), 1.5, 1e-12);
  file.horizontal = "180 270 360";
  EXPECT_NEAR(at(file.read(), 90.0), 2.0, 1e-12);
  EXPECT_NEAR(at(file.read(), 0.0), 4.0, 1e-12);
  file.horizontal = "0 120 240";
  EXPECT_NEAR(at(file.read(), 300.0), 2.5, 1e-12);
  file.horizontal = "-180 0 180";
  EXPECT_NEAR(at(file.read(), 0.0), 2.0, 1e-12);
  EXPECT_NEAR(at(file.read(), 180.0), 1.0, 1e-12);
  EXPECT_EQ(warnings_of(file.read()), "");
  file.horizontal = "0 30 60";
  EXPECT_NE(warnings_of(file.read()).find("made.ies:7: horizontal angles 0 to 60"), std::string::npos)
      << warnings_of(file.read());
  EXPECT_NEAR(at(file.read(), 90.0), 4.0, 1e-12);
  // 0..90, 90..180 and 0..180 degrees; the rest is 0.
  MadeIes up;
  up.vertical = "90 120 180";
  EXPECT_EQ(up.read().intensity.at({0.0, 0.1, -1.0}), 0.0);
  EXPECT_NEAR(up.read().intensity.at({0.0, 1e-9, 1.0}), 0.0, 1e-5);
  EXPECT_NEAR(up.read().intensity.at_angles(120.0, 0.0), 500.0, 1e-12);
  EXPECT_EQ(warnings_of(up.read()), "");
  up.vertical = "0 30 60";
  EXPECT_NE(warnings_of(up.read()).find("vertical angles 0 to 60"), std::string::npos);
}

TEST(ReadIes, has_types_a_and_b_and_both_meanings_of_type_1_in_1986) {
  MadeIes file;
  file.vertical = "-60 0 60";
  file.horizontal = "-60 0 60";
  file.candela = "0 1 0 2 9 3 0 4 0";
  const auto tangent = std::tan(std::numbers::pi / 3.0);
  for (const char* type : {"2", "3"}) {
    file.type = type;
    const auto read = file.read();
    EXPECT_EQ(read.intensity.type(), *type == '2' ? GoniometerType::b : GoniometerType::a);
    EXPECT_NEAR(read.intensity.at({0.0, 0.0, -1.0}), 9.0, 1e-9);
    EXPECT_NEAR(read.intensity.at({tangent, 0.0, -1.0}), 4.0, 1e-6);
    EXPECT_NEAR(read.intensity.at({0.0, tangent, -1.0}), 3.0, 1e-6);
  }
  file.type = "1";
  EXPECT_NE(refusal(file.text()).find("made.ies:6: expected vertical angles from 0 on in type C"),
            std::string::npos)
      << refusal(file.text());
  file.tag = "Headlamp\n";
  EXPECT_EQ(file.read().intensity.type(), GoniometerType::a);
  EXPECT_NE(warnings_of(file.read()).find("type A is taken"), std::string::npos);
  file.type = "2";
  file.horizontal = "0 30 60";
  EXPECT_NEAR(file.read().intensity.at_angles(0.0, -30.0), 9.0, 1e-12) << "mirrored";
}

TEST(ReadIes, applies_the_tilt_factor_of_the_untilted_luminaire_and_says_so) {
  MadeIes file;
  file.tilt = "TILT=INCLUDE\n3\n3\n0 45 90\n0.95 .9 0.8\n";
  const auto read = file.read();
  EXPECT_NEAR(read.intensity.maximum(), 950.0, 1e-9);
  EXPECT_NE(warnings_of(read).find("made.ies:3: tilt factors of 0.8 to 0.95"), std::string::npos)
      << warnings_of(read);
  file.tilt = "TILT=INCLUDE\n4\n1\n0\n1\n";
  EXPECT_NE(refusal(file.text()).find("made.ies:4: expected the lamp's geometry"), std::string::npos);
}

TEST(ReadIes, reads_a_tilt_file_from_its_own_folder_only) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "luxel_tilt";
  std::filesystem::create_directories(folder / "inner");
  std::ofstream(folder / "lamp.tlt") << "1\n2\n0 90\n0.5 0.25\n";
  MadeIes file;
  const auto load = [&](const std::string& name, const char* where) {
    file.tilt = "TILT=" + name + "\n";
    const auto path = folder / where / "made.ies";
    std::ofstream(path) << file.text();
    return load_photometry(path.string());
  };
  EXPECT_NEAR(load("lamp.tlt", ".").intensity.maximum(), 500.0, 1e-9);
  EXPECT_NEAR(load("C:\\tilt\\lamp.tlt", ".").intensity.maximum(), 500.0, 1e-9);
  for (const auto& name : {"../lamp.tlt", "..", ".", "none.tlt", "/dev/zero"}) {
    const auto read = load(name, "inner");
    EXPECT_EQ(read.intensity.maximum(), 1000.0) << name;
    EXPECT_NE(warnings_of(read).find("is not in the folder of this file"), std::string::npos) << name;
  }
  std::filesystem::remove_all(folder);
}

TEST(ReadIes, refuses_bad_files_in_one_sentence_with_file_and_line) {
  struct Case {
    MadeIes file;
    const char* message;
  };
  const auto with = [](auto member, const char* text) {
    MadeIes file;
    file.*member = text;
    return file;
  };
  for (const auto& [file, message] : {
           Case{with(&MadeIes::tilt, ""), "expected a line TILT="},
           Case{with(&MadeIes::lamps, "1 1000 x"),
                "made.ies:4: expected the candela multiplier, a number, found 'x'"},
           Case{with(&MadeIes::lamps, "1 1000 -1"), "made.ies:4: expected the candela multiplier above 0"},
           Case{with(&MadeIes::type, "4"),
                "made.ies:4: expected the photometric type, a whole number from 1 to 3"},
           Case{with(&MadeIes::units, "0"), "made.ies:4: expected the units, 1 for feet or 2 for metres"},
           Case{with(&MadeIes::vertical, "0 60 60"), "made.ies:6: expected ascending vertical angles"},
           Case{with(&MadeIes::vertical, "0 nan 90"), "made.ies:6: expected vertical angle 2 of 3, a number"},
           Case{with(&MadeIes::vertical, "0 90 190"), "expected vertical angles of 0 to 180 degrees"},
           Case{with(&MadeIes::horizontal, "400"), "made.ies:7: expected a horizontal angle within 360"},
           Case{with(&MadeIes::candela, "1000 500"), "made.ies:8: the file ends where candela should be"},
           Case{with(&MadeIes::candela, "1000 1e99 0"),
                "made.ies:8: expected candela, a number, found '1e99'"},
           Case{with(&MadeIes::candela, "1e30 1e30 0"), "" /* the largest numbers are read */},
       })
    EXPECT_NE(refusal(file.text()).find(message), std::string::npos) << message << "\n"
                                                                     << refusal(file.text());
  const std::string head = "IESNA91\nTILT=NONE\n1 1000 1 ";
  for (const char* counts :
       {"1000000 1000000 1 1 0 0 0", "1e18 1 1 1 0 0 0", "-3 1 1 1 0 0 0", "3.5 1 1 1 0 0 0"})
    EXPECT_NE(refusal(head + counts + "\n1 1 1\n0 1 2\n").find("made.ies:3: expected"), std::string::npos)
        << counts;
  for (const char* text : {"", "\n\n\n", "hello", "\xFF\xFEI\0E", "IES"})
    EXPECT_NE(refusal(text), "") << text;
}

TEST(ReadIes, mends_what_files_get_wrong_and_warns) {
  const auto warns = [](auto member, const char* text, const char* message) {
    MadeIes file;
    file.*member = text;
    const auto read = file.read();
    EXPECT_NE(warnings_of(read).find(message), std::string::npos) << warnings_of(read);
    return read;
  };
  EXPECT_EQ(
      warns(&MadeIes::candela, "1000 -2 0", "1 negative values of candela").intensity.at_angles(60.0, 0.0),
      0.0);
  warns(&MadeIes::candela, "1000 500 0 77", "made.ies:8: more follows");
  EXPECT_EQ(warns(&MadeIes::ballast, "0 1 20", "the ballast factor is 0").intensity.maximum(), 1000.0);
  EXPECT_TRUE(warns(&MadeIes::lamps, "1 0 1", "lumens per lamp is 0").absolute);
  warns(&MadeIes::lamps, "0 -1 1", "number of lamps is 0");
  warns(&MadeIes::tilt, "TILT=\n", "TILT= names nothing");
  MadeIes bracketed;
  bracketed.tilt = "[TILT]=NONE\n";
  EXPECT_EQ(bracketed.read().intensity.maximum(), 1000.0);
  warns(&MadeIes::candela, "0 0 0", "all intensities are 0");
}

}  // namespace
}  // namespace luxel
