// SPDX-License-Identifier: Apache-2.0
// End-to-end tests of runs that outlive their process: checkpoint, resume, merge and relight.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <random>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "luxel/solution/solution_file.h"

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

TEST(StoredRuns, killed_a_hundred_times_nothing_is_lost_and_the_end_is_the_same) {
  const auto folder = fresh_folder("killed");
  const std::string bake = "$LUXEL bake cornell-box.obj --max-edge 0.2 --error 2% --store-transport ";
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(cli::run(folder, bake + "-o whole.vtkhdf --quiet").code, 0);
  const std::chrono::duration<double> whole_run = std::chrono::steady_clock::now() - begin;
  const auto expected = read_file(folder / "whole.vtkhdf");
  const auto line = bake + "-o end.vtkhdf --checkpoint run.vtkhdf --every 0 --quiet --threads 2";
  // Moments from the start to about the end; their place in the run depends on the machine.
  std::minstd_rand random(1);
  std::uniform_real_distribution<double> moment(0.0, whole_run.count());
  int found = 0;
  int finished = 0;
  for (int kill = 0; kill < 100; ++kill) {
    const auto run = cli::run(folder, fmt::format("timeout -s KILL {:.3f} {}", moment(random), line));
    if (run.code == 0) {  // it ended before that
      ++finished;
      ASSERT_TRUE(read_file(folder / "end.vtkhdf") == expected) << "run " << kill;
      fs::remove(folder / "end.vtkhdf");
      fs::remove(folder / "run.vtkhdf");
      continue;
    }
    ASSERT_EQ(run.code, 137) << run.err;
    if (!fs::exists(folder / "run.vtkhdf")) continue;
    ++found;
    if (kill % 10 > 0) continue;  // the next run reads it in any case
    ASSERT_EQ(cli::run(folder, "$LUXEL info run.vtkhdf").code, 0) << "after kill " << kill;
  }
  EXPECT_GT(found + finished, 0);
  // To the end, by the same command and by `resume`.
  if (fs::exists(folder / "run.vtkhdf")) fs::copy_file(folder / "run.vtkhdf", folder / "copy.vtkhdf");
  ASSERT_EQ(cli::run(folder, line).code, 0);
  EXPECT_TRUE(read_file(folder / "end.vtkhdf") == expected);
  if (fs::exists(folder / "copy.vtkhdf")) {
    ASSERT_EQ(cli::run(folder, "$LUXEL resume copy.vtkhdf -o resumed.vtkhdf --quiet").code, 0);
    EXPECT_TRUE(read_file(folder / "resumed.vtkhdf") == expected);
  }
}

TEST(StoredRuns, a_resumed_run_records_that_a_new_error_ends_it) {
  const auto folder = fresh_folder("resumed_bound");
  const auto cheap_rays = [&](const std::string& command, const std::string& file) {
    const auto run = cli::run(folder, "$LUXEL " + command + " -o " + file + " --quiet");
    EXPECT_EQ(run.code, 0) << run.err;
    const auto options = read_solution(folder / file).solution.provenance.options;
    const auto found =
        std::find_if(options.begin(), options.end(), [](const auto& o) { return o.first == "cheap-rays"; });
    return found == options.end() ? std::string() : found->second;
  };
  const std::string draft = "bake cornell-box.obj --max-edge 0.2 --quality draft --store-transport";
  EXPECT_EQ(cheap_rays(draft, "a.vtkhdf"), "10M");
  EXPECT_EQ(cheap_rays("resume a.vtkhdf", "b.vtkhdf"), "10M");
  EXPECT_EQ(cheap_rays("resume a.vtkhdf --error 4%", "c.vtkhdf"), "none");
  EXPECT_EQ(cheap_rays("resume c.vtkhdf", "d.vtkhdf"), "none");
}

TEST(StoredRuns, resume_goes_on_to_a_finer_error) {
  const auto folder = fresh_folder("finer");
  ASSERT_EQ(
      cli::run(folder, "$LUXEL bake cornell-box.obj --max-edge 0.05 --error 5% --checkpoint a.vtkhdf").code,
      0);
  const auto run = cli::run(folder, "$LUXEL resume a.vtkhdf --error 1% -o b.glb --json");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = Json::parse(run.out);
  EXPECT_LE(json["solve"]["error"]["reached"], 0.01);
  EXPECT_EQ(json["solution"]["command_line"],
            "luxel bake cornell-box.obj --max-edge 0.05 --error 5%; luxel resume a.vtkhdf --error 1%");
  EXPECT_TRUE(fs::exists(folder / "b.glb"));
  // The checkpoint is at the finer error now: nothing is left to trace.
  const auto again = cli::run(folder, "$LUXEL resume a.vtkhdf --error 1% -o c.vtkhdf --json");
  EXPECT_EQ(Json::parse(again.out)["solution"]["rays"], json["solution"]["rays"]);
}

