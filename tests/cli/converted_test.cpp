// SPDX-License-Identifier: Apache-2.0
// End-to-end tests of FBX, DAE and 3DS scenes: luxel and the program luxel-import that it runs.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "cli/run_program.h"
#include "support/converted_files.h"

namespace luxel::cli {
namespace {

// A closed room lit from inside, once its faces are turned. Cubes of the files are 2 units wide.
const std::string quick = " --flip '*' --max-edge 0.5 --error 20% --up y ";

std::filesystem::path folder_of(const std::string& name) {
  const auto folder = fresh_folder("converted_" + name);
  write_file(folder / "room.fbx", SmallFbx().text());
  write_file(folder / "room.dae", SmallDae().text());
  write_file(folder / "room.3ds", Small3ds().file());
  return folder;
}

// A copy of luxel in the folder, so that it finds only a converter in that folder.
void copy_program(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder / "bin");
  std::filesystem::copy_file(LUXEL_PROGRAM, folder / "bin" / "luxel");
}

std::size_t lines_in(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(Converted, scenes_are_baked_like_others) {
  const auto folder = folder_of("bake");
  for (const std::string name : {"room.fbx", "room.dae", "room.3ds"}) {
    const auto run =
        cli::run(folder, "$LUXEL bake " + name + quick + "-o " + name + ".glb -o " + name + ".vtkhdf");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.out, name + ".vtkhdf\n" + name + ".glb\n");
    EXPECT_EQ(run.err.find("warning"), std::string::npos) << run.err;
    const auto info = cli::run(folder, "$LUXEL info " + name + ".vtkhdf");
    EXPECT_NE(info.out.find(name), std::string::npos) << info.out;
    const auto mesh =
        cli::run(folder, "$LUXEL export " + name + ".vtkhdf --scene " + name + " --quiet -o again.glb");
    EXPECT_EQ(mesh.code, 0) << mesh.err;
  }
}

TEST(Converted, a_damaged_file_is_one_sentence_and_leaves_nothing) {
  const auto folder = folder_of("damaged");
  const auto good = SmallFbx().text();
  write_file(folder / "room.fbx", good.substr(0, good.size() / 2));
  const auto run = cli::run(folder, "$LUXEL bake room.fbx -o a.glb; code=$?; ls; exit $code");
  EXPECT_GT(run.code, 0);
  EXPECT_LT(run.code, 128);
  EXPECT_EQ(lines_in(run.err), 1u) << run.err;
  EXPECT_NE(run.err.find("room.fbx: Assimp cannot read this file: "), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("for example with Blender"), std::string::npos) << run.err;
  EXPECT_EQ(run.out.find("a.glb"), std::string::npos) << run.out;
}

TEST(Converted, a_crash_and_a_missing_converter_are_one_sentence) {
  const auto folder = folder_of("missing");
  copy_program(folder);
  const auto missing = cli::run(folder, "bin/luxel bake room.fbx -o a.glb");
  EXPECT_GT(missing.code, 0);
  EXPECT_EQ(lines_in(missing.err), 1u) << missing.err;
  EXPECT_NE(
      missing.err.find("room.fbx: this format is read by the program luxel-import, which is not installed"),
      std::string::npos)
      << missing.err;
  write_file(folder / "bin" / "luxel-import",
             "#!/bin/sh\necho 'free(): invalid pointer' >&2\nkill -SEGV $$\n");
  const auto crash = cli::run(folder, "chmod +x bin/luxel-import; bin/luxel bake room.fbx -o a.glb");
  EXPECT_GT(crash.code, 0);
  EXPECT_LT(crash.code, 128);
  EXPECT_EQ(lines_in(crash.err), 1u) << crash.err;
  EXPECT_NE(crash.err.find("room.fbx: the converter luxel-import crashed on this file (signal 11"),
            std::string::npos)
      << crash.err;
}

TEST(Converted, an_installed_converter_is_found) {
  const auto folder = folder_of("installed");
  copy_program(folder);
  std::filesystem::create_directories(folder / "libexec" / "luxel");
  std::filesystem::copy_file(std::filesystem::path(LUXEL_PROGRAM).parent_path() / "luxel-import",
                             folder / "libexec" / "luxel" / "luxel-import");
  const auto run = cli::run(folder, "bin/luxel info room.dae");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("12 triangles"), std::string::npos) << run.out;
}

TEST(Converted, an_interrupt_ends_the_converter_too) {
  const auto folder = folder_of("interrupt");
  copy_program(folder);
  write_file(folder / "bin" / "luxel-import", "#!/bin/sh\necho $$ > pid.txt\nexec sleep 600\n");
  for (const std::string signal : {"INT", "KILL"}) {
    const auto run = cli::run(
        folder,
        "chmod +x bin/luxel-import; rm -f pid.txt; bin/luxel bake room.fbx -o a.glb & pid=$!; for i in "
        "$(seq 600); do test -s pid.txt && break; sleep 0.05; done; kill -" +
            signal +
            " $pid; wait $pid; for i in $(seq 100); do kill -0 $(cat pid.txt) 2>/dev/null || break; sleep "
            "0.05; done; kill -0 $(cat pid.txt) 2>/dev/null && echo alive; ls");
    EXPECT_EQ(run.out.find("alive"), std::string::npos) << signal;
    EXPECT_NE(run.out.find("pid.txt"), std::string::npos) << signal;
    EXPECT_EQ(run.out.find("a.glb"), std::string::npos) << signal;
  }
}

}  // namespace
}  // namespace luxel::cli
