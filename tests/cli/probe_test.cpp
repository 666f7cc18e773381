// SPDX-License-Identifier: Apache-2.0
// End-to-end tests of `luxel probe` and `luxel measure`.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "luxel/core/output_file.h"

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

using Json = nlohmann::json;

const std::string bake_for_probes =
    "$LUXEL bake cornell-box.obj --max-edge 0.1 --error 20% --quiet -o box.vtkhdf > bake.txt && ";

class Probe : public testing::Test {
 protected:
  // The box is baked once.
  static const std::filesystem::path& folder() {
    static const auto made = [] {
      auto fresh = fresh_folder("probe");
      const auto run = cli::run(fresh, bake_for_probes + "true");
      EXPECT_EQ(run.code, 0) << run.err;
      return fresh;
    }();
    return made;
  }
  static Outcome run(const std::string& line) { return cli::run(folder(), line); }
  // Runs the program, which must fail with this exit code and a message that contains the text.
  static void refuses(const std::string& line, int code, const std::string& text) {
    const auto outcome = run("$LUXEL " + line);
    EXPECT_EQ(outcome.code, code) << line << "\n" << outcome.err;
    EXPECT_NE(outcome.err.find(text), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "") << line;
  }
  static void refuses_points(const std::string& csv, const std::string& text) {
    write_file(folder() / "bad.csv", csv);
    refuses("probe box.vtkhdf --points bad.csv -o never.csv", 1, text);
    EXPECT_FALSE(std::filesystem::exists(folder() / "never.csv"));
  }
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const auto end = text.find('\n', at);
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

TEST_F(Probe, writes_a_table_and_json_of_the_points_of_a_file) {
  write_file(folder() / "in.csv",
             "# points of a test\nname,z,x,y,nx,ny,nz\na,-0.1,0,0.001,0,1,0\n\nb,-0.3,-0.1,0.4,0,0,-2\n");
  const auto outcome = run("$LUXEL probe box.vtkhdf --points in.csv -o out.csv -o out.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "out.csv\nout.json\n");
  EXPECT_NE(outcome.err.find("2 points: mean "), std::string::npos) << outcome.err;
  const auto table = lines_of(read_file(folder() / "out.csv"));
  ASSERT_EQ(table.size(), 3u);
  EXPECT_EQ(table[0].substr(0, 53), "x,y,z,nx,ny,nz,illuminance_lx,standard_error_lx,sampl");
  EXPECT_EQ(table[1].substr(0, 19), "0,0.001,-0.1,0,1,0,");
  EXPECT_EQ(table[2].substr(0, 20), "-0.1,0.4,-0.3,0,0,-1");
  const auto json = Json::parse(read_file(folder() / "out.json"));
  EXPECT_EQ(json["command"], "probe");
  EXPECT_EQ(json["solution_errors"], "patches");
  ASSERT_EQ(json["points"].size(), 2u);
  for (const auto& point : json["points"]) {
    const auto E = point["illuminance_lx"].get<double>();
    EXPECT_GT(E, 1.0);
    EXPECT_LE(point["sampling_error_lx"].get<double>(), 0.02 * E);
    EXPECT_GE(point["standard_error_lx"].get<double>(), point["sampling_error_lx"].get<double>());
    EXPECT_GT(point["solution_error_lx"].get<double>(), 0.0);
    const auto& H = point["irradiance_W_per_m2"];
    EXPECT_NEAR(
        179.0 * (0.2126 * H[0].get<double>() + 0.7152 * H[1].get<double>() + 0.0722 * H[2].get<double>()), E,
        1e-6 * E);
    EXPECT_EQ(point["reached"], true);
    EXPECT_GT(point["rays"], 1000);
  }
  // The written file can be read as points.
  const auto again = run("$LUXEL probe box.vtkhdf --points out.csv --quiet");
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(lines_of(again.out).size(), 3u);
}

TEST_F(Probe, makes_lines_and_grids) {
  const auto line = run("$LUXEL probe box.vtkhdf --line -0.2,0.1,-0.1:0.2,0.1,-0.1:3 --error 10% --quiet");
  ASSERT_EQ(line.code, 0) << line.err;
  const auto rows = lines_of(line.out);
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[1].substr(0, 20), "-0.2,0.1,-0.1,0,1,0,");
  EXPECT_EQ(rows[2].substr(0, 17), "0,0.1,-0.1,0,1,0,");
  EXPECT_EQ(rows[3].substr(0, 19), "0.2,0.1,-0.1,0,1,0,");
  const auto grid =
      run("$LUXEL probe box.vtkhdf --grid -0.2,0.5,-0.1:0.2,0.5,-0.1:-0.2,0.5,-0.5:2x4 --error 10% --json");
  ASSERT_EQ(grid.code, 0) << grid.err;
  const auto json = Json::parse(grid.out);
  EXPECT_EQ(json["grid"], Json({{"columns", 2}, {"rows", 4}}));
  ASSERT_EQ(json["points"].size(), 8u);
  EXPECT_NEAR(json["points"][1]["position_m"][0].get<double>(), 0.1, 1e-12);
  EXPECT_EQ(json["points"][0]["normal"], Json({0.0, 1.0, 0.0})) << "columns to the right, rows away: up";
  // The box measures 0.55 x 0.55 x 0.56 m.
  const auto plane =
      run("$LUXEL probe box.vtkhdf --plane 0.3 --spacing 0.15 --border 0.05 --error 10% --json");
  ASSERT_EQ(plane.code, 0) << plane.err;
  const auto points = Json::parse(plane.out)["points"];
  ASSERT_EQ(points.size(), 9u);
  for (const auto& point : points) {
    EXPECT_EQ(point["position_m"][1], 0.3);
    EXPECT_EQ(point["normal"], Json({0.0, 1.0, 0.0}));
  }
  const auto down =
      run("$LUXEL probe box.vtkhdf --plane 0.3 --spacing 0.3 --normal 0,-2,0 --error 10% --json");
  EXPECT_EQ(Json::parse(down.out)["points"][0]["normal"], Json({0.0, -1.0, 0.0}));
  const auto facing =
      run("$LUXEL probe box.vtkhdf --line 0,0.1,-0.1:0,0.1,-0.3:3 --facing 0,0.1,0.5 --error 10% --json");
  ASSERT_EQ(facing.code, 0) << facing.err;
  const auto facing_points = Json::parse(facing.out)["points"];
  for (const auto& point : facing_points) EXPECT_EQ(point["normal"], Json({0.0, 0.0, 1.0}));
}

TEST_F(Probe, gives_the_same_bytes_on_any_number_of_threads) {
  const std::string points = "$LUXEL probe box.vtkhdf --plane 0.3 --spacing 0.2 --error 10% --sh 9 --quiet ";
  const auto outcome = run(points + "-o a.csv --threads 1 && " + points + "-o b.csv --threads 5");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(read_file(folder() / "a.csv"), read_file(folder() / "b.csv"));
}

TEST_F(Probe, has_spherical_harmonics) {
  for (const auto count : {4u, 9u}) {
    const auto outcome = run(fmt::format(
        "$LUXEL probe box.vtkhdf --line 0,0.2,-0.05:0,0.4,-0.05:2 --sh {} --error 5% --json", count));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto point = Json::parse(outcome.out)["points"][0];
    ASSERT_EQ(point["sh_W_per_m2_sr"].size(), 3u);
    EXPECT_EQ(point["sh_W_per_m2_sr"][2].size(), count);
    EXPECT_GT(point["sh_W_per_m2_sr"][0][0], 0.0);
    EXPECT_LE(point["sh_error"], 0.05);
  }
}

TEST_F(Probe, reports_points_that_miss_the_error) {
  const auto outcome =
      run("$LUXEL probe box.vtkhdf --line 0,0.1,-0.05:0.1,0.1,-0.05:2 --error 0.01% --rays 2048 -o out.csv");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("2 of 2 points have a larger error than requested"), std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("--rays"), std::string::npos);
}

