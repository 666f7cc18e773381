// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "luxel/core/triangle.h"

#include "support/scene_files.h"

namespace luxel {
namespace {

constexpr const char* two_triangles = R"(
v 0 0 0
v 1 0 0
v 0 1 0
usemtl wall left
f 1 2 3
usemtl wall right
f 1 2 3
)";

TEST(LoadScene, a_missing_file_is_named) {
  SceneFiles files;
  EXPECT_EQ(files.refusal("nothing.obj"), "nothing.obj: no such file");
}

TEST(LoadScene, a_folder_is_no_scene) {
  SceneFiles files;
  std::filesystem::create_directory(files.path("room.obj"));
  EXPECT_EQ(files.refusal("room.obj"),
            "room.obj: it is a folder; name the scene's file inside it (.obj, .glb, .gltf, .ply, .stl, .fbx, "
            ".dae or .3ds)");
}

TEST(LoadScene, other_endings_are_told_what_to_become) {
  SceneFiles files;
  for (const std::string name : {"room.max", "room.GLT", "room.step", "room"}) {
    files.write(name, "solid");
    const auto refusal = files.refusal(name);
    EXPECT_NE(refusal.find(
                  name +
                  ": expected a file that ends in .obj, .glb, .gltf, .ply, .stl, .fbx, .dae or .3ds, found "),
              std::string::npos)
        << refusal;
    EXPECT_NE(refusal.find("convert"), std::string::npos) << refusal;
  }
}

TEST(LoadScene, an_ending_in_capitals_is_fine) {
  SceneFiles files;
  files.write("ROOM.OBJ", two_triangles);
  EXPECT_EQ(files.load("ROOM.OBJ").triangles.size(), 2u);
}

TEST(LoadScene, the_scene_knows_the_file_as_it_was_named) {
  SceneFiles files;
  EXPECT_EQ(files.load_text(two_triangles).source, files.path("room.obj").string());
}

TEST(LoadScene, a_size_that_no_room_has_is_doubted_in_one_warning_with_the_scale_that_mends_it) {
  SceneFiles files;
  std::vector<Message> messages;
  const auto log = Context().with_log([&](const Message& message) { messages.push_back(message); });
  std::string obj;
  for (const int z : {0, 400})
    for (const int y : {0, 250})
      for (const int x : {0, 300}) obj += fmt::format("v {} {} {}\n", x, y, z);
  files.write("room.mtl", "newmtl wall\nKd 0.5 0.5 0.5\n");
  obj += "mtllib room.mtl\nusemtl wall\nf 1 2 4 3\nf 5 6 8 7\nf 1 2 6 5\nf 3 4 8 7\nf 1 3 7 5\nf 2 4 8 6\n";
  files.write("room.obj", obj);
  load_scene(files.path("room.obj"), {}, log);
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages[0].severity, Severity::warning);
  EXPECT_EQ(messages[0].text, files.path("room.obj").string() +
                                  ": the scene is 400 m long, too large for a room; if the file counts "
                                  "in centimetres, a scale of 0.01 makes it 4 m long");
  EXPECT_EQ(messages[0].hints, (std::vector<Hint>{{Setting::scale, "0.01"}}));
  messages.clear();
  load_scene(files.path("room.obj"), {.scale = 0.01}, log);
  EXPECT_TRUE(messages.empty());
}

TEST(LoadScene, scale_is_metres_per_unit) {
  SceneFiles files;
  const auto scene = files.load_text(two_triangles, {.scale = 0.5f});
  EXPECT_EQ(scene.positions[1], Vec3(0.5f, 0, 0));
}

TEST(LoadScene, a_scale_that_makes_no_size_is_refused) {
  SceneFiles files;
  for (const float scale : {0.0f, -1.0f, std::numeric_limits<float>::infinity()})
    EXPECT_NE(files.refusal_of_text(two_triangles, {.scale = scale}).find("expected a scale above 0"),
              std::string::npos);
}

TEST(LoadScene, a_coordinate_too_far_for_floats_names_its_line) {
  SceneFiles files;
  EXPECT_EQ(files.refusal_of_text("v 1e37 0 0\n", {.scale = 1000.0f}),
            "room.obj:1: expected coordinates up to 1e+12 m, found '1e37 0 0' at 1000 m a unit");
}

TEST(LoadScene, a_reflectance_limit_of_one_is_refused) {
  SceneFiles files;
  EXPECT_NE(files.refusal_of_text(two_triangles, {.max_reflectance = 1.0f}).find("max_reflectance"),
            std::string::npos);
}

TEST(LoadScene, materials_are_two_sided_but_those_asked_for) {
  SceneFiles files;
  const auto scene = files.load_text(two_triangles, {.one_sided = {"*right"}});
  EXPECT_TRUE(scene.materials[0].two_sided);
  EXPECT_FALSE(scene.materials[1].two_sided);
}

