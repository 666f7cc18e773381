// SPDX-License-Identifier: Apache-2.0
// Geometry of glTF files: where corners come to lie, which way triangles face, how arrays are written.
#include <array>
#include <numbers>

#include <gtest/gtest.h>

#include "luxel/scene/scene.h"

#include "support/scene_files.h"
#include "support/small_gltf.h"

namespace luxel {
namespace {

class LoadGltf : public testing::Test {
 protected:
  Scene load(const SmallGltf& gltf, const LoadOptions& options = {}) {
    files_.write("room.gltf", gltf.text());
    auto scene = files_.load("room.gltf", options);
    check_scene(scene);
    return scene;
  }
  SceneFiles files_;
};

Vec3 corner(const Scene& scene, std::size_t triangle, std::size_t i) {
  return scene.positions[scene.triangles[triangle][i]];
}

// Twice the area, along the front.
Vec3 front(const Scene& scene, std::size_t triangle) {
  const auto a = corner(scene, triangle, 0);
  return glm::cross(corner(scene, triangle, 1) - a, corner(scene, triangle, 2) - a);
}

void expect_near(const Vec3& found, const Vec3& expected) {
  EXPECT_LT(glm::length(found - expected), 1e-6f)
      << fmt::format("({}, {}, {}) where ({}, {}, {}) was expected", found.x, found.y, found.z, expected.x,
                     expected.y, expected.z);
}

TEST_F(LoadGltf, a_triangle_is_read_as_it_stands) {
  auto gltf = one_triangle();
  gltf.nodes = R"({"mesh":0,"name":"wall"})";
  const auto scene = load(gltf);
  ASSERT_EQ(scene.triangles.size(), 1u);
  EXPECT_EQ(corner(scene, 0, 1), Vec3(1, 0, 0));
  expect_near(front(scene, 0), Vec3(0, 0, 1));
  EXPECT_EQ(scene.groups, std::vector<std::string>{"wall"});
  EXPECT_EQ(scene.objects, std::vector<std::string>{"wall"});
  EXPECT_EQ(scene.triangle_line, std::vector<std::uint32_t>{0});
}

TEST_F(LoadGltf, a_binary_file_says_the_same) {
  const auto gltf = one_triangle();
  files_.write("room.glb", gltf.glb());
  EXPECT_EQ(fingerprint(files_.load("room.glb")), fingerprint(load(gltf)));
}

TEST_F(LoadGltf, buffers_may_lie_beside_the_file) {
  auto gltf = one_triangle();
  files_.write("a room/its bytes.bin", gltf.buffer + "and what another program left behind them");
  files_.write("a room/room.gltf", gltf.json(R"(,"uri":"its%20bytes.bin")"));
  EXPECT_EQ(files_.load("a room/room.gltf").triangles.size(), 1u);
  files_.write("below/room.gltf", gltf.json(R"(,"uri":"../a room/its bytes.bin")"));
  EXPECT_EQ(files_.load("below/room.gltf", {.allow_outside = true}).triangles.size(), 1u);
}

TEST_F(LoadGltf, nodes_scale_then_turn_then_shift_and_stand_on_their_parents) {
  auto gltf = one_triangle();
  const auto half = std::numbers::sqrt2 / 2.0;  // a quarter turn about z: x becomes y
  gltf.nodes = fmt::format(R"({{"children":[1],"translation":[0,0,5]}},)"
                           R"({{"mesh":0,"scale":[2,3,1],"rotation":[0,0,{},{}],"translation":[10,0,0]}})",
                           half, half);
  const auto scene = load(gltf);
  expect_near(corner(scene, 0, 0), Vec3(10, 0, 5));
  expect_near(corner(scene, 0, 1), Vec3(10, 2, 5));
  expect_near(corner(scene, 0, 2), Vec3(7, 0, 5));
}

TEST_F(LoadGltf, a_matrix_stands_by_columns) {
  auto gltf = one_triangle();
  gltf.nodes = R"({"mesh":0,"matrix":[0,1,0,0, -1,0,0,0, 0,0,1,0, 4,5,6,1]})";
  const auto scene = load(gltf);
  expect_near(corner(scene, 0, 1), Vec3(4, 6, 6));
  expect_near(corner(scene, 0, 2), Vec3(3, 5, 6));
}

TEST_F(LoadGltf, a_mirrored_node_keeps_its_front) {
  auto gltf = one_triangle();
  gltf.nodes = R"({"mesh":0,"scale":[-1,1,1]})";  // seen from +z it is still the front
  const auto scene = load(gltf);
  expect_near(front(scene, 0), Vec3(0, 0, 1));
  gltf.nodes = R"({"mesh":0,"scale":[-1,-1,1]})";  // a half turn, no mirror
  expect_near(front(load(gltf), 0), Vec3(0, 0, 1));
}

TEST_F(LoadGltf, a_mesh_may_stand_in_several_places) {
  auto gltf = one_triangle();
  gltf.nodes = R"({"mesh":0,"name":"a"},{"mesh":0,"name":"b","translation":[3,0,0]},{"mesh":0,"name":"a"})";
  const auto scene = load(gltf);
  ASSERT_EQ(scene.triangles.size(), 3u);
  EXPECT_EQ(corner(scene, 1, 0), Vec3(3, 0, 0));
  EXPECT_EQ(scene.objects, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(scene.triangle_object, (std::vector<std::uint32_t>{0, 1, 0}));
}

TEST_F(LoadGltf, only_the_scene_that_is_named_is_read) {
  auto gltf = one_triangle();
  gltf.nodes = R"({"mesh":0},{"mesh":0},{"mesh":0})";
  gltf.rest = R"(,"scenes":[{"nodes":[0]},{"nodes":[1,2]}],"scene":1)";
  EXPECT_EQ(load(gltf).triangles.size(), 2u);
  gltf.rest = R"(,"scenes":[{"nodes":[0]},{"nodes":[1,2]}])";
  EXPECT_EQ(load(gltf).triangles.size(), 1u);
}

// Five points of a zigzag: (0,0) (0,1) (1,0) (1,1) (2,0).
SmallGltf zigzag(int mode, const std::string& more = "") {
  SmallGltf gltf;
  gltf.points({0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0});
  gltf.meshes =
      fmt::format(R"({{"primitives":[{{"mode":{},"attributes":{{"POSITION":0}}{}}}]}})", mode, more);
  return gltf;
}

TEST_F(LoadGltf, all_triangles_of_a_strip_face_one_way) {
  const auto scene = load(zigzag(5));
  ASSERT_EQ(scene.triangles.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) expect_near(front(scene, i), Vec3(0, 0, -1));
}

TEST_F(LoadGltf, a_fan_turns_about_its_first_corner) {
  SmallGltf gltf = zigzag(6, R"(,"indices":1)");
  gltf.array<std::uint8_t>(SmallGltf::u8, "SCALAR", 4, {0, 2, 3, 1});
  const auto scene = load(gltf);
  ASSERT_EQ(scene.triangles.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) expect_near(front(scene, i), Vec3(0, 0, 1));
}

TEST_F(LoadGltf, indices_are_of_one_two_or_four_bytes) {
  const auto with = [](auto indices, int type) {
    SmallGltf gltf = zigzag(4, R"(,"indices":1)");
    gltf.array(type, "SCALAR", indices.size(), indices);
    return gltf;
  };
  const auto bytes = load(with(std::vector<std::uint8_t>{0, 2, 1, 2, 3, 1}, SmallGltf::u8));
  EXPECT_EQ(bytes.triangles.size(), 2u);
  EXPECT_EQ(bytes.positions.size(), 4u) << "the fifth point is not used";
  for (const auto& gltf : {with(std::vector<std::uint16_t>{0, 2, 1, 2, 3, 1}, SmallGltf::u16),
                           with(std::vector<std::uint32_t>{0, 2, 1, 2, 3, 1}, SmallGltf::u32)})
    EXPECT_EQ(fingerprint(load(gltf)), fingerprint(bytes));
}

TEST_F(LoadGltf, points_and_lines_are_passed_over_with_a_warning) {
  auto gltf = one_triangle();
  gltf.meshes =
      R"({"primitives":[{"attributes":{"POSITION":0}},{"mode":1,"attributes":{"POSITION":0}},{"attributes":{}}]})";
  EXPECT_EQ(load(gltf).triangles.size(), 1u);
  EXPECT_NE(files_.all_warnings().find("2 primitives of points or lines"), std::string::npos);
}

TEST_F(LoadGltf, strided_arrays_share_a_view) {
  SmallGltf gltf;
  // Position and normal of each vertex, one after the other.
  const std::vector<float> mixed = {0, 0, 0, 9, 9, 9, 1, 0, 0, 9, 9, 9, 0, 1, 0, 9, 9, 9};
  const auto view = gltf.view(bytes_of(mixed), R"(,"byteStride":24)");
  gltf.accessor(SmallGltf::f32, "VEC3", 3, fmt::format(R"("bufferView":{})", view));
  gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0}}]})";
  EXPECT_EQ(fingerprint(load(gltf)), fingerprint(load(one_triangle())));
}

