// SPDX-License-Identifier: Apache-2.0
// glTF files with light on them: their contents are preserved, and every vertex has the light of its place.
#include "luxel/export/export_round_trip.h"

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/render/ceiling_luminaires.h"

#include "support/round_trip_file.h"

namespace luxel {
namespace {

using namespace test;

// Every vertex of a triangle has the light of its place: of the front, or of the back where the triangle
// faces against the scene's own at that place. Returns the areas of both.
std::array<double, 2> expect_light_of_place(GltfFile& file, const Scene& scene, float tolerance = 5e-4f) {
  std::array<double, 2> area{};
  for_triangles(file, [&](const GltfPart& part, const std::array<Vertex, 3>& triangle) {
    const GltfArray light(file, part.primitive["attributes"]["_IRRADIANCE"], 3, 3);
    const auto normal = normal_of(triangle);
    const auto middle = (triangle[0].place + triangle[1].place + triangle[2].place) / 3.0;
    bool is_front = false, found = false;
    for (const auto& t : scene.triangles) {  // the scene's triangle that lies here
      const auto a = Vec3d(scene.positions[t[0]]), b = Vec3d(scene.positions[t[1]]),
                 c = Vec3d(scene.positions[t[2]]);
      const auto n = glm::cross(b - a, c - a);
      const auto inside = [&](const Vec3d& p, const Vec3d& q) {
        return glm::dot(glm::cross(q - p, middle - p), n) >= -1e-9;
      };
      if (std::abs(glm::dot(middle - a, glm::normalize(n))) > 1e-5 || !inside(a, b) || !inside(b, c) ||
          !inside(c, a))
        continue;
      found = true;
      is_front = glm::dot(n, normal) > 0.0;
    }
    ASSERT_TRUE(found);
    area[is_front ? 0 : 1] += 0.5 * glm::length(normal);
    for (const auto& vertex : triangle) {
      const auto expected = is_front ? linear_front(Vec3(vertex.place)) : linear_back(Vec3(vertex.place));
      for (const auto band : {0, 1, 2})
        EXPECT_NEAR(light.at(vertex.number)[band], expected, tolerance)
            << part.object << fmt::format(" at ({}, {}, {})", vertex.place.x, vertex.place.y, vertex.place.z);
    }
  });
  return area;
}

TEST_F(ExportRoundTrip, every_vertex_of_cut_surfaces_has_the_light_of_its_place) {
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.4f);
  cut();
  auto file = lit();
  const auto area = expect_light_of_place(file, scene_);
  EXPECT_NEAR(area[0], plates + strip, 1e-4);
  EXPECT_NEAR(area[1], plates, 1e-4) << "the strip's back takes no light";
}

TEST_F(ExportRoundTrip, the_files_own_vertices_have_the_light_of_their_places) {
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.4f);
  uncut();
  auto file = lit();
  const auto area = expect_light_of_place(file, scene_);
  EXPECT_NEAR(area[0], plates + strip, 1e-4);
  EXPECT_NEAR(area[1], plates, 1e-4);
}

TEST_F(ExportRoundTrip, what_the_file_says_stays) {
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.4f);
  cut();
  const auto file = lit();
  const auto& root = file.root();
  EXPECT_EQ(root["extras"].text(), "a room");
  EXPECT_EQ(root["extensions"]["FREE_wind"]["speed"].whole(), 3u);
  EXPECT_EQ(root["nodes"].size(), 6u);
  EXPECT_EQ(root["nodes"][0]["name"].text(), "one");
  EXPECT_EQ(root["nodes"][0]["extras"][0].text(), "kept");
  EXPECT_EQ(root["nodes"][1]["children"][0].whole(), 2u);
  EXPECT_EQ(root["materials"][1]["extras"]["of"].text(), "mine");
  EXPECT_TRUE(root["nodes"][5]["extensions"]["KHR_lights_punctual"]);
  for (const std::size_t node : {0, 2, 3}) {  // each has the mesh for itself
    const auto mesh = file.object(root["nodes"][node]["mesh"], "meshes");
    EXPECT_EQ(mesh["name"].text(), "plate");
    EXPECT_EQ(mesh["primitives"][0]["extras"]["mine"].whole(), 7u);
  }
  EXPECT_NE(root["nodes"][0]["mesh"].whole(), root["nodes"][2]["mesh"].whole());
}

