// SPDX-License-Identifier: Apache-2.0
// Files from the test suites of other loaders, which are not part of this repository: the test is skipped
// where they do not lie beside it.
#include <filesystem>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/core/triangle.h"
#include "luxel/import/load_scene.h"

namespace luxel {
namespace {

constexpr int refused = -1;

struct Case {
  const char* file;
  int triangles;      // or refused
  double area = 0.0;  // of all triangles, where it is known
};

constexpr Case cases[] = {
    {"tinyobjloader/cornell_box.obj", 36},
    {"tinyobjloader/cube-vertexcol.obj", 12, 24.0},
    {"tinyobjloader/cube-vertex-w-component.obj", 12, 24.0},
    {"tinyobjloader/invalid-face-definition.obj", refused},
    {"tinyobjloader/invalid-relative-vertex-index.obj", refused},
    {"tinyobjloader/issue-140-zero-face-idx.obj", refused},
    {"tinyobjloader/issue-161-inconsistent-f.obj", 12},
    {"tinyobjloader/issue-235-usemtl-then-o.obj", 2},
    {"tinyobjloader/issue-246-usemtl-whitespace.obj", 1},
    {"tinyobjloader/issue-295-trianguation-failure.obj", 28, 14.0},
    {"tinyobjloader/issue-319-003.obj", 8, 616.909},
    {"tinyobjloader/issue-356-leading-spaces-newmtl.obj", refused},
    {"tinyobjloader/leading-decimal-dot-issue-201.obj", 1, 282.55},
    {"tinyobjloader/mtllib-multiple-files-issue-112.obj", 1},
    {"tinyobjloader/no_material.obj", 36},
    {"tinyobjloader/line-prim.obj", refused},
    {"tinyobjloader/points-prim.obj", refused},
    {"tinyobjloader/test-nan.obj", refused},
    {"tinyobjloader/missing_material_file.obj", 36},
    {"tinyobjloader/texture-filename-with-whitespace.obj", 12, 24.0},
    {"assimp/box_UTF16BE.obj", refused},
    {"assimp/box_longline.obj", 944},
    {"assimp/box_without_lineending.obj", 12, 6.0},
    {"assimp/concave_polygon.obj", 64, 0.2455},
    {"assimp/cube_mtllib_after_g.obj", 12, 6.0},
    {"assimp/malformed.obj", refused},
    {"assimp/multiple_spaces.obj", 1, 2.598},
    {"assimp/number_formats.obj", refused},
    {"assimp/IndexOutOfRange.gltf", refused},
    {"assimp/RecursiveNodes.gltf", refused},
    {"assimp/BoxBadNormals.glb", 12, 6.0},
    {"assimp/wrongTypes/badNumber.gltf", 12, 6.0},
    {"gltf-validator/truncated_chunk_data.glb", refused},
    {"gltf-validator/length_mismatch.glb", refused},
    {"gltf-validator/index_buffer_oob.gltf", refused},
    {"gltf-validator/node_loop.gltf", refused},
    {"gltf-validator/emissive_strength_valid.gltf", refused},
    {"xatlas/degenerate_edge.obj", 2, 2.0},
    {"xatlas/double_sided.obj", 4, 8.0},
    {"xatlas/zero_area_face.obj", 1},
};

double total_area(const Scene& scene) {
  double sum = 0.0;
  for (const auto& [a, b, c] : scene.triangles)
    sum += triangle_area(scene.positions[a], scene.positions[b], scene.positions[c]);
  return sum;
}

TEST(CornerCases, of_other_loaders_are_read_or_refused_as_a_careful_loader_would) {
  const auto folder = std::filesystem::path(LUXEL_SOURCE_DIR) / "../shared/scenes/corner-cases";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << folder << " is not there";
  for (const auto& [file, triangles, area] : cases) {
    SCOPED_TRACE(file);
    try {
      const auto scene = load_scene(folder / file);
      check_scene(scene);
      EXPECT_EQ(static_cast<int>(scene.triangles.size()), triangles);
      if (area > 0.0) {
        EXPECT_NEAR(total_area(scene), area, 3e-4 * area);
      }
    } catch (const InputError& error) {
      EXPECT_EQ(triangles, refused) << error.what();
    }
  }
}

}  // namespace
}  // namespace luxel
