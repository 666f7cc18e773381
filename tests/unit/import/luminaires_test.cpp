// SPDX-License-Identifier: Apache-2.0
// How luminaires come into a scene: by glTF, by materials of an OBJ file, by lists and grids.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/scene/luminous_efficacy.h"
#include "luxel/scene/scene.h"

#include "support/photometric_files.h"
#include "support/scene_files.h"
#include "support/small_gltf.h"

namespace luxel {
namespace {

const std::string quarter_turn = R"("rotation":[-0.70710678,0,0,0.70710678])";  // -Z becomes -Y

// A triangle on the ground, and the given nodes, in a folder with lamp.ies, 0.4 m x 1.2 m, 1000 cd straight
// down.
class GltfLuminaires : public testing::Test {
 protected:
  GltfLuminaires() { files_.write("lamp.ies", lamp_.text()); }

  std::string gltf(const std::string& nodes, const std::string& profiles = R"({"uri":"lamp.ies"})") {
    SmallGltf file;
    const auto place = file.array<float>(SmallGltf::f32, "VEC3", 3, {0, 0, 0, 1, 0, 0, 0, 0, -1});
    file.view(lamp_.text());  // 1
    file.meshes = fmt::format(R"({{"primitives":[{{"attributes":{{"POSITION":{}}}}}]}})", place);
    file.nodes += "," + nodes;
    file.rest =
        R"(,"extensionsUsed":["EXT_lights_ies","KHR_lights_punctual"],"extensions":{"EXT_lights_ies":{"lights":[)" +
        profiles + R"(]},"KHR_lights_punctual":{"lights":[{"type":"point"}]}})";
    return file.text();
  }
  std::vector<PointLight> lights(const std::string& nodes,
                                 const std::string& profiles = R"({"uri":"lamp.ies"})",
                                 const LoadOptions& options = {}) {
    files_.write("room.gltf", gltf(nodes, profiles));
    return files_.load("room.gltf", options).point_lights;
  }
  std::string refusal(const std::string& nodes) {
    files_.write("room.gltf", gltf(nodes));
    return files_.refusal("room.gltf");
  }

