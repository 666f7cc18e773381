// SPDX-License-Identifier: Apache-2.0
// luxel daylight: tables, files of hours, drawings, and invariants of turned and mirrored rooms.
//
// Risk. Seeds are fixed. Points of two runs are compared within eight standard errors of their difference
// plus a tenth of a per cent: with other random numbers one of the 32 would fail with a chance below one in a
// thousand.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "luxel/core/output_file.h"

#include "cli/run_program.h"
#include "scenes/weather/temperate_year.h"

namespace luxel::cli {
namespace {

using Json = nlohmann::json;
using Row = std::map<std::string, double>;

const std::string quick = " --sky-patches 145 --error 10% --quiet ";

// A room of 4 x 4 x 3 m with a window of the given place, and the year.
std::filesystem::path room(const std::string& name, const std::string& window) {
  const auto folder = fresh_folder("daylight_" + name);
  const auto made = cli::run(folder, "$LUXEL room 4x4x3 --quiet --window " + window + " -o room.obj");
  EXPECT_EQ(made.code, 0) << made.err;
  write_file(folder / "town.wea", scenes::temperate_year());
  return folder;
}

std::vector<Row> rows_of(const std::string& csv) {
  std::istringstream lines(csv);
  std::vector<std::string> names;
  std::vector<Row> rows;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    std::vector<std::string> words;
    for (std::string word; std::getline(fields, word, ',');) words.push_back(word);
    if (names.empty()) {
      names = words;
      continue;
    }
    rows.emplace_back();
    for (std::size_t i = 0; i < words.size(); ++i) rows.back()[names[i]] = std::stod(words[i]);
  }
  return rows;
}

std::vector<Row> daylight(const std::filesystem::path& folder, const std::string& arguments) {
  const auto run = cli::run(folder, "$LUXEL daylight room.obj" + quick + arguments);
  EXPECT_EQ(run.code, 0) << run.err;
  return rows_of(run.out);
}

// The row of a place on the plane.
const Row& at(const std::vector<Row>& rows, double x, double y) {
  for (const auto& row : rows)
    if (std::abs(row.at("x") - x) < 1e-6 && std::abs(row.at("y") - y) < 1e-6) return row;
  ADD_FAILURE() << "no point at " << x << ", " << y;
  return rows.front();
}

void expect_same(const Row& a, const Row& b, const std::string& value, const std::string& error) {
  const auto both = std::hypot(a.at(error), b.at(error));
  EXPECT_NEAR(a.at(value), b.at(value), 8.0 * both + 1e-3 * a.at(value))
      << value << " at " << a.at("x") << ", " << a.at("y");
}

TEST(DaylightCommand, has_factors_at_points_and_their_figures) {
  const auto folder = room("factors", "south:1,0.9,2,1.5");
  const auto run =
      cli::run(folder, "$LUXEL daylight room.obj" + quick +
                           "--median-diffuse 15000 --spacing 0.75 -o p.csv -o p.json -o plan.svg");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, "p.csv\np.json\nplan.svg\n");
  const auto rows = rows_of(read_file(folder / "p.csv"));
  ASSERT_EQ(rows.size(), 16u) << "3 m in steps of 0.75 m";
  double mean = 0.0;
  for (const auto& row : rows) {
    EXPECT_EQ(row.at("z"), 0.85);
    EXPECT_NEAR(row.at("sky_component") + row.at("externally_reflected") + row.at("internally_reflected"),
                row.at("daylight_factor_16"), 1e-4 * row.at("daylight_factor_16"));
    EXPECT_LT(row.at("daylight_factor_1"), row.at("daylight_factor_16")) << "type 1 is darker below";
    mean += row.at("daylight_factor_16") / 16.0;
  }
  const auto json = Json::parse(read_file(folder / "p.json"));
  EXPECT_EQ(json["command"], "daylight");
  EXPECT_EQ(json["points"], 16);
  EXPECT_EQ(json["sky_patches"], 145);
  EXPECT_EQ(json["openings_found"], true);
  const auto& figure = json["daylight_factors"][0];
  EXPECT_EQ(figure["cie_type"], 16);
  EXPECT_NEAR(figure["mean"]["value"].get<double>(), mean, 1e-5);
  EXPECT_LE(figure["mean"]["low"].get<double>(), mean);
  EXPECT_GE(figure["mean"]["high"].get<double>(), mean);
  EXPECT_EQ(json["daylight_factors"][1]["cie_type"], 1);
  const auto& provision = json["en_17037_daylight_factor"][0];
  EXPECT_NEAR(provision["target_factor"].get<double>(), 300.0 / 15000.0, 1e-12);
  std::size_t reached = 0;
  for (const auto& row : rows) reached += row.at("daylight_factor_16") >= 0.02 ? 1 : 0;
  EXPECT_NEAR(provision["points_on_target"]["value"].get<double>(), static_cast<double>(reached) / 16.0,
              1e-9);
  EXPECT_FALSE(json.contains("year"));
  const auto plan = read_file(folder / "plan.svg");
  EXPECT_NE(plan.find("Daylight factor, CIE sky type 16"), std::string::npos);
  EXPECT_EQ(plan.find("Daylight autonomy"), std::string::npos);
}

