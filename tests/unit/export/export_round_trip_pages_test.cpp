// SPDX-License-Identifier: Apache-2.0
// glTF files with pages of light on them, in new charts and as the files themselves lay their surfaces out.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/export/export_round_trip.h"
#include "luxel/export/round_trip_layout.h"
#include "luxel/render/lightmap.h"
#include "luxel/render/solve_seams.h"
#include "luxel/render/texel_places.h"
#include "luxel/surface/make_charts.h"

#include "support/lightmap_places.h"
#include "support/round_trip_file.h"

namespace luxel {
namespace {

using namespace test;

// Expects that a reader's lookups at places of the file's triangles are right to less than `texel` / 2.
// Returns the area that has a page.
double expect_places(GltfFile& file, const std::vector<Image>& pages, int page_size, double texel) {
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
      const auto found = look_up(pages.at(page), uv * static_cast<float>(page_size));
      EXPECT_LT(glm::length(Vec3d(found) - place), 0.5 * texel) << part.object;
    }
  });
  return area;
}

TEST_F(ExportRoundTripPages, pages_are_looked_up_where_the_surface_is) {
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.4f);
  const auto atlas = new_atlas(patches_, solution_, {.texel = 0.05f, .page_size = 64});
  const auto pages = pages_of_places(patches_, atlas);
  ASSERT_GT(pages.size(), 1u) << "the test is to have several pages";
  export_round_trip_lightmap(out(), input(), {atlas, pages, 1.0f}, {});
  auto file = lit();
  EXPECT_NEAR(expect_places(file, pages, atlas.page_size, 0.05), 2.0 * plates + strip, 1e-4);
}

// A floor of 2 x 2 in eight triangles, lit from both sides, and a wall upon it that parts the light of four.
SmallGltf parted_room() {
  SmallGltf gltf;
  gltf.points({0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 0, 1, 1, 0, 1, 2, 0, 1, 0, 0, 2, 1, 0, 2, 2, 0, 2});
  gltf.array<std::uint8_t>(SmallGltf::u8, "SCALAR", 24,
                           {0, 3, 1, 1, 3, 4, 1, 4, 2, 2, 4, 5, 3, 6, 4, 4, 6, 7, 4, 7, 5, 5, 7, 8});
  gltf.points({0.33f, 0, 0, 0.33f, 0, 1, 0.33f, 1, 1, 0.33f, 1, 0});
  gltf.array<std::uint8_t>(SmallGltf::u8, "SCALAR", 6, {0, 1, 2, 0, 2, 3});
  gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]},)"
                R"({"primitives":[{"attributes":{"POSITION":2},"indices":3,"material":0}]})";
  gltf.nodes = R"({"mesh":0,"name":"floor"},{"mesh":1,"name":"wall"})";
  gltf.rest = R"(,"materials":[{"doubleSided":true}])";
  return gltf;
}

double sum_of_areas(const PatchSet& patches) {
  double sum = 0.0;
  for (const auto area : patches.area) sum += static_cast<double>(area);
  return sum;
}