TEST_F(LoadGltf, a_sparse_array_replaces_elements_of_another_or_of_zeros) {
  SmallGltf gltf;
  const auto dense = gltf.view(bytes_of(std::vector<float>{0, 0, 0, 7, 7, 7, 0, 1, 0}));
  const auto indices = gltf.view(bytes_of(std::vector<std::uint16_t>{1}));
  const auto values = gltf.view(bytes_of(std::vector<float>{1, 0, 0}));
  gltf.accessor(
      SmallGltf::f32, "VEC3", 3,
      fmt::format(
          R"("bufferView":{},"sparse":{{"count":1,"indices":{{"bufferView":{},"componentType":5123}},)"
          R"("values":{{"bufferView":{}}}}})",
          dense, indices, values));
  gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0}}]})";
  EXPECT_EQ(fingerprint(load(gltf)), fingerprint(load(one_triangle())));

  SmallGltf zeros;
  const auto two = zeros.view(bytes_of(std::vector<std::uint8_t>{1, 2}));
  const auto both = zeros.view(bytes_of(std::vector<float>{1, 0, 0, 0, 1, 0}));
  zeros.accessor(SmallGltf::f32, "VEC3", 3,
                 fmt::format(R"("sparse":{{"count":2,"indices":{{"bufferView":{},"componentType":5121}},)"
                             R"("values":{{"bufferView":{}}}}})",
                             two, both));
  zeros.meshes = gltf.meshes;
  EXPECT_EQ(fingerprint(load(zeros)), fingerprint(load(one_triangle())));
}

