// SPDX-License-Identifier: Apache-2.0
// Files with flat surfaces of needles, which Luxel triangulates again: they are written with the triangles
// that carry the light, and all that their vertices had goes on between these.
#include <gtest/gtest.h>

#include "luxel/image/image.h"
#include "luxel/surface/make_charts.h"

#include "support/lightmap_places.h"
#include "support/round_trip_file.h"

namespace luxel {
namespace {

using namespace test;

constexpr int steps = 40;
constexpr double wall = 80.0, plate = 2.0;  // m²

// A wall of 20 m x 4 m whose top has a vertex every 0.5 m, as a fan around its lower left corner; two nodes
// show it, one mirrored. Between them and after them a plate of two triangles.
SmallGltf walls_of_needles() {
  std::vector<float> points{0, 0, 0, 20, 0, 0}, uv, colours, normals;
  for (int i = 0; i <= steps; ++i) points.insert(points.end(), {0.5f * static_cast<float>(i), 4.0f, 0.0f});
  std::vector<std::uint8_t> indices{0, 1, steps + 2};
  for (int i = steps; i > 0; --i)
    indices.insert(indices.end(), {0, static_cast<std::uint8_t>(i + 2), static_cast<std::uint8_t>(i + 1)});
  for (std::size_t v = 0; v < points.size(); v += 3) {
    uv.insert(uv.end(), {points[v] / 4.0f, points[v + 1] / 4.0f});
    colours.insert(colours.end(), {points[v] / 20.0f, points[v + 1] / 4.0f, 0.5f});
    normals.insert(normals.end(), {0.0f, 0.0f, 1.0f});
  }
  const auto count = points.size() / 3;
  SmallGltf gltf;
  gltf.points(points);
  gltf.array<std::uint8_t>(SmallGltf::u8, "SCALAR", indices.size(), indices);
  gltf.array<float>(SmallGltf::f32, "VEC2", count, uv);
  gltf.array<float>(SmallGltf::f32, "VEC3", count, colours);
  gltf.array<float>(SmallGltf::f32, "VEC3", count, normals);
  gltf.points({0, 0, 3, 2, 0, 3, 2, 1, 3, 0, 1, 3});
  gltf.array<std::uint8_t>(SmallGltf::u8, "SCALAR", 6, {0, 1, 2, 0, 2, 3});
  gltf.meshes =
      R"({"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2,"COLOR_0":3,"NORMAL":4},"indices":1,)"
      R"("material":0}]},{"primitives":[{"attributes":{"POSITION":5},"indices":6,"material":0}]})";
  gltf.nodes = R"({"mesh":0,"translation":[-8,0,4]},{"mesh":1,"translation":[0,0,4]},)"
               R"({"mesh":0,"translation":[12,0,10],"scale":[-1,1,1]},{"mesh":1,"translation":[0,0,10]})";
  gltf.rest = R"(,"materials":[{"doubleSided":true}])";
  return gltf;
}

// The surfaces of both sides are whole, and each vertex has what belongs to its place. Returns how many
// triangles of walls there are.
std::size_t expect_attributes_of_place(GltfFile& file) {
  double area = 0.0;
  std::size_t of_walls = 0;
  for_triangles(file, [&](const GltfPart& part, const std::array<Vertex, 3>& triangle) {
    const auto& attributes = part.primitive["attributes"];
    const GltfArray light(file, attributes["_IRRADIANCE"], 3, 3);
    const bool is_front = normal_of(triangle).z > 0.0;
    area += 0.5 * glm::length(normal_of(triangle));
    for (const auto& vertex : triangle) {
      const Vec3 place(vertex.place);
      EXPECT_NEAR(light.at(vertex.number)[0], is_front ? linear_front(place) : linear_back(place), 5e-4f);
    }
    if (!attributes["TEXCOORD_0"]) return;
    ++of_walls;
    const GltfArray positions(file, attributes["POSITION"], 3, 3), uvs(file, attributes["TEXCOORD_0"], 2, 2),
        normals(file, attributes["NORMAL"], 3, 3);
    for (const auto& vertex : triangle) {
      const auto p = positions.at(vertex.number), uv = uvs.at(vertex.number);
      EXPECT_NEAR(uv[0], p[0] / 4, 1e-5f);
      EXPECT_NEAR(uv[1], p[1] / 4, 1e-5f);
      EXPECT_NEAR(std::abs(normals.at(vertex.number)[2]), 1.0f, 1e-6f);
    }
  });
  EXPECT_NEAR(area, 2.0 * (2.0 * wall + 2.0 * plate), 1e-3);
  return of_walls;
}

TEST_F(ExportRoundTrip, surfaces_that_were_triangulated_again_are_written_so) {
  files_.write("walls.glb", walls_of_needles().glb());
  solve("walls.glb", 2.0f);
  ASSERT_EQ(scene_.retriangulated.size(), 2u);
  cut();
  auto file = lit();
  EXPECT_GT(expect_attributes_of_place(file), 4u * steps);
}

TEST_F(ExportRoundTrip, uncut_surfaces_have_the_points_that_were_added) {
  files_.write("walls.glb", walls_of_needles().glb());
  solve("walls.glb", 2.0f);
  uncut();
  auto file = lit();
  std::size_t triangles = 0;
  for (const auto& surface : scene_.retriangulated) triangles += surface.triangles.size();
  EXPECT_EQ(expect_attributes_of_place(file), 2u * triangles) << "both sides";
}

TEST_F(ExportRoundTripPages, lightmaps_cover_surfaces_that_were_triangulated_again) {
  files_.write("walls.glb", walls_of_needles().glb());
  solve("walls.glb", 2.0f);
  const auto atlas = new_atlas(patches_, solution_, {.texel = 0.25f, .page_size = 256});
  const std::vector<Image> pages(static_cast<std::size_t>(atlas.pages),
                                 Image(atlas.page_size, atlas.page_size));
  export_round_trip_lightmap(out(), input(), {atlas, pages, 1.0f}, {});
  auto file = lit();
  double area = 0.0;
  for_triangles(file, [&](const GltfPart& part, const std::array<Vertex, 3>& triangle) {
    EXPECT_TRUE(part.primitive["attributes"]["TEXCOORD_1"] || part.primitive["attributes"]["TEXCOORD_0"]);
    area += 0.5 * glm::length(normal_of(triangle));
  });
  EXPECT_NEAR(area, 2.0 * (2.0 * wall + 2.0 * plate), 1e-3);
}

TEST_F(ExportRoundTrip, a_file_that_is_loaded_as_it_is_keeps_its_needles) {
  files_.write("walls.glb", walls_of_needles().glb());
  EXPECT_EQ(files_.load("walls.glb", {.retriangulate = false}).triangles.size(), 2u * (steps + 1) + 4u);
}

}  // namespace
}  // namespace luxel