TEST(LoadScene, flip_turns_the_triangles_of_its_materials) {
  SceneFiles files;
  const auto scene = files.load_text(two_triangles, {.flip = {"wall l?ft"}});
  EXPECT_EQ(scene.triangles[0], (std::array<std::uint32_t, 3>{0, 2, 1}));
  EXPECT_EQ(scene.triangles[1], (std::array<std::uint32_t, 3>{0, 1, 2}));
}

TEST(LoadScene, a_material_named_by_two_patterns_is_flipped_once) {
  SceneFiles files;
  const auto scene = files.load_text(two_triangles, {.flip = {"wall left", "wall*"}});
  EXPECT_EQ(scene.triangles[0], (std::array<std::uint32_t, 3>{0, 2, 1}));
}

TEST(LoadScene, glass_makes_panes_and_the_last_option_counts) {
  SceneFiles files;
  const auto scene =
      files.load_text(two_triangles, {.glass = {{"wall*", Vec3(0.8f)}, {"*right", Vec3(0.5f, 0.6f, 0.7f)}}});
  EXPECT_FALSE(scene.materials[0].opaque);
  EXPECT_EQ(scene.materials[0].transmittance, Vec3(0.8f));
  EXPECT_EQ(scene.materials[1].transmittance, Vec3(0.5f, 0.6f, 0.7f));
  const auto all = files.load_text(two_triangles, {.glass = {{"*right", Vec3(0.8f)}, {"", Vec3(0.7f)}}});
  EXPECT_TRUE(all.materials[0].opaque);
  EXPECT_EQ(all.materials[1].transmittance, Vec3(0.7f));
}

TEST(LoadScene, glass_makes_diffusers_with_two_sides_that_give_no_light_away) {
  SceneFiles files;
  const auto scene = files.load_text(
      two_triangles,
      {.one_sided = {"*right"}, .glass = {{"*right", Vec3(0.8f)}, {"*right", Vec3(0.2f, 0.6f, 0.9f), true}}});
  const auto& blind = scene.materials[1];
  EXPECT_TRUE(blind.opaque);
  EXPECT_TRUE(blind.two_sided);
  EXPECT_EQ(blind.diffuse_transmittance, Vec3(0.2f, 0.6f, 0.9f));
  EXPECT_EQ(blind.transmittance, Vec3(1.0f));
  EXPECT_EQ(blind.reflectance, Vec3(0.5f, 0.98f - 0.6f, 0.98f - 0.9f));  // 0.5 in the file
  EXPECT_NE(files.all_warnings().find("reflectance of 'wall right' was lowered"), std::string::npos);
  EXPECT_FALSE(scene.materials[0].is_diffuser());
  const auto pane =
      files.load_text(two_triangles, {.glass = {{"*right", Vec3(0.4f), true}, {"*right", Vec3(0.8f)}}});
  EXPECT_FALSE(pane.materials[1].is_diffuser());
  EXPECT_FALSE(pane.materials[1].opaque);
}

TEST(LoadScene, glass_that_cannot_be_is_refused) {
  SceneFiles files;
  EXPECT_EQ(files.refusal_of_text(two_triangles, {.glass = {{"window", Vec3(0.8f)}}}),
            "room.obj: glass: no material matches 'window'; there are 'wall left', 'wall right'");
  EXPECT_EQ(files.refusal_of_text(two_triangles, {.glass = {{"", Vec3(0.8f)}}}),
            "room.obj: glass: no material lets light pass, so there are no panes; name the material that is "
            "glass; there are 'wall left', 'wall right'");
  for (const auto& wrong : {Vec3(0.0f), Vec3(1.5f), Vec3(0.5f, -0.1f, 0.5f)})
    EXPECT_NE(files.refusal_of_text(two_triangles, {.glass = {{"wall*", wrong}}}).find("transmittance"),
              std::string::npos);
  files.write("room.mtl", "newmtl lamp\nKe 1 1 1\n");
  EXPECT_EQ(files.refusal_of_text("mtllib room.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl lamp\nf 1 2 3\n",
                                  {.glass = {{"lamp", Vec3(0.8f)}}}),
            "room.obj: glass: the material 'lamp' emits light, so it is no pane");
}

TEST(LoadScene, a_pattern_that_matches_nothing_names_the_materials) {
  SceneFiles files;
  EXPECT_EQ(files.refusal_of_text(two_triangles, {.one_sided = {"wal"}}),
            "room.obj: one_sided: no material matches 'wal'; there are 'wall left', 'wall right'");
  EXPECT_NE(files.refusal_of_text(two_triangles, {.flip = {"wal"}}).find("flip: no material"),
            std::string::npos);
}

}  // namespace
}  // namespace luxel
