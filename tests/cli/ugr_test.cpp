// SPDX-License-Identifier: Apache-2.0
// End-to-end tests of rooms and of glare.
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "luxel/core/output_file.h"

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

using Json = nlohmann::json;

// A cosine panel of 0.6 x 0.6 m with 1000 cd straight down, in EULUMDAT, and the same as IES.
std::string panel_ldt() {
  std::string text = "maker\n1\n1\n1\n0\n19\n5\nreport\npanel\nnumber\nfile\ndate\n600\n600\n50\n600\n600\n";
  text += "0\n0\n0\n0\n100\n100\n1\n0\n1\n1\nLED\n3141.6\n4000\n80\n30\n";
  for (int i = 0; i < 10; ++i) text += "0\n";
  text += "0\n";
  for (int i = 0; i < 19; ++i) text += std::to_string(5 * i) + "\n";
  for (int i = 0; i < 19; ++i) text += std::to_string(318.31 * std::cos(5 * i * 3.14159265 / 180.0)) + "\n";
  return text;
}

void refuses(const std::filesystem::path& folder, const std::string& line, int code,
             const std::string& text) {
  const auto outcome = cli::run(folder, "$LUXEL " + line);
  EXPECT_EQ(outcome.code, code) << line << "\n" << outcome.err;
  EXPECT_NE(outcome.err.find(text), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out, "") << line;
}

TEST(Room, loads_and_bakes_at_once) {
  const auto folder = fresh_folder("room");
  const auto made = cli::run(folder, "$LUXEL room 5x4x3 -o closed.obj");
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(made.out, "closed.obj\nclosed.mtl\n");
  const auto info = cli::run(folder, "$LUXEL info closed.obj --json");
  const auto json = Json::parse(info.out);
  EXPECT_EQ(json["triangles"], 12);
  const auto checked = Json::parse(cli::run(folder, "$LUXEL check closed.obj --sky none --json").out);
  EXPECT_EQ(checked["components"], 1);
  EXPECT_EQ(checked["closed_components"], 1) << "each edge belongs to two faces";
  const auto baked = cli::run(folder, "$LUXEL bake closed.obj --error 20% -o room.vtkhdf --quiet");
  EXPECT_EQ(baked.code, 0) << baked.err;
  // The areas and the reflectances of the six faces.
  const auto measured = Json::parse(cli::run(folder, "$LUXEL measure room.vtkhdf --json").out);
  double area = 0.0;
  for (const auto& s : measured["surfaces"]) {
    if (s["name"] == "ceiling luminaire") continue;
    area += s["area_m2"].get<double>();
    if (s["name"] == "wall") {
      EXPECT_NEAR(s["area_m2"].get<double>(), 54.0, 1e-4);
    }
  }
  EXPECT_NEAR(area, 94.0, 1e-3);
}

// Windows are holes: 5 m x 3 m less 2 m² and 1 m², and a door of 2 m² in the wall of 4 m. The cuts of one
// wall are also vertices of its neighbours, so that all but the edges of holes have two faces.
TEST(Room, has_windows) {
  const auto folder = fresh_folder("room_windows");
  const auto made =
      cli::run(folder,
               "$LUXEL room 5x4x3 --reflectance 80,60,30 --names lid,side,base --window "
               "south:0.1,0.2,2,1 --window south:3,0.9,1,1 --window east:1,0,1,2 -o room.obj --json");
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(Json::parse(made.out)["windows"], 3);
  EXPECT_NE(read_file(folder / "room.mtl").find("newmtl lid\nKd 0.8 0.8 0.8\n"), std::string::npos);
  const auto checked = cli::run(folder, "$LUXEL check room.obj");
  EXPECT_NE(checked.out.find("0 errors, 1 warning,"), std::string::npos) << checked.out;
  EXPECT_NE(checked.out.find("clear-panes"), std::string::npos) << checked.out;
  EXPECT_NE(checked.out.find("in 3 boundary loops"), std::string::npos) << checked.out;
  EXPECT_EQ(checked.out.find("T-junction"), std::string::npos) << checked.out;
  const auto baked = cli::run(folder, "$LUXEL bake room.obj --error 20% -o room.vtkhdf --quiet");
  ASSERT_EQ(baked.code, 0) << baked.err;
  const auto measured = Json::parse(cli::run(folder, "$LUXEL measure room.vtkhdf --surface side --json").out);
  EXPECT_NEAR(measured["surfaces"][0]["area_m2"].get<double>(), 54.0 - 5.0, 1e-3);
}

