// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstring>
#include <numbers>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/export/export_mesh.h"
#include "luxel/image/image.h"

#include "support/lit_patches.h"

namespace luxel {
namespace {

using test::LitPatches;
using test::plain_material;

constexpr float pi_f = std::numbers::pi_v<float>;
const ExportOptions clamped = {.tone = {.op = ToneOperator::clamp}};  // shows radiance as it is, up to 1

struct PlyVertex {
  std::array<float, 6> position_normal;
  std::array<unsigned char, 3> colour;
  std::array<float, 3> irradiance;
};
struct Ply {
  std::string header;
  std::vector<PlyVertex> vertices;
  std::vector<std::array<std::int32_t, 3>> faces;
};

// Reads what stands at the cursor and moves it on.
template <typename T>
T take(const std::string& bytes, std::size_t& at) {
  T value{};
  if (at + sizeof(T) > bytes.size()) throw std::out_of_range("the PLY ends too early");
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  at += sizeof(T);
  return value;
}

Ply parsed(const std::string& bytes, std::size_t vertices, std::size_t faces) {
  Ply ply;
  auto at = bytes.find("end_header\n") + 11;
  ply.header = bytes.substr(0, at);
  for (std::size_t i = 0; i < vertices; ++i) {
    PlyVertex v{};
    v.position_normal = take<std::array<float, 6>>(bytes, at);
    v.colour = take<std::array<unsigned char, 3>>(bytes, at);
    v.irradiance = take<std::array<float, 3>>(bytes, at);
    ply.vertices.push_back(v);
  }
  for (std::size_t i = 0; i < faces; ++i) {
    EXPECT_EQ(take<unsigned char>(bytes, at), 3);
    ply.faces.push_back(take<std::array<std::int32_t, 3>>(bytes, at));
  }
  EXPECT_EQ(at, bytes.size());
  return ply;
}

std::filesystem::path file(const std::string& name) {
  return std::filesystem::path(testing::TempDir()) / ("export_ply_" + name + ".ply");
}

std::string exported(const LitPatches& lit) {
  const auto path = file(testing::UnitTest::GetInstance()->current_test_info()->name());
  export_ply(path, lit.patches, lit.solution, make_smooth_light(lit.patches, lit.solution), clamped);
  return read_file(path);
}

// One triangle, lit by pi on its front and 0.5 pi on its back, and a lamp far off.
LitPatches triangle_and_lamp() {
  LitPatches lit({plain_material("grey", 0.5f), plain_material("lamp", 0.0f, false, 2.0f * pi_f)});
  const auto a = lit.vertex({0, 0, 0}), b = lit.vertex({1, 0, 0}), c = lit.vertex({0, 1, 0});
  const auto d = lit.vertex({5, 0, 7}), e = lit.vertex({6, 0, 7}), f = lit.vertex({5, 1, 7});
  lit.patch({a, b, c}, pi_f, 0.5f * pi_f, 0);
  lit.patch({d, e, f}, 0.0f, 0.0f, 1);
  return lit;
}

TEST(ExportPly, the_header_says_what_follows) {
  EXPECT_EQ(parsed(exported(triangle_and_lamp()), 9, 3).header,
            "ply\n"
            "format binary_little_endian 1.0\n"
            "comment light by Luxel, irradiance in W/m2\n"
            "element vertex 9\n"
            "property float x\nproperty float y\nproperty float z\n"
            "property float nx\nproperty float ny\nproperty float nz\n"
            "property uchar red\nproperty uchar green\nproperty uchar blue\n"
            "property float irradiance_red\nproperty float irradiance_green\nproperty float irradiance_blue\n"
            "element face 3\n"
            "property list uchar int vertex_indices\n"
            "end_header\n");
}

TEST(ExportPly, vertices_carry_light_and_colour_of_their_side) {
  const auto ply = parsed(exported(triangle_and_lamp()), 9, 3);
  const auto grey = [](float linear) { return std::lround(255.0f * srgb_encode(linear)); };
  for (std::size_t v = 0; v < 3; ++v)
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_FLOAT_EQ(ply.vertices[v].irradiance[c], pi_f);
      EXPECT_EQ(ply.vertices[v].colour[c], grey(0.5f));
      EXPECT_FLOAT_EQ(ply.vertices[3 + v].irradiance[c], 0.5f * pi_f);
      EXPECT_EQ(ply.vertices[3 + v].colour[c], grey(0.25f));
      EXPECT_EQ(ply.vertices[6 + v].irradiance[c], 0.0f);
      EXPECT_EQ(ply.vertices[6 + v].colour[c], 255);
    }
  EXPECT_EQ(ply.vertices[1].position_normal, (std::array<float, 6>{1, 0, 0, 0, 0, 1}));
  EXPECT_EQ(ply.vertices[4].position_normal[5], -1.0f);
  EXPECT_EQ(ply.vertices[8].position_normal, (std::array<float, 6>{5, 1, 7, 0, 0, 1}));
}

TEST(ExportPly, faces_count_through_all_parts_and_backs_are_turned) {
  const auto ply = parsed(exported(triangle_and_lamp()), 9, 3);
  EXPECT_EQ(ply.faces[0], (std::array<std::int32_t, 3>{0, 1, 2}));
  EXPECT_EQ(ply.faces[1], (std::array<std::int32_t, 3>{3, 5, 4}));
  EXPECT_EQ(ply.faces[2], (std::array<std::int32_t, 3>{6, 7, 8}));
}

TEST(ExportPly, the_same_light_gives_the_same_bytes) {
  const auto first = exported(triangle_and_lamp());
  EXPECT_EQ(first, exported(triangle_and_lamp()));
}

TEST(ExportPly, what_cannot_be_written_is_said) {
  auto lit = triangle_and_lamp();
  const auto light = make_smooth_light(lit.patches, lit.solution);
  EXPECT_THROW(export_ply("/dev/full", lit.patches, lit.solution, light), DeviceError);
  EXPECT_THROW(export_ply(file("no_such_folder") / "a.ply", lit.patches, lit.solution, light), DeviceError);
  lit.solution.bands = lit.patches.bands = {"a", "b", "c"};
  EXPECT_THROW(export_ply(file("bands"), lit.patches, lit.solution, light), MismatchError);
}

}  // namespace
}  // namespace luxel
