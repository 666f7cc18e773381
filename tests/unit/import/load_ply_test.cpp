// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "luxel/image/image.h"
#include "luxel/scene/scene.h"

#include "support/scene_files.h"
#include "support/small_mesh_files.h"
#include "support/small_picture.h"

namespace luxel {
namespace {

class LoadPly : public testing::Test {
 protected:
  Scene load(const std::string& bytes, const LoadOptions& options = {}) {
    files_.write("room.ply", bytes);
    auto scene = files_.load("room.ply", options);
    check_scene(scene);
    return scene;
  }
  std::string refusal(const std::string& bytes, const LoadOptions& options = {}) {
    files_.write("room.ply", bytes);
    return files_.refusal("room.ply", options);
  }
  SceneFiles files_;
};

// Three vertices with more properties, and one triangle.
std::string triangle(const std::string& properties, const std::array<std::string, 3>& values,
                     const std::string& comment = "") {
  return fmt::format(
      "ply\nformat ascii 1.0\n{}element vertex 3\nproperty float x\nproperty float y\nproperty float z\n{}"
      "element face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0 {}\n1 0 0 {}\n0 1 0 {}\n"
      "3 0 1 2\n",
      comment, properties, values[0], values[1], values[2]);
}

const std::string rgb = "property uchar red\nproperty uchar green\nproperty uchar blue\n";

TEST_F(LoadPly, text_and_both_kinds_of_binary_files_are_the_same_scene) {
  const SmallCube cube;
  const auto text = load(cube.ply_text());
  EXPECT_EQ(text.positions, cube.positions);
  EXPECT_EQ(text.triangles, cube.triangles());
  EXPECT_EQ(text.triangle_line[0], 19u) << "the line of the first face";
  for (const bool big_endian : {false, true}) {
    const auto binary = load(cube.ply_binary(big_endian));
    EXPECT_EQ(binary.positions, cube.positions);
    EXPECT_EQ(binary.triangles, cube.triangles());
    EXPECT_EQ(fingerprint(binary), fingerprint(text));
    EXPECT_EQ(binary.triangle_line[0], 0u);
  }
}

TEST_F(LoadPly, the_scale_applies_as_to_obj) {
  EXPECT_EQ(load(SmallCube().ply_text(), {.scale = 0.5}).positions[7], Vec3(1.0f));
}

TEST_F(LoadPly, lines_may_end_as_on_any_system) {
  auto text = SmallCube().ply_text();
  const auto expected = fingerprint(load(text));
  for (const std::string end : {"\r\n", "\r"}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? end : std::string(1, c);
    EXPECT_EQ(fingerprint(load(other)), expected);
  }
}

TEST_F(LoadPly, without_colours_all_is_grey_and_a_note_states_it) {
  const auto scene = load(SmallCube().ply_text());
  EXPECT_EQ(scene.materials[0].reflectance, Vec3(0.5f));
  EXPECT_EQ(files_.all_warnings(), "room.ply: the file has no colours; a grey of 0.5 is taken\n");
}

TEST_F(LoadPly, colours_of_vertices_are_srgb_and_become_reflectances) {
  const auto scene = load(triangle(rgb, {"255 0 0", "0 128 0", "0 0 64"}));
  ASSERT_EQ(scene.corner_colours.size(), 1u);
  const auto reflectance = [&](int corner) {
    return scene.materials[0].reflectance * scene.corner_colours[0][corner];
  };
  EXPECT_FLOAT_EQ(reflectance(0).r, 0.98f);
  EXPECT_FLOAT_EQ(reflectance(1).g, srgb_decode(128.0f / 255.0f));
  EXPECT_FLOAT_EQ(reflectance(2).b, srgb_decode(64.0f / 255.0f));
  EXPECT_EQ(reflectance(0).g, 0.0f);
  EXPECT_EQ(files_.all_warnings(),
            "room.ply: the reflectance of 1 colour was lowered to 0.98, as no surface reflects all light\n");
}

TEST_F(LoadPly, colours_of_floats_are_linear) {
  const auto scene = load(triangle("property float red\nproperty float green\nproperty float blue\n",
                                   {"0.5 0.25 0", "0.5 0.25 0", "0.5 0.25 nan"}));
  const auto& colour = scene.corner_colours[0][0];
  EXPECT_FLOAT_EQ(scene.materials[0].reflectance.r * colour.r, 0.5f);
  EXPECT_FLOAT_EQ(scene.materials[0].reflectance.g * colour.g, 0.25f);
}

TEST_F(LoadPly, colours_of_faces_take_precedence) {
  auto text = triangle(rgb, {"255 0 0", "255 0 0", "255 0 0"});
  text.replace(text.find("vertex_index\n"), 13, "vertex_index\n" + rgb);
  text.replace(text.find("3 0 1 2\n"), 8, "3 0 1 2 0 64 0\n");
  const auto scene = load(text);
  EXPECT_EQ(scene.corner_colours[0][1].r, 0.0f);
  EXPECT_FLOAT_EQ(scene.corner_colours[0][1].g * 0.98f, srgb_decode(64.0f / 255.0f));
}

TEST_F(LoadPly, the_picture_that_meshlab_names_lies_on_the_surface) {
  files_.write("wood.tga", small_tga(2, 1, {{255, 0, 0, 255}, {0, 255, 0, 255}}));
  const auto scene = load(triangle("property float s\nproperty float t\n", {"0 0", "1 0", "0 1"},
                                   "comment TextureFile wood.tga\n"));
  ASSERT_TRUE(scene.materials[0].textures.reflectance);
  EXPECT_EQ(scene.materials[0].name, "wood.tga");
  EXPECT_EQ(scene.materials[0].reflectance, Vec3(0.5f, 0.5f, 0.0f));
  ASSERT_EQ(scene.uv_sets.size(), 1u);
  EXPECT_EQ(scene.uv_sets[0][0], (std::array{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}));
  EXPECT_TRUE(files_.warnings().empty()) << files_.all_warnings();
}

TEST_F(LoadPly, normals_define_the_front) {
  const std::string down = "0 0 -1";
  const auto scene =
      load(triangle("property float nx\nproperty float ny\nproperty float nz\n", {down, down, down}));
  EXPECT_EQ(scene.triangles[0], (std::array<std::uint32_t, 3>{0, 2, 1}));
}

TEST_F(LoadPly, strips_of_triangles_keep_their_fronts) {
  const auto scene = load(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n8 0 1 2 3 -1 0 1 2\n");
  ASSERT_EQ(scene.triangles.size(), 3u);
  for (const auto& t : scene.triangles) {
    const auto& p = scene.positions;
    EXPECT_GT(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]).z, 0.0f);
  }
}

TEST_F(LoadPly, elements_of_other_kinds_are_skipped) {
  auto text = triangle("", {"", "", ""});
  text.replace(text.find("end_header"), 10,
               "element edge 1\nproperty int vertex1\nproperty list uchar float weights\nend_header");
  EXPECT_EQ(load(text + "7 2 0.5 x\n").triangles.size(), 1u);
}

TEST_F(LoadPly, what_is_wrong_is_named_with_its_line) {
  const auto good = triangle("", {"", "", ""});
  const auto with = [&](const std::string& old, const std::string& now) {
    auto text = good;
    text.replace(text.find(old), old.size(), now);
    return refusal(text);
  };
  EXPECT_EQ(with("ply\n", "PLY\n"),
            "room.ply: expected a PLY file, whose first line is 'ply', found another one");
  EXPECT_EQ(with("ascii 1.0", "ascii 2.0"), "room.ply:2: expected version 1.0 of PLY, found '2.0'");
  EXPECT_EQ(with("format ascii 1.0\n", ""), "room.ply:8: the header of this PLY has no line 'format'");
  EXPECT_EQ(with("end_header\n", ""),
            "room.ply:9: expected format, element, property, comment or end_header, found '0'");
  EXPECT_EQ(with("float z", "float w"),
            "room.ply:3: expected the properties x, y and z in the element vertex");
  EXPECT_EQ(with("uchar int", "uchar whole"),
            "room.ply:8: expected a type such as float, uchar or int32, found 'whole'");
  EXPECT_EQ(with("1 0 0", "1 zero 0"),
            "room.ply:11: expected finite coordinates up to 1e+12 m, found 1 nan 0 at 1 m a unit");
  EXPECT_EQ(with("1 0 0", "1 0"), "room.ply:11: the line has fewer numbers than its element");
  EXPECT_EQ(with("1 0 0", "1 0 0 4"), "room.ply:11: the line has more numbers than its element: '4' is left");
  EXPECT_EQ(with("3 0 1 2", "3 0 1 5"),
            "room.ply:13: face 0 names vertex 5, but there are only 3 (numbered from 0)");
  EXPECT_EQ(with("3 0 1 2", "3 0 1 -2"), "room.ply:13: expected the number of a vertex, from 0, found -2");
  EXPECT_EQ(with("3 0 1 2", "9 0 1 2"),
            "room.ply:13: 'vertex_index' is said to have 9 numbers, but at most 3 are left");
  EXPECT_EQ(with("3 0 1 2\n", ""),
            "room.ply:7: 1 elements 'face' are declared, which take at least 2 bytes each, but only 0 bytes "
            "are left; the file is cut off or damaged");
}

TEST_F(LoadPly, counts_beyond_the_file_allocate_nothing) {
  auto bytes = SmallCube().ply_binary(false);
  bytes.replace(bytes.find("vertex 8"), 8, "vertex 99999999999999");
  EXPECT_EQ(refusal(bytes),
            "room.ply:4: 99999999999999 elements 'vertex' are declared, which take at least 12 bytes each, "
            "but only 198 bytes are left; the file is cut off or damaged");
}

TEST_F(LoadPly, a_cut_binary_file_is_refused_with_the_byte) {
  auto bytes = SmallCube().ply_binary(false);
  bytes.resize(bytes.size() - 3);
  EXPECT_EQ(
      refusal(bytes),
      fmt::format("room.ply: at byte {}: 'vertex_indices' is said to have 4 numbers, but at most 3 are left",
                  bytes.size() - 13));
}

TEST_F(LoadPly, a_point_cloud_is_refused_with_a_remedy) {
  EXPECT_EQ(refusal("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                    "property float z\nend_header\n0 0 0\n"),
            "room.ply: no faces found, but 1 vertex position: a point cloud; make a mesh of it first, for "
            "example with MeshLab's surface reconstruction");
}

}  // namespace
}  // namespace luxel
