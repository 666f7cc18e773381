// SPDX-License-Identifier: Apache-2.0
// Machines that refuse threads, files that ask for too much, outputs that would destroy inputs, leftovers of
// killed runs.
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "cli/run_program.h"

namespace luxel::cli {
namespace {
namespace fs = std::filesystem;

const std::string bake = "$LUXEL bake cornell-box.obj --max-edge 0.2 --error 10% ";

TEST(Threads, that_cannot_be_started_are_done_without_and_the_bytes_are_the_same) {
  without_leak_check();
  const auto folder = fresh_folder("no_threads");
  // A limit on processes does not bind the superuser.
  const std::string ordinary = ::geteuid() == 0 ? "setpriv --reuid=65534 --clear-groups " : "";
  fs::permissions(folder, fs::perms::all);
  ASSERT_EQ(cli::run(folder, bake + "-o free.ply --threads 3").code, 0);
  for (const std::string threads : {"2", "64"}) {
    const auto starved = cli::run(
        folder, ordinary + "timeout 100 prlimit --nproc=1 " + bake + "-o starved.ply --threads " + threads);
    ASSERT_EQ(starved.code, 0) << starved.err;
    EXPECT_NE(starved.err.find("warning: only 1 of " + threads + " threads can be started"),
              std::string::npos)
        << starved.err;
    EXPECT_EQ(read_file(folder / "starved.ply"), read_file(folder / "free.ply"));
  }
}

// Address sanitizers reserve more address space than any limit allows.
#ifndef __SANITIZE_ADDRESS__
TEST(Memory, that_patches_would_need_is_compared_with_what_is_free_before_any_is_made) {
  const auto folder = fresh_folder("no_memory");
  const auto run =
      cli::run(folder, "ulimit -v 400000; $LUXEL bake cornell-box.obj --max-edge 0.0008 -o a.ply");
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_NE(run.err.find("patches, which need about "), std::string::npos) << run.err;
  EXPECT_NE(run.err.find(" m would fit"), std::string::npos) << run.err;
  EXPECT_FALSE(fs::exists(folder / "a.ply"));
}
#endif

// A second is promised; ten of the processor are a finding.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
const std::string in_time = "ulimit -t 100; ";
#else
const std::string in_time = "ulimit -t 10; ";
#endif

TEST(Refusals, of_a_polygon_that_crosses_itself_everywhere_come_soon) {
  const auto folder = fresh_folder("crossing");
  constexpr int corners = 60'000;
  std::ofstream file(folder / "fan.obj");
  for (int i = 0; i < corners; ++i)
    file << "v " << i % 300 << ' ' << static_cast<long long>(i) * i % 977 << " 0\n";
  file << 'f';
  for (int i = 1; i <= corners; ++i) file << ' ' << i;
  file << "\n";
  file.close();
  const auto run = cli::run(folder, in_time + "$LUXEL bake fan.obj -o a.glb");
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_NE(run.err.find("surfaces touch or pierce one another in so many places"), std::string::npos)
      << run.err;
}

// The default light is found with rays, each of which passes hundreds of these triangles.
TEST(Refusals, of_a_heap_of_triangles_come_before_any_ray) {
  const auto folder = fresh_folder("heap");
  constexpr int triangles = 3000;
  std::minstd_rand random(1);
  std::uniform_int_distribution<int> place(0, 4999);
  std::ofstream file(folder / "heap.obj");
  for (int i = 0; i < 3 * triangles; ++i)
    file << "v " << place(random) << ' ' << place(random) << ' ' << place(random) << '\n';
  for (int i = 0; i < triangles; ++i)
    file << "f " << 3 * i + 1 << ' ' << 3 * i + 2 << ' ' << 3 * i + 3 << '\n';
  file.close();
  const auto run = cli::run(folder, in_time + "$LUXEL bake heap.obj -o a.glb");
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_NE(run.err.find("surfaces touch or pierce one another in so many places"), std::string::npos)
      << run.err;
  EXPECT_EQ(run.err.find("lit by"), std::string::npos) << run.err;
}

TEST(Outputs, never_overwrite_what_a_run_reads) {
  const auto folder = fresh_folder("keep_inputs");
  const auto mtl = read_file(folder / "cornell-box.mtl");
  fs::create_hard_link(folder / "cornell-box.mtl", folder / "same.json");
  const auto of_scene = cli::run(folder, bake + "-o a.ply --json-file ./same.json");
  EXPECT_EQ(of_scene.code, 2) << of_scene.err;
  EXPECT_NE(of_scene.err.find("--json-file ./same.json: this file is read for this run (cornell-box.mtl)"),
            std::string::npos)
      << of_scene.err;
  const auto of_option = cli::run(folder, bake + "-o a.ply --spectral cornell-spectra.csv --json-file ../" +
                                              folder.filename().string() + "/cornell-spectra.csv");
  EXPECT_EQ(of_option.code, 2) << of_option.err;
  EXPECT_NE(of_option.err.find("this file is read for this run (cornell-spectra.csv)"), std::string::npos)
      << of_option.err;
  EXPECT_EQ(read_file(folder / "cornell-box.mtl"), mtl);
  EXPECT_FALSE(fs::exists(folder / "a.ply"));
}

TEST(Outputs, do_not_follow_links) {
  const auto folder = fresh_folder("linked_output");
  std::ofstream(folder / "precious.txt") << "precious";
  fs::create_symlink("precious.txt", folder / "a.ply");
  const auto run = cli::run(folder, bake + "-o a.ply");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.err.find("it is a symbolic link"), std::string::npos) << run.err;
  EXPECT_EQ(read_file(folder / "precious.txt"), "precious");
}

TEST(Outputs, are_cleared_of_what_killed_runs_left) {
  const auto folder = fresh_folder("leftovers");
  std::ofstream(folder / ".a.4242.0.tmp.ply") << std::string(2'000'000, 'x');
  const auto run = cli::run(folder, bake + "-o a.ply");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find("removed 2.0 MB of temporary files that killed runs left"), std::string::npos)
      << run.err;
  EXPECT_FALSE(fs::exists(folder / ".a.4242.0.tmp.ply"));
}

TEST(Messages, show_control_characters_of_names_instead_of_sending_them) {
  const auto folder = fresh_folder("escapes");
  std::ofstream(folder / "a.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl \x1b]0;owned\x07\nf 1 2 3\n";
  const auto run = cli::run(folder, "$LUXEL check a.obj && $LUXEL bake a.obj -o a.ply --max-edge 1");
  EXPECT_EQ(run.err.find('\x1b'), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("\\x1b]0;owned\\x07"), std::string::npos) << run.err;
  const auto missing = cli::run(folder, "$LUXEL bake $(printf 'x\\033[2Jy.obj')");
  EXPECT_EQ(missing.err, "luxel: x\\x1b[2Jy.obj: no such file\n");
}

}  // namespace
}  // namespace luxel::cli