TEST_F(ExportRoundTrip, new_vertices_have_texture_coordinates_between_the_old_ones) {
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.4f);
  cut();
  auto file = lit();
  std::size_t seen = 0;
  for_triangles(file, [&](const GltfPart& part, const std::array<Vertex, 3>& triangle) {
    const auto place = part.primitive["attributes"]["TEXCOORD_0"];
    if (!place) return;
    const GltfArray uvs(file, place, 2, 2);
    const GltfArray positions(file, part.primitive["attributes"]["POSITION"], 3, 3);
    for (const auto& vertex : triangle) {
      const auto uv = uvs.at(vertex.number), p = positions.at(vertex.number);
      EXPECT_NEAR(uv[0], p[0] / 2, 1e-6f);
      EXPECT_NEAR(uv[1], p[1] / 2, 1e-6f);
      ++seen;
    }
  });
  EXPECT_GT(seen, 500u);
}

// The plate again, wound the other way: Luxel keeps one of the two, lit on both sides.
TEST_F(ExportRoundTrip, a_primitive_that_lies_on_another_one_goes) {
  auto gltf = small_room();
  gltf.array<std::uint8_t>(SmallGltf::u8, "SCALAR", 6, {0, 2, 1, 0, 3, 2});
  const std::string twin = R"({"attributes":{"POSITION":0},"indices":5})";
  gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2},"indices":1},)" + twin +
                R"(]},{"primitives":[)" + twin + "]}";
  gltf.nodes = R"({"mesh":0},{"mesh":1,"name":"twin"})";
  gltf.rest = "";
  files_.write("room.glb", gltf.glb());
  solve("room.glb", 0.4f);
  cut();
  auto file = lit();
  std::array<double, 2> area{};
  for_triangles(file, [&](const GltfPart& part, const std::array<Vertex, 3>& triangle) {
    const auto normal = normal_of(triangle);
    area[normal.z > 0.0 ? 0 : 1] += 0.5 * glm::length(normal);
    EXPECT_TRUE(part.primitive["attributes"]["COLOR_0"]);
  });
  EXPECT_NEAR(area[0], 2.0, 1e-5);
  EXPECT_NEAR(area[1], 2.0, 1e-5);
  EXPECT_EQ(file.root()["nodes"][1]["name"].text(), "twin");
  EXPECT_FALSE(file.root()["nodes"][1]["mesh"]);
}

TEST_F(ExportRoundTrip, luminaires_that_were_added_to_the_scene_are_left_out) {
  const auto triangles = [&] {
    std::size_t count = 0;
    auto file = lit();
    for_triangles(file, [&](const auto&, const auto&) { ++count; });
    return count;
  };
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.0f);
  uncut();
  const auto without = triangles();
  add_luminaires({{Vec3(1, 5, 1), Vec3(1, 5, 0), Vec3(0, 5, 0), Vec3(0, 5, 1)}}, Vec3(1.0f), scene_);
  patches_ = make_patches(scene_, {.max_edge = 0.0f});
  solution_ = linear_light(patches_);
  cut();
  EXPECT_EQ(triangles(), without);
  uncut();
  EXPECT_EQ(triangles(), without);
  // A scene with one more triangle is another scene.
  scene_.added_triangles = 1;
  EXPECT_THROW(uncut(), MismatchError);
}

TEST_F(ExportRoundTrip, a_picture_that_is_missing_stays_so) {
  auto gltf = small_room();
  gltf.rest += R"(,"images":[{"uri":"lost.png"}],"textures":[{"source":0}])";
  files_.write("room.glb", gltf.glb());
  solve("room.glb", 0.4f);
  cut();
  EXPECT_EQ(lit().root()["images"][0]["uri"].text(), "lost.png");
}