// Adjacent triangles have the same corners along their edge, so that there are no gaps between them.
TEST_F(ExportRoundTripPages, triangles_that_are_not_cut_take_the_points_of_those_that_are) {
  files_.write("room.glb", parted_room().glb());
  solve("room.glb", 0.2f);
  // Much brighter on one side of the wall, so that a chart ends there.
  for (std::size_t p = 0; p < patches_.size(); ++p)
    if (patches_.centroid(p).x < 0.33f)
      for (std::size_t b = 0; b < patches_.band_count(); ++b) {
        solution_.irradiance.front[p * patches_.band_count() + b] *= 4.0f;
        solution_.irradiance.back[p * patches_.band_count() + b] *= 4.0f;
      }
  const auto atlas = new_atlas(patches_, solution_, {.texel = 0.05f, .page_size = 256});
  const auto pages = pages_of_places(patches_, atlas);
  export_round_trip_lightmap(out(), input(), {atlas, pages, 1.0f}, {});
  auto file = lit();
  EXPECT_NEAR(expect_places(file, pages, atlas.page_size, 0.05), 2.0 * (4.0 + 1.0), 1e-5);
  std::vector<std::array<Vec3d, 3>> triangles;  // of the floor, seen from above
  for_triangles(file, [&](const GltfPart& part, const std::array<Vertex, 3>& t) {
    if (part.object == "floor" && normal_of(t).y > 0.0)
      triangles.push_back({t[0].place, t[1].place, t[2].place});
  });
  EXPECT_GT(triangles.size(), 20u) << "some are cut";
  const auto of_floor =
      std::count_if(patches_.triangle.begin(), patches_.triangle.end(), [](auto t) { return t < 8; });
  EXPECT_LT(static_cast<std::ptrdiff_t>(triangles.size()), of_floor) << "some are not";
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = t[k], along = t[(k + 1) % 3] - a;
      for (const auto& other : triangles)
        for (const auto& p : other) {
          const auto fraction = glm::dot(p - a, along) / glm::dot(along, along);
          const auto off = glm::length(p - a - fraction * along);
          EXPECT_FALSE(fraction > 1e-6 && fraction < 1.0 - 1e-6 && off < 1e-6)
              << fmt::format("({}, {}) hangs on an edge from ({}, {})", p.x, p.z, a.x, a.z);
        }
    }
}

// Exported fronts and backs coincide exactly, so that they are read as sheets again.
TEST_F(ExportRoundTripPages, what_was_written_can_be_solved_again) {
  files_.write("room.glb", parted_room().glb());
  solve("room.glb", 0.2f);
  const auto area = sum_of_areas(patches_);
  const auto atlas = new_atlas(patches_, solution_, {.texel = 0.05f, .page_size = 256});
  const std::vector<Image> pages(static_cast<std::size_t>(atlas.pages),
                                 Image(atlas.page_size, atlas.page_size));
  const auto expect_the_same = [&](const char* form) {
    const auto again = make_patches(files_.load("lit.glb"), {.max_edge = 0.2f});
    EXPECT_NEAR(sum_of_areas(again), area, 1e-6 * area) << form;
    for (std::size_t p = 0; p < again.size(); ++p) EXPECT_TRUE(again.material_of(p).two_sided) << form;
  };
  export_round_trip_lightmap(out(), input(), {atlas, pages, 1.0f}, {});
  expect_the_same("lightmap");
  export_round_trip_emissive(out(), input(), {atlas, pages}, {});
  expect_the_same("emissive");
  cut();
  expect_the_same("vertex");
  uncut();
  expect_the_same("vertex, the file's triangles");
}

// Two nodes, each a square of 1 m in two halves that lie apart on the page though the surface goes on.
SmallGltf mapped_room(float second_from) {
  SmallGltf gltf;
  gltf.points({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0});
  const auto add_uvs = [&](float x) {
    gltf.array<float>(SmallGltf::f32, "VEC2", 6,
                      {x, 0.9f, x + 0.4f, 0.9f, x + 0.4f, 0.5f, x, 0.4f, x + 0.4f, 0.0f, x, 0.0f});
  };
  add_uvs(0.05f);
  add_uvs(second_from);
  gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1,"TEXCOORD_1":1}}]},)"
                R"({"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2,"TEXCOORD_1":2}}]})";
  gltf.nodes = R"({"mesh":0,"name":"one"},{"mesh":1,"name":"two","translation":[0,0,3]})";
  return gltf;
}

