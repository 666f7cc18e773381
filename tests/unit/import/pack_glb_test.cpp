// SPDX-License-Identifier: Apache-2.0
// Packed files show the same scene as the plain ones.
#include "luxel/import/pack_glb.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/core/json.h"
#include "luxel/import/load_gltf.h"
#include "luxel/import/meshopt_encode.h"

#include "support/same_triangles.h"
#include "support/small_gltf.h"

namespace luxel {
namespace {

constexpr auto quantised = GltfPacking{.compression = GltfCompression::quantised};
constexpr auto meshopt = GltfPacking{.compression = GltfCompression::meshopt};

Scene loaded(const std::string& glb) { return load_gltf(glb, "room.glb", {}, {}); }

SortedJson json_of(const std::string& glb) {
  std::uint32_t size = 0;
  std::memcpy(&size, glb.data() + 12, 4);
  return SortedJson::parse(glb.substr(20, size));
}

// A waved sheet of 8 x 8 quads, 1 m wide, with texture coordinates, normals and
// colours.
struct Sheet {
  SmallGltf gltf;
  std::vector<float> positions;

  explicit Sheet(float red = 0.25f, float uv_scale = 1.0f) {
    constexpr std::uint32_t side = 9;
    std::vector<float> normals, uvs, colours;
    std::vector<std::uint16_t> indices;
    for (std::uint32_t y = 0; y < side; ++y)
      for (std::uint32_t x = 0; x < side; ++x) {
        const auto u = static_cast<float>(x) / 8.0f, v = static_cast<float>(y) / 8.0f;
        positions.insert(positions.end(), {u, 0.1f * std::sin(3.0f * u), v});
        normals.insert(normals.end(), {0.0f, 1.0f, 0.0f});
        uvs.insert(uvs.end(), {uv_scale * u, uv_scale * v});
        colours.insert(colours.end(), {red, 0.5f + 0.5f * u, 0.5f + 0.5f * v});
        if (x + 1 == side || y + 1 == side) continue;
        const auto corner = y * side + x;
        for (const auto offset : {0u, side, 1u, 1u, side, side + 1})
          indices.push_back(static_cast<std::uint16_t>(corner + offset));
      }
    gltf.points(positions);
    gltf.array(SmallGltf::f32, "VEC3", side * side, normals);
    gltf.array(SmallGltf::f32, "VEC2", side * side, uvs);
    gltf.array(SmallGltf::f32, "VEC3", side * side, colours);
    gltf.array(SmallGltf::u16, "SCALAR", indices.size(), indices);
    gltf.meshes = R"({"name":"sheet","primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2,)"
                  R"("COLOR_0":3},"indices":4,"material":0}]})";
    gltf.nodes = R"({"mesh":0,"name":"cloth"})";
    gltf.rest = R"(,"materials":[{"name":"linen"}])";
  }
};

SortedJson attribute(const SortedJson& file, const char* name) {
  return file["accessors"][file["meshes"][0]["primitives"][0]["attributes"][name].get<std::size_t>()];
}

TEST(PackGlb, a_quantised_file_shows_the_same_scene) {
  const auto plain = Sheet(0.01f).gltf.glb();
  const auto packed = packed_glb(plain, "room.glb", quantised);
  const auto file = json_of(packed);
  EXPECT_LT(packed.size(), 0.8 * static_cast<double>(plain.size()));
  EXPECT_EQ(file["extensionsRequired"], SortedJson::array({"KHR_mesh_quantization"}));
  EXPECT_EQ(attribute(file, "POSITION")["componentType"], SmallGltf::u16);
  EXPECT_EQ(attribute(file, "NORMAL")["componentType"], SmallGltf::i8);
  EXPECT_EQ(attribute(file, "TEXCOORD_0")["componentType"], SmallGltf::u16);
  const auto before = loaded(plain), after = loaded(packed);
  EXPECT_EQ(after.objects, before.objects);
  EXPECT_EQ(after.materials[0].name, "linen");
  test::expect_same_triangles(before, after, 0.5 * 0x1p-15);  // 1 m in 65534 steps
  for (std::size_t t = 0; t < before.corner_colours.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_LT(glm::length(before.corner_colours[t][c] - after.corner_colours[t][c]), 1.4e-5f);
}

TEST(PackGlb, a_compressed_file_shows_the_same_scene) {
  const auto plain = Sheet().gltf.glb();
  if (!has_meshopt()) {
    EXPECT_THROW(packed_glb(plain, "room.glb", meshopt), InputError);
    return;
  }
  const auto packed = packed_glb(plain, "room.glb", meshopt);
  EXPECT_LT(packed.size(), packed_glb(plain, "room.glb", quantised).size());
  const auto file = json_of(packed);
  EXPECT_EQ(file["buffers"].size(), 2u);
  EXPECT_EQ(file["buffers"][1]["extensions"]["EXT_meshopt_compression"]["fallback"], true);
  test::expect_same_triangles(loaded(plain), loaded(packed), 0.5 * 0x1p-14);  // 1 m in 32766 steps
}

TEST(PackGlb, the_node_stays_and_its_child_has_the_mesh) {
  auto gltf = Sheet().gltf;
  gltf.nodes = R"({"mesh":0,"name":"cloth","translation":[7,8,9],"rotation":[0,1,0,0],"extras":{"mine":1}})";
  gltf.rest += R"(,"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}],)"
               R"("samplers":[{"input":0,"output":0}]}])";
  const auto file = json_of(packed_glb(gltf.glb(), "room.glb", quantised));
  const auto& node = file["nodes"][0];
  EXPECT_EQ(node["translation"], SortedJson::array({7, 8, 9}));
  EXPECT_EQ(node["name"], "cloth");
  EXPECT_EQ(node["extras"]["mine"], 1);
  EXPECT_FALSE(node.contains("mesh"));
  EXPECT_EQ(node["children"], SortedJson::array({1}));
  EXPECT_EQ(file["nodes"][1]["mesh"], 0);
  EXPECT_EQ(file["animations"][0]["channels"][0]["target"]["node"], 0);
}

