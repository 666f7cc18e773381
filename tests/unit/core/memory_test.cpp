// SPDX-License-Identifier: Apache-2.0
// Free memory, read from folders in place of /proc and /sys. Limits of the test's own process apply too: they
// are far above these numbers.
#include "luxel/core/memory.h"

#include <fstream>

#include <gtest/gtest.h>

namespace luxel {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t mebibyte = 1u << 20;

class Memory : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(root_);
    write("proc/meminfo", "MemTotal:  8000000 kB\nMemAvailable:    102400 kB\n");  // 100 MiB
  }
  void TearDown() override { fs::remove_all(root_); }
  void write(const fs::path& file, const std::string& text) const {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }
  // A group of the second version.
  void write_group(const fs::path& folder, const std::string& limit, std::uint64_t used,
                   std::uint64_t cache) const {
    write(folder / "memory.max", limit);
    write(folder / "memory.current", std::to_string(used * mebibyte));
    write(folder / "memory.stat", "anon 5\ninactive_file " + std::to_string(cache * mebibyte) + "\nslab 7\n");
  }
  std::uint64_t free_mebibytes() const { return free_memory(root_) / mebibyte; }

  fs::path root_ = fs::path(testing::TempDir()) / "luxel_memory_test";
};

TEST_F(Memory, is_what_the_system_says_where_there_are_no_limits) {
  EXPECT_EQ(free_mebibytes(), 100u);
  write("proc/self/cgroup", "0::/some/slice\n");
  write_group("sys/fs/cgroup/some/slice", "max\n", 3000, 0);
  EXPECT_EQ(free_mebibytes(), 100u);
}

TEST_F(Memory, is_unknown_where_the_system_says_nothing) {
  fs::remove_all(root_);
  EXPECT_EQ(free_memory(root_), 0u);
}

TEST_F(Memory, is_what_the_tightest_group_leaves_without_what_it_caches_of_files) {
  write("proc/self/cgroup", "0::/job/step\n");
  write_group("sys/fs/cgroup/job/step", std::to_string(90 * mebibyte) + "\n", 40, 10);
  EXPECT_EQ(free_mebibytes(), 60u);
  write_group("sys/fs/cgroup/job", std::to_string(70 * mebibyte) + "\n", 45, 10);
  EXPECT_EQ(free_mebibytes(), 35u) << "the group around it";
}

TEST_F(Memory, is_that_of_a_container_whose_path_is_seen_from_outside) {
  write("proc/self/cgroup", "0::/../../docker/0123\n");
  write_group("sys/fs/cgroup", std::to_string(50 * mebibyte) + "\n", 30, 0);
  EXPECT_EQ(free_mebibytes(), 20u);
}

TEST_F(Memory, knows_groups_of_the_first_version) {
  write("proc/self/cgroup", "9:cpu,cpuacct:/other\n8:hugetlb,memory:/slurm/job\n1:name=systemd:/\n");
  const fs::path folder = "sys/fs/cgroup/memory/slurm/job";
  write(folder / "memory.limit_in_bytes", std::to_string(64 * mebibyte) + "\n");
  write(folder / "memory.usage_in_bytes", std::to_string(32 * mebibyte) + "\n");
  write(folder / "memory.stat", "total_inactive_file " + std::to_string(8 * mebibyte) + "\n");
  EXPECT_EQ(free_mebibytes(), 40u);
}

TEST_F(Memory, is_next_to_nothing_above_a_limit) {
  write("proc/self/cgroup", "0::/\n");
  write_group("sys/fs/cgroup", std::to_string(50 * mebibyte) + "\n", 60, 0);
  EXPECT_EQ(free_memory(root_), 1u);
}

}  // namespace
}  // namespace luxel
