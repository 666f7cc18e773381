// SPDX-License-Identifier: Apache-2.0
// Materials, pictures and lamps of glTF files.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "luxel/scene/scene.h"

#include "support/scene_files.h"
#include "support/small_gltf.h"
#include "support/small_picture.h"

namespace luxel {
namespace {

using Pixels = std::vector<std::array<std::uint8_t, 4>>;

constexpr float half_code = 188.0f;  // sRGB of about 0.5
const float half_linear = std::pow((half_code / 255.0f + 0.055f) / 1.055f, 2.4f);

void expect_near(const Vec3& found, const Vec3& expected, float error = 1e-5f) {
  EXPECT_LT(glm::length(found - expected), error)
      << fmt::format("({}, {}, {}) where ({}, {}, {}) was expected", found.x, found.y, found.z, expected.x,
                     expected.y, expected.z);
}

class LoadGltfMaterials : public testing::Test {
 protected:
  // A triangle with TEXCOORD_0 and TEXCOORD_1 and this material; the pictures a.tga and b.tga are
  // textures 0 and 1; 2 is b.tga laid like a.tga.
  Scene load(const std::string& material, const std::string& more = "", const LoadOptions& options = {}) {
    auto gltf = one_triangle();
    gltf.array<float>(SmallGltf::f32, "VEC2", 3, {0, 0, 1, 0, 0, 1});
    gltf.array<std::uint8_t>(SmallGltf::u8, "VEC2", 3, {0, 0, 51, 0, 0, 255}, R"(,"normalized":true)");
    gltf.meshes = primitives_;
    gltf.rest = fmt::format(
        R"(,"materials":[{}],"textures":[{{"source":0}},{{"source":1,"sampler":0}},{{"source":1}}],)"
        R"("images":[{{"uri":"a.tga","name":"oak"}},{{"uri":"b.tga"}}],)"
        R"("samplers":[{{"wrapS":33071,"wrapT":33648}}]{})",
        material, more);
    files_.write("room.gltf", gltf.text());
    auto scene = files_.load("room.gltf", options);
    check_scene(scene);
    return scene;
  }
  void picture(const std::string& name, int width, int height, const Pixels& pixels) {
    files_.write(name, small_tga(width, height, pixels));
  }

