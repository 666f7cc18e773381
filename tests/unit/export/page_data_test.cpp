// SPDX-License-Identifier: Apache-2.0
// The numbers a page carries; what it shows of them is tested in tests/web.
#include <cmath>
#include <cstring>
#include <numbers>

#include <gtest/gtest.h>

#include "luxel/core/half.h"
#include "luxel/export/page_arrays.h"
#include "luxel/export/page_light.h"
#include "luxel/export/page_mesh.h"

#include "support/lit_patches.h"

namespace luxel {
namespace {

using test::LitPatches;
using test::plain_material;

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

// Its light times so much.
GroupLight times(const LitPatches& lit, float front, float back) {
  GroupLight group{lit.solution, make_smooth_light(lit.patches, lit.solution)};
  for (auto& h : group.light.irradiance.front) h *= front;
  for (auto& h : group.light.irradiance.back) h *= back;
  return group;
}

TEST(PageData, vertices_are_not_shared_by_materials_and_lit_backs_stand_apart) {
  const auto lit = square();
  const auto mesh = make_page_mesh(lit.patches, lit.solution, make_smooth_light(lit.patches, lit.solution));
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
  const auto mesh = make_page_mesh(lit.patches, lit.solution, light);
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
      EXPECT_NEAR(first + second, light.irradiance.front[3 * mesh.vertices[v].smooth + b], 2e-3f);
      EXPECT_NEAR(first / (first + second), 0.25 / 1.03, 1e-3);
    }
}

TEST(PageData, the_brightest_light_is_far_from_a_halfs_end) {
  auto lit = square();
  for (auto& h : lit.solution.irradiance.front) h *= 1e9f;
  const auto light = make_smooth_light(lit.patches, lit.solution);
  const auto page = make_page_light(lit.patches, make_page_mesh(lit.patches, lit.solution, light), light, {});
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
  const auto mesh = make_page_mesh(lit.patches, lit.solution, light);
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
  const auto mesh = make_page_mesh(lit.patches, lit.solution, light);
  EXPECT_EQ(make_page_errors(lit.patches, mesh, lit.solution, {}).largest, 0.0);
}

TEST(PageData, first_bytes_come_first) {
  PageArrays arrays;
  arrays.add("a", std::vector<std::uint16_t>{0x0102, 0x0304});
  arrays.add("b", std::vector<std::uint8_t>{7});
  EXPECT_EQ(arrays.bytes(), std::string("\x02\x04\x01\x03\x07", 5));
  EXPECT_EQ(json_text(arrays.list()),
            R"([{"name":"a","type":"f16","count":2},{"name":"b","type":"u8","count":1}])");
}

TEST(PageData, no_text_ends_the_script_it_stands_in) {
  EXPECT_EQ(page_json("a</script>\"\\\n"), R"("a\u003c/script\u003e\"\\\n")");
  EXPECT_EQ(page_json("Wand gr\xc3\xbcn"), "\"Wand gr\xc3\xbcn\"");
  EXPECT_EQ(page_json("\xff"), "\"\xef\xbf\xbd\"");
}

}  // namespace
}  // namespace luxel
