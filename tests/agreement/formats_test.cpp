// SPDX-License-Identifier: Apache-2.0
// A scene has the same light in every file format.
#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/solve/sampled.h"
#include "luxel/trace/tracer.h"

#include "support/scene_files.h"
#include "support/small_gltf.h"

namespace luxel {
namespace {

// The scene as glTF: one primitive per triangle, which preserves their order; radiance becomes luminance.
SmallGltf as_gltf(const Scene& scene) {
  SmallGltf gltf;
  std::string primitives, materials;
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    std::vector<float> corners;
    for (const auto corner : scene.triangles[i])
      for (int axis = 0; axis < 3; ++axis) corners.push_back(scene.positions[corner][axis]);
    primitives += fmt::format(R"({}{{"attributes":{{"POSITION":{}}},"material":{}}})", i > 0 ? "," : "",
                              gltf.points(corners), static_cast<std::uint32_t>(scene.triangle_material[i]));
  }
  for (const auto& m : scene.materials) {
    const auto nits = 179.0f / pi * m.emittance;
    materials +=
        fmt::format(R"({}{{"name":"{}","doubleSided":true,"pbrMetallicRoughness":{{"metallicFactor":0,)"
                    R"("baseColorFactor":[{},{},{},1]}},"emissiveFactor":[{},{},{}]}})",
                    materials.empty() ? "" : ",", m.name, m.reflectance.r, m.reflectance.g, m.reflectance.b,
                    nits.r, nits.g, nits.b);
  }
  gltf.meshes = fmt::format(R"({{"primitives":[{}]}})", primitives);
  gltf.rest = fmt::format(R"(,"materials":[{}])", materials);
  return gltf;
}

Solution lit(const Scene& scene) {
  const Context context;
  const auto patches = make_patches(scene, {.max_edge = 0.1f});
  const Tracer tracer(patches, context);
  Solution light;
  solve_sampled(patches, tracer, light, {.error = 0.0, .error_measure = ErrorMeasure::power, .rays = 100'000},
                context);
  return light;
}

TEST(Formats, the_cornell_box_has_the_same_light_as_obj_and_as_glb) {
  SceneFiles files;
  const auto obj = load_scene(std::filesystem::path(LUXEL_SOURCE_DIR) / "scenes/cornell-box.obj");
  files.write("box.glb", as_gltf(obj).glb());
  const auto glb = files.load("box.glb");
  EXPECT_TRUE(files.warnings().empty()) << files.all_warnings();
  ASSERT_EQ(glb.triangles.size(), obj.triangles.size());
  const auto one = lit(obj), other = lit(glb);
  ASSERT_EQ(one.irradiance.front.size(), other.irradiance.front.size());
  // Everything is bitwise equal except the lamp's emission, which was converted to cd/m² and back.
  float brightest = 0.0f;
  for (const auto light : one.irradiance.front) brightest = std::max(brightest, light);
  EXPECT_GT(brightest, 0.0f);
  for (std::size_t i = 0; i < one.irradiance.front.size(); ++i)
    ASSERT_NEAR(one.irradiance.front[i], other.irradiance.front[i], 1e-5f * brightest) << i;
}

}  // namespace
}  // namespace luxel