TEST(DaylightCommand, a_turned_room_with_turned_north_has_the_same_year) {
  const auto south = room("south", "south:0.5,0.9,2,1.5"), west = room("west", "west:1.5,0.9,2,1.5");
  // North from +Y to +X: what was at (x, y) is at (y, 4 - x).
  const auto a = daylight(south, "--weather town.wea --spacing 0.75"),
             b = daylight(west, "--weather town.wea --spacing 0.75 --north 90");
  ASSERT_EQ(a.size(), 16u);
  double sun = 0.0;
  for (const auto& row : a) {
    const auto& turned = at(b, row.at("y"), 4.0 - row.at("x"));
    expect_same(row, turned, "daylight_factor_16", "daylight_factor_16_standard_error");
    expect_same(row, turned, "daylight_factor_1", "daylight_factor_1_standard_error");
    // One ray per hour to the disc of the sun: at the frame of the window they may differ.
    EXPECT_NEAR(row.at("direct_sun_hours_1000"), turned.at("direct_sun_hours_1000"), 25.0);
    EXPECT_NEAR(row.at("daylight_autonomy_300"), turned.at("daylight_autonomy_300"), 0.01);
    EXPECT_NEAR(row.at("annual_light_exposure_lxh") / turned.at("annual_light_exposure_lxh"), 1.0, 0.03);
    sun = std::max(sun, row.at("direct_sun_hours_1000"));
  }
  EXPECT_GT(sun, 300.0);
  // With unchanged north the window faces west, which gives another year.
  const auto other = daylight(west, "--weather town.wea --spacing 0.75");
  EXPECT_LT(at(other, 0.875, 2.375).at("annual_light_exposure_lxh"),
            0.9 * at(b, 0.875, 2.375).at("annual_light_exposure_lxh"));
}

TEST(DaylightCommand, a_mirrored_room_mirrors_its_factors) {
  const auto left = room("left", "south:0.3,0.9,1.5,1.5"), right = room("right", "south:2.2,0.9,1.5,1.5");
  const auto a = daylight(left, "--spacing 0.75"), b = daylight(right, "--spacing 0.75");
  ASSERT_EQ(a.size(), 16u);
  for (const auto& row : a) {
    const auto& mirrored = at(b, 4.0 - row.at("x"), row.at("y"));
    expect_same(row, mirrored, "daylight_factor_16", "daylight_factor_16_standard_error");
  }
  EXPECT_GT(at(a, 0.875, 0.875).at("daylight_factor_16"), 1.2 * at(a, 3.125, 0.875).at("daylight_factor_16"));
}