TEST_F(ExportRoundTripPages, a_files_own_coordinates_are_used_as_they_are) {
  for (const auto& [second_from, pages_wanted] : {std::pair(0.55f, 1u), std::pair(0.05f, 2u)}) {
    files_.write("room.glb", mapped_room(second_from).glb());
    solve("room.glb", 0.3f);
    std::string why;
    const auto given = round_trip_layout(scene_, patches_, 1.0, why);
    ASSERT_TRUE(given) << why;
    EXPECT_EQ(given->pages, pages_wanted);
    EXPECT_EQ(page_size_for(scene_, *given, 40.0, 1024), 128) << "40 / 0.4 = 100 texels";
    const auto laid = lay_out(scene_, patches_, *given, {30.0f, 128, 2}, Context(2));
    const auto pages = pages_of_places(patches_, laid.atlas);
    ASSERT_EQ(pages.size(), pages_wanted);
    export_round_trip_lightmap(out(), input(), {laid.atlas, pages, 1.0f, true}, {});
    auto file = lit();
    EXPECT_NEAR(expect_places(file, pages, 128, 1.0 / (0.4 * 128)), 2.0, 1e-6);
    EXPECT_FALSE(file.root()["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_2"]);
    EXPECT_EQ(file.root()["meshes"][0]["primitives"].size(), 1u);
    // The diagonal of each, 1.41 m long at 51 texels per metre, two places a texel.
    const auto seams = find_seam_places(laid.charts, laid.atlas);
    EXPECT_NEAR(static_cast<double>(seams.size()), 2 * 2 * std::sqrt(2.0) * 0.4 * 128, 20.0);
  }
}

TEST_F(ExportRoundTripPages, coordinates_that_cannot_be_used_are_not_and_the_reason_is_told) {
  std::string why;
  files_.write("room.glb", mapped_room(0.7f).glb());  // to 1.1
  solve("room.glb", 0.3f);
  EXPECT_FALSE(round_trip_layout(scene_, patches_, 1.0, why));
  EXPECT_EQ(why, "those of 'two' go beyond the page");
  auto some = mapped_room(0.55f);
  some.meshes = R"({"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1,"TEXCOORD_1":1}}]},)"
                R"({"primitives":[{"attributes":{"POSITION":0}}]})";
  files_.write("room.glb", some.glb());
  solve("room.glb", 0.3f);
  EXPECT_FALSE(round_trip_layout(scene_, patches_, 1.0, why));
  EXPECT_EQ(why, "'two' has none");
  auto over = mapped_room(0.55f);
  over.array<float>(SmallGltf::f32, "VEC2", 6, {0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0.9f, 0.2f});
  over.meshes = R"({"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1,"TEXCOORD_1":3}}]},)"
                R"({"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2,"TEXCOORD_1":2}}]})";
  files_.write("room.glb", over.glb());
  solve("room.glb", 0.3f);
  EXPECT_FALSE(round_trip_layout(scene_, patches_, 1.0, why));
  EXPECT_EQ(why, "surfaces of one node lie over each other");
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.3f);
  EXPECT_FALSE(round_trip_layout(scene_, patches_, 1.0, why));
  EXPECT_EQ(why, "") << "a file without any is no fault";
}

// glTF's own defaults are those of a white metal, which no diffuse light shows.
TEST_F(ExportRoundTripPages, what_has_no_material_gets_the_grey_that_it_was_solved_with) {
  auto gltf = small_room();
  gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0},"indices":1}]})";
  gltf.nodes = R"({"mesh":0})";
  files_.write("room.glb", gltf.glb());
  solve("room.glb", 0.0f);
  const auto atlas = new_atlas(patches_, solution_, {.texel = 0.1f, .page_size = 256});
  const std::vector<Image> pages(1, Image(atlas.page_size, atlas.page_size));
  export_round_trip_lightmap(out(), input(), {atlas, pages, 1.0f}, {});
  const auto file = lit();
  const auto base =
      file.object(file.root()["meshes"][0]["primitives"][0]["material"], "materials")["pbrMetallicRoughness"];
  EXPECT_EQ(base["metallicFactor"].number(), 0.0);
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_EQ(base["baseColorFactor"][c].number(), scene_.materials[0].reflectance[static_cast<int>(c)]);
}