TEST_F(Probe, names_file_and_line_of_bad_points) {
  refuses_points("1,2,3\n1,2\n", "bad.csv:2: expected 3 fields as before, separated by commas, found 2");
  refuses_points("1,2,nan\n", "bad.csv:1: expected a finite number for z, found 'nan'");
  refuses_points("x,y,z\n0,0,0\n0,1e99,0\n", "bad.csv:3: expected a finite number for y, found '1e99'");
  refuses_points("0,0,0\n0,zero,0\n", "bad.csv:2: expected a finite number for y, found 'zero'");
  refuses_points("0;0;0\n",
                 "bad.csv:1: expected 3 or 6 numbers (x,y,z or x,y,z,nx,ny,nz), separated by commas");
  refuses_points("x,y,height\n0,0,0\n", "bad.csv:1: expected the columns x, y and z");
  refuses_points("x,y,z,nx\n0,0,0,1\n",
                 "bad.csv:1: expected all of the columns nx, ny and nz, or none of them");
  refuses_points("0,0,0,0,0,0\n", "bad.csv:1: expected a normal that is not 0,0,0");
  refuses_points("", "bad.csv: expected points");
  refuses_points("x,y,z\n# nothing\n", "bad.csv: expected points");
  refuses_points(std::string("\0\1", 2), "bad.csv");
  refuses("probe box.vtkhdf --points none.csv", 1, "none.csv");
}