// The hours by h5py: shapes, units, and daylight autonomy counted again.
TEST(DaylightCommand, the_hours_of_a_year_are_read_by_h5py) {
  const auto folder = room("h5", "south:1,0.9,2,1.5");
  if (cli::run(folder, "/usr/bin/python3 -c 'import h5py, numpy'").code != 0)
    GTEST_SKIP() << "h5py is not installed";
  const auto run = cli::run(folder, "$LUXEL daylight room.obj" + quick +
                                        "--weather town.wea --spacing 1 -o year.h5 --occupied 9-17");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, "year.h5\n");
  write_file(folder / "read.py",
             "import h5py, numpy as np\n"
             "f = h5py.File('year.h5')\n"
             "E, t, d = f['illuminance'][:], f['hours/time'][:], f['hours/duration'][:]\n"
             "assert f['illuminance'].attrs['unit'] == b'lx', dict(f['illuminance'].attrs)\n"
             "assert E.shape == f['direct_sun'].shape == f['standard_error'].shape == (len(t), 9), E.shape\n"
             "assert f['points/position'].shape == (9, 3)\n"
             "assert len(t) > 4000 and (E >= 0).all() and (E + 1 >= f['direct_sun'][:]).all()\n"
             "occupied = (t >= 9) & (t < 17)\n"
             "autonomy = ((E >= 300) * d[:, None])[occupied].sum(0) / (8 * 365)\n"
             "stored = f['metrics/daylight_autonomy_300'][:]\n"
             "assert abs(autonomy - stored).max() < 1e-3, (autonomy, stored)\n"
             "assert abs((E * d[:, None]).sum(0) / f['metrics/annual_light_exposure'][:] - 1).max() < 1e-3\n"
             "summer = (f['hours/month'][:] == 6) & (f['hours/day'][:] == 21)\n"
             "assert 62 < f['hours/sun_elevation'][:][summer].max() < 64\n"
             "print('ok')\n");
  const auto read = cli::run(folder, "/usr/bin/python3 read.py");
  EXPECT_EQ(read.out, "ok\n") << read.err;
}

TEST(DaylightCommand, draws_plans_heat_map_and_report_as_whole_files) {
  const auto folder = room("drawings", "south:1,0.9,2,1.5");
  std::filesystem::rename(folder / "room.obj", folder / "a & <b>.obj");
  const auto run = cli::run(folder, "$LUXEL daylight 'a & <b>.obj'" + quick +
                                        "--weather town.wea --spacing 1 -o plan.svg -o day.html --heat-map "
                                        "year.svg --heat-map-point 2 --json");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = Json::parse(run.out);
  EXPECT_EQ(json["outputs"], (Json{"plan.svg", "day.html", "year.svg"}));
  write_file(
      folder / "check.py",
      "import xml.etree.ElementTree as t\n"
      "for f in ('plan.svg', 'year.svg'):\n"
      "  assert t.parse(f).getroot().tag == '{http://www.w3.org/2000/svg}svg'\n"
      "text = open('day.html', encoding='utf-8').read()\n"
      "root = t.fromstring(text.split('\\n', 1)[1])\n"
      "for e in root.iter():\n"
      "  assert not e.tag.endswith(('script', 'link', 'iframe', 'img')), e.tag\n"
      "  assert not any(k in ('src', 'href', 'style') or k.startswith('on') for k in e.attrib), e.attrib\n"
      "svg = '{http://www.w3.org/2000/svg}svg'\n"
      "inner = {i for e in root.iter(svg) for i in e.iter(svg) if i is not e}\n"
      "print(sum(e not in inner for e in root.iter(svg)))\n");
  const auto checked = cli::run(folder, "python3 check.py");
  EXPECT_EQ(checked.out, "5\n") << "four plans and the heat map; " << checked.err;
  const auto page = read_file(folder / "day.html"), plan = read_file(folder / "plan.svg"),
             map = read_file(folder / "year.svg");
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  for (const char* text : {"a &amp; &lt;b&gt;", "temperate year made by Luxel", "LEED v4.1", "BREEAM",
                           "EN 17037 on the climate, high, by hours", "Not assessed", "glass"})
    EXPECT_TRUE(has(page, text)) << text;
  EXPECT_FALSE(has(page, "<b>.obj"));
  const auto& m = json["year"]["sda_300_50_with_blinds"];
  EXPECT_TRUE(has(page, fmt::format("{:.0f} %", 100.0 * m["value"].get<double>())));
  for (const char* text : {"Daylight factor", "Daylight autonomy", "Useful daylight", "Direct sun"})
    EXPECT_TRUE(has(plan, text)) << text;
  EXPECT_TRUE(has(map, "Illuminance at point 2 (2, 1, 0.85 m)")) << map.substr(0, 900);
}

