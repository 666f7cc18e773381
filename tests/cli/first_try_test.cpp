// SPDX-License-Identifier: Apache-2.0
// Arbitrary scenes without any option.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "cli/run_program.h"

namespace luxel::cli {
namespace {

TEST(FirstTry, writes_a_mesh_beside_the_scene_if_no_output_is_named) {
  const auto folder = fresh_folder("default_output");
  std::filesystem::create_directories(folder / "scenes");
  write_file(folder / "scenes/plate.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 3 2\n");
  const auto run = cli::run(folder, "$LUXEL bake scenes/plate.obj --error 10%");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, "scenes/plate-lit.glb\n");
  EXPECT_TRUE(std::filesystem::exists(folder / "scenes/plate-lit.glb"));
}

TEST(FirstTry, lists_its_stages_if_verbose_and_prints_the_camera_that_it_chose) {
  const auto folder = fresh_folder("verbose");
  write_file(folder / "plate.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 3 2\n");
  const std::string bake = "$LUXEL bake plate.obj --error 10% -o a.png --width 32 --height 24 ";
  const auto plain = cli::run(folder, bake);
  EXPECT_EQ(plain.err.find("ns per ray"), std::string::npos) << plain.err;
  EXPECT_NE(plain.err.find("camera    --eye "), std::string::npos) << plain.err;
  const auto given = cli::run(folder, bake + "--verbose --eye 0.3,2,0.3 --target 0.3,0,0.3");
  EXPECT_NE(given.err.find("ns per ray"), std::string::npos) << given.err;
  EXPECT_EQ(given.err.find("camera    --eye"), std::string::npos) << given.err;
}

TEST(FirstTry, lights_a_scene_without_a_lamp_and_finds_the_same_light_again) {
  const auto folder = fresh_folder("no_lamp");
  write_file(folder / "plate.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 3 2\n");
  auto run = cli::run(folder, "$LUXEL bake plate.obj --error 5% --max-edge 0.5 -o a.vtkhdf");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find("light     no lamp in the scene: lit by daylight, a uniform sky of 10000 lx"),
            std::string::npos)
      << run.err;
  EXPECT_NE(run.err.find("--sky"), std::string::npos) << run.err;
  EXPECT_NE(cli::run(folder, "$LUXEL bake plate.obj --print-config").out.find("\nsky = \"auto\""),
            std::string::npos);
  EXPECT_NE(cli::run(folder, "$LUXEL bake plate.obj --print-config --sky 0").out.find("\nsky = \"none\""),
            std::string::npos);
  EXPECT_NE(
      cli::run(folder, "$LUXEL bake plate.obj --print-config --sky 1,2,3").out.find("\nsky = \"1,2,3\""),
      std::string::npos);
  // A closed room, whose luminaire is not in the file.
  write_file(folder / "room.obj",
             "v 0 0 0\nv 4 0 0\nv 4 0 5\nv 0 0 5\nv 0 3 0\nv 4 3 0\nv 4 3 5\nv 0 3 5\nf 4 3 2 1\nf 5 6 7 8\n"
             "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  run = cli::run(folder, "$LUXEL bake room.obj --error 10% --max-edge 1 -o room.vtkhdf");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find("lit by a square luminaire below the ceiling"), std::string::npos) << run.err;
  run = cli::run(folder, "$LUXEL export room.vtkhdf --scene room.obj -o room.glb --as vertex");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(std::filesystem::exists(folder / "room.glb"));
}

}  // namespace
}  // namespace luxel::cli