  MadeIes lamp_{.size = "0.4 1.2 0"};
  SceneFiles files_;
};

void expect_near(const Vec3& a, const Vec3& b, float tolerance = 1e-6f) {
  EXPECT_LE(glm::distance(a, b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST_F(GltfLuminaires, of_the_extension_have_the_axes_of_their_node_its_multiplier_and_its_colour) {
  const auto node = R"({"name":"down","translation":[1,2,3],)" + quarter_turn +
                    R"(,"extensions":{"EXT_lights_ies":{"light":0,"multiplier":2,"color":[1,0.5,0.25]}}})";
  for (const std::string profile : {R"({"uri":"lamp.ies"})", R"({"bufferView":1})"}) {
    const auto all = lights(node, profile);
    ASSERT_EQ(all.size(), 1u) << profile;
    const auto& light = all[0];
    EXPECT_EQ(light.kind, PointLightKind::luminaire);
    EXPECT_EQ(light.name, "down");
    expect_near(light.position, {1, 2, 3});
    expect_near(light.direction, {0, -1, 0});
    expect_near(light.local_x, {1, 0, 0});
    expect_near(light.local_y, {0, 0, -1});
    expect_near(light.intensity * static_cast<float>(luminous_efficacy), {2000, 1000, 500}, 0.1f);
    EXPECT_DOUBLE_EQ(light.photometry->opening.size.x, 1.2);
  }
}

TEST_F(GltfLuminaires, share_a_profile_that_is_read_once) {
  const std::string use = R"("extensions":{"EXT_lights_ies":{"light":0}}})";
  const auto all = lights(R"({"translation":[0,2,0],)" + use + R"(,{"translation":[1,2,0],)" + use);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].photometry, all[1].photometry);
  EXPECT_EQ(all[0].name, "node 1");
}

TEST_F(GltfLuminaires, of_extras_are_those_of_a_list) {
  const auto of_extras =
      lights(R"({"translation":[1,2,3],"extras":{"luminaire":"lamp.ies","luminaire_dimming":0.5,)"
             R"("luminaire_maintenance":0.8,"luminaire_group":"row","luminaire_turn":30}})");
  files_.write("list.csv", "file,x,y,z,dimming,maintenance,group,turn\nlamp.ies,1,2,3,0.5,0.8,row,30\n");
  const auto of_list = lights("{}", R"({"uri":"lamp.ies"})", {.luminaires = {files_.path("list.csv")}});
  ASSERT_EQ(of_extras.size(), 1u);
  ASSERT_EQ(of_list.size(), 1u);
  const auto &a = of_extras[0], &b = of_list[0];
  EXPECT_EQ(a.name, b.name);
  expect_near(a.position, b.position);
  expect_near(a.direction, b.direction);
  expect_near(a.local_x, b.local_x);
  expect_near(a.local_y, b.local_y);
  expect_near(a.intensity, b.intensity);
  EXPECT_EQ(a.dimming, b.dimming);
  EXPECT_EQ(a.maintenance, b.maintenance);
  for (const Vec3d d : {Vec3d(0.3, 0.1, -1.0), Vec3d(-0.5, 0.7, -0.2)})
    EXPECT_EQ(a.photometry->intensity.at(d), b.photometry->intensity.at(d));
}

TEST_F(GltfLuminaires, of_extras_replace_a_punctual_light_and_aim_as_it_does) {
  const auto all = lights(R"({"translation":[0,2,0],"extras":{"luminaire":"lamp.ies"},)"
                          R"("extensions":{"KHR_lights_punctual":{"light":0}}})");
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].kind, PointLightKind::luminaire);
  EXPECT_EQ(all[0].name, "lamp");
  expect_near(all[0].direction, {0, 0, -1});
}

TEST_F(GltfLuminaires, of_a_mirrored_node_are_not_mirrored) {
  const auto all = lights(R"({"scale":[-1,1,1],"extensions":{"EXT_lights_ies":{"light":0}}})");
  ASSERT_EQ(all.size(), 1u);
  expect_near(glm::cross(all[0].local_x, all[0].local_y), -all[0].direction);
}

TEST_F(GltfLuminaires, extras_of_other_programs_are_ignored) {
  EXPECT_TRUE(
      lights(R"({"extras":{"luminaire":7}},{"extras":["luminaire"]},{"extras":"luminaire"})").empty());
}

TEST_F(GltfLuminaires, that_make_no_sense_are_refused_with_their_place) {
  const auto of_extension = [](const std::string& use) {
    return R"({"extensions":{"EXT_lights_ies":)" + use + "}}";
  };
  EXPECT_NE(refusal(of_extension(R"({"light":3})")).find("it names light profile 3, but the file has 1"),
            std::string::npos);
  EXPECT_NE(refusal(of_extension(R"({"light":0,"multiplier":-1})"))
                .find("expected a number from 0 to 1e+06, found -1"),
            std::string::npos);
  EXPECT_NE(refusal(of_extension(R"({"light":0,"color":[1,-1,1]})")).find("expected numbers of 0 or more"),
            std::string::npos);
  EXPECT_NE(refusal(R"({"scale":[0,1,1],"extensions":{"EXT_lights_ies":{"light":0}}})")
                .find("whose scale is not 0"),
            std::string::npos);
  EXPECT_NE(refusal(R"({"extras":{"luminaire":"lamp.ies","luminaire_maintenance":1.5}})")
                .find("expected a number from 0.001 to 1"),
            std::string::npos);
  EXPECT_NE(refusal(R"({"extras":{"luminaire":"none.ies"}})").find("none.ies"), std::string::npos);
  files_.write("broken.ies", "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 0\n");
  EXPECT_NE(refusal(R"({"extras":{"luminaire":"broken.ies"}})")
                .find("room.gltf: /nodes/1/extras/luminaire: broken.ies:3: expected"),
            std::string::npos);
  files_.write("profile.gltf", gltf(of_extension(R"({"light":0})"), R"({"uri":"broken.ies"})"));
  EXPECT_NE(files_.refusal("profile.gltf")
                .find("profile.gltf: /extensions/EXT_lights_ies/lights/0: broken.ies:3: expected"),
            std::string::npos);
  files_.write("sub/room.gltf", gltf(R"({"extras":{"luminaire":"../lamp.ies"}})", ""));
  EXPECT_NE(files_.refusal("sub/room.gltf").find("lies outside the scene's folder"), std::string::npos);
}

// Two panels below a ceiling at z = 2.8, longer along y, each of one quad; both face down.
TEST(ObjLuminaires, stand_where_their_material_has_a_connected_component) {
  SceneFiles files;
  files.write("lamp.ies", MadeIes{.size = "0.4 1.2 0"}.text());
  files.write("room.mtl", "newmtl lamp.ies\nKd 0.5 0.5 0.5\nnewmtl floor\nKd 0.5 0.5 0.5\n");
  std::string obj =
      "mtllib room.mtl\nv 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nusemtl floor\nf 1 2 3 4\nusemtl lamp.ies\n";
  for (const double x : {1.0, 3.0}) {
    obj += fmt::format("v {} 1.4 2.8\nv {} 2.6 2.8\nv {} 2.6 2.8\nv {} 1.4 2.8\n", x - 0.2, x - 0.2, x + 0.2,
                       x + 0.2);
    obj += "f -4 -3 -2 -1\n";
  }
  files.write("room.obj", obj);
  const auto scene = files.load("room.obj", {.up = {0, 0, 1}});
  ASSERT_EQ(scene.point_lights.size(), 2u) << files.all_warnings();
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& light = scene.point_lights[i];
    EXPECT_EQ(light.name, "lamp.ies");
    expect_near(Vec3(Vec3d(light.position) + scene.origin), {i == 0 ? 1.0f : 3.0f, 2.0f, 2.8f});
    expect_near(light.direction, {0, 0, -1});
    EXPECT_NEAR(std::abs(light.local_x.y), 1.0f, 1e-5f)
        << "the length of the opening lies along that of the panel";
  }
  for (const auto& material : scene.materials)
    EXPECT_EQ(material.opaque, material.name == "floor") << "light passes through the panels";
}