TEST(DaylightCommand, refuses_in_one_sentence_what_it_cannot_do) {
  const auto folder = room("misuse", "south:1,0.9,2,1.5");
  const auto whole = read_file(folder / "town.wea");
  write_file(folder / "cut.wea", whole.substr(0, whole.find("\n6 21 12.5") + 6));
  const std::vector<std::tuple<std::string, int, std::string>> cases = {
      {"-o year.h5", 2, "-o FILE.h5 holds the hours of a year: give --weather FILE"},
      {"--heat-map year.svg", 2, "--heat-map draws the hours of a year: give --weather FILE"},
      {"--heat-map year.png --weather town.wea", 2, "--heat-map year.png: expected the extension .svg"},
      {"--heat-map y.svg --heat-map-point 0 --weather town.wea", 2, "expected mean or the number of a point"},
      {"--heat-map-point 3", 2, "--heat-map-point belongs to --heat-map"},
      {"--heat-map y.svg --heat-map-point 1000 --weather town.wea", 1, "expected a number from 1 to 36"},
      {"-o same.svg --heat-map same.svg --weather town.wea", 2, "same.svg is given twice"},
      {"-o plan.svg --line 1,1,0.85:3,1,0.85:5", 2, "-o plan.svg: a plan needs a grid of points"},
      {"-o plan.svg --grid 1,1,1:3,1,1:2,3,1:4x4", 2, "a plan needs a rectangular --grid"},
      {"-o plan.dxf", 2, "plan.dxf: expected one of the extensions .csv .json .h5 .svg .html"},
      {"--occupied 18-8", 2, "--occupied: expected two hours of a day such as 8-18, not '18-8'"},
      {"--occupied 8", 2, "--occupied: expected two hours of a day"},
      {"--occupied 8-25", 2, "--occupied: expected two hours of a day"},
      {"--sky-patches 146", 2, "--sky-patches: expected one of 145|577|2305, not '146'"},
      {"--weather none.epw", 1, "none.epw"},
      {"--weather cut.wea", 1, "cut.wea:4123: expected"},
      {"--weather room.obj", 1, "room.obj:1: expected a weather file"}};
  for (const auto& [arguments, code, sentence] : cases) {
    const auto run = cli::run(folder, "$LUXEL daylight room.obj" + quick + arguments);
    EXPECT_EQ(run.code, code) << arguments;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_NE(run.err.find(sentence), std::string::npos) << arguments << "\n" << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
}

// A file with a part of a year is reported as such.
TEST(DaylightCommand, reports_the_oddities_of_weather) {
  const auto folder = room("odd", "south:1,0.9,2,1.5");
  const auto whole = read_file(folder / "town.wea");
  write_file(folder / "part.wea", whole.substr(0, whole.find("\n2 1 0.5") + 1));
  const auto run = cli::run(folder,
                            "$LUXEL daylight room.obj --sky-patches 145 --error 10% --spacing 1 --weather "
                            "part.wea -o day.html");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find("744 records, where a year has 8760"), std::string::npos) << run.err;
  EXPECT_NE(read_file(folder / "day.html").find("744 records, where a year has 8760"), std::string::npos);
}

// The window to the south has the sun, that to the north never; a schedule replaces the rule.
TEST(DaylightCommand, blinds_are_operated_by_groups_of_windows) {
  const auto folder = room("groups", "south:1,1,2,1.5 --window north:1,1,2,1.5");
  const std::string command = "$LUXEL daylight room.obj --weather town.wea --spacing 1 --json" + quick;
  const auto year = [&](const std::string& options) {
    const auto run = cli::run(folder, command + options);
    EXPECT_EQ(run.code, 0) << run.err;
    return Json::parse(run.out)["year"];
  };
  const std::string groups = " --blinds window_1=0.1 --blinds window_2 --lighting-power 200";
  const auto by_sun = year(groups);
  ASSERT_EQ(by_sun["blinds"].size(), 2u);
  EXPECT_EQ(by_sun["blinds"][0]["transmittance"], 0.1);
  EXPECT_GT(by_sun["blinds"][0]["closed_hours"], 500.0);
  EXPECT_EQ(by_sun["blinds"][1]["closed_hours"], 0.0);
  EXPECT_NEAR(double{by_sun["blinds"][0]["part_of_light"]} + double{by_sun["blinds"][1]["part_of_light"]},
              1.0, 0.02);
  const double undimmed = 0.2 * 3650.0;
  EXPECT_NEAR(double{by_sun["lighting_energy_kwh"]["value"]} + double{by_sun["lighting_saved_kwh"]["value"]},
              undimmed, 1e-6 * undimmed);

  std::string open = "blinds,occupied\n", closed = open;
  for (int i = 0; i < 8760; ++i) {
    open += i % 24 == 12 ? "0,1\n" : "0,0\n";
    closed += i % 24 == 12 ? "1,1\n" : "1,0\n";
  }
  write_file(folder / "open.csv", open);
  write_file(folder / "closed.csv", closed);
  const auto opened = year(groups + " --schedule open.csv"), shut = year(groups + " --schedule closed.csv");
  EXPECT_EQ(opened["occupied_hours"], 365);
  EXPECT_EQ(opened["hours_with_blinds"], 0);
  EXPECT_EQ(opened["sda_300_50_with_blinds"]["value"], opened["sda_300_50"]["value"]);
  EXPECT_EQ(shut["hours_with_blinds"], 365);
  EXPECT_LT(double{shut["lighting_saved_kwh"]["value"]}, double{opened["lighting_saved_kwh"]["value"]});

  const auto unknown = cli::run(folder, command + " --blinds west");
  EXPECT_EQ(unknown.code, 1);
  EXPECT_NE(unknown.err.find("no window is called 'west'"), std::string::npos) << unknown.err;
  EXPECT_EQ(cli::run(folder, "$LUXEL daylight room.obj --blinds window_1" + quick).code, 2);
  EXPECT_EQ(cli::run(folder, command + " --blinds =0.5").code, 2);
}

