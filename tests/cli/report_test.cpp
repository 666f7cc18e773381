// SPDX-License-Identifier: Apache-2.0
// The report of a lighting design: page and JSON.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "luxel/core/output_file.h"

#include "cli/run_program.h"
#include "scenes/weather/temperate_year.h"

namespace luxel::cli {
namespace {

using Json = nlohmann::json;

// A cosine panel of 0.6 x 0.6 m with 1000 cd straight down and 32 W, that is 3141.6 lm; its texts have
// markup.
std::string panel_ies() {
  std::string text =
      "IESNA:LM-63-2002\n[TEST] R-17\n[MANUFAC] Lumen & Sons <Ltd>\n[LUMINAIRE] Panel \"600\"\nTILT=NONE\n"
      "1 -1 1 37 1 1 2 0.6 0.6 0\n1 1 32\n";
  for (int i = 0; i < 37; ++i) text += fmt::format("{}\n", 2.5 * i);
  text += "0\n";
  for (int i = 0; i < 37; ++i)
    text += fmt::format("{:.3f}\n", std::abs(1000.0 * std::cos(2.5 * i * 3.14159265 / 180.0)));
  return text;
}

// A room with 2 x 2 panels, solved.
std::filesystem::path solved_room(const std::string& name) {
  const auto folder = fresh_folder(name);
  write_file(folder / "panel.ies", panel_ies());
  const auto baked = cli::run(
      folder,
      "$LUXEL room 5x4x2.8 -o room.obj > made.txt && $LUXEL bake room.obj --luminaire-grid panel.ies:2x2@2.8 "
      "--error 5% --store-transport --quiet -o room.vtkhdf");
  EXPECT_EQ(baked.code, 0) << baked.err;
  return folder;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string lux_text(const Json& number, int more = 0) {
  const auto v = number.get<double>();
  return fmt::format("{:.{}f}", v, (v >= 99.95 ? 0 : v >= 9.995 ? 1 : 2) + more);
}
std::string lux(const Json& number) { return lux_text(number["value"]); }
// One place more where the ends of the interval would read alike.
std::string lux_before_interval(const Json& number) {
  return lux_text(number["value"], lux_text(number["low"]) == lux_text(number["high"]) ? 1 : 0);
}

TEST(Report, has_the_numbers_of_the_json_and_is_one_whole_page) {
  const auto folder = solved_room("report");
  const auto made =
      cli::run(folder,
               "$LUXEL report room.vtkhdf --project 'A & <B>' --date 2026-01-02 --require-mean 100 "
               "--require-uniformity 0.99 --require-ugr 40 -o a.html --json");
  ASSERT_EQ(made.code, 0) << made.err;
  const auto json = Json::parse(made.out);
  const auto page = read_file(folder / "a.html");

  // The page is well-formed and loads nothing from outside: its only addresses are those of the picture and
  // of namespaces.
  write_file(folder / "check.py",
             "import sys, xml.etree.ElementTree as t\n"
             "from html.parser import HTMLParser\n"
             "text = open('a.html', encoding='utf-8').read()\n"
             "root = t.fromstring(text.split('\\n', 1)[1])\n"
             "HTMLParser().feed(text)\n"
             "ids = [e.get('id') for e in root.iter() if e.get('id')]\n"
             "assert len(ids) == len(set(ids)), ids\n"
             "for e in root.iter():\n"
             "  assert not e.tag.endswith(('script', 'link', 'iframe')), e.tag\n"
             "  for k in ('src', 'href', '{http://www.w3.org/1999/xlink}href'):\n"
             "    assert e.get(k, 'data:').startswith(('data:image/png;base64,', 'data:', '#')), e.get(k)\n"
             "svg = '{http://www.w3.org/2000/svg}svg'\n"
             "inner = {i for e in root.iter(svg) for i in e.iter(svg) if i is not e}\n"
             "print(sum(e not in inner for e in root.iter(svg)))\n");
  const auto checked = cli::run(folder, "python3 check.py");
  EXPECT_EQ(checked.code, 0) << checked.err;
  EXPECT_EQ(checked.out, "5\n") << "unfolded room, plan, polar diagram, isolux lines, values";
  EXPECT_FALSE(has(page, "url(http"));
  EXPECT_TRUE(has(page, "A &amp; &lt;B&gt;"));
  EXPECT_TRUE(has(page, "Lumen &amp; Sons &lt;Ltd&gt;"));
  EXPECT_TRUE(has(page, "Panel &quot;600&quot;"));
  EXPECT_FALSE(has(page, "<Ltd>"));
  EXPECT_TRUE(has(page, "2026-01-02"));

  const auto& plane = json["planes"][0];
  for (const auto* key : {"mean_lx", "min_lx", "max_lx"})
    EXPECT_TRUE(has(page, "<td class=\"n\">" + lux(plane[key]) + " lx</td>")) << key;
  for (const auto* key : {"min_over_mean", "min_over_max"})
    EXPECT_TRUE(has(page, fmt::format("<td class=\"n\">{:.2f}</td>", plane[key]["value"].get<double>())))
        << key;
  for (const auto& o : json["glare"]["observers"])
    EXPECT_TRUE(has(page, fmt::format("<td class=\"n\">{:.1f}", o["ugr"]["value"].get<double>())));
  for (const auto& s : json["surfaces"])
    EXPECT_TRUE(has(page, lux_before_interval(s["mean_lx"]) + " <span class=\"i\">(")) << s["name"];
  EXPECT_TRUE(has(page, ">met</span>"));
  EXPECT_TRUE(has(page, ">not met</span>"));
}

// Powers and areas by hand; the mean of the floor by energy: what falls onto the surfaces is absorbed by
// them.
TEST(Report, has_the_power_and_the_balance_of_the_room) {
  const auto folder = solved_room("report_power");
  const auto made = cli::run(folder, "$LUXEL report room.vtkhdf --picture off --json");
  ASSERT_EQ(made.code, 0) << made.err;
  const auto json = Json::parse(made.out);
  const auto& list = json["luminaires"];
  EXPECT_EQ(list["count"], 4);
  EXPECT_NEAR(list["watts"].get<double>(), 128.0, 1e-9);
  EXPECT_NEAR(json["room"]["floor_area_m2"].get<double>(), 20.0, 1e-4);
  EXPECT_NEAR(list["watts_per_m2"].get<double>(), 6.4, 1e-4);
  const auto mean = json["planes"][0]["mean_lx"]["value"].get<double>();
  EXPECT_NEAR(list["watts_per_m2_per_100_lx"]["value"].get<double>(), 640.0 / mean, 1e-3);
  EXPECT_NEAR(list["types"][0]["flux_lm"].get<double>(), 1000.0 * 3.14159265, 3.0);
  EXPECT_NEAR(list["placed"][0]["position_m"][0].get<double>(), 1.25, 1e-4);
  EXPECT_NEAR(list["placed"][0]["position_m"][2].get<double>(), 2.8, 1e-4);
  const double reflectance[] = {0.2, 0.5, 0.7};  // floor, walls, ceiling
  const double area[] = {20.0, 50.4, 20.0};      // m²
  double absorbed = 0.0;                         // lm
  ASSERT_EQ(json["surfaces"].size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& s = json["surfaces"][i];
    EXPECT_NEAR(s["area_m2"].get<double>(), area[i], 1e-3);
    absorbed += (1.0 - reflectance[i]) * area[i] * s["mean_lx"]["value"].get<double>();
  }
  EXPECT_NEAR(absorbed, 4000.0 * 3.14159265, 0.02 * 4000.0 * 3.14159265);
  // Opposite observers of a symmetric room have the same glare.
  const auto& observers = json["glare"]["observers"];
  ASSERT_EQ(observers.size(), 4u);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_NEAR(observers[i]["ugr"]["value"].get<double>(), observers[i + 2]["ugr"]["value"].get<double>(),
                0.3);
}

TEST(Report, is_the_same_twice_and_on_any_number_of_threads) {
  const auto folder = solved_room("report_twice");
  const auto made =
      cli::run(folder,
               "$LUXEL report room.vtkhdf -o a.html > 1.txt && $LUXEL report room.vtkhdf --threads 1 -o "
               "b.html > 2.txt && cmp a.html b.html");
  EXPECT_EQ(made.code, 0) << made.err;
}

TEST(Report, takes_calculation_areas) {
  const auto folder = solved_room("report_areas");
  write_file(folder / "areas.toml",
             "[[area]]\nname = \"desk <1>\"\nkind = \"task\"\n"
             "polygon = [[1, 1, 0.75], [2, 1, 0.75], [2, 2, 0.75], [1, 2, 0.75]]\nEm = 100\n");
  const auto made =
      cli::run(folder, "$LUXEL report room.vtkhdf --areas areas.toml --picture off -o a.html --json");
  ASSERT_EQ(made.code, 0) << made.err;
  const auto json = Json::parse(made.out);
  ASSERT_GE(json["planes"].size(), 2u);
  EXPECT_EQ(json["planes"][0]["name"], "working plane");
  EXPECT_EQ(json["planes"][1]["name"], "desk <1>");
  EXPECT_EQ(json["planes"][1]["verdicts"][0]["verdict"], "met");
  EXPECT_TRUE(has(read_file(folder / "a.html"), "desk &lt;1&gt;"));
}

// Luminaires with a maintenance factor of 0.8 and an area with another one: the sentence names both, and
// drawings do not print "initial".
TEST(Report, warns_where_maintenance_applies_twice) {
  const auto folder = fresh_folder("report_maintenance");
  write_file(folder / "panel.ies", panel_ies());
  write_file(folder / "list.csv", "file,x,y,z,maintenance\npanel.ies,2.5,2,2.8,0.8\n");
  write_file(folder / "areas.toml",
             "maintenance = 0.75\n[[area]]\nname = \"desk\"\n"
             "polygon = [[1, 1, 0.75], [2, 1, 0.75], [2, 2, 0.75], [1, 2, 0.75]]\n");
  const auto made = cli::run(
      folder,
      "$LUXEL room 5x4x2.8 --quiet -o room.obj && $LUXEL bake room.obj --luminaires list.csv --error 10% "
      "--store-transport --quiet -o room.vtkhdf && $LUXEL report room.vtkhdf --picture off -o a.html --json "
      "&& "
      "$LUXEL report room.vtkhdf --picture off --areas areas.toml -o b.html --json-file b.json --quiet && "
      "$LUXEL probe room.vtkhdf --areas areas.toml --json-file c.json -o c.csv");
  ASSERT_EQ(made.code, 0) << made.err;
  const std::string twice =
      "aintenance applies twice: the luminaires have the factor 0.80, and the area \"desk\" has 0.75";
  EXPECT_TRUE(has(made.err, twice)) << made.err;
  const auto page = read_file(folder / "a.html");
  EXPECT_TRUE(has(page, "maintenance factor of the luminaires 0.80"));
  EXPECT_FALSE(has(page, "lx, initial"));
  const auto json = Json::parse(read_file(folder / "b.json"));
  EXPECT_EQ(json["planes"][1]["maintenance"], "maintenance factor 0.60 (luminaires 0.80, area 0.75)");
  EXPECT_EQ(json["planes"][0]["maintenance_factor"], 0.75)
      << "the factor of the file is that of the working plane";
  bool is_warned = false;
  for (const auto& warning : json["warnings"])
    is_warned = is_warned || has(warning.get<std::string>(), twice);
  EXPECT_TRUE(is_warned);
  // The same light with one factor less: 0.75 times the working plane of the first report.
  const auto start = made.out.find('{');
  const auto first = Json::parse(made.out.substr(start, made.out.find("\n}\n", start) + 2 - start));
  EXPECT_NEAR(json["planes"][0]["mean_lx"]["value"].get<double>(),
              0.75 * first["planes"][0]["mean_lx"]["value"].get<double>(), 1e-6);
  EXPECT_NEAR(json["surfaces"][0]["mean_lx"]["value"].get<double>(),
              0.75 * first["surfaces"][0]["mean_lx"]["value"].get<double>(), 1e-6);
}

// UGR by the observers in an area, Ra by the files; escape routes by their kind alone, with direct light.
TEST(Report, judges_glare_colour_rendering_and_escape_routes_of_areas) {
  const auto folder = solved_room("report_verdicts");
  write_file(folder / "seats.csv", "x,y,z,nx,ny,nz\n1.5,1.5,1.2,1,0,0\n");
  write_file(folder / "areas.toml",
             "[[area]]\nname = \"desk\"\nkind = \"task\"\nUGR = 40\nRa = 80\n"
             "polygon = [[1, 1, 0.75], [2, 1, 0.75], [2, 2, 0.75], [1, 2, 0.75]]\n"
             "[[area]]\nname = \"far\"\nUGR = 1\n"
             "polygon = [[3, 1, 0.75], [4, 1, 0.75], [4, 2, 0.75], [3, 2, 0.75]]\n"
             "[[area]]\nname = \"way\"\nkind = \"escape_route\"\nline = [[0.5, 1, 0.02], [4.5, 1, 0.02]]\n"
             "[[area]]\nname = \"hall\"\nkind = \"anti_panic\"\n"
             "polygon = [[0, 0, 0.02], [5, 0, 0.02], [5, 4, 0.02], [0, 4, 0.02]]\n");
  const auto made =
      cli::run(folder,
               "$LUXEL report room.vtkhdf --picture off --areas areas.toml --observers seats.csv "
               "--hours 1000 -o a.html --json");
  ASSERT_EQ(made.code, 0) << made.err;
  const auto json = Json::parse(made.out);
  ASSERT_EQ(json["glare"]["observers"].size(), 5u);
  const auto& desk = json["planes"][1]["verdicts"];
  EXPECT_EQ(desk[0]["quantity"], "Ra");
  EXPECT_EQ(desk[0]["verdict"], "not known");
  EXPECT_EQ(desk[0]["measured"], nullptr);
  EXPECT_EQ(desk[0]["note"], "the file panel.ies does not state it");
  EXPECT_EQ(desk[1]["verdict"], "met");
  EXPECT_EQ(desk[1]["note"], "highest of the observers in this area: E");
  EXPECT_EQ(desk[1]["measured"]["value"], json["glare"]["observers"][4]["ugr"]["value"]);
  const auto& far = json["planes"][2]["verdicts"];
  EXPECT_EQ(far[0]["verdict"], "not met");
  EXPECT_TRUE(has(far[0]["note"].get<std::string>(), "highest of all observers"));
  const auto& way = json["planes"][3];
  EXPECT_EQ(way["direct"], true);
  EXPECT_EQ(way["verdicts"][0]["quantity"], "Emin");
  EXPECT_EQ(way["verdicts"][0]["at_least"], 1.0);
  EXPECT_EQ(way["verdicts"][1]["quantity"], "max_over_min");
  EXPECT_EQ(way["verdicts"][1]["at_most"], 40.0);
  EXPECT_EQ(json["planes"][4]["verdicts"][0]["at_least"], 0.5);
  EXPECT_EQ(json["planes"][4]["border_m"], 0.5);
  const auto page = read_file(folder / "a.html");
  EXPECT_TRUE(has(page, "class=\"profile\""));
  EXPECT_TRUE(has(page, "direct light only"));
  // 6.4 W/m² for 1000 h.
  EXPECT_NEAR(json["luminaires"]["kwh_per_m2_per_year"].get<double>(), 6.4, 1e-4);
  EXPECT_TRUE(has(page, "6.4 kWh/m² per year: the installed power for 1000 h"));
  // All faces of the unfolded room; the mean over the floor is that of its patches.
  ASSERT_EQ(json["faces"].size(), 6u);
  EXPECT_NEAR(json["faces"][0]["mean_lx"]["value"].get<double>(),
              json["surfaces"][0]["mean_lx"]["value"].get<double>(),
              0.02 * json["surfaces"][0]["mean_lx"]["value"].get<double>());
}

TEST(Report, dates_its_solution_reproducibly) {
  const auto folder = solved_room("report_date");
  const auto date = [&](const std::string& environment, const std::string& more) {
    const auto made =
        cli::run(folder, "touch -d '2026-03-05 12:00 UTC' room.vtkhdf && " + environment +
                             " $LUXEL report room.vtkhdf --picture off --unfolded off --json " + more);
    EXPECT_EQ(made.code, 0) << made.err;
    const auto json = Json::parse(made.out);
    return json["date_of"].get<std::string>() + " " + json["date"].get<std::string>();
  };
  EXPECT_EQ(date("", ""), "Solution file dated 2026-03-05");
  EXPECT_EQ(date("SOURCE_DATE_EPOCH=1700000000", ""), "Solution file dated 2023-11-14");
  EXPECT_EQ(date("SOURCE_DATE_EPOCH=1900000000", ""), "Solution file dated 2026-03-05");
  EXPECT_EQ(date("SOURCE_DATE_EPOCH=soon", ""), "Solution file dated 2026-03-05");
  EXPECT_EQ(date("", "--date 'May 2026'"), "Date May 2026");
}

// The sections on daylight have the numbers of `luxel daylight` of the same scene.
TEST(Report, has_the_daylight_of_the_solved_scene) {
  const auto folder = fresh_folder("report_daylight");
  write_file(folder / "town.wea", scenes::temperate_year());
  write_file(folder / "panel.ies", panel_ies());
  const auto baked =
      cli::run(folder,
               "$LUXEL room 4x4x3 --window south:1,0.9,2,1.5 --quiet -o room.obj && $LUXEL bake room.obj "
               "--luminaire-grid panel.ies:2x2@3 --error 20% --quiet -o room.vtkhdf");
  ASSERT_EQ(baked.code, 0) << baked.err;
  const std::string daylight = " --weather town.wea --sky-patches 145 --lighting-power 100 ";
  const auto made = cli::run(folder, "$LUXEL report room.vtkhdf --scene room.obj" + daylight +
                                         "--error 10% --unfolded=off --picture=off -o a.html --json");
  ASSERT_EQ(made.code, 0) << made.err;
  const auto alone = cli::run(folder, "$LUXEL daylight room.obj" + daylight + "--json --quiet");
  ASSERT_EQ(alone.code, 0) << alone.err;
  auto expected = Json::parse(alone.out);
  expected.erase("command");
  EXPECT_EQ(Json::parse(made.out)["daylight"], expected) << "without lamps the scene is the same";
  const auto page = read_file(folder / "a.html");
  for (const char* text : {"<h2>Daylight</h2>", "<h2>Daylight: requirements</h2>", "<h2>Daylight: plans</h2>",
                           "<h2>Daylight: the year</h2>", "LEED v4.1, option 1: ASE1000,250h",
                           "at a height of 0.85 m, 0.5 m from the walls", "<h2>Room</h2>"})
    EXPECT_TRUE(has(page, text)) << text;
  EXPECT_EQ(page.find("<h2>Room</h2>"), page.rfind("<h2>Room</h2>")) << "once";
  const auto refused = cli::run(folder, "$LUXEL report room.vtkhdf --weather town.wea -o b.html");
  EXPECT_EQ(refused.code, 2);
  EXPECT_TRUE(has(refused.err, "give --scene FILE")) << refused.err;
}

TEST(Report, reports_scenes_without_luminaires_and_refuses_what_it_cannot_do) {
  const auto folder = fresh_folder("report_without");
  const auto baked =
      cli::run(folder, "$LUXEL bake cornell-box.obj --max-edge 0.2 --error 20% -o box.vtkhdf --quiet");
  ASSERT_EQ(baked.code, 0) << baked.err;
  const auto made =
      cli::run(folder, "$LUXEL report box.vtkhdf --picture off --unfolded off -o box.html --json");
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_TRUE(has(made.err, "no luminaires with photometric files")) << made.err;
  EXPECT_TRUE(has(read_file(folder / "box.html"), "there is no list of luminaires"));
  EXPECT_EQ(Json::parse(made.out)["luminaires"]["watts"], nullptr);
  const auto refuses = [&](const std::string& line, int code, const std::string& text) {
    const auto outcome = cli::run(folder, "$LUXEL report " + line);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_TRUE(has(outcome.err, text)) << outcome.err;
  };
  refuses("box.vtkhdf", 2, "give -o report.html");
  refuses("box.vtkhdf -o a.pdf", 2, ".html .json");
  refuses("none.vtkhdf -o a.html", 1, "none.vtkhdf");
  refuses("box.vtkhdf --scene cornell-box.obj -o a.html", 2, "--scene belongs to --areas");
  refuses("box.vtkhdf --requirement castle -o a.html", 2,
          "there is no requirement 'castle'; expected one of writing");
  refuses("box.vtkhdf --requirements a.toml -o a.html", 2,
          "--requirements belongs to --areas or --requirement");
  refuses("box.vtkhdf --border 100 -o a.html", 1, "working plane");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.html"));
}

}  // namespace
}  // namespace luxel::cli
