// SPDX-License-Identifier: Apache-2.0
// glTF files with light on them: what they said stays, and every vertex has the light of its place.
#include "luxel/export/export_kept.h"

#include <cmath>
#include <fstream>
#include <functional>

#include <gtest/gtest.h>

#include "luxel/file/output_file.h"
#include "luxel/gltf/gltf_array.h"
#include "luxel/gltf/gltf_parts.h"
#include "luxel/lightmap/lightmap.h"
#include "luxel/lightmap/make_charts.h"
#include "luxel/lightmap/texel_places.h"
#include "luxel/patch/make_patches.h"
#include "luxel/report/error.h"

#include "support/linear_light.h"
#include "support/scene_files.h"
#include "support/small_gltf.h"

namespace luxel {
namespace {

using test::linear_back;
using test::linear_front;
using test::linear_light;

// A quad of 2 x 1 that three nodes show: as it is, turned and scaled below a parent, and mirrored. Beside it
// a strip without indices whose vertices nothing else has; things that Luxel knows nothing of, and a point
// light.
SmallGltf small_room() {
  SmallGltf gltf;
  gltf.points({0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0});
  gltf.array<std::uint8_t>(SmallGltf::u8, "SCALAR", 6, {0, 1, 2, 0, 2, 3});
  gltf.array<float>(SmallGltf::f32, "VEC2", 4, {0, 0, 1, 0, 1, 0.5f, 0, 0.5f});
  gltf.array<float>(SmallGltf::f32, "VEC3", 4, {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  gltf.points({5, 0, 0, 6, 0, 0, 5, 1, 0, 6, 1, 1, 5, 2, 1});
  gltf.meshes = R"({"name":"plate","primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2,"NORMAL":3},)"
                R"("indices":1,"material":1,"extras":{"mine":7}}]},)"
                R"({"primitives":[{"attributes":{"POSITION":4},"mode":5,"material":0}]})";
  gltf.nodes =
      R"({"mesh":0,"name":"one","extras":["kept"]},)"
      R"({"children":[2],"translation":[0,0,4],"rotation":[0,0.7071067811865476,0,0.7071067811865476]},)"
      R"({"mesh":0,"scale":[2,1,1]},{"mesh":0,"translation":[0,3,0],"scale":[-1,1,1]},{"mesh":1},)"
      R"({"extensions":{"KHR_lights_punctual":{"light":0}}})";
  gltf.rest = R"(,"materials":[{"name":"strip"},{"name":"plate","doubleSided":true,"extras":{"of":"mine"},)"
              R"("pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,0.125,1],"metallicFactor":0}}],)"
              R"("extensionsUsed":["KHR_lights_punctual","FREE_wind"],"extensions":{"FREE_wind":{"speed":3},)"
              R"("KHR_lights_punctual":{"lights":[{"type":"point"}]}},"extras":"a room")";
  return gltf;
}

class ExportKept : public testing::Test {
 protected:
  void solve(const std::string& name, float max_edge) {
    scene_ = files_.load(name);
    patches_ = make_patches(scene_, {.max_edge = max_edge});
    solution_ = linear_light(patches_);
  }
  KeptInput input() const { return {scene_, patches_, solution_}; }
  std::filesystem::path out() const { return files_.path("lit.glb"); }
  GltfFile lit() const { return GltfFile(out(), known_extensions()); }
  void cut() { export_kept_cut(out(), input(), make_smooth_light(patches_, solution_), {}); }
  void uncut() {
    export_kept_uncut(out(), input(), fit_vertices(scene_, patches_, make_smooth_light(patches_, solution_)),
                      {});
  }

  SceneFiles files_;
  Scene scene_;
  PatchSet patches_;
  Solution solution_;
};

struct Vertex {
  Vec3d place;  // in the scene
  std::uint32_t number;
};

