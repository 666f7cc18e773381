// SPDX-License-Identifier: Apache-2.0
// The numbers of a page; tests/web tests their display.
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <numbers>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "luxel/core/half.h"
#include "luxel/core/triangle.h"
#include "luxel/export/page_arrays.h"
#include "luxel/export/page_light.h"
#include "luxel/export/page_mesh.h"
#include "luxel/export/page_textures.h"
#include "luxel/image/raster.h"
#include "luxel/patch/colour_patches.h"

#include "support/lit_patches.h"

namespace luxel {
namespace {

using test::LitPatches;
using test::plain_material;

PageMesh mesh_of(const LitPatches& lit, const SmoothLight& light) {
  return make_page_mesh(lit.patches, lit.solution, light, PageTextures(lit.patches));
}

// The number that a half stands for; all here are plain ones.
float value_of(std::uint16_t half) { return glm::unpackHalf1x16(half); }

// Two triangles of one square, of two materials; the second is lit from behind as well.
LitPatches square() {
  LitPatches lit({plain_material("red", 0.5f), plain_material("blue", 0.5f)});
  const auto a = lit.vertex({0, 0, 2}), b = lit.vertex({1, 0, 2}), c = lit.vertex({1, 3, 2}),
             d = lit.vertex({0, 3, 2});
  lit.patch({a, b, c}, 2.0f, 0.0f, 0);
  lit.patch({a, c, d}, 2.0f, 0.5f, 1);
  return lit;
}

// A hidden back is of a part without lit backs, and its light and error are 0.
TEST(PageData, hidden_backs_are_not_shown) {
  auto lit = square();
  lit.solution.standard_error = lit.solution.irradiance;
  const auto light = make_smooth_light(lit.patches, lit.solution);
  const std::vector<std::uint8_t> hidden = {0, 1};
  const auto mesh = make_page_mesh(lit.patches, lit.solution, light, PageTextures(lit.patches), hidden);
  ASSERT_EQ(mesh.parts.size(), 2u);
  EXPECT_FALSE(mesh.parts[1].back_is_lit);
  const auto halves = make_page_light(lit.patches, mesh, light, {}).halves;
  const auto half = static_cast<std::ptrdiff_t>(halves.size() / 2);
  EXPECT_TRUE(std::all_of(halves.begin(), halves.begin() + half, [](auto h) { return h != 0; }));
  EXPECT_TRUE(std::all_of(halves.begin() + half, halves.end(), [](auto h) { return h == 0; }));
  const auto errors = make_page_errors(lit.patches, mesh, lit.solution, {}).codes;
  ASSERT_EQ(errors.size(), 4u);
  EXPECT_GT(errors[1], 0);
  EXPECT_EQ(errors[3], 0);
  const auto all = make_page_light(lit.patches, mesh_of(lit, light), light, {}).halves;
  EXPECT_TRUE(std::any_of(all.begin() + half, all.end(), [](auto h) { return h != 0; }));
}

// Its light times a factor.
GroupLight times(const LitPatches& lit, float front, float back) {
  GroupLight group{lit.solution, make_smooth_light(lit.patches, lit.solution)};
  for (auto& h : group.light.irradiance.front) h *= front;
  for (auto& h : group.light.irradiance.back) h *= back;
  return group;
}

TEST(PageData, vertices_are_not_shared_by_materials_and_lit_backs_stand_apart) {
  const auto lit = square();
  const auto mesh = mesh_of(lit, make_smooth_light(lit.patches, lit.solution));
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.vertices.size(), 6u);
  ASSERT_EQ(mesh.parts.size(), 2u);
  EXPECT_FALSE(mesh.parts[0].back_is_lit);
  EXPECT_TRUE(mesh.parts[1].back_is_lit);
  EXPECT_EQ(mesh.parts[1].material, 1u);
  EXPECT_EQ(mesh.parts[1].first, 1u);
  for (std::size_t t = 0; t < 2; ++t)
    for (const auto v : mesh.triangles[t]) EXPECT_EQ(mesh.vertices[v].material, t);
  EXPECT_EQ(mesh.patch, (std::vector<std::uint32_t>{0, 1}));
}

TEST(PageData, groups_sum_up_to_the_solution_whatever_their_smoothing_did) {
  const auto lit = square();
  const auto light = make_smooth_light(lit.patches, lit.solution);
  const auto mesh = mesh_of(lit, light);
  // They should be a quarter and three quarters; the second came out 4 % too bright.
  const std::vector<GroupLight> groups = {times(lit, 0.25f, 0.25f), times(lit, 0.78f, 0.75f)};
  const auto page = make_page_light(lit.patches, mesh, light, groups);
  ASSERT_EQ(page.components, 3u);
  const auto side = mesh.vertices.size() * 3;
  ASSERT_EQ(page.halves.size(), 2 * 2 * side);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    for (std::size_t b = 0; b < 3; ++b) {
      const auto at = 3 * v + b;
      const auto first = page.unit * value_of(page.halves[at]);
      const auto second = page.unit * value_of(page.halves[2 * side + at]);
      EXPECT_NEAR(first + second, light.irradiance.front[3 * mesh.vertices[v].point.smooth[0] + b], 2e-3f);
      EXPECT_NEAR(first / (first + second), 0.25 / 1.03, 1e-3);
    }
}

TEST(PageData, the_brightest_light_is_far_from_a_halfs_end) {
  auto lit = square();
  for (auto& h : lit.solution.irradiance.front) h *= 1e9f;
  const auto light = make_smooth_light(lit.patches, lit.solution);
  const auto page = make_page_light(lit.patches, mesh_of(lit, light), light, {});
  float largest = 0.0f;
  for (const auto h : page.halves) largest = std::max(largest, value_of(h));
  EXPECT_NEAR(largest, 32768.0f, 32.0f);
  EXPECT_NEAR(page.unit * largest, 2e9f, 2e6f);
}

TEST(PageData, errors_keep_their_size_to_a_twenty_fourth_of_an_octave) {
  auto lit = square();
  lit.solution.standard_error.front = {0.3f, 0.3f, 0.3f, 0.0f, 0.01f, 0.0f};
  lit.solution.standard_error.back.assign(6, 0.0f);
  const auto light = make_smooth_light(lit.patches, lit.solution);
  const auto mesh = mesh_of(lit, light);
  const auto page = make_page_errors(lit.patches, mesh, lit.solution, {});
  EXPECT_NEAR(page.largest, 179.0 * 0.3, 1e-4);
  ASSERT_EQ(page.codes.size(), 4u);
  const auto lux = [&](std::size_t i) { return page.largest * std::exp2((page.codes[i] - 255) / 12.0); };
  EXPECT_EQ(page.codes[0], 255);
  EXPECT_NEAR(std::log2(lux(1) / (179.0 * 0.7152 * 0.01)), 0.0, 1.0 / 24.0 + 1e-6);
  EXPECT_EQ(page.codes[2], 0);
  EXPECT_EQ(page.codes[3], 0);
}

TEST(PageData, a_solution_without_errors_has_none) {
  const auto lit = square();
  const auto light = make_smooth_light(lit.patches, lit.solution);
  const auto mesh = mesh_of(lit, light);
  EXPECT_EQ(make_page_errors(lit.patches, mesh, lit.solution, {}).largest, 0.0);
}

TEST(PageData, differences_alternate_and_their_first_bytes_come_first) {
  PageArrays arrays;
  arrays.add_differences("a", std::vector<std::int32_t>{300, 299, 301}, 1);
  arrays.add("b", std::vector<std::uint8_t>{7});
  // 300 is 600 = 0x258, -1 is 1, 2 is 4.
  EXPECT_EQ(arrays.bytes(), std::string("\x58\x01\x04\x02\0\0\0\0\0\0\0\0\x07", 13));
  EXPECT_EQ(json_text(arrays.list()),
            R"([{"name":"a","type":"i32","count":3,"stride":1},{"name":"b","type":"u8","count":1}])");
}

TEST(PageData, differences_from_the_lowest_to_the_highest_number_wrap_around) {
  PageArrays arrays;
  constexpr auto low = std::numeric_limits<std::int32_t>::min(),
                 high = std::numeric_limits<std::int32_t>::max();
  arrays.add_differences("a", std::vector<std::int32_t>{low, high}, 1);
  EXPECT_EQ(arrays.bytes(), std::string("\xff\x01\xff\0\xff\0\xff\0", 8));  // low: itself; high - low: -1
}

// Two small patches meet the long edge of a third in its middle.
TEST(PageData, a_vertex_within_an_edge_divides_it) {
  LitPatches lit;
  const auto a = lit.vertex({0, 0, 0}), b = lit.vertex({2, 0, 0}), c = lit.vertex({1, 2, 0}),
             below = lit.vertex({1, -1, 0}), middle = lit.vertex({1, 0, 0});
  lit.patch({a, b, c}, 2.0f);
  lit.patch({a, below, middle}, 2.0f);
  lit.patch({middle, below, b}, 2.0f);
  const auto light = make_smooth_light(lit.patches, lit.solution);
  const auto mesh = mesh_of(lit, light);
  ASSERT_EQ(mesh.triangles.size(), 4u);
  EXPECT_EQ(mesh.patch, (std::vector<std::uint32_t>{0, 0, 1, 2}));
  double area = 0.0;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& t : mesh.triangles) {
    const auto place = [&](std::size_t k) { return mesh.vertices[t[k]].point.vertex; };
    for (std::size_t k = 0; k < 3; ++k) edges.insert({place(k), place((k + 1) % 3)});
    const auto& v = lit.patches.vertices;
    area += triangle_area(v[place(0)], v[place(1)], v[place(2)]);
  }
  EXPECT_NEAR(area, 2.0 + 1.0, 1e-6);
  EXPECT_FALSE(edges.contains({a, b}));
  for (const auto& [from, to] : {std::pair(a, middle), std::pair(middle, b)}) {
    EXPECT_TRUE(edges.contains({from, to}));
    EXPECT_TRUE(edges.contains({to, from}));
  }
  const auto page = make_page_light(lit.patches, mesh, light, {});
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    EXPECT_NEAR(page.unit * value_of(page.halves[3 * v]), 2.0f, 2e-3f);
}

