// SPDX-License-Identifier: Apache-2.0
// End-to-end tests of `luxel photometry`.
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

using Json = nlohmann::json;

std::filesystem::path folder_of_luminaires(const std::string& name) {
  const auto folder = fresh_folder(name);
  for (const auto& entry : std::filesystem::directory_iterator(LUXEL_SOURCE_DIR "/scenes/luminaires"))
    std::filesystem::copy_file(entry.path(), folder / entry.path().filename());
  return folder;
}

TEST(PhotometryCommand, prints_what_a_data_sheet_has) {
  const auto folder = folder_of_luminaires("photometry");
  const auto run = cli::run(folder, "$LUXEL photometry wall-washer.ies");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_TRUE(
      run.out.starts_with("wall-washer.ies: IES LM-63-2002, type C, relative photometry\n"
                          "  luminous flux      2880.00 lm\n"))
      << run.out;
  for (const char* words :
       {"80.0 % of the lamps' 3600 lm", "96.0 lm/W", "100.0 % of the flux", "gamma 35, C 90",
        "0.9 m along X, 0.08 m along Y", "Luxel", "1 x LED, 3600 lm, 30 W"})
    EXPECT_NE(run.out.find(words), std::string::npos) << words << "\n" << run.out;
  // The narrow beam in steps of 1 degree: zonal and linear flux differ by less than 0.5 %.
  EXPECT_EQ(cli::run(folder, "$LUXEL photometry spotlight.ies").out.find("zonal"), std::string::npos);
}

TEST(PhotometryCommand, has_the_same_numbers_as_json) {
  const auto folder = folder_of_luminaires("photometry_json");
  const auto run = cli::run(folder, "$LUXEL photometry wall-washer.ldt --json -o polar.svg");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = Json::parse(run.out);
  EXPECT_EQ(json["command"], "photometry");
  EXPECT_EQ(json["format"], "EULUMDAT");
  EXPECT_NEAR(json["luminous_flux"].get<double>(), 2880.0, 0.05);
  EXPECT_NEAR(json["linear_flux"].get<double>() / 2880.0, 1.0, 2e-3);
  EXPECT_NEAR(json["efficiency"].get<double>(), 0.8, 1e-4);
  EXPECT_NEAR(json["downward_fraction"].get<double>(), 1.0, 1e-12);
  EXPECT_EQ(json["maximum"]["vertical_angle"], 35.0);
  EXPECT_EQ(json["maximum"]["horizontal_angle"], 0.0);
  EXPECT_EQ(json["planes"][0]["plane"], "C0-C180");
  EXPECT_GT(json["planes"][0]["field_angle"], json["planes"][0]["beam_angle"]);
  EXPECT_EQ(json["opening"]["shape"], "rectangle");
  EXPECT_EQ(json["opening"]["size"], (Json{0.08, 0.9, 0.0}));
  EXPECT_EQ(json["lamps"][0]["flux"], 3600.0);
  EXPECT_EQ(json["lamp_set"], 1);
  EXPECT_EQ(json["warnings"], Json::array());
  EXPECT_EQ(json["outputs"], Json{"polar.svg"});
  const auto svg = read_file(folder / "polar.svg");
  EXPECT_TRUE(svg.starts_with("<svg ")) << svg;
  EXPECT_NE(svg.find(">cd/klm<"), std::string::npos);
  EXPECT_EQ(Json::parse(cli::run(folder, "$LUXEL photometry led-panel.ies --json").out)["efficiency"],
            nullptr);
}

TEST(PhotometryCommand, draws_the_diagram_of_the_documents) {
  const auto folder = folder_of_luminaires("photometry_figure");
  ASSERT_EQ(cli::run(folder, "$LUXEL photometry wall-washer.ldt -o polar.svg").code, 0);
  EXPECT_EQ(read_file(folder / "polar.svg"),
            read_file(LUXEL_SOURCE_DIR "/docs/images/polar-wall-washer.svg"));
}