// A large vertex array of which few vertices are used, and an array that is too short for it. Data that Luxel
// does not read may be wrong too: they are named in an error, or left as they are.
TEST_F(ExportRoundTrip, damage_in_parts_that_nobody_reads_is_answered) {
  const auto refusal = [&](const SmallGltf& gltf) -> std::string {
    files_.write("room.gltf", gltf.text());
    solve("room.gltf", 0.4f);
    try {
      cut();
      uncut();
      return "written";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  const auto expect = [](const std::string& found, const std::string& words) {
    EXPECT_NE(found.find(words), std::string::npos) << found;
  };
  for (const auto* place : {R"(,"byteOffset":[1])", R"(,"byteOffset":-4)", R"(,"byteOffset":99999)"}) {
    auto gltf = small_room();
    gltf.views += fmt::format(R"(,{{"buffer":0,"byteLength":4{}}})", place);
    expect(refusal(gltf), "room.gltf: /bufferViews/5");
  }
  auto used = small_room();
  used.rest.replace(used.rest.find(R"("FREE_wind"])"), 11, "7");
  expect(refusal(used), "room.gltf: /extensionsUsed/1: expected");
  for (const auto* more : {R"("animations":[{"samplers":[{"input":99,"output":"x"},3]}])",
                           R"("skins":[{"inverseBindMatrices":-1}])", R"("animations":7,"skins":{"a":1})",
                           R"("textures":{},"samplers":5)", R"("textures":[{"source":9,"sampler":{}},4])"}) {
    auto gltf = small_room();
    gltf.rest += std::string(",") + more;
    EXPECT_EQ(refusal(gltf), "written") << more;
  }
  auto sparse = small_room();
  sparse.accessors += R"(,{"componentType":5126,"type":"SCALAR","count":1,"sparse":3})";
  EXPECT_EQ(refusal(sparse), "written");
}

TEST_F(ExportRoundTrip, vertices_that_nothing_uses_are_not_written_again) {
  auto gltf = small_room();
  std::vector<float> points = {0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0};
  points.resize(3 * 1000);
  gltf.points(points);
  gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":5},"indices":1,"material":1}]})";
  gltf.nodes = R"({"mesh":0})";
  files_.write("room.glb", gltf.glb());
  solve("room.glb", 0.4f);
  cut();
  auto file = lit();
  for (const auto& part : drawn_parts(file, placed_nodes(file)).parts)
    EXPECT_LT(GltfArray(file, part.primitive["attributes"]["POSITION"], 3, 3).size(), 100u);
  expect_light_of_place(file, scene_);

  gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0,"NORMAL":6},"indices":1,"material":1}]})";
  gltf.array<float>(SmallGltf::f32, "VEC3", 1, {0, 0, 1});
  files_.write("room.glb", gltf.glb());
  solve("room.glb", 0.4f);
  try {
    cut();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("/attributes/NORMAL: expected 4 elements, found 1"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(ExportRoundTrip, the_files_own_arrays_are_not_touched_where_it_keeps_its_triangles) {
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.4f);
  uncut();
  auto file = lit();
  GltfFile before(files_.path("room.glb"), known_extensions());
  const auto bytes_at = [](GltfFile& of, const char* attribute) {
    const auto accessor =
        of.object(of.root()["meshes"][0]["primitives"][0]["attributes"][attribute], "accessors");
    return std::string(of.view(accessor["bufferView"]));
  };
  for (const auto* attribute : {"POSITION", "NORMAL", "TEXCOORD_0"})
    EXPECT_EQ(bytes_at(file, attribute), bytes_at(before, attribute));
  const auto front = file.root()["meshes"][0]["primitives"][0];
  EXPECT_EQ(file.object(front["indices"], "accessors")["componentType"].whole(), 5121u);
}

TEST_F(ExportRoundTrip, the_back_turns_its_normals_and_the_front_is_seen_from_the_front_alone) {
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.4f);
  uncut();
  auto file = lit();
  const auto primitives = file.root()["meshes"][0]["primitives"];
  ASSERT_EQ(primitives.size(), 2u);
  EXPECT_EQ(GltfArray(file, primitives[1]["attributes"]["NORMAL"], 3, 3).at(0)[2], -1.0f);
  EXPECT_FALSE(file.object(primitives[0]["material"], "materials")["doubleSided"].truth(true));
}

