// SPDX-License-Identifier: Apache-2.0
// Any number of processes that solve one scene give the bytes of one process.
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class Ranks : public testing::Test {
 protected:
  void SetUp() override {
    without_leak_check();
    if (std::system("mpirun --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "mpirun is not installed";
  }
  // A test may have fewer cores than ranks, and may run as root in a container.
  static std::string mpirun(int ranks) {
    return fmt::format(
        "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --oversubscribe "
        "--bind-to none --mca btl self,vader --mca mpi_yield_when_idle 1 -n {} ",
        ranks);
  }
};

const std::string fine_bake = "$LUXEL bake cornell-box.obj --max-edge 0.04 --error 2% --threads 1 ";

TEST_F(Ranks, two_and_three_give_the_bytes_of_one_with_all_that_is_kept) {
  const auto folder = fresh_folder("ranks_same");
  ASSERT_EQ(cli::run(folder, fine_bake + "--store-transport -o one.vtkhdf --quiet").code, 0);
  for (const int ranks : {2, 3}) {
    const auto run = cli::run(folder, mpirun(ranks) + fine_bake + "--store-transport -o many.vtkhdf");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.out, "many.vtkhdf\n") << "one rank speaks";
    EXPECT_TRUE(read_file(folder / "one.vtkhdf") == read_file(folder / "many.vtkhdf")) << ranks << " ranks";
  }
}

TEST_F(Ranks, each_reports_its_part_of_the_work) {
  const auto folder = fresh_folder("ranks_report");
  ASSERT_EQ(
      cli::run(folder, mpirun(3) + fine_bake + "--error 2% -o a.vtkhdf --json-file a.json --quiet").code, 0);
  const auto report = Json::parse(read_file(folder / "a.json"));
  const auto& each = report["solve"]["ranks"]["each"];
  ASSERT_EQ(each.size(), 3u);
  const auto whole = report["solution"]["rays"].get<double>();
  double sum = 0.0;
  for (const auto& rank : each) {
    const auto rays = rank["rays"].get<double>();
    sum += rays;
    EXPECT_GT(rays, 0.1 * whole);
    EXPECT_GT(rank["exchanges"].get<int>(), 0);
    EXPECT_GT(rank["received_bytes"].get<double>(), 0.0);
    EXPECT_GT(rank["processor_seconds"].get<double>(), 0.0);
  }
  EXPECT_NEAR(sum, whole, 3.0);  // the light of the first pictures is divided with a remainder
}

TEST_F(Ranks, what_memory_cannot_hold_is_traced_again_by_each_for_its_own_rows) {
  const auto folder = fresh_folder("ranks_streamed");
  ASSERT_EQ(cli::run(folder, fine_bake + "--error 5% -o one.vtkhdf --quiet").code, 0);
  const auto run =
      cli::run(folder, mpirun(2) + fine_bake + "--error 5% -o many.vtkhdf --quiet --memory 40MiB");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(read_file(folder / "one.vtkhdf") == read_file(folder / "many.vtkhdf"));
}

TEST_F(Ranks, shooting_is_shared_too) {
  const auto folder = fresh_folder("ranks_shooting");
  const std::string shoot = "$LUXEL bake cornell-box.obj --method shooting --rays 3e5 --threads 1 --quiet ";
  ASSERT_EQ(cli::run(folder, shoot + "-o one.vtkhdf").code, 0);
  const auto run = cli::run(folder, mpirun(3) + shoot + "-o many.vtkhdf");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(read_file(folder / "one.vtkhdf") == read_file(folder / "many.vtkhdf"));
}

TEST_F(Ranks, a_rank_that_dies_ends_the_run_and_the_checkpoint_goes_on_with_another_number) {
  const auto folder = fresh_folder("ranks_dead");
  const auto line = fine_bake + "--error 1% --checkpoint run.vtkhdf --every 0 -o end.vtkhdf ";
  ASSERT_EQ(cli::run(folder, fine_bake + "--error 1% -o whole.vtkhdf --quiet").code, 0);
  // The second rank is killed as soon as there is a checkpoint.
  const auto run = cli::run(
      folder, mpirun(3) + line +
                  "--quiet & pid=$!; while [ ! -e run.vtkhdf ]; do sleep 0.02; kill -0 $pid || exit 9; "
                  "done; kill -KILL $(pgrep -P $pid | sed -n 2p); wait $pid");
  ASSERT_NE(run.code, 0) << "the run was over before it could be killed";
  ASSERT_NE(run.code, 9) << run.err;
  EXPECT_FALSE(fs::exists(folder / "end.vtkhdf"));
  EXPECT_NE(run.err.find("signal 9"), std::string::npos) << run.err;
  const auto rest =
      cli::run(folder, mpirun(2) + "$LUXEL resume run.vtkhdf -o end.vtkhdf --quiet --threads 1");
  ASSERT_EQ(rest.code, 0) << rest.err;
  EXPECT_TRUE(read_file(folder / "end.vtkhdf") == read_file(folder / "whole.vtkhdf"));
}

// The second rank stands still for six seconds as soon as there is a checkpoint; on a busy machine it waits
// for the first one for some of them, while that writes files.
TEST_F(Ranks, a_slow_one_ends_nothing_is_named_and_changes_no_byte) {
  const auto folder = fresh_folder("ranks_slow");
  ASSERT_EQ(cli::run(folder, fine_bake + "--error 1% -o whole.vtkhdf --quiet").code, 0);
  const auto run = cli::run(
      folder,
      mpirun(2) + fine_bake +
          "--error 1% --checkpoint run.vtkhdf --every 0 -o end.vtkhdf "
          "& pid=$!; while [ ! -e run.vtkhdf ]; do sleep 0.02; kill -0 $pid || exit 9; done; "
          "slow=$(pgrep -P $pid | sed -n 2p); kill -STOP $slow; sleep 6; kill -CONT $slow; wait $pid");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find("rank 1 of 2 is slow: each of the others waited"), std::string::npos) << run.err;
  EXPECT_TRUE(read_file(folder / "end.vtkhdf") == read_file(folder / "whole.vtkhdf"));
}