// Three sheets with arrays of their own: the second continues the first, the third is turned by a quarter and
// begins at the same corner. Their nodes are shifted by no multiple of the step.
TEST(PackGlb, vertices_that_meet_still_do) {
  const Sheet sheet;
  auto gltf = sheet.gltf;
  const auto add = [&](const Vec3& shift) {
    auto moved = sheet.positions;
    for (std::size_t i = 0; i < moved.size(); ++i) moved[i] += shift[static_cast<int>(i % 3)];
    gltf.meshes += fmt::format(R"(,{{"primitives":[{{"attributes":{{"POSITION":{}}},"indices":4}}]}})",
                               gltf.points(moved));
  };
  add({0, 0, -0.37f});
  add({0.21f, 0, 0.13f});
  gltf.nodes =
      R"({"mesh":0,"translation":[0.3,0,0]},{"mesh":1,"translation":[0.3,0,1.37]},)"
      R"({"mesh":2,"translation":[0.17,0,0.21],"rotation":[0,0.7071067811865476,0,0.7071067811865476]})";
  const auto before = loaded(gltf.glb()), after = loaded(packed_glb(gltf.glb(), "room.glb", quantised));
  test::expect_same_triangles(before, after, 0x1p-16);
  std::set<std::pair<std::uint32_t, std::uint32_t>> meetings;  // vertices of different sheets
  for (std::uint32_t a = 0; a < before.positions.size(); ++a)
    for (std::uint32_t b = a + 1; b < before.positions.size(); ++b)
      if (glm::length(before.positions[a] - before.positions[b]) < 1e-6f) meetings.insert({a, b});
  EXPECT_EQ(meetings.size(), 9u + 1u);
  for (const auto& meeting : meetings)
    EXPECT_LT(glm::length(after.positions[meeting.first] - after.positions[meeting.second]), 1e-6f);
}

TEST(PackGlb, instances_use_the_same_arrays) {
  auto gltf = Sheet().gltf;
  const auto once = packed_glb(gltf.glb(), "room.glb", quantised);
  gltf.nodes += R"(,{"mesh":0,"translation":[3,0,0.1]})";
  const auto twice = packed_glb(gltf.glb(), "room.glb", quantised);
  EXPECT_LT(twice.size(), once.size() + 400);
  test::expect_same_triangles(loaded(gltf.glb()), loaded(twice), 0x1p-15);
}

TEST(PackGlb, dark_colours_have_16_bits_and_bright_ones_8) {
  const auto type = [](float red, bool is_srgb) {
    auto packing = quantised;
    packing.colours_are_srgb = is_srgb;
    const auto packed = packed_glb(Sheet(red).gltf.glb(), "room.glb", packing);
    return attribute(json_of(packed), "COLOR_0")["componentType"].get<int>();
  };
  EXPECT_EQ(type(0.01f, false), SmallGltf::u16);
  EXPECT_EQ(type(0.9f, false), SmallGltf::u8);
  EXPECT_EQ(type(0.01f, true), SmallGltf::u8);
}

