// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/output_file.h"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "luxel/core/error.h"

namespace luxel {
namespace {
namespace fs = std::filesystem;

// An empty folder of the test's own, removed with all that is in it.
class OutputFileTest : public testing::Test {
 protected:
  OutputFileTest()
      : folder_(fs::path(testing::TempDir()) /
                testing::UnitTest::GetInstance()->current_test_info()->name()) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~OutputFileTest() override { fs::remove_all(folder_); }

  fs::path path(const std::string& name) const { return folder_ / name; }
  std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(folder_), {}); }

 private:
  fs::path folder_;
};

void put(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

std::string refusal(const fs::path& path) {
  try {
    write_file(path, "light");
  } catch (const DeviceError& e) {
    return e.what();
  }
  return "written without complaint";
}

TEST_F(OutputFileTest, a_written_file_holds_the_bytes_and_nothing_stays_beside_it) {
  const std::string bytes("a\0b\r\n\xff", 6);
  write_file(path("a.bin"), bytes);
  EXPECT_EQ(read_file(path("a.bin")), bytes);
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, the_old_file_stays_until_commit) {
  put(path("a.txt"), "old");
  OutputFile file(path("a.txt"));
  file.write("ne");
  file.write("w");
  EXPECT_EQ(read_file(path("a.txt")), "old");
  file.commit();
  EXPECT_EQ(read_file(path("a.txt")), "new");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, an_interrupted_writer_leaves_the_old_file_as_it_was) {
  put(path("a.txt"), "old");
  {
    OutputFile file(path("a.txt"));
    file.write("half of the n");
  }
  EXPECT_EQ(read_file(path("a.txt")), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, a_killed_writer_leaves_nothing_that_the_next_one_does_not_remove) {
  put(path("a.txt"), "old");
  const auto child = ::fork();
  if (child == 0) {
    OutputFile file(path("a.txt"));
    file.write(std::string(100'000, 'x'));
    ::kill(::getpid(), SIGKILL);
  }
  ASSERT_GT(child, 0);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status));
  remove_leftovers(path("a.txt"));
  EXPECT_EQ(read_file(path("a.txt")), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, leftovers_of_the_dead_are_removed_and_those_of_the_living_stay) {
  put(path(".a.1234.0.tmp.txt"), "left");
  put(path(".b.1234.0.tmp.txt"), "of another file");
  put(path(".a.5678.0.tmp.txt"), "being written");
  const int living = ::open(path(".a.5678.0.tmp.txt").c_str(), O_RDWR);
  ASSERT_EQ(::flock(living, LOCK_EX), 0);
  EXPECT_EQ(remove_leftovers(path("a.txt")), 4u);
  EXPECT_FALSE(fs::exists(path(".a.1234.0.tmp.txt")));
  EXPECT_TRUE(fs::exists(path(".b.1234.0.tmp.txt")));
  EXPECT_TRUE(fs::exists(path(".a.5678.0.tmp.txt")));
  ::close(living);
}

TEST_F(OutputFileTest, two_writers_of_one_file_do_not_disturb_each_other) {
  OutputFile a(path("a.txt"));
  OutputFile b(path("a.txt"));
  a.write("first");
  b.write("second");
  b.commit();
  a.commit();
  EXPECT_EQ(read_file(path("a.txt")), "first");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, a_name_as_long_as_the_system_allows_can_be_written) {
  const auto name = fmt::format("{}.png", std::string(251, 'n'));
  write_file(path(name), "x");
  EXPECT_EQ(read_file(path(name)), "x");
}

TEST_F(OutputFileTest, a_missing_folder_is_named) {
  const auto folder = path("missing");
  const auto file = folder / "a.png";
  EXPECT_EQ(refusal(file),
            "cannot write " + file.string() + ": the folder '" + folder.string() + "' does not exist");
}

TEST_F(OutputFileTest, a_file_cannot_be_a_folder) {
  put(path("plain"), "");
  const auto file = path("plain") / "a.png";
  EXPECT_NE(refusal(file).find("cannot write " + file.string() + ": "), std::string::npos);
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, a_folder_is_not_overwritten) {
  fs::create_directory(path("out.png"));
  EXPECT_EQ(refusal(path("out.png")),
            "cannot write " + path("out.png").string() + ": it is a folder, expected the name of a file");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, an_empty_name_is_refused) {
  EXPECT_EQ(refusal(""), "cannot write a file without a name");
}

TEST_F(OutputFileTest, a_full_device_says_so) {
  EXPECT_EQ(refusal("/dev/full"), "cannot write /dev/full: No space left on device");
}

TEST_F(OutputFileTest, a_write_protected_file_is_not_replaced) {
  if (::geteuid() == 0) GTEST_SKIP() << "the superuser may write everywhere";
  put(path("a.txt"), "old");
  ::chmod(path("a.txt").c_str(), 0444);
  EXPECT_NE(refusal(path("a.txt")).find("write-protected"), std::string::npos);
  EXPECT_EQ(read_file(path("a.txt")), "old");
}

TEST_F(OutputFileTest, a_link_is_not_followed) {
  put(path("real.txt"), "old");
  for (const auto* target : {"real.txt", "later.txt"}) {
    fs::create_symlink(target, path("link.txt"));
    EXPECT_NE(refusal(path("link.txt")).find("it is a symbolic link"), std::string::npos);
    EXPECT_TRUE(fs::is_symlink(path("link.txt")));
    fs::remove(path("link.txt"));
  }
  EXPECT_EQ(read_file(path("real.txt")), "old");
  EXPECT_FALSE(fs::exists(path("later.txt")));
}

TEST_F(OutputFileTest, a_replaced_file_keeps_its_permissions) {
  put(path("a.txt"), "old");
  ::chmod(path("a.txt").c_str(), 0600);
  write_file(path("a.txt"), "new");
  EXPECT_EQ(fs::status(path("a.txt")).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(OutputFileTest, a_pipe_is_written_where_it_stands) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  std::string received;
  std::thread reader([&] { received = read_file(path("pipe")); });
  write_file(path("pipe"), "through the pipe");
  reader.join();
  EXPECT_EQ(received, "through the pipe");
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFileTest, a_device_is_not_removed_by_an_interrupted_writer) {
  {
    OutputFile file("/dev/null");
    file.write("x");
  }
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

}  // namespace
}  // namespace luxel
