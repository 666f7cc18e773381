// SPDX-License-Identifier: Apache-2.0
// Files named by a scene are read from its own folder only, unless the user allows more.
#include "luxel/import/scene_folder.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "luxel/image/image_file.h"

#include "support/scene_files.h"
#include "support/small_gltf.h"

namespace luxel {
namespace {
namespace fs = std::filesystem;

const LoadOptions allowed = {.allow_outside = true};

SmallGltf one_triangle() {
  SmallGltf gltf;
  gltf.meshes = "{\"primitives\":[{\"attributes\":{\"POSITION\":" +
                std::to_string(gltf.points({0, 0, 0, 1, 0, 0, 0, 1, 0})) + "}}]}";
  return gltf;
}

void write_white(const fs::path& path) {
  Image image(1, 1);
  image.at(0, 0) = Vec3(1.0f);
  write_png(path, image);
}

TEST(SceneFolder, permits_what_lies_in_it_or_below_wherever_links_lead) {
  SceneFiles files;
  files.write("room/here.txt", "x");
  files.write("room/below/there.txt", "x");
  files.write("room-2/beside.txt", "x");
  fs::create_symlink("here.txt", files.path("room/link-inside.txt"));
  fs::create_symlink("../room-2/beside.txt", files.path("room/link-outside.txt"));
  fs::create_symlink("../room-2", files.path("room/folder"));
  const SceneFolder folder(files.path("room/scene.obj"));
  for (const char* name : {"here.txt", "below/there.txt", "below/../here.txt", "link-inside.txt"})
    EXPECT_TRUE(folder.permits(files.path("room") / name)) << name;
  for (const char* name : {"../room-2/beside.txt", "link-outside.txt", "folder/beside.txt", "missing.txt"})
    EXPECT_FALSE(folder.permits(files.path("room") / name)) << name;
  EXPECT_TRUE(SceneFolder(files.path("room/scene.obj"), true).permits(files.path("room-2/beside.txt")));
}

TEST(SceneFolder, of_gltf_holds_all_buffers_that_are_read) {
  SceneFiles files;
  const auto gltf = one_triangle();
  files.write("secret.bin", gltf.buffer);
  fs::create_directories(files.path("room"));
  fs::create_symlink("../secret.bin", files.path("room/link.bin"));
  for (const auto& uri : {std::string("../secret.bin"), std::string("%2e%2e/secret.bin"),
                          std::string("link.bin"), files.path("secret.bin").string()}) {
    files.write("room/room.gltf", gltf.json(",\"uri\":\"" + uri + "\""));
    const auto refusal = files.refusal("room/room.gltf");
    EXPECT_NE(refusal.find("lies outside the scene's folder; copy it there, or allow files outside"),
              std::string::npos)
        << uri << ": " << refusal;
    const auto scene = files.load("room/room.gltf", allowed);
    EXPECT_EQ(scene.triangles.size(), 1u) << uri;
    ASSERT_EQ(scene.files.size(), 1u);
    EXPECT_TRUE(fs::equivalent(scene.files[0], files.path("secret.bin")));
  }
}

TEST(SceneFolder, of_gltf_leaves_textures_outside_unread_with_one_warning) {
  SceneFiles files;
  auto gltf = one_triangle();
  gltf.meshes.insert(gltf.meshes.find("}}]}") + 1, ",\"material\":0");
  gltf.rest =
      R"(,"materials":[{"pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":{"index":0}}}],)"
      R"("textures":[{"source":0}],"images":[{"uri":"../white.png"}])";
  fs::create_directories(files.path("room"));
  write_white(files.path("white.png"));
  files.write("room/room.gltf", gltf.text());
  EXPECT_NEAR(files.load("room/room.gltf").materials[0].reflectance.r, 0.5f, 1e-6f);
  ASSERT_EQ(files.warnings().size(), 2u) << "of missing texture coordinates, and: " << files.all_warnings();
  EXPECT_NE(files.all_warnings().find("1 picture cannot be read"), std::string::npos) << files.all_warnings();
  EXPECT_NE(files.all_warnings().find("lies outside the scene's folder"), std::string::npos)
      << files.all_warnings();
  EXPECT_NEAR(files.load("room/room.gltf", allowed).materials[0].reflectance.r, 0.98f, 1e-6f);
}

TEST(SceneFolder, of_OBJ_holds_its_MTL_files_and_textures) {
  SceneFiles files;
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl m\nf 1/1 2/2 3/3\n";
  files.write("outside.mtl", "newmtl m\nKd 0.2 0.2 0.2\n");
  files.write("room/room.obj", "mtllib ../outside.mtl\n" + triangle);
  EXPECT_EQ(files.refusal("room/room.obj"),
            "room/room.obj:1: the material file '../outside.mtl' lies outside the scene's folder; copy it "
            "there, or allow files outside");
  EXPECT_NEAR(files.load("room/room.obj", allowed).materials[0].reflectance.r, 0.2f, 1e-6f);

  write_white(files.path("white.png"));
  files.write("room/room.mtl", "newmtl m\nmap_Kd " + files.path("white.png").string() + "\n");
  files.write("room/room.obj", "mtllib room.mtl\n" + triangle);
  EXPECT_NEAR(files.load("room/room.obj").materials[0].reflectance.r, 0.5f, 1e-6f);
  ASSERT_EQ(files.warnings().size(), 1u) << files.all_warnings();
  EXPECT_NE(files.all_warnings().find("1 texture outside the scene's folder not read"), std::string::npos)
      << files.all_warnings();
  EXPECT_NEAR(files.load("room/room.obj", allowed).materials[0].reflectance.r, 0.98f, 1e-6f);

  // A full path of another machine stands for the file of that name in the folder.
  write_white(files.path("room/white.png"));
  const auto scene = files.load("room/room.obj");
  EXPECT_NEAR(scene.materials[0].reflectance.r, 0.98f, 1e-6f);
  EXPECT_EQ(scene.files.size(), 2u) << "its MTL file and its texture";
}

}  // namespace
}  // namespace luxel
