// SPDX-License-Identifier: Apache-2.0
// The end of a run: its report, the file it opens, quiet runs, and the time limit.
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

using Json = nlohmann::json;
const std::string small_bake =
    "$LUXEL bake cornell-box.obj --max-edge 0.2 --error 10% --width 64 --height 48 ";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(LastWords, are_what_was_written_how_accurate_it_is_and_what_it_took) {
  const auto folder = fresh_folder("last_words");
  const auto run = cli::run(folder, small_bake + "-o a.png -o a.vtkhdf");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, "a.vtkhdf\na.png\n");
  const auto lines = lines_of(run.err);
  ASSERT_GE(lines.size(), 3u) << run.err;
  EXPECT_EQ(lines[lines.size() - 3], "wrote     a.vtkhdf, a.png");
  EXPECT_TRUE(lines[lines.size() - 2].starts_with("error     ")) << run.err;
  EXPECT_NE(lines[lines.size() - 2].find(" % or less from 95 % of viewpoints, "), std::string::npos)
      << run.err;
  EXPECT_TRUE(lines[lines.size() - 2].ends_with(" % in the picture; 10 % requested")) << run.err;
  EXPECT_TRUE(lines.back().starts_with("time      ")) << run.err;
  EXPECT_NE(lines.back().find(" rays, "), std::string::npos) << run.err;
  EXPECT_LE(lines.size(), 7u) << "short: " << run.err;
  for (const char* jargon : {"emitted", "unshot", "RMS", "ns per ray", "triangles are touched"})
    EXPECT_EQ(run.err.find(jargon), std::string::npos) << run.err;
}

TEST(LastWords, of_a_mesh_alone_have_no_camera) {
  const auto folder = fresh_folder("last_words_mesh");
  const auto run = cli::run(folder, small_bake + "-o a.glb");
  EXPECT_EQ(run.err.find("camera"), std::string::npos) << run.err;
  EXPECT_NE(cli::run(folder, small_bake + "-o a.glb --verbose").err.find("camera    --eye"),
            std::string::npos);
}

TEST(LastWords, are_none_if_quiet_and_none_but_json_if_that_is_requested) {
  const auto folder = fresh_folder("last_words_quiet");
  const auto run = cli::run(folder, small_bake + "-o a.png --quiet --flip lamp");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.out + run.err, "");
  EXPECT_TRUE(std::filesystem::exists(folder / "a.png"));
  const auto json = cli::run(folder, small_bake + "-o a.png --quiet --json");
  EXPECT_EQ(json.err, "");
  EXPECT_EQ(Json::parse(json.out)["outputs"], Json::array({"a.png"}));
  const auto wrong = cli::run(folder, "$LUXEL bake none.obj --quiet");
  EXPECT_EQ(wrong.err, "luxel: none.obj: no such file\n");
}

TEST(LastWords, with_a_time_that_is_too_short_begin_with_a_warning_and_reassure_with_no_number) {
  const auto folder = fresh_folder("short_time");
  const auto run = cli::run(folder, small_bake + "-o a.png -o a.vtkhdf --time 0.001s --json");
  EXPECT_EQ(run.code, 3);
  const auto warning = run.err.find("warning: --time 0.001s is less than this run needs, at least about ");
  ASSERT_NE(warning, std::string::npos) << run.err;
  EXPECT_LT(warning, run.err.find("wrote     a.vtkhdf, a.png\n")) << run.err;
  EXPECT_NE(run.err.find("error     not yet known: the run ended at the first light"), std::string::npos)
      << run.err;
  const auto json = Json::parse(run.out);
  EXPECT_EQ(json["solve"]["error"]["stop_reason"], "time_limit");
  EXPECT_EQ(json["solution"]["stop_reason"], "time_limit");
  EXPECT_TRUE(json["solve"].contains("error"));
}

// A stand-in for the desktop's program records its arguments.
TEST(Open, starts_the_desktops_program_with_the_first_picture) {
  const auto folder = fresh_folder("open");
  std::filesystem::create_directory(folder / "programs");
  write_file(folder / "programs/xdg-open",
             "#!/bin/sh\nprintf %s \"$1\" > opened.tmp\nmv opened.tmp opened.txt\n");
  std::filesystem::permissions(folder / "programs/xdg-open", std::filesystem::perms::owner_all);
  const auto run =
      cli::run(folder, "export PATH=\"$PWD/programs:$PATH\" DISPLAY=:7; " + small_bake +
                           "-o a.glb -o a.png -o a.vtkhdf --open; "
                           "for i in $(seq 200); do test -e opened.txt && break; sleep 0.05; done");
  EXPECT_EQ(run.err.find("--open"), std::string::npos) << run.err;
  EXPECT_EQ(read_file(folder / "opened.txt"), (folder / "a.png").string());
}

TEST(Open, without_a_desktop_says_so_and_fails_nothing) {
  const auto folder = fresh_folder("open_nothing");
  const auto bare = cli::run(folder, "unset DISPLAY WAYLAND_DISPLAY; " + small_bake + "-o a.png --open");
  EXPECT_EQ(bare.code, 0);
  EXPECT_NE(bare.err.find("warning: --open: there is no desktop here"), std::string::npos) << bare.err;
  const auto missing = cli::run(folder, "PATH=/nowhere DISPLAY=:7 " + small_bake + "-o a.png --open");
  EXPECT_EQ(missing.code, 0);
  EXPECT_NE(missing.err.find("xdg-open is not installed"), std::string::npos) << missing.err;
  const auto solution = cli::run(folder, "DISPLAY=:7 " + small_bake + "-o a.vtkhdf --open");
  EXPECT_NE(solution.err.find("no picture, page or mesh"), std::string::npos) << solution.err;
}

}  // namespace
}  // namespace luxel::cli
