// SPDX-License-Identifier: Apache-2.0
// The scene in scenes/, as a user loads it.

#include <string>

#include <gtest/gtest.h>

#include "luxel/core/triangle.h"
#include "luxel/import/load_scene.h"

namespace luxel {
namespace {

Scene cornell_box() { return load_scene(LUXEL_SOURCE_DIR "/scenes/cornell-box.obj"); }

Vec3 normal_of(const Scene& scene, std::size_t triangle) {
  const auto& [a, b, c] = scene.triangles[triangle];
  return triangle_normal(scene.positions[a], scene.positions[b], scene.positions[c]);
}

Vec3 middle_of(const Scene& scene, std::size_t triangle) {
  const auto& [a, b, c] = scene.triangles[triangle];
  return (scene.positions[a] + scene.positions[b] + scene.positions[c]) / 3.0f;
}

TEST(CornellBox, has_its_measured_size_in_metres) {
  const auto size = bounds(cornell_box()).size();
  EXPECT_FLOAT_EQ(size.x, 0.5528f);
  EXPECT_FLOAT_EQ(size.y, 0.5488f);
  EXPECT_FLOAT_EQ(size.z, 0.5592f);
}

TEST(CornellBox, loads_without_a_warning) {
  auto warnings = std::string{};
  const auto log = [&](const Message& message) {
    if (message.severity == Severity::warning) warnings += message.text + "\n";
  };
  load_scene(LUXEL_SOURCE_DIR "/scenes/cornell-box.obj", {}, Context().with_log(log));
  EXPECT_EQ(warnings, "");
}

TEST(CornellBox, turns_walls_inwards_blocks_outwards_and_its_lamp_down) {
  const auto scene = cornell_box();
  ASSERT_EQ(scene.triangles.size(), 32u);  // 5 walls, a lamp and two blocks of 5 faces, each a quad
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const auto group = scene.groups[scene.triangle_group[t]];
    const auto normal = normal_of(scene, t);
    if (group == "lamp") {
      EXPECT_FLOAT_EQ(normal.y, -1.0f);
      continue;
    }
    const auto inside = group == "short_block"  ? Vec3(0.0904f, 0.0825f, -0.1685f)
                        : group == "tall_block" ? Vec3(-0.0921f, 0.165f, -0.351f)
                                                : Vec3(0.0f, 0.2744f, -0.2796f);
    const auto outwards = glm::dot(normal, middle_of(scene, t) - inside);
    EXPECT_TRUE(group.ends_with("_block") ? outwards > 0.0f : outwards < 0.0f) << group;
  }
}

TEST(CornellBox, shines_from_its_lamp_alone) {
  const auto scene = cornell_box();
  for (const auto& material : scene.materials) EXPECT_EQ(material.is_lamp(), material.name == "lamp");
}

}  // namespace
}  // namespace luxel
