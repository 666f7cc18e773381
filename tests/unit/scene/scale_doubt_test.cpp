// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/scale_doubt.h"

#include <gtest/gtest.h>

namespace luxel {
namespace {

// A closed box, with a square lamp of this exitance (W/m² per band) below its ceiling, y up.
Scene box(const Vec3& size, float lamp_edge = 0.0f, float exitance = 0.0f) {
  Scene scene;
  scene.source = "box";
  scene.groups = {"default"};
  scene.materials.resize(2);
  scene.materials[1].emittance = Vec3(exitance);
  const auto quad = [&](const Vec3& at, const Vec3& a, const Vec3& b, std::uint32_t material) {
    const auto first = static_cast<std::uint32_t>(scene.positions.size());
    for (const auto& p : {at, at + a, at + a + b, at + b}) scene.positions.push_back(p);
    scene.triangles.push_back({first, first + 1, first + 2});
    scene.triangles.push_back({first, first + 2, first + 3});
    for (int i = 0; i < 2; ++i) {
      scene.triangle_material.push_back(MaterialId{material});
      scene.triangle_line.push_back(0);
      scene.triangle_group.push_back(0);
    }
  };
  const Vec3 x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z), o(0.0f);
  for (const auto& [a, b, c] : {std::array{x, y, z}, std::array{y, z, x}, std::array{z, x, y}}) {
    quad(o, a, b, 0);
    quad(c, a, b, 0);
  }
  if (lamp_edge > 0.0f) quad(0.9f * y, {lamp_edge, 0, 0}, {0, 0, lamp_edge}, 1);
  return scene;
}

// Hills of this height on a square.
Scene terrain(float edge, float height) {
  Scene scene;
  scene.groups = {"default"};
  scene.materials.resize(1);
  constexpr std::uint32_t n = 8;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t k = 0; k <= n; ++k)
      scene.positions.emplace_back(edge / n * static_cast<float>(i), (i + k) % 3 == 0 ? height : 0.0f,
                                   edge / n * static_cast<float>(k));
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t k = 0; k < n; ++k) {
      const auto at = i * (n + 1) + k;
      scene.triangles.push_back({at, at + 1, at + n + 2});
      scene.triangles.push_back({at, at + n + 2, at + n + 1});
    }
  scene.triangle_material.assign(scene.triangles.size(), MaterialId{0});
  scene.triangle_line.assign(scene.triangles.size(), 0);
  scene.triangle_group.assign(scene.triangles.size(), 0);
  return scene;
}

TEST(ScaleDoubt, finds_rooms_in_other_units) {
  const auto centimetres = doubt_scale(box({300, 250, 400}));
  ASSERT_TRUE(centimetres);
  EXPECT_TRUE(centimetres->is_large);
  EXPECT_EQ(centimetres->extent, 400.0);
  EXPECT_STREQ(centimetres->unit, "centimetres");
  EXPECT_EQ(centimetres->metres, 0.01);
  EXPECT_STREQ(doubt_scale(box({4000, 2500, 5000}))->unit, "millimetres");
  EXPECT_STREQ(doubt_scale(box({160, 100, 240}))->unit, "inches");
}

TEST(ScaleDoubt, finds_a_scene_of_three_millimetres) {
  const auto doubt = doubt_scale(box({0.003f, 0.002f, 0.003f}));
  ASSERT_TRUE(doubt);
  EXPECT_FALSE(doubt->is_large);
  EXPECT_EQ(doubt->metres, 1000.0);
}

TEST(ScaleDoubt, leaves_alone_what_exists) {
  for (const auto& size :
       {Vec3(0.55f, 0.55f, 0.56f), Vec3(2.0f), Vec3(6, 3, 4), Vec3(29, 15, 10), Vec3(52, 42, 9),
        Vec3(77, 36, 60), Vec3(120, 12, 90), Vec3(300, 40, 200), Vec3(0.1f, 0.12f, 0.08f), Vec3(1, 1, 0)})
    EXPECT_FALSE(doubt_scale(box(size))) << size.x << " x " << size.y << " x " << size.z;
  EXPECT_FALSE(doubt_scale(terrain(5000.0f, 800.0f)));
}

TEST(ScaleDoubt, lumens_beyond_any_office_are_doubted) {
  // 2.8 million lm on 20 x 12 m.
  const auto exitance = static_cast<float>(2.8e6 / 179.0);
  EXPECT_EQ(
      doubt_lumens(box({20, 3, 12}, 1.0f, exitance)),
      "the lamps emit 2.8 million lm, 12 times as much per area as in a bright office; emission is read as "
      "W/(m² sr) in OBJ and cd/m² in glTF: check its unit in the file");
}

TEST(ScaleDoubt, ordinary_and_luminous_ceilings_are_not) {
  EXPECT_EQ(doubt_lumens(box({20, 3, 12}, 1.0f, 240.0f * 500.0f / 179.0f)), "") << "500 lx";
  EXPECT_EQ(doubt_lumens(box({100, 20, 80}, 4.0f, 8000.0f * 2000.0f / 16.0f / 179.0f)), "") << "a stadium";
  EXPECT_EQ(doubt_lumens(box({20, 3, 12}, 12.0f, 40000.0f / 179.0f)), "") << "a sky";
  EXPECT_EQ(doubt_lumens(box({20, 3, 12})), "");
}

}  // namespace
}  // namespace luxel