// Surfaces solved by Luxel have no gloss. A file's own gloss is kept unless it would reduce the light.
TEST_F(ExportRoundTripPages, gloss_takes_nothing_off_the_light) {
  const auto gloss_after = [&](const std::string& name, TargetApplication program) {
    solve(name, 0.3f);
    const auto atlas = new_atlas(patches_, solution_, {.texel = 0.1f, .page_size = 256});
    const std::vector<Image> pages(1, Image(atlas.page_size, atlas.page_size));
    export_round_trip_lightmap(out(), input(), {atlas, pages, 1.0f}, {.tone = {}, .program = program});
    const auto file = lit();
    const auto material = file.object(file.root()["meshes"][0]["primitives"][0]["material"], "materials");
    return material["extensions"]["KHR_materials_specular"]["specularFactor"].number(1.0);
  };
  files_.write("room.obj", "v 0 0 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\n");
  EXPECT_EQ(gloss_after("room.obj", TargetApplication::any), 0.0);
  files_.write("bare.glb", one_triangle().glb());
  EXPECT_EQ(gloss_after("bare.glb", TargetApplication::any), 0.0) << "no material is one of ours";
  files_.write("room.glb", small_room().glb());
  EXPECT_EQ(gloss_after("room.glb", TargetApplication::any), 1.0);
  EXPECT_EQ(gloss_after("room.glb", TargetApplication::three), 0.0);
  // Shadeless, without other extensions that describe reflection.
  solve("bare.glb", 0.3f);
  cut();
  EXPECT_EQ(lit().root()["materials"][0]["extensions"].keys(),
            std::vector<std::string>{"KHR_materials_unlit"});
}

// Two primitives share a material, and one has more texture coordinates than the other; and the file has been
// lightmapped before.
TEST_F(ExportRoundTripPages, each_primitive_has_the_coordinates_that_its_material_names) {
  auto gltf = small_room();
  gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2,"TEXCOORD_1":2},"indices":1,)"
                R"("material":0},{"attributes":{"POSITION":4},"mode":5,"material":0}]})";
  gltf.nodes = R"({"mesh":0})";
  gltf.rest = R"(,"materials":[{"extensions":{"MOZ_lightmap":{"index":0,"texCoord":1}}}],"extensionsUsed":)"
              R"(["MOZ_lightmap"],"images":[{"uri":"old.png"}],"textures":[{"source":0}])";
  files_.write("room.glb", gltf.glb());
  solve("room.glb", 0.0f);
  const auto atlas = new_atlas(patches_, solution_, {.texel = 0.1f, .page_size = 256});
  const std::vector<Image> pages(1, Image(atlas.page_size, atlas.page_size));
  const auto expect_coordinates = [&](bool as_lightmap) {
    const auto file = lit();
    const auto primitives = file.root()["meshes"][0]["primitives"];
    ASSERT_GE(primitives.size(), 2u);
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const auto material = file.object(primitives[i]["material"], "materials");
      const auto map = material["extensions"]["MOZ_lightmap"];
      EXPECT_EQ(static_cast<bool>(map), as_lightmap) << "none but the new one";
      const auto set = (as_lightmap ? map : material["emissiveTexture"])["texCoord"].whole();
      EXPECT_TRUE(primitives[i]["attributes"][fmt::format("TEXCOORD_{}", set)]);
    }
  };
  export_round_trip_lightmap(out(), input(), {atlas, pages, 1.0f}, {});
  expect_coordinates(true);
  export_round_trip_emissive(out(), input(), {atlas, pages}, {});
  expect_coordinates(false);
  cut();
  EXPECT_FALSE(lit().root()["materials"][0]["extensions"]["MOZ_lightmap"]);
}

