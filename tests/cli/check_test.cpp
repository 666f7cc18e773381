// SPDX-License-Identifier: Apache-2.0
// End-to-end tests of `luxel check`.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

using Json = nlohmann::json;

TEST(Check, reports_diagnostics_as_text_as_json_and_as_a_mesh) {
  const auto folder = fresh_folder("check");
  const auto text = cli::run(
      folder, "$LUXEL check cornell-box.obj --places 2 -o diagnostics.glb --json-file r.json --quiet");
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_EQ(text.err, "");
  EXPECT_NE(text.out.find("cornell-box.obj: 32 triangles in 4 connected components"), std::string::npos)
      << text.out;
  EXPECT_NE(text.out.find("\nwarning  escape: "), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("cornell-box.obj:20  ("), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("\n0 errors, 1 warning, 1 note\n"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("diagnostics.glb: grey what is well"), std::string::npos) << text.out;
  EXPECT_GT(std::filesystem::file_size(folder / "diagnostics.glb"), 1000u);

  const auto json = Json::parse(read_file(folder / "r.json"));
  EXPECT_EQ(json["command"], "check");
  EXPECT_EQ(json["warnings"], 1);
  EXPECT_EQ(json["diagnostics"][1]["kind"], "open-edge");
  EXPECT_EQ(json["diagnostics"][1]["count"], 16);
  EXPECT_EQ(json["diagnostics"][1]["all_places"], 4);
  EXPECT_EQ(json["diagnostics"][1]["places"].size(), 2u);
  EXPECT_EQ(json["outputs"], Json::array({"diagnostics.glb"}));
}

TEST(Check, exits_with_1_for_a_warning_only_with_strict) {
  const auto folder = fresh_folder("strict");
  EXPECT_EQ(cli::run(folder, "$LUXEL check cornell-box.obj --quiet").code, 0);
  EXPECT_EQ(cli::run(folder, "$LUXEL check cornell-box.obj --quiet --strict").code, 1);
  EXPECT_EQ(cli::run(folder, "$LUXEL check cornell-box.obj --quiet -o a.png").code, 2);
  EXPECT_EQ(cli::run(folder, "$LUXEL check none.obj --quiet").code, 1);
}

TEST(Check, repairs_are_reported_and_recorded_in_the_command_line_of_a_bake) {
  const auto folder = fresh_folder("repairs");
  const auto run =
      cli::run(folder,
               "$LUXEL bake cornell-box.obj --weld 1e-4 --orient --error 20% --max-edge 0.2 -o a.vtkhdf"
               " && $LUXEL info a.vtkhdf");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find("welding within 0.0001 m: no two vertices are that near"), std::string::npos)
      << run.err;
  EXPECT_NE(run.err.find("orientation: "), std::string::npos) << run.err;
  EXPECT_NE(run.out.find("--weld 0.0001 --orient"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace luxel::cli