// 0.1 + 0.2 is not 0.3 in binary: windows that touch, and one that ends with its wall, leave no slivers.
TEST(Room, has_no_slivers) {
  const auto folder = fresh_folder("room_slivers");
  const auto made =
      cli::run(folder,
               "$LUXEL room 1.1x1x1 --window south:0.1,0.1,0.2,0.5 --window south:0.3,0.1,0.8,0.5 -o "
               "room.obj && $LUXEL info room.obj --json");
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(read_file(folder / "room.obj").find("e-"), std::string::npos);
  EXPECT_EQ(read_file(folder / "room.obj")
                .find("v 0.3 0 0.1\n", read_file(folder / "room.obj").find("v 0.3 0 0.1\n") + 1),
            std::string::npos);
}

TEST(Room, refuses_what_is_no_room) {
  const auto folder = fresh_folder("room_refused");
  for (const char* size : {"6x4", "6x4x0", "6x4x2x1", "1e9x2x2", "nanx2x2", "6x-4x2", "6,4,2"})
    refuses(folder, std::string("room ") + size + " -o a.obj", 2, "expected length x width x height");
  refuses(folder, "room 6x4x3", 2, "give -o room.obj");
  refuses(folder, "room 6x4x3 -o a.glb", 2, "expected the extension .obj");
  refuses(folder, "room 6x4x3 -o a.obj --reflectance 0.7,0.5,0.2", 2, "looks like fractions");
  refuses(folder, "room 6x4x3 -o a.obj --reflectance 70,50,120", 2, "per cent from 0 to 98");
  refuses(folder, "room 6x4x3 -o a.obj --window south:5,0,2,1", 2, "outside its wall of 6 x 3 m");
  refuses(folder, "room 6x4x3 -o a.obj --window west:1,0,2,1 --window west:2,0.5,1,1", 2,
          "overlaps the window");
  refuses(folder, "room 6x4x3 -o a.obj --window roof:1,0,2,1", 2, "--window: expected a wall");
  refuses(folder, "room 6x4x3 -o a.obj --names a,b", 2, "three different words");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.obj"));
}

TEST(UgrTableCommand, writes_the_table) {
  const auto folder = fresh_folder("ugr_table");
  write_file(folder / "panel.ldt", panel_ldt());
  const auto printed = cli::run(folder, "$LUXEL ugr-table panel.ldt");
  ASSERT_EQ(printed.code, 0) << printed.err;
  EXPECT_NE(printed.out.find(" 12H x 8H"), std::string::npos) << printed.out;
  const auto written = cli::run(folder, "$LUXEL ugr-table panel.ldt --spacing 1 -o t.csv -o t.json");
  ASSERT_EQ(written.code, 0) << written.err;
  EXPECT_EQ(written.out, "t.csv\nt.json\n");
  const auto json = Json::parse(read_file(folder / "t.json"));
  EXPECT_EQ(json["command"], "ugr-table");
  EXPECT_EQ(json["spacing_H"], 1.0);
  ASSERT_EQ(json["crosswise"].size(), 19u);
  ASSERT_EQ(json["endwise"][18].size(), 5u);
  // A square panel with rotational light is the same crosswise and endwise.
  for (std::size_t r = 0; r < 19; ++r)
    EXPECT_NEAR(json["crosswise"][r][0].get<double>(), json["endwise"][r][0].get<double>(), 1e-6);
  refuses(folder, "ugr-table none.ldt", 1, "none.ldt: cannot read it");
  refuses(folder, "ugr-table panel.ldt --spacing 0", 2, "--spacing");
  refuses(folder, "ugr-table panel.ldt -o t.txt", 2, ".csv .json");
}