TEST_F(LoadGltf, quantised_positions_are_whole_numbers_or_fractions_of_the_largest) {
  SmallGltf gltf;
  gltf.array<std::int16_t>(SmallGltf::i16, "VEC3", 3, {0, 0, 0, 32767, 0, 0, 0, 32767, 0},
                           R"(,"normalized":true)");
  gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0}}]})";
  gltf.rest = R"(,"extensionsRequired":["KHR_mesh_quantization"])";
  EXPECT_EQ(fingerprint(load(gltf)), fingerprint(load(one_triangle())));
  SmallGltf plain;
  plain.array<std::int8_t>(SmallGltf::i8, "VEC3", 3, {0, 0, 0, -5, 0, 0, 0, 7, 0});
  plain.meshes = gltf.meshes;
  EXPECT_EQ(corner(load(plain), 0, 1), Vec3(-5, 0, 0));
}

TEST_F(LoadGltf, colours_of_corners_are_kept_and_white_ones_dropped) {
  auto gltf = one_triangle();
  gltf.array<std::uint8_t>(SmallGltf::u8, "VEC4", 3, {255, 0, 51, 255, 0, 255, 0, 0, 255, 255, 255, 255},
                           R"(,"normalized":true)");
  gltf.points({0, 0, 0, 1, 0, 0, 0, 1, 0});
  gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":2}},{"attributes":{"POSITION":0,"COLOR_0":1}}]})";
  const auto scene = load(gltf);
  ASSERT_EQ(scene.corner_colours.size(), 2u);
  EXPECT_EQ(scene.corner_colours[0][2], Vec3(1.0f));
  expect_near(scene.corner_colours[1][0], Vec3(1.0f, 0.0f, 0.2f));
  auto white = one_triangle();
  white.array<float>(SmallGltf::f32, "VEC3", 3, {1, 1, 1, 2, 1, 1, 1, 1, 1});
  white.meshes = R"({"primitives":[{"attributes":{"POSITION":0,"COLOR_0":1}}]})";
  EXPECT_TRUE(load(white).corner_colours.empty());
}