TEST_F(Probe, refuses_wrong_options) {
  refuses("probe box.vtkhdf", 2,
          "give one of --points FILE, --line, --grid or --plane HEIGHT, or --areas FILE");
  refuses("probe box.vtkhdf --plane 0.3 --line 0,0,0:1,0,0:2", 2, "found several");
  refuses("probe box.vtkhdf --plane nan", 2, "--plane: expected a height");
  refuses("probe box.vtkhdf --line 0,0,0:1,0,0", 2, "--line: expected two points and a number from 2");
  refuses("probe box.vtkhdf --line 0,0,0:1,0,0:1", 2, "--line: expected two points and a number from 2");
  refuses("probe box.vtkhdf --grid 0,0,0:1,0,0:2,0,0:2x2", 2, "not on a line");
  refuses("probe box.vtkhdf --grid 0,0,0:1,0,0:0,0,1:2x0", 2, "--grid: expected three corners");
  refuses("probe box.vtkhdf --plane 0.3 --border 0.3", 1, "--border 0.3: it leaves nothing of the scene");
  refuses("probe box.vtkhdf --plane 0.3 --spacing 1e-5", 1, "--spacing 1e-05: it makes more than");
  refuses("probe box.vtkhdf --line 0,0,0:1,0,0:2 --border 0.1", 2,
          "--spacing and --border belong to --plane");
  refuses("probe box.vtkhdf --plane 0.3 --normal 0,0,0", 2, "--normal: expected a direction");
  refuses("probe box.vtkhdf --plane 0.3 --normal 0,0,1 --facing 0,0,0", 2, "one of --normal and --facing");
  refuses("probe box.vtkhdf --line 0,0.1,-0.1:0,0.1,-0.3:3 --facing 0,0.1,-0.1", 1,
          "--facing: expected a place that is none of the points");
  refuses("probe box.vtkhdf --plane 0.3 --error 0", 2, "--error: expected a fraction above 0");
  refuses("probe box.vtkhdf --plane 0.3 --rays 10", 2, "--rays: expected a count from 1024");
  refuses("probe box.vtkhdf --plane 0.3 --sh 5", 2, "--sh: expected one of none|4|9");
  refuses("probe box.vtkhdf --plane 0.3 -o out.xls", 2, "expected one of the extensions .csv .json");
  refuses("probe cornell-box.obj --plane 0.3", 1, "cornell-box.obj");
  refuses("probe none.vtkhdf --plane 0.3", 1, "none.vtkhdf");
}

const std::string desk =
    "[[area]]\nname = \"desk\"\nkind = \"task\"\npolygon = [[-0.2, -0.5], [0.2, -0.5], [0.2, -0.1], [-0.2, "
    "-0.1]]\nheight = 0.45\n";

