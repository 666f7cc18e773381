// SPDX-License-Identifier: Apache-2.0
// Pictures on OBJ surfaces: which, where they lie, and where they cut holes.
#include <gtest/gtest.h>

#include "luxel/scene/scene.h"

#include "support/scene_files.h"
#include "support/small_picture.h"

namespace luxel {
namespace {

const std::string square =
    "mtllib room.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl m\n";

class LoadObjTextures : public testing::Test {
 protected:
  // Two pixels above two: red, green, blue, white; alpha 255, 100, 200, 0.
  LoadObjTextures() {
    files_.write("four.tga",
                 small_tga(2, 2, {{255, 0, 0, 255}, {0, 255, 0, 100}, {0, 0, 255, 200}, {255, 255, 255, 0}}));
    files_.write("grey.tga", small_tga(2, 1, {{128, 128, 128, 255}, {127, 127, 127, 255}}));
  }
  Scene load(const std::string& mtl, const std::string& faces = "f 1/1 2/2 3/3 4/4\n") {
    files_.write("room.mtl", "newmtl m\n" + mtl);
    auto scene = files_.load_text(square + faces);
    check_scene(scene);
    return scene;
  }
  SceneFiles files_;
};

TEST_F(LoadObjTextures, a_picture_lies_with_its_bottom_at_v_0) {
  const auto scene = load("Kd 0.5 1 1\nmap_Kd four.tga\n");
  const auto& textures = scene.materials[0].textures;
  ASSERT_TRUE(textures.reflectance);
  EXPECT_EQ(textures.reflectance_factor, Vec3(0.5f, 1.0f, 1.0f));
  EXPECT_EQ(scene.materials[0].reflectance, Vec3(0.25f, 0.5f, 0.5f));
  ASSERT_EQ(scene.uv_sets.size(), 1u);
  EXPECT_EQ(scene.uv_sets[0][1], (std::array{Vec2(0, 0), Vec2(1, 1), Vec2(0, 1)}));
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.textures[0].name, "four.tga");
  // The corner of u = 0, v = 0 shows the blue pixel, bottom left; a little above v = 1/2 it is red.
  const auto& use = *textures.reflectance;
  const auto& raster = *scene.textures[0].raster;
  EXPECT_EQ(raster.codes[pixel_at(raster, use, use.place({0.1f, 0.1f}))], (Raster::Code{0, 0, 255, 200}));
  EXPECT_EQ(raster.codes[pixel_at(raster, use, use.place({0.1f, 0.9f}))], (Raster::Code{255, 0, 0, 255}));
  EXPECT_EQ(raster.codes[pixel_at(raster, use, use.place({1.1f, 1.9f}))], (Raster::Code{255, 0, 0, 255}))
      << "repeats";
  EXPECT_TRUE(files_.warnings().empty()) << files_.all_warnings();
}

TEST_F(LoadObjTextures, options_scale_shift_and_clamp) {
  const auto scene = load("map_Kd -s 2 4 1 -o 0.25 0.5 -clamp on four.tga\n");
  const auto& use = *scene.materials[0].textures.reflectance;
  EXPECT_EQ(use.place({0.5f, 0.0f}), Vec2(1.25f, 0.5f));
  EXPECT_EQ(use.place({0.0f, 0.125f}), Vec2(0.25f, 0.0f));
  EXPECT_EQ(use.wrap, (std::array{Wrap::clamp, Wrap::clamp}));
}

TEST_F(LoadObjTextures, a_picture_may_emit) {
  const auto scene = load("Kd 0 0 0\nmap_Ke four.tga\n");
  const auto& textures = scene.materials[0].textures;
  EXPECT_TRUE(textures.emittance);
  EXPECT_EQ(textures.emittance_factor, Vec3(pi));
  EXPECT_EQ(scene.materials[0].emittance, Vec3(0.5f * pi));
}

TEST_F(LoadObjTextures, alpha_cuts_holes_where_map_d_asks_for_it) {
  const auto scene = load("map_Kd four.tga\nmap_d four.tga\n");
  const auto& textures = scene.materials[0].textures;
  EXPECT_EQ(textures.cutout, textures.reflectance);
  EXPECT_EQ(textures.cutout_threshold, 0.5f);
  EXPECT_EQ(scene.textures.size(), 1u);
  EXPECT_FALSE(load("map_Kd four.tga\n").materials[0].textures.cutout);
}

TEST_F(LoadObjTextures, the_grey_of_a_picture_without_alpha_cuts_holes) {
  const auto scene = load("Kd 0.5 0.5 0.5\nd 0.8\nmap_d grey.tga\n");
  const auto& textures = scene.materials[0].textures;
  ASSERT_TRUE(textures.cutout);
  EXPECT_FALSE(textures.reflectance);
  EXPECT_EQ(textures.cutout_threshold, 0.625f) << "d times the picture";
  const auto& raster = *scene.textures.at(textures.cutout->texture).raster;
  EXPECT_EQ(raster.codes[0][3], 128);
  EXPECT_EQ(raster.codes[1][3], 127);
}

TEST_F(LoadObjTextures, faces_without_coordinates_get_the_mean) {
  const auto scene = load("map_Kd four.tga\n", "f 1/1 2/2 3/3\nf 1 3 4\nf 1/1 3/9 4/4\nf 1/1 2/-1 3/-9\n");
  ASSERT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.materials[1].name, "m");
  EXPECT_FALSE(scene.materials[1].textures.any());
  EXPECT_EQ(scene.materials[1].reflectance, Vec3(0.5f));
  EXPECT_EQ(scene.triangle_material,
            (std::vector{MaterialId{0}, MaterialId{1}, MaterialId{1}, MaterialId{1}}));
  EXPECT_NE(files_.all_warnings().find(
                "3 faces of textured materials without texture coordinates (first: line 12)"),
            std::string::npos)
      << files_.all_warnings();
}

TEST_F(LoadObjTextures, coordinates_of_plain_materials_are_passed_over) {
  const auto scene = load("Kd 0.5 0.5 0.5\n", "vt nan x\nf 1/1 2/2 3/99\n");
  EXPECT_TRUE(scene.uv_sets.empty());
  EXPECT_TRUE(scene.textures.empty());
  EXPECT_TRUE(files_.warnings().empty()) << files_.all_warnings();
}

TEST_F(LoadObjTextures, coordinates_that_are_no_numbers_are_told) {
  load("map_Kd four.tga\n", "vt 0 nan\nvt 0.5\nf 1/1 2/5 3/6\n");
  EXPECT_NE(files_.all_warnings().find("1 texture coordinate not of finite numbers (first: line 11)"),
            std::string::npos)
      << files_.all_warnings();
}

TEST_F(LoadObjTextures, a_turned_face_takes_its_coordinates_with_it) {
  const auto scene = load("map_Kd four.tga\n", "vn 0 0 -1\nf 1/1/1 2/2/1 3/3/1\n");
  EXPECT_EQ(scene.triangles[0], (std::array<std::uint32_t, 3>{0, 2, 1}));
  EXPECT_EQ(scene.uv_sets[0][0], (std::array{Vec2(0, 0), Vec2(1, 1), Vec2(1, 0)}));
}

}  // namespace
}  // namespace luxel