TEST_F(LoadGltf, the_scale_holds_for_positions_cameras_and_lamps) {
  auto gltf = one_triangle();
  gltf.nodes = R"({"mesh":0},{"camera":0,"translation":[0,0,300]},)"
               R"({"translation":[100,0,0],"extensions":{"KHR_lights_punctual":{"light":0}}})";
  gltf.rest = R"(,"cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":0.1}}],)"
              R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"point"}]}})";
  const auto scene = load(gltf, {.scale = 0.01});
  expect_near(corner(scene, 0, 1), Vec3(0.01f, 0, 0));
  expect_near(scene.cameras.at(0).eye, Vec3(0, 0, 3));
  expect_near(scene.point_lights.at(0).position, Vec3(1, 0, 0));
}

TEST_F(LoadGltf, a_scene_far_from_zero_counts_from_an_origin) {
  auto gltf = one_triangle();
  gltf.nodes =
      R"({"children":[1,2],"translation":[1e7,0,0]},{"mesh":0,"scale":[0.001,0.001,1]},{"camera":0,"translation":[0,0,1]})";
  gltf.rest = R"(,"cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":0.1}}])";
  const auto scene = load(gltf);
  EXPECT_GT(scene.origin.x, 9e6);
  EXPECT_LT(glm::length(front(scene, 0) - Vec3(0, 0, 1e-6f)), 1e-12f);
  EXPECT_LT(std::abs(scene.cameras.at(0).eye.x), 1.0f);
}

TEST_F(LoadGltf, cameras_look_along_the_nodes_minus_z) {
  auto gltf = one_triangle();
  const auto half = std::numbers::sqrt2 / 2.0;  // a quarter turn about y: -z becomes -x
  gltf.nodes = fmt::format(
      R"({{"mesh":0}},{{"camera":1,"translation":[1,2,3],"rotation":[0,{},0,{}]}},{{"camera":0}})", half,
      half);
  gltf.rest =
      R"(,"cameras":[{"type":"orthographic"},{"type":"perspective","perspective":{"yfov":1.5707963267948966,"aspectRatio":1.5}}])";
  const auto scene = load(gltf);
  ASSERT_EQ(scene.cameras.size(), 1u);
  const auto& camera = scene.cameras[0];
  expect_near(camera.eye, Vec3(1, 2, 3));
  expect_near(glm::normalize(camera.target - camera.eye), Vec3(-1, 0, 0));
  expect_near(camera.up, Vec3(0, 1, 0));
  EXPECT_NEAR(camera.vertical_fov, 90.0f, 1e-4f);
  EXPECT_EQ(camera.aspect, 1.5f);
  EXPECT_NE(files_.all_warnings().find("1 camera without perspective"), std::string::npos);
}

TEST_F(LoadGltf, skins_and_morphs_are_taken_at_rest) {
  auto gltf = one_triangle();
  gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0},"targets":[{"POSITION":0}]}]})";
  gltf.nodes = R"({"mesh":0,"skin":0})";
  gltf.rest = R"(,"skins":[{"joints":[0]}])";
  EXPECT_EQ(load(gltf).triangles.size(), 1u);
  EXPECT_NE(files_.all_warnings().find("1 node with a skin"), std::string::npos);
  EXPECT_NE(files_.all_warnings().find("1 primitive with morph targets"), std::string::npos);
}

TEST_F(LoadGltf, loading_can_be_stopped) {
  files_.write("room.gltf", one_triangle().text());
  const auto scene = load_scene(files_.path("room.gltf"), {},
                                Context().with_monitor([](const Progress&) { return Next::stop; }));
  EXPECT_TRUE(scene.triangles.empty());
}

}  // namespace
}  // namespace luxel
