// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"

namespace luxel {
namespace {

std::string refusal(const std::filesystem::path& path, std::uint64_t most = 1 << 20) {
  try {
    read_file(path, most);
  } catch (const InputError& e) {
    return e.what();
  }
  return "read without complaint";
}

TEST(ReadFile, every_byte_comes_back) {
  const auto path = std::filesystem::path(testing::TempDir()) / "read_file.bytes";
  std::string bytes;
  for (int i = 0; i < 300'000; ++i) bytes.push_back(static_cast<char>(i * 7 + i / 256));
  std::ofstream(path, std::ios::binary) << bytes;
  EXPECT_EQ(read_file(path), bytes);
  std::filesystem::remove(path);
}

TEST(ReadFile, an_empty_file_is_an_empty_string) { EXPECT_EQ(read_file("/dev/null"), ""); }

TEST(ReadFile, a_missing_file_is_named_with_the_reason) {
  EXPECT_EQ(refusal("no/such/file.obj"), "no/such/file.obj: cannot read it: No such file or directory");
}

TEST(ReadFile, a_folder_is_no_file) {
  const auto folder = testing::TempDir();
  EXPECT_EQ(refusal(folder), folder + ": it is a folder, expected a file");
}

TEST(ReadFile, a_file_that_never_ends_is_left_alone) {
  EXPECT_EQ(refusal("/dev/zero", 1000), "/dev/zero: it holds more than the 1000 bytes that are read");
}

TEST(ReadFile, the_limit_itself_is_allowed) {
  const auto path = std::filesystem::path(testing::TempDir()) / "read_file.limit";
  std::ofstream(path) << "12345";
  EXPECT_EQ(read_file(path, 5), "12345");
  EXPECT_NE(refusal(path, 4).find("more than the 4 bytes"), std::string::npos);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace luxel