TEST_F(Probe, measures_areas_and_judges_them) {
  write_file(folder() / "areas.toml",
             "maintenance = { LLMF = 0.9, LSF = 1, LMF = 0.95, RMF = 0.9 }\n" + desk +
                 "requirement = \"client\"\n[[area]]\nname = \"way out\"\nkind = "
                 "\"escape_route\"\nline = [[-0.2, 0.01, -0.05], [0.2, 0.01, -0.05]]\n");
  write_file(folder() / "more.toml", "[requirement.client]\nEm = 1\nU0 = 0.99\nEz = 1\n");
  const auto outcome = run(
      "$LUXEL probe box.vtkhdf --areas areas.toml --requirements more.toml --error 10% -o plan.svg -o a.json "
      "-o a.vtp -o a.csv");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "plan-desk.svg\nplan-way-out.svg\na.json\na.vtp\na.csv\n");
  EXPECT_NE(outcome.err.find("maintenance factor 0.77"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("Em ≥ 1: met"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("U0 ≥ 0.99: not met"), std::string::npos) << outcome.err;
  const auto json = Json::parse(read_file(folder() / "a.json"));
  ASSERT_EQ(json["areas"].size(), 2u);
  const auto& area = json["areas"][0];
  EXPECT_EQ(area["verdict"], "not met");
  EXPECT_NEAR(area["maintenance"]["factor"].get<double>(), 0.7695, 1e-12);
  for (const char* key : {"mean_lx", "min_lx", "max_lx", "min_over_mean", "min_over_max", "cylindrical_lx"}) {
    EXPECT_LE(area[key]["low"], area[key]["value"]) << key;
    EXPECT_LE(area[key]["value"], area[key]["high"]) << key;
  }
  EXPECT_EQ(area["points"].size(),
            area["grid"]["columns"].get<std::size_t>() * area["grid"]["rows"].get<std::size_t>());
  EXPECT_EQ(json["areas"][1]["direct"], true);
  EXPECT_EQ(json["areas"][1]["points"][0]["place"], "free");
  const auto table = lines_of(read_file(folder() / "a.csv"));
  EXPECT_EQ(table.size(), 1 + area["points"].size() + json["areas"][1]["points"].size());
  EXPECT_EQ(table[1].substr(0, 5), "desk,");
  EXPECT_NE(read_file(folder() / "plan-desk.svg").find("class=\"isolux\""), std::string::npos);
  // Indirect light is missing.
  const auto whole = run("$LUXEL probe box.vtkhdf --line 0,0.1,-0.05:0.1,0.1,-0.05:2 --json"),
             direct = run("$LUXEL probe box.vtkhdf --line 0,0.1,-0.05:0.1,0.1,-0.05:2 --direct --json");
  EXPECT_LT(Json::parse(direct.out)["mean_lx"], Json::parse(whole.out)["mean_lx"]);
  EXPECT_GT(Json::parse(direct.out)["mean_lx"], 0.0);
}

TEST_F(Probe, names_file_and_line_of_bad_areas) {
  write_file(folder() / "bad.toml", desk + "requirement = \"wriitng\"\n");
  refuses("probe box.vtkhdf --areas bad.toml", 1, "bad.toml:6: requirement: there is no requirement");
  write_file(folder() / "bad.toml", desk + "border = 1\n");
  refuses("probe box.vtkhdf --areas bad.toml", 1, "area \"desk\": the border of 1 m leaves nothing");
  write_file(folder() / "bad.toml", "[[area]]\nname = \"a\"\nsurface = \"flor\"\n");
  refuses("probe box.vtkhdf --areas bad.toml", 1, "no material is called 'flor'; objects and groups need");
  refuses("probe box.vtkhdf --areas none.toml", 1, "none.toml");
  refuses("probe box.vtkhdf --areas bad.toml --plane 0.3", 2, "found several");
  refuses("probe box.vtkhdf --areas bad.toml --sh 9", 2, "do not belong to --areas");
  refuses("probe box.vtkhdf --plane 0.3 --drawing both", 2, "--drawing belongs to --areas");
  refuses("probe box.vtkhdf --plane 0.3 -o plan.svg", 2, "expected one of the extensions .csv .json");
}

TEST_F(Probe, render_has_pictures_of_luminance_and_illuminance) {
  const std::string small = " --width 32 --height 24 --samples 1 --quiet";
  const auto outcome = run("$LUXEL render box.vtkhdf --quantity luminance -o l.png -o l.exr" + small +
                           " && $LUXEL render box.vtkhdf --quantity illuminance --max-value 100 -o e.png" +
                           small + " && $LUXEL render box.vtkhdf -o r.png" + small);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(read_file(folder() / "l.png"), read_file(folder() / "r.png"));
  EXPECT_NE(read_file(folder() / "e.png"), read_file(folder() / "l.png"));
  refuses("render box.vtkhdf --quantity illuminance --gather 16 -o never.png", 2, "--gather does not apply");
  refuses("render box.vtkhdf --quantity lux -o never.png", 2, "--quantity: expected one of");
}

TEST_F(Probe, measure_lists_all_materials_or_the_named_surfaces) {
  const auto all = run("$LUXEL measure box.vtkhdf --json");
  ASSERT_EQ(all.code, 0) << all.err;
  const auto json = Json::parse(all.out);
  EXPECT_EQ(json["command"], "measure");
  EXPECT_EQ(json["errors_of_means"], "patches");
  EXPECT_GE(json["surfaces"].size(), 4u);
  for (const auto& surface : json["surfaces"])
    for (const char* key : {"mean_lx", "min_lx", "max_lx", "min_over_mean", "min_over_max"}) {
      EXPECT_LE(surface[key]["low"], surface[key]["value"]);
      EXPECT_LE(surface[key]["value"], surface[key]["high"]);
    }
  const auto table = run("$LUXEL measure box.vtkhdf --surface white --surface 'r*'");
  ASSERT_EQ(table.code, 0) << table.err;
  const auto rows = lines_of(table.out);
  EXPECT_EQ(rows[0].substr(0, 9), "surface  ");
  EXPECT_EQ(rows[1].substr(0, 6), "white ");
  EXPECT_EQ(rows[2].substr(0, 3), "r* ");
  EXPECT_NE(table.out.find("95 % intervals"), std::string::npos);
  const auto floor = run("$LUXEL measure box.vtkhdf --scene cornell-box.obj --surface floor --json");
  ASSERT_EQ(floor.code, 0) << floor.err;
  // The floor of the box, of which two blocks hide 0.165 x 0.165 m each.
  const auto surface = Json::parse(floor.out)["surfaces"][0];
  const auto lit = surface["area_m2"].get<double>(), unlit = surface["unlit_area_m2"].get<double>();
  EXPECT_NEAR(lit + unlit, 0.3091, 1e-3);
  EXPECT_NEAR(unlit, 2 * 0.165 * 0.165, 1e-3);
  EXPECT_GT(surface["min_lx"]["value"], 0.0);
}

TEST_F(Probe, measure_has_narrower_intervals_where_the_transport_is_stored) {
  const auto stored = run(
      "$LUXEL bake cornell-box.obj --max-edge 0.1 --error 20% --store-transport --quiet -o stored.vtkhdf && "
      "$LUXEL measure stored.vtkhdf --surface white --json && "
      "$LUXEL probe stored.vtkhdf --line 0,0.1,-0.05:0.1,0.1,-0.05:2 --json > probe.json");
  ASSERT_EQ(stored.code, 0) << stored.err;
  const auto json = Json::parse(stored.out.substr(stored.out.find('{')));
  EXPECT_EQ(json["errors_of_means"], "replicates");
  const auto width = [](const Json& of) {
    const auto& mean = of["surfaces"][0]["mean_lx"];
    return mean["high"].get<double>() - mean["low"].get<double>();
  };
  const auto plain = run("$LUXEL measure box.vtkhdf --surface white --json");
  EXPECT_LT(width(json), width(Json::parse(plain.out)));
  EXPECT_EQ(Json::parse(read_file(folder() / "probe.json"))["solution_errors"], "replicates");
}

TEST_F(Probe, measure_refuses_names_that_there_are_not) {
  refuses("measure box.vtkhdf --surface whte", 1, "no material is called 'whte', did you mean 'white'?");
  refuses("measure box.vtkhdf --surface floor", 1, "give --scene FILE for objects and groups");
  refuses("measure box.vtkhdf --scene cornell-box.obj --surface flor", 1,
          "no material, object or group is called 'flor', did you mean 'floor'?");
  refuses("measure box.vtkhdf --side top", 2, "--side: expected one of auto|front|back");
  refuses("measure cornell-box.obj", 1, "cornell-box.obj");
}

// A grid with requirements: verdicts by the whole interval, and the time to decide open ones.
TEST_F(Probe, judges_grids) {
  const auto run_json = [&](const std::string& options) {
    const auto outcome = run("$LUXEL probe box.vtkhdf --plane 0.2 --spacing 0.1 " + options + " --json");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return std::pair(Json::parse(outcome.out), outcome.err);
  };
  const auto [plain, nothing] = run_json("");
  EXPECT_FALSE(plain.contains("figures"));
  const auto mean = plain["mean_lx"].get<double>();
  const auto [met, err] = run_json(fmt::format("--require-mean {} --require-uniformity 1", 0.5 * mean));
  const auto& verdicts = met["figures"]["verdicts"];
  EXPECT_EQ(verdicts[0]["quantity"], "Em");
  EXPECT_EQ(verdicts[0]["verdict"], "met");
  EXPECT_EQ(verdicts[1]["quantity"], "U0");
  EXPECT_EQ(verdicts[1]["verdict"], "not met");
  EXPECT_EQ(met["figures"]["verdict"], "not met");
  EXPECT_NEAR(met["figures"]["mean_lx"]["value"].get<double>(), mean, 1e-9);
  EXPECT_NE(err.find("Em ≥"), std::string::npos) << err;
  EXPECT_NE(err.find("95 % intervals, initial"), std::string::npos) << err;
  // A bound within the interval.
  const auto& interval = met["figures"]["mean_lx"];
  const auto inside = 0.5 * (interval["value"].get<double>() + interval["high"].get<double>());
  const auto [open, advice] = run_json(fmt::format("--require-mean {}", inside));
  EXPECT_EQ(open["figures"]["verdict"], "cannot be told yet");
  EXPECT_TRUE(advice.find("some verdicts cannot be told yet: --error") != std::string::npos ||
              advice.find("some verdicts need a better solution") != std::string::npos)
      << advice;
  const auto [named, text] = run_json("--requirement corridor");
  EXPECT_EQ(named["figures"]["verdicts"][0]["required"], 100.0);
  EXPECT_EQ(named["figures"]["verdicts"][2]["verdict"], "not known") << "Ra: the box has no luminaires";
  refuses("probe box.vtkhdf --line 0,0,0.1:0.1,0,0.1:3 --require-mean 5", 2, "belong to --plane and --grid");
  refuses("probe box.vtkhdf --plane 0.2 --requirement castle", 2, "there is no requirement 'castle'");
}

TEST_F(Probe, lists_requirements_without_a_solution) {
  write_file(folder() / "mine.toml", "[requirement.shop]\nsource = \"client\"\nEm = 750\nU0 = 0.6\n");
  const auto table = run("$LUXEL probe --list-requirements --requirements mine.toml");
  ASSERT_EQ(table.code, 0) << table.err;
  const auto lines = lines_of(table.out);
  EXPECT_EQ(lines[0].substr(0, 4), "name");
  EXPECT_NE(lines.back().find("shop"), std::string::npos);
  EXPECT_NE(lines.back().find("client"), std::string::npos);
  const auto json = Json::parse(run("$LUXEL probe --list-requirements --json").out);
  EXPECT_EQ(json["requirements"][0]["name"], "writing");
  EXPECT_EQ(json["requirements"][0]["UGR"], 19.0);
  refuses("probe", 2, "SOLUTION is missing");
}

}  // namespace
}  // namespace luxel::cli