TEST(ListedLuminaires, refuse_what_is_no_list_with_its_line) {
  SceneFiles files;
  files.write("lamp.ies", MadeIes().text());
  files.write("room.obj", "v 0 0 0\nv 4 0 0\nv 4 4 0\nf 1 2 3\n");
  const auto refusal = [&](const std::string& list) {
    files.write("list.csv", list);
    return files.refusal("room.obj", {.luminaires = {files.path("list.csv")}, .up = {0, 0, 1}});
  };
  const std::string head = "file,x,y,z,aim_x,aim_y,aim_z,dir_x,dir_y,dir_z,columns,step_x\nlamp.ies,1,1,2,";
  EXPECT_NE(refusal(head + "1,1,0,0,0,-1,1,0\n").find("list.csv:2: expected a point to aim at"),
            std::string::npos);
  EXPECT_NE(refusal(head + "1,1,2,,,,1,0\n").find("found its own position"), std::string::npos);
  EXPECT_NE(refusal(head + ",,,0,0,0,1,0\n").find("a direction other than 0, 0, 0"), std::string::npos);
  EXPECT_NE(refusal(head + ",,,,,,2,\n").find("expected a distance in step_x"), std::string::npos);
  EXPECT_NE(refusal(head + ",,,,,,1.5,1\n").find("expected a whole number for columns"), std::string::npos);
}

// The file of a lamp may lie anywhere, so its name alone does not say who asked for it.
TEST(ListedLuminaires, name_their_line_where_a_lamp_cannot_be_read) {
  SceneFiles files;
  files.write("room.obj", "v 0 0 0\nv 4 0 0\nv 4 4 0\nf 1 2 3\n");
  files.write("list.csv", "file,x,y,z\n/nowhere/lamp.ies,1,1,1\n");
  const auto said = files.refusal("room.obj", {.luminaires = {files.path("list.csv")}, .up = {0, 0, 1}});
  EXPECT_NE(said.find("list.csv:2: /nowhere/lamp.ies"), std::string::npos) << said;
}

TEST(ListedLuminaires, too_far_away_are_refused) {
  SceneFiles files;
  files.write("lamp.ies", MadeIes().text());
  files.write("room.obj", "v 0 0 0\nv 4 0 0\nv 4 4 0\nf 1 2 3\n");
  files.write("list.csv", "file,x,y,z\nlamp.ies,1e30,0,0\n");
  EXPECT_NE(
      files.refusal("room.obj", {.luminaires = {files.path("list.csv")}, .up = {0, 0, 1}}).find("beyond"),
      std::string::npos);
}

}  // namespace
}  // namespace luxel
