// SPDX-License-Identifier: Apache-2.0
// End-to-end tests of --glass.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

using Json = nlohmann::json;

// A folder with a room of a window, room.obj.
std::filesystem::path glazed_folder(const std::string& name) {
  const auto folder = fresh_folder(name);
  const auto run = cli::run(folder, "$LUXEL room 4x3x2.7 --window south:1,0.9,2,1.2 -o room.obj --quiet");
  EXPECT_EQ(run.code, 0) << run.err;
  cli::run(folder, "echo 2,1.5,0.85 > p.csv");
  return folder;
}

double illuminance(const std::filesystem::path& folder, const std::string& options) {
  const auto run =
      cli::run(folder, "$LUXEL bake room.obj --sky 1 --error 3% --max-edge 0.5 " + options +
                           " -o a.vtkhdf --quiet && $LUXEL probe a.vtkhdf --points p.csv --json --quiet");
  EXPECT_EQ(run.code, 0) << run.err;
  return Json::parse(run.out)["points"][0]["illuminance_lx"].get<double>();
}

TEST(GlassOption, darkens_a_room_by_its_transmittance_and_stays_in_the_solution) {
  const auto folder = glazed_folder("glass");
  const auto clear = illuminance(folder, "");
  for (const auto* option : {"--glass glass=0.5", "--glass 0.5", "--glass 'gl*=0.9' --glass glass=0.5"}) {
    const auto dimmed = illuminance(folder, option);
    EXPECT_LT(dimmed, 0.5 * clear) << option;  // by the angle of incidence
    EXPECT_GT(dimmed, 0.38 * clear) << option;
  }
  EXPECT_NEAR(illuminance(folder, "--glass glass=1"), clear, 0.1 * clear);
  const auto info = cli::run(folder, "$LUXEL info a.vtkhdf");
  EXPECT_NE(info.out.find("--glass glass=1"), std::string::npos) << info.out;
}

TEST(GlassOption, reports_what_is_lost_in_panes) {
  const auto folder = glazed_folder("glass_power");
  const auto run = cli::run(folder,
                            "$LUXEL bake room.obj --sky 1 --glass 0.6,0.7,0.5 --error 5% --max-edge 0.5 -o "
                            "a.vtkhdf --json --verbose");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find("in panes of glass "), std::string::npos) << run.err;
  const auto power = Json::parse(run.out)["solve"]["power_W"]["in_panes"];
  ASSERT_EQ(power.size(), 3u);
  EXPECT_GT(power[2].get<double>(), power[1].get<double>());  // blue is lost most, and
  EXPECT_GT(power[1].get<double>(), 0.0);
}

TEST(GlassOption, refuses_what_is_no_transmittance) {
  const auto folder = glazed_folder("glass_errors");
  const auto error = [&](const std::string& options) {
    const auto run = cli::run(folder, "$LUXEL bake room.obj --sky 1 " + options + " -o a.png --quiet");
    EXPECT_NE(run.code, 0) << options;
    return run.err;
  };
  for (const auto* wrong : {"0", "1.2", "-0.5", "half", "glass=", "glass=tn:2", "=0.5", "glass=0.5,0.6"})
    EXPECT_NE(
        error(std::string("--glass ") + wrong).find("--glass: expected a visible transmittance above 0"),
        std::string::npos)
        << wrong;
  EXPECT_NE(error("--glass pane=0.5").find("no material matches 'pane'"), std::string::npos);
  EXPECT_NE(error("--glass 0.8 --method dense")
                .find("this method does not know glass that absorbs light, as 'glass' does; solve it by the "
                      "sampled method or by luxel reference"),
            std::string::npos);
  const auto none = cli::run(folder, "$LUXEL bake cornell-box.obj --glass 0.8 -o a.png --quiet");
  EXPECT_NE(none.err.find("no material lets light pass"), std::string::npos) << none.err;
}

// A window in a wall sees half of the sky, and a thin one sends the same part of its light on, whatever the
// direction.
TEST(GlassOption, diffusers_light_a_room_and_are_named_by_info) {
  const auto folder = glazed_folder("glass_diffuse");
  const auto half = illuminance(folder, "--glass glass=diffuse:0.5");
  EXPECT_NEAR(illuminance(folder, "--glass glass=diffuse:0.25"), 0.5 * half, 0.15 * half);
  EXPECT_GT(half, 0.0);
  const auto dense =
      cli::run(folder,
               "$LUXEL bake room.obj --sky 1 --glass glass=diffuse:0.5 --method lines --max-edge 0.7 -o "
               "b.vtkhdf --quiet");
  EXPECT_EQ(dense.code, 0) << dense.err;
  const auto info = cli::run(folder, "$LUXEL info a.vtkhdf");
  EXPECT_NE(info.out.find("--glass glass=diffuse:0.25"), std::string::npos) << info.out;
}

TEST(GlassOption, check_knows_windows) {
  const auto folder = glazed_folder("glass_check");
  const auto kinds = [&](const std::string& options) {
    const auto run = cli::run(folder, "$LUXEL check room.obj --sky 1 " + options + " --json --quiet");
    EXPECT_EQ(run.code, 0) << run.err;
    std::string names;
    const auto json = Json::parse(run.out);
    for (const auto& d : json["diagnostics"]) names += d["kind"].get<std::string>() + " ";
    return names;
  };
  EXPECT_NE(kinds("").find("clear-panes"), std::string::npos);
  EXPECT_EQ(kinds("--glass glass=0.8").find("panes"), std::string::npos);
}

}  // namespace
}  // namespace luxel::cli