// A triangle with a texture of two columns, 0.8 and 0.2 of the maximum reflectance of its material.
LitPatches textured() {
  LitPatches lit;
  const auto raster = std::make_shared<Raster>(Raster{2, 1, {}, {Vec3(0.8f), Vec3(0.2f)}});
  lit.patch({lit.vertex({0, 0, 0}), lit.vertex({1, 0, 0}), lit.vertex({0, 1, 0})}, 2.0f);
  auto& patches = lit.patches;
  patches.textures = {{"columns", raster}};
  patches.uv_sets = {{{Vec2(0.0f, 0.5f), Vec2(3.0f, 0.5f), Vec2(0.0f, -1.5f)}}};
  auto& use = patches.materials[0].textures;
  use.reflectance = TextureUse{};
  use.reflectance_factor = Vec3(0.9f);
  return lit;
}

TEST(PageData, vertices_have_the_places_of_the_texture_and_the_factor_it_is_multiplied_by) {
  auto lit = textured();
  auto& patches = lit.patches;
  const auto mean = FineColours(patches, Context(1)).mean_reflectance(0).r;
  patches.reflectance_ratio.assign(
      3, 0.9f * mean / 0.5f);  // as colour_patch() has it; the material reflects 0.5
  const auto mesh = mesh_of(lit, make_smooth_light(patches, lit.solution));
  ASSERT_EQ(mesh.vertices.size(), 3u);
  EXPECT_EQ(mesh.vertices[1].places[0],
            (std::array<std::int32_t, 2>{3 * page_place_parts, page_place_parts / 2}));
  EXPECT_EQ(mesh.vertices[2].places[0][1], -3 * page_place_parts / 2);
  const auto colours = make_page_colours(patches, mesh);
  for (const auto half : colours.reflectance) EXPECT_NEAR(0.5f * value_of(half), 0.9f, 1e-3f);
}

