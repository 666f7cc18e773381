// SPDX-License-Identifier: Apache-2.0
// A program built without MPI: one process alone works, one of several says what is wrong.
#include <filesystem>

#include <gtest/gtest.h>

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

TEST(WithoutMpi, one_of_several_processes_ends_with_a_sentence) {
  const auto folder = fresh_folder("without_mpi");
  const auto run = cli::run(folder, "OMPI_COMM_WORLD_SIZE=2 $LUXEL bake cornell-box.obj -o a.png");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.err.find("one of 2 processes, but built without MPI"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

TEST(WithoutMpi, one_process_works) {
  const auto folder = fresh_folder("without_mpi_alone");
  const auto run = cli::run(folder, "OMPI_COMM_WORLD_SIZE=1 $LUXEL info cornell-box.obj");
  EXPECT_EQ(run.code, 0) << run.err;
}

}  // namespace
}  // namespace luxel::cli