  SceneFiles files_;
  std::string primitives_ =
      R"({"primitives":[{"material":0,"attributes":{"POSITION":0,"TEXCOORD_0":1,"TEXCOORD_1":2}}]})";
};

TEST_F(LoadGltfMaterials, diffuse_light_is_what_metal_leaves_of_the_base_colour) {
  const auto scene = load(R"({"name":"paint","doubleSided":true,"pbrMetallicRoughness":)"
                          R"({"baseColorFactor":[0.8,0.4,0.2,1],"metallicFactor":0.25}})");
  ASSERT_EQ(scene.materials.size(), 1u);
  EXPECT_EQ(scene.materials[0].name, "paint");
  expect_near(scene.materials[0].reflectance, Vec3(0.6f, 0.3f, 0.15f));
  EXPECT_TRUE(scene.materials[0].two_sided);
  EXPECT_FALSE(scene.materials[0].textures.reflectance);
}

TEST_F(LoadGltfMaterials, the_back_absorbs_unless_the_file_says_otherwise) {
  const auto scene = load(R"({"pbrMetallicRoughness":{"metallicFactor":0}})");
  EXPECT_FALSE(scene.materials[0].two_sided);
  EXPECT_EQ(scene.materials[0].name, "material 0");
  expect_near(scene.materials[0].reflectance, Vec3(0.98f));
  EXPECT_EQ(scene.materials[0].stated_reflectance, Vec3(1.0f));
  EXPECT_NE(files_.all_warnings().find("lowered to 0.98"), std::string::npos);
}

TEST_F(LoadGltfMaterials, what_has_no_material_is_grey) {
  primitives_ = R"({"primitives":[{"attributes":{"POSITION":0}}]})";
  const auto scene = load("{}");
  expect_near(scene.materials[0].reflectance, Vec3(0.5f));
  EXPECT_NE(files_.all_warnings().find("a grey of 0.5"), std::string::npos);
}

TEST_F(LoadGltfMaterials, the_base_colour_of_metal_stands_for_its_reflections) {
  const auto gold = load(R"({"name":"gold","pbrMetallicRoughness":{"baseColorFactor":[1,0.75,0.25,1]}})");
  expect_near(gold.materials[0].reflectance, Vec3(0.8f, 0.75f, 0.25f));
  EXPECT_EQ(files_.all_warnings(),
            "room.gltf: stand-ins, since metals and mirrors are not modelled: their colour, at most 0.8, is "
            "taken as "
            "diffuse for 'gold'\n");
  const auto capped = load(R"({"name":"gold"})", "", {.max_reflectance = 0.5f});
  expect_near(capped.materials[0].reflectance, Vec3(0.5f));
}

TEST_F(LoadGltfMaterials, a_mirror_of_specular_and_glossiness_shows_its_specular_colour) {
  const auto mirror = load(R"({"name":"chrome","extensions":{"KHR_materials_pbrSpecularGlossiness":)"
                           R"({"diffuseFactor":[0.125,0.125,0.125,1],"specularFactor":[0.5,0.5,1]}}})");
  expect_near(mirror.materials[0].reflectance, Vec3(0.625f, 0.625f, 0.8f));
  EXPECT_NE(files_.all_warnings().find("'chrome'"), std::string::npos);
  const auto plastic = load(R"({"extensions":{"KHR_materials_pbrSpecularGlossiness":)"
                            R"({"diffuseFactor":[0.125,0.125,0.125,1],"specularFactor":[0.04,0.04,0.04]}}})");
  expect_near(plastic.materials[0].reflectance, Vec3(0.125f));
  EXPECT_EQ(files_.all_warnings(), "");
}

// 1000 cd/m² of white are 1000 pi lm/m², and 179 lm are a watt.
TEST_F(LoadGltfMaterials, emission_is_luminance) {
  const auto scene = load(R"({"emissiveFactor":[1,0.5,0],"extensions":)"
                          R"({"KHR_materials_emissive_strength":{"emissiveStrength":1000}}})");
  const auto watts = 1000.0f * pi / 179.0f;
  expect_near(scene.materials[0].emittance, Vec3(watts, 0.5f * watts, 0.0f));
}

TEST_F(LoadGltfMaterials, a_picture_colours_the_surface_and_its_mean_stands_for_the_whole) {
  picture("a.tga", 2, 1, {{255, 0, 0, 255}, {0, 188, 0, 255}});
  const auto scene =
      load(R"({"name":"rug","pbrMetallicRoughness":{"baseColorFactor":[0.5,0.5,1,1],"metallicFactor":0,)"
           R"("baseColorTexture":{"index":0}}})");
  const auto& material = scene.materials[0];
  ASSERT_TRUE(material.textures.reflectance);
  EXPECT_EQ(material.textures.reflectance->placement, (std::array<float, 6>{1, 0, 0, 0, 1, 0}));
  EXPECT_EQ(material.textures.reflectance->wrap[0], Wrap::repeat);
  expect_near(material.textures.reflectance_factor, Vec3(0.5f, 0.5f, 1.0f));
  expect_near(material.reflectance, Vec3(0.25f, 0.25f * half_linear, 0.0f));
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.textures[0].name, "oak");
  ASSERT_EQ(scene.uv_sets.size(), 1u);
  EXPECT_EQ(scene.uv_sets[0][0][1], Vec2(1, 0));
}

TEST_F(LoadGltfMaterials, other_sets_of_coordinates_samplers_and_whole_numbers_are_read) {
  picture("b.tga", 1, 1, {{255, 255, 255, 255}});
  const auto scene = load(R"({"emissiveFactor":[1,1,1],"emissiveTexture":{"index":1,"texCoord":1}})");
  const auto& use = scene.materials[0].textures.emittance;
  ASSERT_TRUE(use);
  EXPECT_EQ(use->texture, 0u);
  EXPECT_EQ(use->wrap, (std::array{Wrap::clamp, Wrap::mirror}));
  EXPECT_EQ(scene.uv_sets.at(use->uv_set)[0][1], Vec2(0.2f, 0.0f));
  expect_near(scene.materials[0].textures.emittance_factor, Vec3(pi / 179.0f));
}

// A quarter turn, counter-clockwise as seen on the picture, whose y goes down: (1, 0) comes to (0, -1).
TEST_F(LoadGltfMaterials, pictures_are_scaled_turned_and_shifted) {
  picture("a.tga", 1, 1, {{255, 255, 255, 255}});
  const auto scene = load(fmt::format(
      R"({{"pbrMetallicRoughness":{{"metallicFactor":0,"baseColorTexture":{{"index":0,"extensions":)"
      R"({{"KHR_texture_transform":{{"offset":[0,1],"rotation":{},"scale":[0.5,0.25],"texCoord":1}}}}}}}}}})",
      std::numbers::pi / 2.0));
  const auto& use = scene.materials[0].textures.reflectance;
  ASSERT_TRUE(use);
  const auto near = [](const Vec2& found, const Vec2& expected) {
    EXPECT_LT(glm::length(found - expected), 1e-6f) << found.x << " " << found.y;
  };
  near(use->place({0, 0}), {0, 1});
  near(use->place({1, 0}), {0, 0.5f});
  near(use->place({0, 1}), {0.25f, 1});
  EXPECT_EQ(scene.uv_sets[0][0][1], Vec2(0.2f, 0.0f)) << "the transform's own set";
}

TEST_F(LoadGltfMaterials, metal_in_a_picture_lowers_bright_base_colours_place_by_place) {
  picture("a.tga", 2, 2, Pixels(4, {255, 255, 255, 77}));
  picture("b.tga", 2, 1, {{0, 0, 0, 255}, {0, 0, 255, 255}});  // blue: none, all
  const auto scene = load(
      R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":1}}})");
  // Their placements differ (the second clamps), so the mean is used: half of it is not metallic.
  expect_near(scene.materials[0].reflectance, Vec3(0.5f));
  EXPECT_EQ(scene.textures.size(), 1u);

  const auto same = load(
      R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":2}}})");
  ASSERT_EQ(same.textures.size(), 1u);
  const auto& raster = *same.textures[0].raster;
  EXPECT_EQ(raster.width, 2);
  EXPECT_EQ(raster.height, 2);
  for (const int y : {0, 1}) {
    EXPECT_EQ(raster.codes[raster.index(0, y)], (Raster::Code{255, 255, 255, 77}));
    EXPECT_EQ(raster.codes[raster.index(1, y)], (Raster::Code{231, 231, 231, 77}));
  }
  expect_near(same.materials[0].reflectance, Vec3(0.9f), 1e-3f);
  expect_near(same.materials[0].textures.reflectance_factor, Vec3(1.0f));

  const auto alone = load(R"({"pbrMetallicRoughness":{"metallicRoughnessTexture":{"index":1}}})");
  expect_near(alone.materials[0].reflectance, Vec3(0.9f), 1e-3f);
}

TEST_F(LoadGltfMaterials, what_alpha_masks_is_a_hole) {
  picture("a.tga", 2, 1, {{255, 0, 0, 255}, {0, 255, 0, 20}});
  const auto scene =
      load(R"({"alphaMode":"MASK","alphaCutoff":0.25,"pbrMetallicRoughness":{"metallicFactor":0,)"
           R"("baseColorFactor":[1,1,1,0.5],"baseColorTexture":{"index":0}}})");
  const auto& material = scene.materials[0];
  EXPECT_EQ(material.textures.cutout, material.textures.reflectance);
  EXPECT_FLOAT_EQ(material.textures.cutout_threshold, 0.5f);  // of the picture alone
  EXPECT_TRUE(material.opaque);
  expect_near(material.reflectance, Vec3(0.5f, 0.5f, 0.0f));
}

TEST_F(LoadGltfMaterials, a_picture_without_holes_cuts_none) {
  picture("a.tga", 1, 1, {{255, 0, 0, 200}});
  EXPECT_FALSE(load(R"({"alphaMode":"MASK","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})")
                   .materials[0]
                   .textures.cutout);
  picture("a.tga", 1, 1, {{255, 0, 0, 0}});
  EXPECT_FALSE(
      load(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})").materials[0].textures.cutout);
}