// The first rank stands still, so that the second waits for it; the second is stopped while it waits and goes
// on more than five seconds after the first. Its own clock cannot tell those from waiting.
TEST_F(Ranks, one_that_stands_still_while_it_waits_is_named) {
  const auto folder = fresh_folder("ranks_stopped_in_wait");
  const auto run = cli::run(
      folder, mpirun(2) + fine_bake +
                  "--error 1% --checkpoint run.vtkhdf --every 0 -o end.vtkhdf "
                  "& pid=$!; while [ ! -e run.vtkhdf ]; do sleep 0.02; kill -0 $pid || exit 9; done; "
                  "first=$(pgrep -P $pid | sed -n 1p); slow=$(pgrep -P $pid | sed -n 2p); "
                  "kill -STOP $first; sleep 1.5; kill -STOP $slow; kill -CONT $first; sleep 5.5; "
                  "kill -CONT $slow; wait $pid");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find("rank 1 of 2 is slow: each of the others waited"), std::string::npos) << run.err;
}

// Address sanitizers reserve more address space than any limit allows.
#ifndef __SANITIZE_ADDRESS__
TEST_F(Ranks, one_that_is_out_of_memory_ends_all_with_a_sentence) {
  const auto folder = fresh_folder("ranks_memory");
  const std::string line =
      "$LUXEL bake cornell-box.obj --max-edge 0.01 --mesh-error none --error 0 --rays 200M "
      "--memory 8GiB --threads 1 -o a.vtkhdf";
  const auto run =
      cli::run(folder, mpirun(1) + line + " : -n 1 sh -c \"ulimit -v 520000; exec " + line + "\"");
  EXPECT_NE(run.code, 0);
  const auto at = run.err.find("luxel: rank 1: ");
  ASSERT_NE(at, std::string::npos) << run.err;
  EXPECT_NE(run.err.find("memory", at), std::string::npos) << run.err;
  EXPECT_FALSE(fs::exists(folder / "a.vtkhdf"));
}
#endif

TEST_F(Ranks, bad_input_is_one_sentence_and_ends_all) {
  const auto folder = fresh_folder("ranks_bad");
  const auto run = cli::run(folder, mpirun(3) + "$LUXEL bake nothing.obj -o a.vtkhdf");
  EXPECT_NE(run.code, 0);
  const std::string sentence = "luxel: nothing.obj:";
  const auto at = run.err.find(sentence);
  ASSERT_NE(at, std::string::npos) << run.err;
  EXPECT_EQ(run.err.find(sentence, at + 1), std::string::npos) << run.err;
}

TEST_F(Ranks, other_commands_are_run_by_one) {
  const auto folder = fresh_folder("ranks_other");
  const auto run = cli::run(folder, mpirun(3) + "$LUXEL info cornell-box.obj");
  EXPECT_EQ(run.code, 0) << run.err;
  const auto at = run.out.find("32 triangles");
  ASSERT_NE(at, std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("32 triangles", at + 1), std::string::npos) << run.out;
}

}  // namespace
}  // namespace luxel::cli
