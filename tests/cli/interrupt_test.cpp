// SPDX-License-Identifier: Apache-2.0
// Ctrl-C at every stage of a bake.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

// The interrupt is sent once the solve has begun, which the first progress line shows.
TEST(Interrupt, writes_what_it_has_and_says_so) {
  const auto folder = fresh_folder("interrupt");
  const auto run = run_interrupted(
      folder, "$LUXEL bake cornell-box.obj --method shooting --rays 50G --max-edge 0.1 -o a.glb -o a.vtkhdf",
      "grep -q lamp stderr.txt", "1");
  EXPECT_NE(run.err.find("stopped"), std::string::npos) << run.err;
  expect_light_is_kept(folder, run);
}

// The first error on a line of the refinement is that of its first mesh.
TEST(Interrupt, while_it_refines_writes_the_light_that_decided) {
  const auto folder = fresh_folder("interrupt_refinement");
  const auto run = run_interrupted(folder, "$LUXEL bake cornell-box.obj --mesh-error 0.05% -o a.vtkhdf",
                                   "grep -q 'refine.*error' stderr.txt");
  EXPECT_EQ(run.code, 3) << run.err;
  EXPECT_NE(run.err.find("stopped"), std::string::npos) << run.err;
  EXPECT_EQ(run.out, "a.vtkhdf\n");
  const auto info = cli::run(folder, "$LUXEL info a.vtkhdf");
  EXPECT_NE(info.out.find("stopped by user"), std::string::npos) << info.out;
  EXPECT_NE(info.out.find("mesh error"), std::string::npos) << info.out;
}

// No other file has the light, so that the mesh is waited for.
TEST(Interrupt, while_it_refines_writes_a_mesh_that_alone_has_the_light) {
  const auto folder = fresh_folder("interrupt_refined_mesh");
  const auto run = run_interrupted(folder, "$LUXEL bake cornell-box.obj --mesh-error 0.05% -o a.glb",
                                   "grep -q 'refine.*error' stderr.txt");
  EXPECT_EQ(run.code, 3) << run.err;
  EXPECT_EQ(run.out, "a.glb\n") << run.err;
}

// The picture takes longer than an interrupted run has, and can be made from the solution.
TEST(Interrupt, of_the_solve_leaves_a_second_for_what_can_be_made_from_the_solution) {
  const auto folder = fresh_folder("interrupt_second");
  const auto run = run_interrupted(
      folder,
      "$LUXEL bake cornell-box.obj --method shooting --rays 50G --max-edge 0.1 --width 10000 --height 10000 "
      "-o a.png -o a.vtkhdf",
      "grep -q lamp stderr.txt", "1");
  EXPECT_EQ(run.code, 3) << run.err;
  EXPECT_NE(run.err.find("stopped: "), std::string::npos) << run.err;
  EXPECT_EQ(cli::run(folder, "$LUXEL info a.vtkhdf").code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

// Where the machine is so busy that one tile of the picture takes a second, the program ends amid it.
TEST(Interrupt, while_it_draws_keeps_the_light_and_writes_no_half_picture) {
  const auto folder = fresh_folder("interrupt_picture");
  const auto run = run_interrupted(
      folder,
      "$LUXEL bake cornell-box.obj --method shooting --rays 10k --max-edge 0.1 --width 5000 --height 5000 "
      "-o a.png -o a.vtkhdf",
      "test -e a.vtkhdf", "0.5");
  EXPECT_EQ(run.code, 3) << run.err;
  const bool is_ended = run.err.find("stopped: no further file is written") != std::string::npos;
  EXPECT_NE(is_ended, run.err.find("the picture was not finished") != std::string::npos) << run.err;
  EXPECT_EQ(run.out, "a.vtkhdf\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

// The solution is there first; the second mesh takes longer than an interrupt.
TEST(Interrupt, while_it_writes_meshes_keeps_the_solution_and_ends) {
  const auto folder = fresh_folder("interrupt_outputs");
  const auto run =
      run_interrupted(folder,
                      "$LUXEL bake cornell-box.obj --error 0 --rays 100k --mesh-error none --max-edge 0.01 "
                      "-o a.vtkhdf -o a.glb -o b.glb -o c.glb",
                      "test -e a.vtkhdf");
  EXPECT_EQ(run.code, 3) << run.err;
  EXPECT_NE(run.err.find("stopped: "), std::string::npos) << run.err;
  EXPECT_EQ(cli::run(folder, "$LUXEL info a.vtkhdf").code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "c.glb"));
}

// Opening a pipe without a writer blocks forever and does not poll the interrupt.
TEST(Interrupt, where_no_stage_heeds_it_ends_the_program) {
  const auto folder = fresh_folder("interrupt_overdue");
  const auto run = run_interrupted(folder, "mkfifo slow.obj; exec $LUXEL bake slow.obj -o a.glb",
                                   "test -p slow.obj", "0.5");
  EXPECT_EQ(run.code, 3) << run.err;
  EXPECT_EQ(run.err, "stopped: no further file is written\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.glb"));
}

}  // namespace
}  // namespace luxel::cli