// Two materials, one with holes, share nothing but a sampler; one texture was never used.
TEST_F(ExportRoundTripPages, pictures_that_black_surfaces_do_not_show_go) {
  auto gltf = small_room();
  gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2},"indices":1,"material":0}]},)"
                R"({"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2},"indices":1,"material":1}]})";
  gltf.nodes = R"({"mesh":0},{"mesh":1,"translation":[0,0,1]})";
  gltf.rest =
      R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}},"normalTexture":{"index":3},)"
      R"("extensions":{"KHR_materials_clearcoat":{"clearcoatTexture":{"index":4}}}},{"alphaMode":"MASK",)"
      R"("pbrMetallicRoughness":{"baseColorTexture":{"index":1}}}],"extensionsUsed":["KHR_materials_clearcoat"],)"
      R"("samplers":[{"wrapS":33071},{"wrapS":33648}],"images":[{"uri":"a.png"},{"uri":"b.png"},{"uri":"c.png"},)"
      R"({"uri":"d.png"},{"uri":"e.png"}],"textures":[{"source":0,"sampler":0},{"source":1,"sampler":1},)"
      R"({"source":2,"sampler":0},{"source":3},{"source":4}])";
  files_.write("room.gltf", gltf.text());
  solve("room.gltf", 0.0f);
  const auto atlas = new_atlas(patches_, solution_, {.texel = 0.1f, .page_size = 256});
  const std::vector<Image> pages(1, Image(atlas.page_size, atlas.page_size));
  const auto names = [&] {
    std::vector<std::string> found;
    const auto file = lit();
    const auto images = file.root()["images"];
    for (std::size_t i = 0; i < images.size(); ++i)
      found.push_back(images[i][images[i]["uri"] ? "uri" : "name"].text());
    return found;
  };
  export_round_trip_emissive(out(), input(), {atlas, pages}, {});
  EXPECT_EQ(names(), (std::vector<std::string>{"b.png", "c.png", "light 1"}))
      << "holes and what nobody used stay";
  const auto file = lit();
  const auto picture_of = [&](const JsonValue& texture_info) {
    return file.object(file.object(texture_info["index"], "textures")["source"], "images");
  };
  for (const std::size_t m : {0, 1})
    EXPECT_EQ(picture_of(file.root()["materials"][m]["emissiveTexture"])["name"].text(), "light 1");
  const auto holed = file.root()["materials"][1]["pbrMetallicRoughness"]["baseColorTexture"];
  EXPECT_EQ(picture_of(holed)["uri"].text(), "b.png");
  EXPECT_EQ(file.object(file.object(holed["index"], "textures")["sampler"], "samplers")["wrapS"].whole(),
            33648u);
  EXPECT_FALSE(file.root()["materials"][0]["extensions"]["KHR_materials_clearcoat"]);
  // A lightmap multiplies them all.
  export_round_trip_lightmap(out(), input(), {atlas, pages, 1.0f}, {});
  EXPECT_EQ(names(), (std::vector<std::string>{"a.png", "b.png", "c.png", "d.png", "e.png", "lightmap 1"}));
}

TEST_F(ExportRoundTripPages, what_is_stopped_writes_no_file) {
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.0f);
  const auto atlas = new_atlas(patches_, solution_, {.texel = 0.1f, .page_size = 256});
  const std::vector<Image> pages(1, Image(atlas.page_size, atlas.page_size));
  for (const auto* stage : {"pictures", "write"}) {
    const auto context = Context().with_monitor(
        [&](const Progress& progress) { return progress.stage == stage ? Next::stop : Next::go_on; });
    EXPECT_FALSE(export_round_trip_lightmap(out(), input(), {atlas, pages, 1.0f}, {}, context));
    EXPECT_FALSE(export_round_trip_emissive(out(), input(), {atlas, pages}, {}, context));
    EXPECT_FALSE(std::filesystem::exists(out())) << stage;
  }
  const auto go_on = Context().with_monitor([](const Progress&) { return Next::go_on; });
  EXPECT_TRUE(export_round_trip_lightmap(out(), input(), {atlas, pages, 1.0f}, {}, go_on));
}

TEST_F(ExportRoundTripPages, a_lightmapped_file_has_no_lamps_to_light_it_twice) {
  files_.write("room.glb", small_room().glb());
  solve("room.glb", 0.0f);
  const auto atlas = new_atlas(patches_, solution_, {.texel = 0.1f, .page_size = 256});
  const std::vector<Image> pages(1, Image(atlas.page_size, atlas.page_size));
  export_round_trip_lightmap(out(), input(), {atlas, pages, 1.0f}, {});
  EXPECT_FALSE(lit().root()["nodes"][5]["extensions"]["KHR_lights_punctual"]);
  export_round_trip_emissive(out(), input(), {atlas, pages}, {});
  const auto file = lit();
  const auto material = file.object(file.root()["meshes"][0]["primitives"][0]["material"], "materials");
  EXPECT_EQ(material["pbrMetallicRoughness"]["baseColorFactor"][0].number(), 0.0);
  EXPECT_TRUE(material["emissiveTexture"]["index"]);
}

}  // namespace
}  // namespace luxel
