// SPDX-License-Identifier: Apache-2.0
// Each call of the operating system that writes fails once: the file that was there is whole, old or new, the
// exit code says which, and nothing is left beside it. Reads that give little, or are interrupted, are
// repeated.
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cli/run_program.h"

namespace luxel::cli {
namespace {
namespace fs = std::filesystem;

class FailingWrites : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = fresh_folder("failing_writes");
    ASSERT_EQ(
        cli::run(folder,
                 "$LUXEL bake cornell-box.obj --max-edge 0.5 --mesh-error none --error 20% -o light.vtkhdf")
            .code,
        0);
    ASSERT_EQ(cli::run(folder, command).code, 0);
    whole = read_file(folder / "out.glb");
  }

  // Runs the command with planned failures over an old file, and checks the resulting files.
  static void expect_old_or_new(const std::string& plan) {
    std::ofstream(folder / "out.glb", std::ios::trunc) << "old";
    const auto run =
        cli::run(folder, fmt::format("LD_PRELOAD='{}' FAIL_CALL={} {}", LUXEL_FAILING_CALLS, plan, command));
    const auto found = read_file(folder / "out.glb");
    if (run.code == 0) {
      EXPECT_EQ(found, whole) << plan;
    } else {
      EXPECT_EQ(run.code, 1) << plan << ": " << run.err;
      EXPECT_EQ(found, "old") << plan;
      EXPECT_NE(run.err.find("out.glb: "), std::string::npos) << plan << ": " << run.err;
    }
    for (const auto& entry : fs::directory_iterator(folder))
      EXPECT_EQ(entry.path().filename().string().find(".tmp"), std::string::npos) << plan << entry.path();
  }

  inline static fs::path folder;
  inline static const std::string command = "$LUXEL export light.vtkhdf -o out.glb";
  inline static std::string whole;
};

TEST_F(FailingWrites, leave_the_old_file_or_the_new_one) {
  for (const char* call : {"tmpfile", "open", "write", "fsync", "linkat", "rename"})
    for (const int error : {EIO, ENOSPC, EINTR}) expect_old_or_new(fmt::format("{}:1:{}", call, error));
  for (const char* plan : {"write:1:0", "tmpfile:2:95", "close:3:5", "close:4:5", "close:5:5"})
    expect_old_or_new(plan);
}

// As from a folder of a network: few bytes at a time, and interrupted.
TEST(SlowReads, change_no_byte_of_a_result) {
  const auto folder = fresh_folder("slow_reads");
  const std::string bake =
      "$LUXEL bake cornell-box.obj --max-edge 0.5 --mesh-error none --error 20% -o light.vtkhdf -o lit.glb";
  const std::string use =
      "$LUXEL export light.vtkhdf -o out.glb && $LUXEL bake lit.glb --mesh-error none --error 20% -o "
      "again.vtkhdf";
  const auto plain_bake = cli::run(folder, bake), plain_use = cli::run(folder, use);
  ASSERT_EQ(plain_use.code, 0) << plain_bake.err << plain_use.err;
  const std::string files[] = {"light.vtkhdf", "out.glb", "again.vtkhdf"};
  std::vector<std::string> whole;
  for (const auto& file : files) whole.push_back(read_file(folder / file));
  const auto slowly = fmt::format("export LD_PRELOAD='{}' SLOW_READS=997; ", LUXEL_FAILING_CALLS);
  const auto slow_bake = cli::run(folder, slowly + bake), slow_use = cli::run(folder, slowly + use);
  EXPECT_EQ(slow_bake.code, plain_bake.code) << slow_bake.err;
  EXPECT_EQ(slow_use.code, 0) << slow_use.err;
  for (std::size_t i = 0; i < std::size(files); ++i)
    EXPECT_EQ(read_file(folder / files[i]), whole[i]) << files[i];
}

}  // namespace
}  // namespace luxel::cli