// One luminaire in a room; each factor is checked by hand in unit tests, here that they reach the report.
TEST(UgrCommand, reports_observers_with_intervals_and_sources) {
  const auto folder = fresh_folder("ugr");
  write_file(folder / "panel.ldt", panel_ldt());
  const auto baked = cli::run(folder,
                              "$LUXEL room 6x4x2.8 -o room.obj > made.txt && $LUXEL bake room.obj "
                              "--luminaire-grid panel.ldt:1x1@2.8 --error 5% --store-transport --quiet -o "
                              "room.vtkhdf");
  ASSERT_EQ(baked.code, 0) << baked.err;
  const auto seen = cli::run(
      folder,
      "$LUXEL ugr room.vtkhdf --observer 0.2,2,1.2:1,0,0 --observer 0.2,2,1.2:-2,0,0 -o u.csv -o u.json");
  ASSERT_EQ(seen.code, 0) << seen.err;
  EXPECT_EQ(seen.out, "u.csv\nu.json\n");
  EXPECT_NE(seen.err.find("observer 1: UGR "), std::string::npos) << seen.err;
  EXPECT_NE(seen.err.find("observer 2: no UGR"), std::string::npos) << seen.err;
  const auto json = Json::parse(read_file(folder / "u.json"));
  EXPECT_EQ(json["solution_errors"], "replicates");
  EXPECT_EQ(json["lamps"], 1);
  const auto& first = json["observers"][0];
  ASSERT_EQ(first["sources"].size(), 1u);
  const auto& source = first["sources"][0];
  EXPECT_NEAR(source["position_m"][0].get<double>(), 3.0, 1e-5);
  EXPECT_NEAR(source["luminance_cd_per_m2"].get<double>(), 1000.0 / 0.36, 20.0);  // linear between 5 degrees
  EXPECT_NEAR(source["contribution"].get<double>(), 1.0, 1e-12);
  const auto ugr = first["ugr"].get<double>(), p = source["position_index"].get<double>();
  const auto expected = 8.0 * std::log10(0.25 / first["background_cd_per_m2"].get<double>() *
                                         std::pow(source["luminance_cd_per_m2"].get<double>() / p, 2) *
                                         source["solid_angle_sr"].get<double>());
  EXPECT_NEAR(ugr, expected, 1e-9);
  EXPECT_LT(first["low"].get<double>(), ugr);
  EXPECT_GT(first["high"].get<double>(), ugr);
  EXPECT_LT(first["high"].get<double>() - first["low"].get<double>(), 1.0);
  EXPECT_TRUE(json["observers"][1]["ugr"].is_null());
  const auto table = read_file(folder / "u.csv");
  EXPECT_EQ(table.substr(0, 22), "x,y,z,nx,ny,nz,ugr,low");
  EXPECT_NE(table.find("\n0.2,2,1.2,-1,0,0,,,,"), std::string::npos) << table;

  write_file(folder / "seats.csv", "x,y,z,nx,ny,nz\n0.2,2,1.2,3,0,0\n");
  const auto of_file = cli::run(folder, "$LUXEL ugr room.vtkhdf --observers seats.csv --quiet --json");
  EXPECT_EQ(Json::parse(of_file.out)["observers"][0], first);
  const auto grid =
      cli::run(folder, "$LUXEL ugr room.vtkhdf --grid 0,0,1.2:6,0,1.2:0,4,1.2:2x2 --quiet --json");
  EXPECT_EQ(Json::parse(grid.out)["observers"].size(), 16u);
  const auto one_way = cli::run(
      folder, "$LUXEL ugr room.vtkhdf --grid 0,0,1.2:6,0,1.2:0,4,1.2:2x2 --view 0,1,0 --quiet --json");
  EXPECT_EQ(Json::parse(one_way.out)["observers"].size(), 4u);

  refuses(folder, "ugr room.vtkhdf", 2, "no observers");
  refuses(folder, "ugr room.vtkhdf --observer 1,2,3", 2, "expected an eye and a direction");
  refuses(folder, "ugr room.vtkhdf --observer 1,2,3:0,0,0", 2, "expected a direction");
  refuses(folder, "ugr room.vtkhdf --observer 1,2,3:1,0,0 --view 1,0,0", 2, "--view belongs to --grid");
  write_file(folder / "bad.csv", "1,2,1.2\n");
  refuses(folder, "ugr room.vtkhdf --observers bad.csv", 1, "expected where observers look");
}