TEST(PackGlb, texture_coordinates_that_repeat_stay_floats) {
  const auto packed = packed_glb(Sheet(0.5f, 3.0f).gltf.glb(), "room.glb", quantised);
  EXPECT_EQ(attribute(json_of(packed), "TEXCOORD_0")["componentType"], SmallGltf::f32);
}

TEST(PackGlb, a_mesh_that_is_too_large_keeps_floats) {
  auto gltf = Sheet().gltf;
  gltf.nodes = R"({"mesh":0,"scale":[100,1,1]})";
  const auto packed = packed_glb(gltf.glb(), "room.glb", quantised);
  const auto file = json_of(packed);
  EXPECT_EQ(attribute(file, "POSITION")["componentType"], SmallGltf::f32);
  EXPECT_EQ(file["nodes"].size(), 1u);
  test::expect_same_triangles(loaded(gltf.glb()), loaded(packed), 0.0);

  // Beside one that fits, its floats are rounded to the same grid, for vertices that meet.
  gltf.points({0, 0, 0, 1, 0, 0, 0, 0, 1});
  gltf.meshes += R"(,{"primitives":[{"attributes":{"POSITION":5}}]})";
  gltf.nodes += R"(,{"mesh":1})";
  test::expect_same_triangles(loaded(gltf.glb()), loaded(packed_glb(gltf.glb(), "room.glb", quantised)),
                              0.5 * 0x1p-15);
}

TEST(PackGlb, programs_without_the_extension_get_what_glTF_has) {
  auto packing = quantised;
  packing.core_only = true;
  const auto file = json_of(packed_glb(Sheet().gltf.glb(), "room.glb", packing));
  EXPECT_FALSE(file.contains("extensionsRequired"));
  EXPECT_EQ(attribute(file, "POSITION")["componentType"], SmallGltf::f32);
  EXPECT_EQ(attribute(file, "NORMAL")["componentType"], SmallGltf::f32);
  EXPECT_EQ(attribute(file, "TEXCOORD_0")["componentType"], SmallGltf::u16);
}

TEST(PackGlb, morph_targets_and_skins_stay_as_they_are) {
  auto morphed = Sheet().gltf;
  morphed.meshes.insert(morphed.meshes.find(R"("indices")"), R"("targets":[{"POSITION":0}],)");
  EXPECT_EQ(packed_glb(morphed.glb(), "room.glb", quantised), morphed.glb());
  auto skinned = Sheet().gltf;
  skinned.nodes = R"({"mesh":0,"skin":0},{})";
  skinned.rest += R"(,"skins":[{"joints":[1]}])";
  EXPECT_EQ(packed_glb(skinned.glb(), "room.glb", quantised), skinned.glb());
}

TEST(PackGlb, a_file_with_unknown_extensions_stays_as_it_is) {
  auto gltf = Sheet().gltf;
  gltf.rest += R"(,"extensionsUsed":["FREE_wind"])";
  EXPECT_EQ(packed_glb(gltf.glb(), "room.glb", quantised), gltf.glb());
}

TEST(PackGlb, positions_that_are_not_finite_stay_floats) {
  auto gltf = Sheet().gltf;
  gltf.points({0, 0, std::numeric_limits<float>::quiet_NaN(), 1, 0, 0, 0, 0, 1});
  gltf.meshes += R"(,{"primitives":[{"attributes":{"POSITION":5},"mode":0}]})";
  gltf.nodes += R"(,{"mesh":1},{"mesh":77,"name":"astray"})";
  gltf.rest += R"(,"scene":0,"scenes":[{"nodes":[0,1]}])";
  const auto file = json_of(packed_glb(gltf.glb(), "room.glb", quantised));
  EXPECT_EQ(attribute(file, "POSITION")["componentType"], SmallGltf::u16);
  EXPECT_EQ(file["nodes"][1]["mesh"], 1);
  EXPECT_EQ(file["nodes"][2]["mesh"], 77);
}

TEST(PackGlb, arrays_that_nothing_can_read_stay_as_they_are) {
  auto gltf = Sheet().gltf;
  gltf.meshes.insert(gltf.meshes.find(R"("COLOR_0")"), R"("TEXCOORD_3":77,)");
  EXPECT_EQ(packed_glb(gltf.glb(), "room.glb", quantised), gltf.glb());
}

}  // namespace
}  // namespace luxel
