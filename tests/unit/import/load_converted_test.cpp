// SPDX-License-Identifier: Apache-2.0
// FBX, COLLADA and 3DS files through the program luxel-import.
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "luxel/core/bounds.h"
#include "luxel/scene/scene.h"

#include "support/converted_files.h"
#include "support/scene_files.h"
#include "support/small_picture.h"

namespace luxel {
namespace {

constexpr float pi = 3.14159265f;

class LoadConverted : public testing::Test {
 protected:
  Scene load(const std::string& name, const std::string& bytes, const LoadOptions& options = {}) {
    files_.write(name, bytes);
    auto scene = files_.load(name, options);
    check_scene(scene);
    return scene;
  }
  SceneFiles files_;
};

const Material& material_of(const Scene& scene, const std::string& name) {
  for (const auto& material : scene.materials)
    if (material.name == name) return material;
  ADD_FAILURE() << "there is no material " << name;
  return scene.materials.front();
}

// Place of a corner of the first triangle on the picture.
Vec2 placed(const Scene& scene, std::size_t corner) {
  const auto& use = material_of(scene, "wall").textures.reflectance;
  return use ? use->place(scene.uv_sets.at(use->uv_set)[0][corner]) : Vec2(-1.0f);
}

void expect_near(const Vec3& found, const Vec3& expected, float tolerance = 1e-5f) {
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(found[i], expected[i], tolerance * std::max(1.0f, std::abs(expected[i])))
        << "component " << i;
}

// The cube with its materials in a box of these bounds, whose face of the lamp looks along this axis.
void expect_cube(const Scene& scene, const Vec3& low, const Vec3& high, const Vec3& lamp_normal) {
  ASSERT_EQ(scene.triangles.size(), 12u);
  const auto box = bounds(scene);
  expect_near(box.low, low);
  expect_near(box.high, high);
  std::size_t lamp_triangles = 0;
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    const auto [a, b, c] = scene.triangles[i];
    const auto normal = glm::normalize(
        glm::cross(scene.positions[b] - scene.positions[a], scene.positions[c] - scene.positions[a]));
    const auto middle = (scene.positions[a] + scene.positions[b] + scene.positions[c]) / 3.0f;
    EXPECT_GT(glm::dot(normal, middle - 0.5f * (low + high)), 0.0f) << "fronts look outwards";
    if (scene.materials[static_cast<std::size_t>(scene.triangle_material[i])].name != "lamp") continue;
    expect_near(normal, lamp_normal);
    ++lamp_triangles;
  }
  EXPECT_EQ(lamp_triangles, 2u);
}

void expect_materials(const Scene& scene, const ConvertedCube& cube) {
  ASSERT_EQ(scene.materials.size(), 2u);
  const auto& wall = material_of(scene, "wall");
  expect_near(wall.reflectance, cube.wall);
  EXPECT_EQ(wall.emittance, Vec3(0.0f));
  EXPECT_TRUE(wall.two_sided);
  const auto& lamp = material_of(scene, "lamp");
  EXPECT_TRUE(lamp.is_lamp());
  expect_near(lamp.emittance, pi * cube.emission);
}

TEST_F(LoadConverted, collada_has_the_unit_the_axis_and_the_materials_of_the_file) {
  SmallDae dae;
  const auto scene = load("room.dae", dae.text());
  expect_cube(scene, dae.cube.place, dae.cube.place + Vec3(2.0f), Vec3(1, 0, 0));
  expect_materials(scene, dae.cube);
  EXPECT_EQ(scene.up, Vec3(0, 1, 0));
  EXPECT_EQ(scene.source, files_.path("room.dae").string());
  EXPECT_EQ(scene.objects, std::vector<std::string>{"box 0"});
  EXPECT_EQ(files_.all_warnings(), "");

  dae.asset = "<unit name=\"centimeter\" meter=\"0.01\"/><up_axis>Z_UP</up_axis>";
  const auto upright = load("upright.dae", dae.text());
  expect_cube(upright, Vec3(0.03f, 0.07f, -0.07f), Vec3(0.05f, 0.09f, -0.05f), Vec3(1, 0, 0));
  EXPECT_EQ(upright.up, Vec3(0, 1, 0));
}

TEST_F(LoadConverted, collada_places_a_geometry_at_each_node_that_names_it) {
  SmallDae dae;
  dae.instances = 3;
  const auto scene = load("room.dae", dae.text());
  EXPECT_EQ(scene.triangles.size(), 36u);
  EXPECT_EQ(scene.objects, (std::vector<std::string>{"box 0", "box 1", "box 2"}));
  EXPECT_EQ(scene.materials.size(), 2u);
  expect_near(bounds(scene).high, dae.cube.place + Vec3(202, 2, 2));
}

TEST_F(LoadConverted, fbx_has_the_unit_the_axes_and_the_materials_of_the_file) {
  SmallFbx fbx;
  const auto scene = load("room.fbx", fbx.text());
  expect_cube(scene, fbx.cube.place, fbx.cube.place + Vec3(2.0f), Vec3(1, 0, 0));
  expect_materials(scene, fbx.cube);
  EXPECT_EQ(scene.up, Vec3(0, 1, 0));
  EXPECT_EQ(scene.objects, std::vector<std::string>{"box"});
  EXPECT_EQ(files_.all_warnings(), "");

  fbx.settings = SmallFbx::unit(1.0) + SmallFbx::z_up();
  expect_cube(load("upright.fbx", fbx.text()), Vec3(0.03f, 0.07f, -0.07f), Vec3(0.05f, 0.09f, -0.05f),
              Vec3(1, 0, 0));

  // Up is -Z, and right is +Y: front is right × up, -X.
  fbx.settings = SmallFbx::unit(100.0) + SmallFbx::axis("Up", 2, -1) + SmallFbx::axis("Coord", 1, 1);
  expect_cube(load("turned.fbx", fbx.text()), Vec3(5, -9, -5), Vec3(7, -7, -3), Vec3(0, 0, -1));
}

TEST_F(LoadConverted, a_file_in_centimetres_and_metres_is_the_same_scene) {
  SmallFbx metres, centimetres;
  metres.cube.place = Vec3(0.0f);
  centimetres.settings = SmallFbx::unit(1.0);
  centimetres.cube.place = Vec3(0.0f);
  const auto large = load("large.fbx", metres.text());
  const auto small = load("small.fbx", centimetres.text(), {.scale = 100.0});
  expect_near(bounds(small).high, bounds(large).high);
}

TEST_F(LoadConverted, max_3ds_has_the_coordinates_of_the_file_and_no_direction_up) {
  const Small3ds file;
  const auto scene = load("room.3ds", file.file());
  expect_cube(scene, file.cube.place, file.cube.place + Vec3(2.0f), Vec3(1, 0, 0));
  EXPECT_EQ(scene.up, Vec3(0.0f)) << "to be estimated, as of OBJ";
  expect_near(material_of(scene, "wall").reflectance, file.cube.wall, 1e-2f);
  expect_near(material_of(scene, "lamp").emittance, pi * Vec3(0.8f, 0.4f, 0.2f), 1e-2f);
  EXPECT_TRUE(material_of(scene, "wall").two_sided);
}

TEST_F(LoadConverted, pictures_are_found_beside_the_file_whatever_path_it_gives) {
  const std::array<std::uint8_t, 4> red = {255, 0, 0, 255}, blue = {0, 0, 255, 255};
  files_.write("tiles.tga", small_tga(2, 2, {red, red, blue, blue}));
  files_.write("textures/Wood 1.TGA", small_tga(1, 1, {{188, 0, 0, 255}}));
  const auto check = [&](const std::string& name, const std::string& bytes, const Vec3& mean) {
    const auto scene = load(name, bytes);
    EXPECT_EQ(files_.all_warnings(), "") << name;
    ASSERT_EQ(scene.textures.size(), 1u) << name;
    ASSERT_EQ(scene.uv_sets.size(), 1u) << name;
    expect_near(material_of(scene, "wall").reflectance, mean, 1e-2f);
  };
  const Vec3 tiles(0.5f, 0.0f, 0.5f), wood(0.503f, 0.0f, 0.0f);
  SmallFbx fbx;
  SmallDae dae;
  for (const std::string path : {"tiles.tga", "C:\\\\Users\\\\me\\\\tiles.tga", "../elsewhere/TILES.TGA"}) {
    fbx.cube.picture = path;
    check("room.fbx", fbx.text(), tiles);
  }
  dae.cube.picture = "tiles.tga";
  check("room.dae", dae.text(), tiles);
  dae.cube.picture = "file:///C:/pictures/Wood%201.tga";
  check("room.dae", dae.text(), wood);
}

// Texture coordinates run upwards in these formats and in OBJ.
TEST_F(LoadConverted, pictures_stand_as_those_of_obj) {
  const std::array<std::uint8_t, 4> red = {255, 0, 0, 255}, blue = {0, 0, 255, 255};
  files_.write("tiles.tga", small_tga(1, 2, {red, blue}));
  files_.write("room.mtl", "newmtl wall\nmap_Kd tiles.tga\n");
  const auto obj = load("room.obj",
                        "mtllib room.mtl\nv 0 0 0\nv 2 0 0\nv 0 2 0\nv 2 2 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 "
                        "1\nusemtl wall\nf 1/1 3/2 4/3 2/4\n");
  SmallDae dae;
  dae.cube.picture = "tiles.tga";
  SmallFbx fbx;
  fbx.cube.picture = "tiles.tga";
  const auto dae_scene = load("room.dae", dae.text()), fbx_scene = load("room.fbx", fbx.text());
  for (const auto* scene : {&dae_scene, &fbx_scene})
    for (std::size_t corner = 0; corner < 3; ++corner) EXPECT_EQ(placed(*scene, corner), placed(obj, corner));
}

TEST_F(LoadConverted, a_missing_picture_is_a_warning_that_names_it_and_the_file) {
  SmallFbx fbx;
  fbx.cube.picture = "C:/gone.png";
  const auto scene = load("room.fbx", fbx.text());
  EXPECT_EQ(files_.all_warnings(),
            "room.fbx: 1 picture cannot be read (first: room.fbx: /images/0/uri: there is no file "
            "'gone.png'); 0.5 is "
            "taken for the reflectance there, and 0 for the light that is emitted\n");
  expect_near(material_of(scene, "wall").reflectance, Vec3(0.5f));
}

TEST_F(LoadConverted, opacity_decides_whether_light_passes) {
  SmallDae dae;
  dae.transparency =
      "<transparent opaque=\"A_ONE\"><color>1 1 1 "
      "1</color></transparent><transparency><float>0.2</float></transparency>";
  EXPECT_FALSE(material_of(load("glass.dae", dae.text()), "wall").opaque);
  // Some programs write the transparency there.
  dae.transparency =
      "<transparent opaque=\"A_ONE\"><color>1 1 1 "
      "1</color></transparent><transparency><float>0</float></transparency>";
  EXPECT_TRUE(material_of(load("wall.dae", dae.text()), "wall").opaque);
  EXPECT_EQ(
      files_.all_warnings(),
      "wall.dae: an opacity of 0 is read as a transparency of 0, and the surfaces are opaque: 'wall'\n");
  SmallFbx fbx;
  fbx.wall_properties = "P: \"Opacity\", \"double\", \"Number\", \"\",0.25\n";
  EXPECT_FALSE(material_of(load("glass.fbx", fbx.text()), "wall").opaque);
}

TEST_F(LoadConverted, lamps_have_watts_and_cameras_their_view) {
  SmallDae dae;
  dae.asset = "<unit name=\"centimeter\" meter=\"0.01\"/><up_axis>Z_UP</up_axis>";
  dae.libraries =
      "<library_lights><light id=\"bulb-l\"><technique_common><point><color>100 50 "
      "0</color></point></technique_common>"
      "</light><light id=\"sun-l\"><technique_common><directional><color>3 3 "
      "3</color></directional></technique_common>"
      "</light><light id=\"spot-l\"><technique_common><spot><color>10 10 "
      "10</color><falloff_angle>60</falloff_angle>"
      "</spot></technique_common></light></library_lights><library_cameras><camera "
      "id=\"cam\" name=\"cam\"><optics><technique_common><perspective><xfov>90</xfov><aspect_ratio>2</"
      "aspect_ratio><znear>0.1</znear>"
      "<zfar>100</zfar></perspective></technique_common></optics></camera></library_cameras>";
  dae.nodes =
      "<node id=\"n1\" name=\"bulb\"><translate>100 200 300</translate><instance_light "
      "url=\"#bulb-l\"/></node>"
      "<node id=\"n2\" name=\"sun\"><instance_light url=\"#sun-l\"/></node>"
      "<node id=\"n3\" name=\"spot\"><rotate>1 0 0 90</rotate><instance_light url=\"#spot-l\"/></node>"
      "<node id=\"n4\" name=\"eye\"><translate>0 -500 160</translate><rotate>1 0 0 "
      "90</rotate><instance_camera url=\"#cam\"/></node>";
  const auto scene = load("room.dae", dae.text());
  EXPECT_EQ(files_.warnings()[0],
            "room.dae: the intensity of 3 lamps has no unit in this format; it is taken as watts");
  ASSERT_EQ(scene.point_lights.size(), 3u);
  const auto& bulb = scene.point_lights[0];
  EXPECT_EQ(bulb.name, "bulb");
  EXPECT_EQ(bulb.kind, PointLightKind::point);
  expect_near(bulb.position, Vec3(1, 3, -2));
  expect_near(bulb.intensity, Vec3(100, 50, 0) / (4.0f * pi));
  const auto& sun = scene.point_lights[1];
  EXPECT_EQ(sun.kind, PointLightKind::directional);
  expect_near(sun.direction, Vec3(0, -1, 0));
  expect_near(sun.intensity, Vec3(3.0f));
  const auto& spot = scene.point_lights[2];
  EXPECT_EQ(spot.kind, PointLightKind::spot);
  expect_near(spot.direction, Vec3(0, 0, -1));
  EXPECT_NEAR(spot.cos_outer, std::cos(pi / 6.0f), 2e-3f);
  ASSERT_EQ(scene.cameras.size(), 1u);
  const auto& camera = scene.cameras[0];
  expect_near(camera.eye, Vec3(0, 1.6f, 5));
  expect_near(glm::normalize(camera.target - camera.eye), Vec3(0, 0, -1));
  expect_near(camera.up, Vec3(0, 1, 0));
  EXPECT_NEAR(camera.vertical_fov, 2.0f * std::atan(0.5f) * 180.0f / pi, 1e-3f);
}

TEST_F(LoadConverted, two_lamps_of_one_name_stand_where_the_file_places_them) {
  SmallDae dae;
  dae.libraries =
      "<library_lights><light id=\"l\"><technique_common><point><color>1 1 "
      "1</color></point></technique_common></light>"
      "</library_lights>";
  dae.nodes =
      "<node id=\"a\" name=\"bulb\"><translate>1 0 0</translate></node>"
      "<node id=\"b\" name=\"bulb\"><translate>2 0 0</translate><instance_light url=\"#l\"/></node>"
      "<node id=\"c\" name=\"bulb\"><translate>3 0 0</translate><instance_light url=\"#l\"/></node>";
  const auto scene = load("room.dae", dae.text());
  ASSERT_EQ(scene.point_lights.size(), 2u);
  EXPECT_EQ(scene.point_lights[0].position, Vec3(2, 0, 0));
  EXPECT_EQ(scene.point_lights[1].position, Vec3(3, 0, 0));
}

TEST_F(LoadConverted, lamps_of_fbx_and_3ds_stand_where_the_file_places_them) {
  SmallFbx fbx;
  fbx.settings = SmallFbx::unit(1.0);
  fbx.objects =
      "NodeAttribute: 500, \"NodeAttribute::bulb\", \"Light\" {\nProperties70:  {\nP: \"LightType\", "
      "\"enum\", \"\", "
      "\"\",0\nP: \"Intensity\", \"Number\", \"\", \"A\",5000\n}\nTypeFlags: \"Light\"\nGeometryVersion: "
      "124\n}\n"
      "Model: 501, \"Model::bulb\", \"Light\" {\nVersion: 232\nProperties70:  {\nP: \"Lcl Translation\", "
      "\"Lcl "
      "Translation\", \"\", \"A\",100,200,300\n}\n}\n";
  fbx.connections = "C: \"OO\",501,0\nC: \"OO\",500,501\n";
  const auto scene = load("room.fbx", fbx.text());
  ASSERT_EQ(scene.point_lights.size(), 1u);
  expect_near(scene.point_lights[0].position, Vec3(1, 2, 3));
  expect_near(scene.point_lights[0].intensity, Vec3(50.0f / (4.0f * pi)));

  Small3ds file;
  file.objects = Small3ds::chunk(
      0x4000, Small3ds::text("spot") +
                  Small3ds::chunk(0x4600, Small3ds::vector(Vec3(1, 2, 3)) +
                                              Small3ds::chunk(0x4610, Small3ds::vector(Vec3(1, 5, 3)) +
                                                                          Small3ds::bytes(40.0f) +
                                                                          Small3ds::bytes(60.0f))));
  const auto spot = load("room.3ds", file.file());
  ASSERT_EQ(spot.point_lights.size(), 1u);
  expect_near(spot.point_lights[0].position, Vec3(1, 2, 3));
  expect_near(spot.point_lights[0].direction, Vec3(0, 1, 0));
  EXPECT_NEAR(spot.point_lights[0].cos_inner, std::cos(pi / 9.0f), 1e-3f);
  EXPECT_NEAR(spot.point_lights[0].cos_outer, std::cos(pi / 6.0f), 1e-3f);
}

TEST_F(LoadConverted, options_of_loading_apply) {
  SmallDae dae;
  const auto scene = load("room.dae", dae.text(), {.scale = 2.0, .one_sided = {"wall"}, .flip = {"lamp"}});
  expect_near(bounds(scene).low, 2.0f * dae.cube.place);
  EXPECT_FALSE(material_of(scene, "wall").two_sided);
}

TEST_F(LoadConverted, a_repeated_load_is_the_same_scene_and_leaves_no_file) {
  const SmallFbx fbx;
  const auto first = fingerprint(load("room.fbx", fbx.text()));
  EXPECT_EQ(fingerprint(load("room.fbx", fbx.text())), first);
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(files_.path(""))) count += entry.exists();
  EXPECT_EQ(count, 1u);
}

}  // namespace
}  // namespace luxel