TEST(PhotometryCommand, turns_the_light) {
  const auto folder = folder_of_luminaires("photometry_rotate");
  const auto turned =
      Json::parse(cli::run(folder, "$LUXEL photometry wall-washer.ies --rotate -90 --json").out);
  const auto ldt = Json::parse(cli::run(folder, "$LUXEL photometry wall-washer.ldt --json").out);
  EXPECT_EQ(turned["opening"], ldt["opening"]);
  for (int i = 0; i < 2; ++i)
    EXPECT_NEAR(turned["planes"][i]["beam_angle"].get<double>(), ldt["planes"][i]["beam_angle"].get<double>(),
                1e-3);
}

TEST(PhotometryCommand, chooses_among_alternative_lamps) {
  const auto folder = folder_of_luminaires("photometry_lamps");
  auto text = read_file(folder / "wall-washer.ldt");
  const std::string lamps = "\n1\n1\nLED\n3600\n4000 K\n80\n30\n";
  const auto at = text.find(lamps);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, lamps.size(), "\n2\n1\nLED\n3600\n4000 K\n80\n30\n2\nhigh output\n7200\n3000 K\n90\n60\n");
  std::ofstream(folder / "two.ldt") << text;
  const auto run = cli::run(folder, "$LUXEL photometry two.ldt --lamp-set 2");
  EXPECT_NE(run.out.find("luminous flux      5760.00 lm"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("2 x high output, 7200 lm, 60 W, colour 3000 K, Ra 90 (used)"), std::string::npos);
  EXPECT_NE(run.err.find("two.ldt:26: the file has 2 alternative sets of lamps: set 2 is taken"),
            std::string::npos)
      << run.err;
  const auto third = cli::run(folder, "$LUXEL photometry two.ldt --lamp-set 3");
  EXPECT_EQ(third.code, 1);
  EXPECT_NE(third.err.find("there is no lamp set 3, the file has 2"), std::string::npos) << third.err;
}

TEST(PhotometryCommand, refuses_and_warns_in_one_sentence) {
  const auto folder = folder_of_luminaires("photometry_misuse");
  std::ofstream(folder / "bad.ies") << "IESNA91\nTILT=NONE\n1 1000 1 2 1 1 2 0 0 0\n1 1 10\n90 0\n0\n1 1\n";
  const auto bad = cli::run(folder, "$LUXEL photometry bad.ies");
  EXPECT_EQ(bad.code, 1);
  EXPECT_EQ(bad.out, "");
  EXPECT_EQ(bad.err, "luxel: bad.ies:5: expected ascending vertical angles, found 0 after 90\n");
  EXPECT_EQ(cli::run(folder, "$LUXEL photometry none.ies").code, 1);
  EXPECT_EQ(cli::run(folder, "$LUXEL photometry cornell-box.obj").code, 1);
  EXPECT_EQ(cli::run(folder, "$LUXEL photometry spotlight.ies -o polar.png").code, 2);
  EXPECT_EQ(cli::run(folder, "$LUXEL photometry spotlight.ies --lamp-set 0").code, 2);
  std::ofstream(folder / "odd.ies")
      << "IESNA95\nTILT=NONE\n1 100 1 2 1 1 2 0 0 0\n1 1 10\n0 90\n0\n100 100\n";
  const auto odd = cli::run(folder, "$LUXEL photometry odd.ies --json");
  EXPECT_EQ(odd.code, 0);
  EXPECT_NE(odd.err.find("warning: odd.ies:1: 'IESNA95' names no version of LM-63"), std::string::npos)
      << odd.err;
  EXPECT_NE(odd.err.find("an efficiency of 6.28"), std::string::npos) << odd.err;
  EXPECT_EQ(Json::parse(odd.out)["warnings"].size(), 2u);
}

}  // namespace
}  // namespace luxel::cli
