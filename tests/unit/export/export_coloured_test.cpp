// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/export_coloured.h"

#include <gtest/gtest.h>

#include "luxel/session/diagnostic_mesh.h"

#include "support/glb_file.h"
#include "support/truth_scenes.h"

namespace luxel {
namespace {

TEST(ExportColoured, writes_a_node_and_a_material_for_each_mesh_that_has_triangles) {
  const std::vector<ColouredMesh> meshes = {
      {"well (grey)", Vec3(0.4f), {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}}},
      {"nothing", Vec3(1.0f), {}, {}},
      {"sliver (olive)",
       Vec3(0.25f, 0.5f, 0.0f),
       {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
       {{0, 1, 2}, {1, 3, 2}}}};
  const auto path = std::filesystem::path(testing::TempDir()) / "export_coloured.glb";
  export_coloured(path, "faults of room.obj", meshes, {0, 0, 1}, {100.0, 200.0, 300.0});
  const test::GlbFile model(path);
  const auto& json = model.json;
  ASSERT_EQ(json["materials"].size(), 2u);
  EXPECT_EQ(json["materials"][1]["name"], "sliver (olive)");
  EXPECT_EQ(json["materials"][1]["pbrMetallicRoughness"]["baseColorFactor"],
            (std::vector<double>{0.25, 0.5, 0.0, 1.0}));
  ASSERT_EQ(json["scenes"][0]["nodes"].size(), 1u);
  const auto& root = json["nodes"].at(json["scenes"][0]["nodes"][0].get<std::size_t>());
  EXPECT_EQ(root["name"], "faults of room.obj");
  EXPECT_EQ(root["children"], (std::vector<int>{0, 1}));
  // Up is turned from z to y: (x, y, z) lies at (x, z, -y).
  ASSERT_EQ(root["translation"].size(), 3u);
  EXPECT_NEAR(root["translation"][1].get<double>(), 300.0, 1e-9);
  EXPECT_NEAR(root["translation"][2].get<double>(), -200.0, 1e-9);
  const auto& primitive = json["meshes"].at(json["nodes"][1]["mesh"].get<std::size_t>())["primitives"][0];
  EXPECT_EQ(model.accessor(primitive["indices"])["count"], 6u);
  EXPECT_EQ(model.accessor(primitive["attributes"]["POSITION"])["max"], (std::vector<double>{1, 1, 0}));
}

TEST(FaultParts, colour_each_face_once_and_draw_a_rod_for_each_edge) {
  const auto scene = truth::plates();  // two squares: eight open edges
  const auto report = diagnose(scene, {}, Context(1));
  std::size_t triangles = 0;
  bool has_rods = false;
  for (const auto& part : fault_parts(scene, report)) {
    if (!part.kind) triangles += part.triangles.size();
    if (part.kind != DiagnosticKind::open_edge) continue;
    has_rods = true;
    EXPECT_EQ(part.triangles.size(), 8u * 6u);
  }
  EXPECT_EQ(triangles, scene.triangles.size()) << "the faces themselves are well";
  EXPECT_TRUE(has_rods);
}

}  // namespace
}  // namespace luxel