TEST(PageData, a_picture_of_a_page_is_the_texture) {
  const auto lit = textured();
  const PageTextures textures(lit.patches);
  ASSERT_EQ(textures.pictures().size(), 1u);
  const auto picture = decode_raster(textures.pictures()[0], "picture");
  ASSERT_EQ(picture.width, 2);
  EXPECT_NEAR(picture.colour(0).g, 0.8f, 0.01f);
  EXPECT_NEAR(picture.colour(1).g, 0.2f, 0.01f);
  EXPECT_EQ(json_text(textures.description(0)),
            R"({"reflectance":{"picture":0,"set":0,"wrap":["repeat","repeat"],"scale":1.0}})");
}

// Noise, which compresses badly.
TEST(PageData, pictures_shrink_until_they_have_room) {
  auto lit = textured();
  Raster noise{512, 256, {}, {}};
  for (std::uint32_t i = 0; i < 512 * 256; ++i) {
    const auto code = static_cast<std::uint8_t>(i * 2654435761u >> 24u);
    noise.codes.push_back(
        {code, static_cast<std::uint8_t>(code * 7u), static_cast<std::uint8_t>(code * 31u), 255});
  }
  lit.patches.textures[0].raster = std::make_shared<Raster>(noise);
  const auto size = [](const PageTextures& textures) {
    const auto picture = decode_raster(textures.pictures()[0], "picture");
    return std::pair(picture.width, picture.height);
  };
  EXPECT_EQ(size(PageTextures(lit.patches)), std::pair(512, 256));
  const PageTextures small(lit.patches, 30'000);
  EXPECT_LE(small.pictures()[0].size(), 30'000u);
  EXPECT_LT(size(small).first, 512);
  EXPECT_EQ(size(PageTextures(lit.patches, 1)), std::pair(64, 32));
}

TEST(PageData, holes_are_a_picture_of_alpha) {
  auto lit = textured();
  lit.patches.textures[0].raster =
      std::make_shared<Raster>(Raster{2, 1, {{10, 20, 30, 255}, {10, 20, 30, 0}}, {}});
  auto& use = lit.patches.materials[0].textures;
  use.cutout = use.reflectance;
  const PageTextures textures(lit.patches);
  ASSERT_EQ(textures.pictures().size(), 2u);
  const auto mask = decode_raster(textures.pictures()[1], "picture");
  EXPECT_EQ(mask.codes[0], (Raster::Code{255, 255, 255, 255}));
  EXPECT_EQ(mask.codes[1], (Raster::Code{0, 0, 0, 255}));
  EXPECT_EQ(textures.uv_sets(), 1u);
}

TEST(PageData, no_text_ends_the_script_it_stands_in) {
  EXPECT_EQ(page_json("a</script>\"\\\n"), R"("a\u003c/script\u003e\"\\\n")");
  EXPECT_EQ(page_json("Wand gr\xc3\xbcn"), "\"Wand gr\xc3\xbcn\"");
  EXPECT_EQ(page_json("\xff"), "\"\xef\xbf\xbd\"");
}

}  // namespace
}  // namespace luxel