// Calls for each triangle of each part, its corners as a reader of the file winds them in the scene.
void for_triangles(GltfFile& file,
                   const std::function<void(const GltfPart&, const std::array<Vertex, 3>&)>& visit) {
  for (const auto& part : drawn_parts(file, placed_nodes(file)).parts) {
    const GltfArray positions(file, part.primitive["attributes"]["POSITION"], 3, 3);
    for (auto corners : triangle_corners(file, part.primitive, positions.size())) {
      if (mirrors(part.placed.world)) std::swap(corners[1], corners[2]);
      std::array<Vertex, 3> triangle{};
      for (std::size_t i = 0; i < 3; ++i) {
        const auto p = positions.at(corners[i]);
        triangle[i] = {Vec3d(part.placed.world * glm::dvec4(p[0], p[1], p[2], 1.0)), corners[i]};
      }
      visit(part, triangle);
    }
  }
}

Vec3d normal_of(const std::array<Vertex, 3>& t) {
  return glm::cross(t[1].place - t[0].place, t[2].place - t[0].place);
}

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

constexpr double plates = 2.0 + 4.0 + 2.0;  // m², of the three nodes
const double strip = 0.5 + 2 * 0.5 * std::sqrt(3.0);

TEST_F(ExportKept, every_vertex_of_cut_surfaces_has_the_light_of_its_place) {
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.4f);
  cut();
  auto file = lit();
  const auto area = expect_light_of_place(file, scene_);
  EXPECT_NEAR(area[0], plates + strip, 1e-4);
  EXPECT_NEAR(area[1], plates, 1e-4) << "the strip's back takes no light";
}

TEST_F(ExportKept, the_files_own_vertices_have_the_light_of_their_places) {
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.4f);
  uncut();
  auto file = lit();
  const auto area = expect_light_of_place(file, scene_);
  EXPECT_NEAR(area[0], plates + strip, 1e-4);
  EXPECT_NEAR(area[1], plates, 1e-4);
}

TEST_F(ExportKept, what_the_file_says_stays) {
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

TEST_F(ExportKept, new_vertices_have_texture_coordinates_between_the_old_ones) {
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

TEST_F(ExportKept, the_files_own_arrays_are_not_touched_where_it_keeps_its_triangles) {
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

TEST_F(ExportKept, the_back_turns_its_normals_and_the_front_is_seen_from_the_front_alone) {
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.4f);
  uncut();
  auto file = lit();
  const auto primitives = file.root()["meshes"][0]["primitives"];
  ASSERT_EQ(primitives.size(), 2u);
  EXPECT_EQ(GltfArray(file, primitives[1]["attributes"]["NORMAL"], 3, 3).at(0)[2], -1.0f);
  EXPECT_FALSE(file.object(primitives[0]["material"], "materials")["doubleSided"].truth(true));
}

// Each page's texels hold the place that they are of, so that what is looked up at a corner is known.
TEST_F(ExportKept, pages_are_looked_up_where_the_surface_is) {
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.4f);
  const PackOptions pack{.texel = 0.05f, .page_size = 64};
  const Workers workers(2);
  const auto charts =
      make_charts(patches_, solution_, {.texel = pack.texel, .most_texels = most_texels(pack)}, workers);
  const auto atlas = pack_charts(patches_, charts, pack);
  const auto places = find_texel_places(atlas, workers);
  std::vector<Image> pages;
  for (const auto& of_page : places) {
    auto& page = pages.emplace_back(atlas.page_size, atlas.page_size);
    for (std::size_t i = 0; i < of_page.size(); ++i) {
      if (of_page[i].kind == Texel::empty) continue;
      const auto p = patches_.points(of_page[i].side / 2);
      const auto& w = of_page[i].weights;
      page.pixels[i] = p[0] + w.x * (p[1] - p[0]) + w.y * (p[2] - p[0]);
    }
  }
  ASSERT_GT(pages.size(), 1u) << "the test is to have several pages";
  export_kept_lightmap(out(), input(), {atlas, pages, 1.0f}, {});
  auto file = lit();
  double area = 0.0;
  for_triangles(file, [&](const GltfPart& part, const std::array<Vertex, 3>& triangle) {
    const auto map = file.object(part.primitive["material"], "materials")["extensions"]["MOZ_lightmap"];
    const auto set = fmt::format("TEXCOORD_{}", map["texCoord"].whole());
    const auto texture = file.object(map["index"], "textures");
    const auto name = file.object(texture["source"], "images")["name"].text();  // "lightmap 2"
    const auto page = static_cast<std::size_t>(std::stoi(name.substr(name.rfind(' ')))) - 1;
    const GltfArray uvs(file, part.primitive["attributes"][set], 2, 2);
    area += 0.5 * glm::length(normal_of(triangle));
    for (const auto& weights : {Vec3d(0.6, 0.2, 0.2), Vec3d(0.2, 0.6, 0.2), Vec3d(1.0 / 3.0)}) {
      Vec2 uv(0.0f);
      Vec3d place(0.0);
      for (int i = 0; i < 3; ++i) {
        const auto at = uvs.at(triangle[static_cast<std::size_t>(i)].number);
        uv += static_cast<float>(weights[i]) * Vec2(at[0], at[1]);
        place += weights[i] * triangle[static_cast<std::size_t>(i)].place;
      }
      const auto found = look_up(pages.at(page), uv * static_cast<float>(atlas.page_size));
      EXPECT_LT(glm::length(Vec3d(found) - place), 0.02) << "less than half a texel";
    }
  });
  EXPECT_NEAR(area, 2.0 * plates + strip, 1e-4);
}

TEST_F(ExportKept, a_lightmapped_file_has_no_lamps_to_light_it_twice) {
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.0f);
  const PackOptions pack{.texel = 0.1f, .page_size = 256};
  const auto charts =
      make_charts(patches_, solution_, {.texel = pack.texel, .most_texels = most_texels(pack)}, Workers(1));
  const auto atlas = pack_charts(patches_, charts, pack);
  const std::vector<Image> pages(1, Image(atlas.page_size, atlas.page_size));
  export_kept_lightmap(out(), input(), {atlas, pages, 1.0f}, {});
  EXPECT_FALSE(lit().root()["nodes"][5]["extensions"]["KHR_lights_punctual"]);
  export_kept_emissive(out(), input(), {atlas, pages}, {});
  const auto file = lit();
  const auto material = file.object(file.root()["meshes"][0]["primitives"][0]["material"], "materials");
  EXPECT_EQ(material["pbrMetallicRoughness"]["baseColorFactor"][0].number(), 0.0);
  EXPECT_TRUE(material["emissiveTexture"]["index"]);
}