TEST_F(LoadGltfMaterials, light_passes_through_what_is_more_transparent_than_not) {
  const auto glass =
      load(R"({"name":"pane","alphaMode":"BLEND","pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.2]}})");
  EXPECT_FALSE(glass.materials[0].opaque);
  EXPECT_NE(files_.all_warnings().find("'pane'"), std::string::npos);
  EXPECT_TRUE(load(R"({"alphaMode":"BLEND","pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.7]}})")
                  .materials[0]
                  .opaque);
  EXPECT_TRUE(load(R"({"pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.2]}})").materials[0].opaque);
  EXPECT_FALSE(
      load(R"({"extensions":{"KHR_materials_transmission":{"transmissionFactor":1}}})").materials[0].opaque);
}

TEST_F(LoadGltfMaterials, what_transmits_is_a_pane_of_the_factor_times_the_base_colour) {
  const auto pane = load(R"({"name":"pane","pbrMetallicRoughness":{"baseColorFactor":[0.8,0.9,0.7,1]},)"
                         R"("extensions":{"KHR_materials_transmission":{"transmissionFactor":0.9}}})");
  EXPECT_FALSE(pane.materials[0].opaque);
  expect_near(pane.materials[0].transmittance, Vec3(0.72f, 0.81f, 0.63f));
  EXPECT_NE(files_.all_warnings().find("panes of glass, with the transmittance"), std::string::npos);
  const auto clear = load(R"({"extensions":{"KHR_materials_transmission":{"transmissionFactor":1}}})");
  EXPECT_EQ(clear.materials[0].transmittance, Vec3(1.0f));
  EXPECT_NE(files_.all_warnings().find("light passes freely"), std::string::npos);
  const auto solid = load(R"({"extensions":{"KHR_materials_transmission":{"transmissionFactor":0.4}}})");
  EXPECT_TRUE(solid.materials[0].opaque);
  EXPECT_EQ(solid.materials[0].transmittance, Vec3(1.0f));
}