// Any spelling of the ending: a file that is read as glTF is exported by the round trip as glTF.
TEST_F(ExportRoundTrip, a_file_is_kept_however_its_ending_is_written) {
  for (const auto* name : {"room.Glb", "room.GLB", "room.gLb"}) {
    files_.write(name, small_room().glb());
    solve(name, 0.4f);
    cut();
    EXPECT_EQ(lit().root()["nodes"][0]["name"].text(), "one") << name;
    EXPECT_EQ(lit().root()["extensions"]["FREE_wind"]["speed"].whole(), 3u) << name;
  }
}

TEST_F(ExportRoundTrip, other_formats_become_what_they_would_be_as_gltf) {
  files_.write("room.mtl", "newmtl red\nKd 0.5 0.1 0.1\nnewmtl lamp\nKd 0.2 0.2 0.2\nKe 3 2 1\n");
  files_.write("room.obj",
               "mtllib room.mtl\no table\nusemtl red\nv 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n"
               "usemtl lamp\nv 0 0 1\nv 1 0 1\nv 0 1 1\nf 5 6 7\no chair\nusemtl red\nf 3 2 6\n");
  solve("room.obj", 0.3f);
  uncut();
  auto file = lit();
  // On surfaces with few patches, smooth light flattens slopes by some 1e-4 of the light.
  expect_light_of_place(file, scene_, 2e-3f);
  std::vector<std::string> names;
  for (const auto& part : drawn_parts(file, placed_nodes(file)).parts)
    names.push_back(part.object + "/" + file.object(part.primitive["material"], "materials")["name"].text());
  const std::vector<std::string> fronts = {"table/red",  "table/lamp", "table/red",
                                           "table/lamp", "chair/red",  "chair/red"};
  EXPECT_EQ(names, fronts) << "backs behind";
}

TEST_F(ExportRoundTrip, a_pane_of_another_format_is_there_and_lets_all_through) {
  files_.write("room.mtl", "newmtl red\nKd 0.5 0.1 0.1\nnewmtl glass\nKd 0 0 0\nd 0.1\n");
  files_.write("room.obj",
               "mtllib room.mtl\nusemtl red\nv 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n"
               "usemtl glass\nv 0 0 1\nv 1 0 1\nv 0 1 1\nf 5 6 7\n");
  solve("room.obj", 0.3f);
  uncut();
  const auto file = lit();
  const auto materials = file.root()["materials"];
  ASSERT_EQ(materials[1]["name"].text(), "glass");
  EXPECT_EQ(materials[1]["alphaMode"].text(), "BLEND");
  EXPECT_EQ(materials[1]["pbrMetallicRoughness"]["baseColorFactor"][3].number(), 0.0);
  EXPECT_EQ(materials[0]["pbrMetallicRoughness"]["baseColorFactor"][3].number(), 1.0);
}

TEST_F(ExportRoundTrip, another_file_is_refused) {
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.4f);
  files_.write("room.glb", one_triangle().glb());
  EXPECT_THROW(cut(), MismatchError);
  EXPECT_FALSE(std::filesystem::exists(out()));
}

// The same input gives the same bytes.
TEST_F(ExportRoundTrip, repeats) {
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.4f);
  cut();
  const auto once = read_file(out());
  cut();
  EXPECT_EQ(read_file(out()), once);
}

}  // namespace
}  // namespace luxel