TEST_F(ExportKept, other_formats_become_what_they_would_be_as_gltf) {
  files_.write("room.mtl", "newmtl red\nKd 0.5 0.1 0.1\nnewmtl lamp\nKd 0.2 0.2 0.2\nKe 3 2 1\n");
  files_.write("room.obj",
               "mtllib room.mtl\no table\nusemtl red\nv 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n"
               "usemtl lamp\nv 0 0 1\nv 1 0 1\nv 0 1 1\nf 5 6 7\no chair\nusemtl red\nf 3 2 6\n");
  solve("room.obj", 0.3f);
  uncut();
  auto file = lit();
  // Where a surface has few patches, smooth light holds slopes back by some 1e-4 of the light.
  expect_light_of_place(file, scene_, 2e-3f);
  std::vector<std::string> names;
  for (const auto& part : drawn_parts(file, placed_nodes(file)).parts)
    names.push_back(part.object + "/" + file.object(part.primitive["material"], "materials")["name"].text());
  const std::vector<std::string> fronts = {"table/red",  "table/lamp", "table/red",
                                           "table/lamp", "chair/red",  "chair/red"};
  EXPECT_EQ(names, fronts) << "backs behind";
}

TEST_F(ExportKept, another_file_is_refused) {
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.4f);
  files_.write("room.glb", one_triangle().glb());
  EXPECT_THROW(cut(), MismatchError);
  EXPECT_FALSE(std::filesystem::exists(out()));
}

// The same input gives the same bytes.
TEST_F(ExportKept, repeats) {
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.4f);
  cut();
  const auto once = read_file(out());
  cut();
  EXPECT_EQ(read_file(out()), once);
}

}  // namespace
}  // namespace luxel