// Squares that emit, which the command adds below the ceiling of a room without lamps, dazzle too.
TEST(UgrCommand, has_surfaces_as_sources) {
  const auto folder = fresh_folder("ugr_surfaces");
  const auto seen =
      cli::run(folder,
               "$LUXEL room 6x4x2.8 -o room.obj > made.txt && $LUXEL bake room.obj --error 20% --quiet "
               "-o room.vtkhdf > baked.txt && $LUXEL ugr room.vtkhdf --observer 0.2,2,1.2:1,0,0 --json");
  ASSERT_EQ(seen.code, 0) << seen.err;
  const auto observer = Json::parse(seen.out)["observers"][0];
  ASSERT_EQ(observer["sources"].size(), 1u) << seen.out;
  EXPECT_EQ(observer["sources"][0]["name"], "ceiling luminaire");
  EXPECT_EQ(observer["sources"][0]["visible"], 1.0);
}

TEST(Room, is_quiet_on_request) {
  const auto folder = fresh_folder("room_quiet");
  const auto made = cli::run(folder, "$LUXEL room 5x4x3 --quiet -o a.obj");
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(made.out + made.err, "");
  EXPECT_TRUE(std::filesystem::exists(folder / "a.mtl"));
}

// UGR of an area is judged by the observers in it, else by all; colour rendering by the EULUMDAT file.
TEST(UgrCommand, judges_areas) {
  const auto folder = fresh_folder("ugr_areas");
  write_file(folder / "panel.ldt", panel_ldt());
  write_file(folder / "areas.toml",
             "[[area]]\nname = \"desk\"\nkind = \"task\"\nrequirement = \"writing\"\nUGR = 40\n"
             "polygon = [[0.5, 0.5, 0.75], [2, 0.5, 0.75], [2, 2, 0.75], [0.5, 2, 0.75]]\n"
             "[[area]]\nname = \"empty\"\nUGR = 1\n"
             "polygon = [[3, 3, 0.75], [4, 3, 0.75], [4, 3.9, 0.75], [3, 3.9, 0.75]]\n"
             "[[area]]\nname = \"free\"\nEm = 1\n"
             "polygon = [[3, 3, 0.75], [4, 3, 0.75], [4, 3.9, 0.75], [3, 3.9, 0.75]]\n");
  const auto made = cli::run(folder,
                             "$LUXEL room 5x4x2.8 --quiet -o room.obj && $LUXEL bake room.obj "
                             "--luminaire-grid panel.ldt:2x2@2.8 --error "
                             "10% --store-transport --quiet -o room.vtkhdf && $LUXEL ugr room.vtkhdf "
                             "--observer 1,1,1.2:1,0,0 --observer "
                             "0.2,2,1.2:1,0,0 --areas areas.toml --require-ugr 2 --json && $LUXEL probe "
                             "room.vtkhdf --areas areas.toml "
                             "--json-file probe.json -o p.csv --quiet");
  ASSERT_EQ(made.code, 0) << made.err;
  const auto start = made.out.find('{');
  const auto json = Json::parse(made.out.substr(start, made.out.find("\n}\n", start) + 2 - start));
  const auto& verdicts = json["verdicts"];
  ASSERT_EQ(verdicts.size(), 3u);
  EXPECT_EQ(verdicts[0]["area"], nullptr);
  EXPECT_EQ(verdicts[0]["verdict"], "not met");
  EXPECT_EQ(verdicts[1]["area"], "desk");
  EXPECT_EQ(verdicts[1]["verdict"], "met");
  EXPECT_EQ(verdicts[1]["note"], "highest of the observers in this area: 1");
  EXPECT_EQ(verdicts[1]["measured"]["value"], json["observers"][0]["ugr"]);
  EXPECT_EQ(verdicts[2]["area"], "empty");
  EXPECT_EQ(verdicts[2]["verdict"], "not met");
  EXPECT_NE(verdicts[2]["note"].get<std::string>().find("highest of all observers"), std::string::npos);
  EXPECT_NE(made.err.find("desk: UGR ≤ 40: met"), std::string::npos) << made.err;
  const auto probe = Json::parse(read_file(folder / "probe.json"));
  const auto& of_desk = probe["areas"][0]["verdicts"];
  EXPECT_EQ(of_desk.back()["quantity"], "Ra");
  EXPECT_EQ(of_desk.back()["verdict"], "met") << "the file states 80";
  refuses(folder, "ugr room.vtkhdf --observer 1,1,1.2:1,0,0 --requirements a.toml", 2,
          "--requirements belongs to --areas");
}

}  // namespace
}  // namespace luxel::cli
