// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/scene_gltf.h"

#include <gtest/gtest.h>

#include "support/scene_files.h"
#include "support/truth_scenes.h"

namespace luxel {
namespace {

TEST(SceneGltf, keeps_what_diffusers_reflect_and_transmit) {
  truth::SceneBuilder builder;
  builder.material("opal", 0.4f, 0.0f).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  builder.material("wall", 0.5f, 0.0f).quad({0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0});
  auto scene = builder.scene();
  scene.materials[0].reflectance = Vec3(0.4f, 0.3f, 0.1f);
  scene.materials[0].diffuse_transmittance = Vec3(0.2f, 0.5f, 0.3f);
  SceneFiles files;
  files.write("scene.glb", gltf_of(scene, {0, 1, 0}).bytes);
  const auto read = files.load("scene.glb");
  ASSERT_EQ(read.materials.size(), 2u);
  for (int band = 0; band < 3; ++band) {
    EXPECT_NEAR(read.materials[0].reflectance[band], scene.materials[0].reflectance[band], 1e-6f);
    EXPECT_NEAR(read.materials[0].diffuse_transmittance[band], scene.materials[0].diffuse_transmittance[band],
                1e-6f);
  }
  EXPECT_FALSE(read.materials[1].is_diffuser());
}

}  // namespace
}  // namespace luxel