TEST_F(LoadGltfMaterials, diffuse_transmission_makes_diffusers_of_the_rest_of_the_base_colour) {
  const auto material = [&](const std::string& extension, const std::string& more = "") {
    return load(
               R"({"name":"shade","pbrMetallicRoughness":{"baseColorFactor":[0.8,0.6,0.4,1],"metallicFactor":0)" +
               more + R"(},"extensions":{"KHR_materials_diffuse_transmission":{)" + extension + "}}}")
        .materials[0];
  };
  const auto shade =
      material(R"("diffuseTransmissionFactor":0.25,"diffuseTransmissionColorFactor":[0.8,1,0.4])");
  expect_near(shade.reflectance, Vec3(0.6f, 0.45f, 0.3f));
  expect_near(shade.diffuse_transmittance, Vec3(0.2f, 0.25f, 0.1f));
  EXPECT_TRUE(shade.opaque);
  EXPECT_TRUE(shade.two_sided);
  EXPECT_NE(files_.all_warnings().find("diffusers, with the transmittance"), std::string::npos);
  EXPECT_FALSE(material("").is_diffuser());
  EXPECT_FALSE(material(R"("diffuseTransmissionFactor":0)").is_diffuser());

  const auto bright = material(R"("diffuseTransmissionFactor":0.9)");  // 0.08 + 0.9 in red
  expect_near(bright.reflectance + bright.diffuse_transmittance, Vec3(0.98f, 0.96f, 0.94f));
  const auto too_bright =
      load(R"({"name":"lost","pbrMetallicRoughness":{"metallicFactor":0},"extensions":)"
           R"({"KHR_materials_diffuse_transmission":{"diffuseTransmissionFactor":0.5}}})");
  expect_near(too_bright.materials[0].reflectance, Vec3(0.48f));
  expect_near(too_bright.materials[0].diffuse_transmittance, Vec3(0.5f));
  EXPECT_NE(files_.all_warnings().find("reflects and transmits more than 0.98"), std::string::npos);
  EXPECT_THROW(material(R"("diffuseTransmissionFactor":1.5)"), InputError);
}

