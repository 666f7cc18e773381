// SPDX-License-Identifier: Apache-2.0
// Calculation areas that nodes of a glTF file describe.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/import/load_scene.h"
#include "luxel/lighting/areas.h"

#include "support/small_gltf.h"

namespace luxel {
namespace {

const Vec3d up(0, 1, 0);

class AreaNodes : public testing::Test {
 protected:
  // A floor, and a node that may have the mesh of a plane of 2 x 2 units, as Blender makes them.
  std::filesystem::path write(const std::string& node) {
    SmallGltf gltf;
    const std::vector<float> corners = {-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1};
    const auto position = gltf.array(SmallGltf::f32, "VEC3", 4, corners, R"(,"min":[-1,0,-1],"max":[1,0,1])");
    const auto index = gltf.array<std::uint16_t>(SmallGltf::u16, "SCALAR", 6, {0, 2, 1, 0, 3, 2});
    const auto mesh =
        fmt::format(R"({{"primitives":[{{"attributes":{{"POSITION":{}}},"indices":{}}}]}})", position, index);
    gltf.meshes = mesh;
    gltf.nodes = R"({"mesh":0,"name":"floor","scale":[4,1,3]},)" + node;
    const auto file = std::filesystem::path(testing::TempDir()) / "area_nodes.gltf";
    std::ofstream(file) << gltf.text();
    return file;
  }
  std::vector<CalculationArea> areas(const std::string& node) {
    return read_areas(write(node).string(), RequirementTable(), up);
  }
  void refuses(const std::string& node, const std::string& message) {
    try {
      areas(node);
      FAIL() << node;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
  }
};

TEST_F(AreaNodes, are_rectangles_of_their_mesh_with_the_keys_of_a_file) {
  const std::string node =
      R"({"mesh":0,"name":"desk","translation":[1,0.75,0],"scale":[0.8,1,0.4],
          "extras":{"calculation_area":"task","area_requirement":"writing","area_Em":600,"area_surround":1,
                    "area_direct":false,"other":"text"}})";
  const auto all = areas(node);
  ASSERT_EQ(all.size(), 3u);
  const auto& desk = all[0];
  EXPECT_EQ(desk.name, "desk");
  EXPECT_EQ(desk.kind, AreaKind::task);
  EXPECT_EQ(desk.requirement.Em, 600.0);
  EXPECT_EQ(desk.requirement.U0, 0.6);
  ASSERT_EQ(desk.polygon.size(), 4u);
  Vec3d low = desk.polygon[0], high = low;
  for (const auto& corner : desk.polygon) low = glm::min(low, corner), high = glm::max(high, corner);
  EXPECT_LT(glm::length(low - Vec3d(0.2, 0.75, -0.4)), 1e-6);
  EXPECT_LT(glm::length(high - Vec3d(1.8, 0.75, 0.4)), 1e-6);
}

TEST_F(AreaNodes, take_no_part_in_the_light) {
  const auto file = write(R"({"mesh":0,"name":"desk","extras":{"calculation_area":"task"}})");
  EXPECT_EQ(load_scene(file).triangles.size(), 2u);
}

TEST_F(AreaNodes, without_a_mesh_are_a_square_of_the_node_and_escape_routes_are_lines) {
  const auto all = areas(
      R"({"name":"way","translation":[0,0.02,0],"scale":[6,1,1],"extras":{"calculation_area":"escape_route"}})");
  ASSERT_EQ(all.size(), 1u);
  EXPECT_TRUE(all[0].is_direct);
  ASSERT_EQ(all[0].line.size(), 2u);
  EXPECT_LT(std::min(glm::length(all[0].line[0] - Vec3d(-3, 0.02, 0)),
                     glm::length(all[0].line[1] - Vec3d(-3, 0.02, 0))),
            1e-6);
  EXPECT_NEAR(glm::length(all[0].line[1] - all[0].line[0]), 6.0, 1e-6);
}

TEST_F(AreaNodes, are_refused_with_their_place_where_a_key_is_wrong) {
  refuses(R"({"name":"a","extras":{"calculation_area":"desk"}})", "expected task, surround");
  refuses(R"({"name":"a","extras":{"calculation_area":"task","area_colour":1}})",
          "/nodes/1/extras/area_colour: expected one of area_requirement");
  refuses(R"({"name":"a","extras":{"calculation_area":"task","area_Em":"much"}})", "/nodes/1/extras/area_Em");
  refuses(R"({"name":"a"})", "expected a node with the extra \"calculation_area\"");
}

}  // namespace
}  // namespace luxel