// A stored run gives the results of its scene; a changed run those of the changed scene within their errors.
TEST(DaylightCommand, changes_surfaces_and_panes_of_a_stored_run) {
  const auto folder = room("stored", "south:1,0.9,2,1.5");
  const auto stored = cli::run(folder, "$LUXEL daylight room.obj --glass glass=0.8" + quick +
                                           "--weather town.wea -o run.vtkhdf -o own.csv");
  ASSERT_EQ(stored.code, 0) << stored.err;
  const auto of_run = [&](const std::string& changes) {
    const auto run = cli::run(folder, "$LUXEL daylight run.vtkhdf --quiet " + changes);
    EXPECT_EQ(run.code, 0) << run.err;
    return run.out;
  };
  EXPECT_EQ(of_run("--weather town.wea"), read_file(folder / "own.csv"));

  const std::string shaded = "--weather town.wea --blinds glass=0.1 --json";
  const auto by_run = Json::parse(of_run(shaded))["year"];
  const auto by_scene =
      cli::run(folder, "$LUXEL daylight room.obj --glass glass=0.8 --quiet" + quick + shaded);
  EXPECT_GT(by_run["blinds"][0]["closed_hours"], 500.0);
  EXPECT_EQ(by_run["blinds"], Json::parse(by_scene.out)["year"]["blinds"]);
  EXPECT_EQ(by_run["sda_300_50_with_blinds"], Json::parse(by_scene.out)["year"]["sda_300_50_with_blinds"]);

  auto mtl = read_file(folder / "room.mtl");
  const auto wall = mtl.find("Kd 0.5 0.5 0.5");
  ASSERT_NE(wall, std::string::npos);
  mtl.replace(wall, 14, "Kd 0.8 0.8 0.8");
  write_file(folder / "room.mtl", mtl);
  const auto changed = rows_of(of_run("--reflectance wall=0.8 --transmittance glass=0.4")),
             expected = daylight(folder, "--glass glass=0.4"), own = rows_of(read_file(folder / "own.csv"));
  ASSERT_EQ(changed.size(), expected.size());
  for (std::size_t i = 0; i < changed.size(); ++i) {
    expect_same(changed[i], expected[i], "daylight_factor_16", "daylight_factor_16_standard_error");
    EXPECT_LT(changed[i].at("daylight_factor_16"), 0.9 * own[i].at("daylight_factor_16"));
    EXPECT_GT(changed[i].at("internally_reflected") / changed[i].at("sky_component"),
              1.5 * own[i].at("internally_reflected") / own[i].at("sky_component"));
  }

  const auto refuses = [&](const std::string& line, int code, const std::string& text) {
    const auto outcome = cli::run(folder, "$LUXEL daylight " + line);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_NE(outcome.err.find(text), std::string::npos) << outcome.err;
  };
  refuses("room.obj --reflectance wall=0.7", 2, "change a stored run");
  refuses("run.vtkhdf --north 20", 2, "--north is that of the stored run");
  refuses("run.vtkhdf --weather town.wea --blinds window_1", 1,
          "a stored run knows glass by its material, which is 'glass'");
  refuses("run.vtkhdf --transmittance glas=0.4", 1, "there is no glass 'glas', but 'glass'");
  refuses("run.vtkhdf --transmittance glass=4", 2, "a number from 0 to 1");
}

}  // namespace
}  // namespace luxel::cli