TEST_F(LoadGltfMaterials, older_files_state_a_diffuse_colour) {
  const auto scene =
      load(R"({"extensions":{"KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[0.1,0.2,0.3,1]}}})",
           R"(,"extensionsRequired":["KHR_materials_pbrSpecularGlossiness"])");
  expect_near(scene.materials[0].reflectance, Vec3(0.1f, 0.2f, 0.3f));
}

TEST_F(LoadGltfMaterials, unlit_surfaces_are_taken_as_diffuse_with_a_warning) {
  const auto scene =
      load(R"({"name":"sign","pbrMetallicRoughness":{"baseColorFactor":[0.5,0.5,0.5,1],"metallicFactor":0},)"
           R"("extensions":{"KHR_materials_unlit":{}}})");
  expect_near(scene.materials[0].reflectance, Vec3(0.5f));
  EXPECT_FALSE(scene.materials[0].is_lamp());
  EXPECT_NE(files_.all_warnings().find("'sign'"), std::string::npos);
}

TEST_F(LoadGltfMaterials, a_picture_that_cannot_be_had_is_a_warning) {
  files_.write("a.tga", "no picture");
  const auto scene = load(R"({"pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":{"index":0}},)"
                          R"("emissiveFactor":[1,1,1],"emissiveTexture":{"index":1}})");
  expect_near(scene.materials[0].reflectance, Vec3(0.5f));
  EXPECT_FALSE(scene.materials[0].is_lamp());
  EXPECT_NE(files_.all_warnings().find("2 pictures cannot be read (first: room.gltf"), std::string::npos)
      << files_.all_warnings();
}

TEST_F(LoadGltfMaterials, surfaces_without_coordinates_get_the_mean) {
  picture("a.tga", 2, 1, {{255, 255, 255, 255}, {0, 0, 0, 255}});
  primitives_ = R"({"primitives":[{"material":0,"attributes":{"POSITION":0,"TEXCOORD_0":1}},)"
                R"({"material":0,"attributes":{"POSITION":0}}]})";
  const auto scene =
      load(R"({"name":"tiles","pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":{"index":0}}})");
  ASSERT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.materials[1].name, "tiles");
  EXPECT_TRUE(scene.materials[0].textures.reflectance);
  EXPECT_FALSE(scene.materials[1].textures.reflectance);
  expect_near(scene.materials[1].reflectance, Vec3(0.5f));
  EXPECT_EQ(scene.triangle_material[1], MaterialId{1});
  EXPECT_NE(files_.all_warnings().find("no texture coordinates"), std::string::npos);
}