TEST(StoredRuns, what_would_be_lost_is_refused_in_a_sentence_and_stays) {
  const auto folder = fresh_folder("refused");
  const auto refused = [&](const std::string& line, const std::string& says) {
    const auto before = fs::exists(folder / "a.vtkhdf") ? read_file(folder / "a.vtkhdf") : std::string();
    const auto run = cli::run(folder, line);
    EXPECT_NE(run.code, 0) << line;
    EXPECT_NE(run.err.find(says), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_TRUE(read_file(folder / "a.vtkhdf") == before) << line;
  };
  const std::string quick = "$LUXEL bake cornell-box.obj --max-edge 0.2 --quiet ";
  ASSERT_EQ(cli::run(folder, quick + "--error 5% --checkpoint a.vtkhdf").code, 0);
  refused(quick + "--error 4% --checkpoint a.vtkhdf", "it holds a run with other options (luxel bake");
  refused("$LUXEL bake cornell-box.obj --max-edge 0.2 --sky 1 --error 5% --checkpoint a.vtkhdf --quiet",
          "it holds a run of another scene");
  refused(quick + "--method shooting --checkpoint b.vtkhdf", "--checkpoint needs --method sampled");
  ASSERT_EQ(cli::run(folder, quick + "--error 5% -o plain.vtkhdf").code, 0);
  refused(quick + "--error 5% --checkpoint plain.vtkhdf", "a solution without samples");
  refused("$LUXEL resume plain.vtkhdf -o c.vtkhdf", "it stores no samples to continue from");
  refused("$LUXEL relight plain.vtkhdf -o c.vtkhdf", "it stores no transport to relight with");
  refused("$LUXEL relight a.vtkhdf --off desk -o c.vtkhdf", "there is no light group 'desk', but");
  refused("$LUXEL merge plain.vtkhdf plain.vtkhdf -o c.vtkhdf", "it is made with seed 1, as is");
  // A file cut in half.
  const auto whole = read_file(folder / "a.vtkhdf");
  fs::resize_file(folder / "a.vtkhdf", whole.size() / 2);
  refused("$LUXEL resume a.vtkhdf -o c.vtkhdf", "a.vtkhdf: ");
  refused(quick + "--error 5% --checkpoint a.vtkhdf", "a.vtkhdf: ");
}

TEST(StoredRuns, a_full_disk_costs_the_checkpoint_not_the_run) {
  const auto folder = fresh_folder("full");
  ASSERT_EQ(cli::run(folder,
                     "$LUXEL bake cornell-box.obj --max-edge 0.1 --error 3% --checkpoint a.vtkhdf -q "
                     "2>/dev/null || $LUXEL bake cornell-box.obj --max-edge 0.1 --error 3% "
                     "--checkpoint a.vtkhdf --quiet")
                .code,
            0);
  const auto before = read_file(folder / "a.vtkhdf");
  // No file may grow beyond 100 KiB here: a disk that is full.
  const auto run = cli::run(folder,
                            "ulimit -f 100; trap '' XFSZ; $LUXEL resume a.vtkhdf --error 1% --every 0 -o "
                            "small.png --width 32 --height 32");
  EXPECT_NE(run.err.find("cannot write a.vtkhdf"), std::string::npos) << run.err;
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_TRUE(fs::exists(folder / "small.png")) << "what could be written was not";
  EXPECT_TRUE(read_file(folder / "a.vtkhdf") == before);
}

TEST(StoredRuns, ten_machines_without_mpi_make_one_answer) {
  const auto folder = fresh_folder("merge");
  std::string files;
  for (int seed = 1; seed <= 3; ++seed) {
    const auto file = fmt::format("{}.vtkhdf", seed);
    ASSERT_EQ(
        cli::run(folder, fmt::format("$LUXEL bake cornell-box.obj --max-edge 0.1 --error 3% --seed {} -o {} "
                                     "--quiet",
                                     seed, file))
            .code,
        0);
    files = file + " " + files;
  }
  const auto run =
      cli::run(folder, "$LUXEL merge " + files + "-o all.vtkhdf -o all.png --width 64 --height 64 --json");
  ASSERT_EQ(run.code, 0) << run.err;
  ASSERT_EQ(cli::run(folder, "$LUXEL merge 1.vtkhdf 2.vtkhdf 3.vtkhdf -o other.vtkhdf").code, 0);
  EXPECT_TRUE(read_file(folder / "all.vtkhdf") == read_file(folder / "other.vtkhdf"));
  EXPECT_LT(Json::parse(run.out)["solution"]["predicted_error"], 0.02);
}

TEST(StoredRuns, relight_changes_lamps_and_walls_without_a_ray) {
  const auto folder = fresh_folder("relight");
  ASSERT_EQ(cli::run(folder,
                     "$LUXEL bake cornell-box.obj --max-edge 0.1 --error 3% --store-transport -o a.vtkhdf "
                     "--light-group top=lamp --quiet")
                .code,
            0);
  const auto mean_after = [&](const std::string& options) {
    const auto run = cli::run(folder, "$LUXEL relight a.vtkhdf -o b.vtkhdf --json " + options);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err.find("warning"), std::string::npos) << run.err;
    return Json::parse(run.out);
  };
  mean_after("--light top=0.3 --tint 'top=#ffd0a0'");
  ASSERT_EQ(cli::run(folder, "$LUXEL info b.vtkhdf").code, 0);
  EXPECT_EQ(mean_after("--off top")["solution"]["predicted_error"], 0.0);
  mean_after("--reflectance 'white=0.5,0.2,0.2' --reflectance 'red=#ff8000'");
  // A fresh bake of the same scene agrees.
  mean_after("--reflectance white=0.4");
  ASSERT_EQ(cli::run(folder,
                     "sed -i '/newmtl white/,/^$/ s/Kd .*/Kd 0.4 0.4 0.4/' cornell-box.mtl && $LUXEL bake "
                     "cornell-box.obj --max-edge 0.1 --error 1% --seed 5 -o fresh.vtkhdf --quiet")
                .code,
            0);
  const auto same = cli::run(folder, "$LUXEL compare fresh.vtkhdf b.vtkhdf");
  EXPECT_NE(same.out.find("agree within their errors"), std::string::npos) << same.out << same.err;
  EXPECT_EQ(same.out.find("do NOT"), std::string::npos) << same.out;
}

}  // namespace
}  // namespace luxel::cli