TEST_F(LoadGltfMaterials, pictures_may_lie_in_the_buffer) {
  auto gltf = one_triangle();
  gltf.array<float>(SmallGltf::f32, "VEC2", 3, {0, 0, 1, 0, 0, 1});
  // A PNG of one red pixel.
  const std::string png(
      "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x8\2\0\0\0\x90wS\xde\0\0\0\fIDATx\x9c"
      "c\xf8\xcf\xc0\0\0\3\1\1\0\xc9"
      "\xfe\x92\xef\0\0\0\0IEND\xae"
      "B`\x82",
      69);
  const auto view = gltf.view(png);
  gltf.meshes = R"({"primitives":[{"material":0,"attributes":{"POSITION":0,"TEXCOORD_0":1}}]})";
  gltf.rest = fmt::format(
      R"(,"materials":[{{"pbrMetallicRoughness":{{"metallicFactor":0,"baseColorTexture":{{"index":0}}}}}}],)"
      R"("textures":[{{"source":0}}],"images":[{{"bufferView":{},"mimeType":"image/png"}}])",
      view);
  files_.write("room.glb", gltf.glb());
  const auto scene = files_.load("room.glb");
  EXPECT_EQ(files_.all_warnings().find("cannot be read"), std::string::npos) << files_.all_warnings();
  expect_near(scene.materials[0].reflectance, Vec3(0.98f, 0.0f, 0.0f));
}

class LoadGltfLamps : public LoadGltfMaterials {
 protected:
  PointLight lamp(const std::string& light, const std::string& node = "") {
    auto gltf = one_triangle();
    gltf.nodes = fmt::format(
        R"({{"mesh":0}},{{"name":"bulb","extensions":{{"KHR_lights_punctual":{{"light":0}}}}{}}})", node);
    gltf.rest = fmt::format(R"(,"extensionsRequired":["KHR_lights_punctual"],)"
                            R"("extensions":{{"KHR_lights_punctual":{{"lights":[{}]}}}})",
                            light);
    files_.write("room.gltf", gltf.text());
    const auto scene = files_.load("room.gltf");
    check_scene(scene);
    return scene.point_lights.at(0);
  }
};

TEST_F(LoadGltfLamps, a_point_is_given_in_candela) {
  const auto point =
      lamp(R"({"type":"point","color":[1,0.5,0],"intensity":358})", R"(,"translation":[1,2,3])");
  EXPECT_EQ(point.kind, PointLightKind::point);
  EXPECT_EQ(point.name, "bulb");
  EXPECT_EQ(point.position, Vec3(1, 2, 3));
  expect_near(point.intensity, Vec3(2, 1, 0));  // 358 cd / 179 lm/W
}

TEST_F(LoadGltfLamps, a_sun_is_given_in_lux) {
  const auto sun = lamp(R"({"type":"directional","intensity":1790})",
                        R"(,"rotation":[-0.70710678,0,0,0.70710678],"scale":[5,5,5])");
  EXPECT_EQ(sun.kind, PointLightKind::directional);
  expect_near(sun.direction, Vec3(0, -1, 0));
  expect_near(sun.intensity, Vec3(10));
}

TEST_F(LoadGltfLamps, a_spot_has_two_angles) {
  const auto spot = lamp(
      R"({"type":"spot","spot":{"innerConeAngle":0.5235987755982988,"outerConeAngle":1.0471975511965976}})");
  EXPECT_NEAR(spot.cos_inner, std::sqrt(0.75f), 1e-6f);
  EXPECT_NEAR(spot.cos_outer, 0.5f, 1e-6f);
  expect_near(spot.direction, Vec3(0, 0, -1));
  const auto standard = lamp(R"({"type":"spot"})");
  EXPECT_EQ(standard.cos_inner, 1.0f);
  EXPECT_NEAR(standard.cos_outer, std::sqrt(0.5f), 1e-6f);
  const auto sharp = lamp(R"({"type":"spot","spot":{"innerConeAngle":0.5,"outerConeAngle":0.5}})");
  EXPECT_NEAR(sharp.cos_inner - sharp.cos_outer, 1e-3f, 1e-6f);
}

}  // namespace
}  // namespace luxel
