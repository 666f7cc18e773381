// SPDX-License-Identifier: Apache-2.0
#include "scenes/scene_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/import/load_scene.h"

#include "scenes/to_scene.h"
#include "scenes/write_scene.h"
#include "support/mesh_topology.h"

namespace luxel::scenes {
namespace {

struct Made {
  std::string name;
  MadeScene scene;
};

const std::vector<Made>& all() {
  static const auto made = [] {
    auto scenes = std::vector<Made>{};
    for (const auto& [name, about, make] : scene_list()) scenes.push_back({name, make_scene(name)});
    return scenes;
  }();
  return made;
}

std::size_t triangle_count(const MadeScene& scene) {
  auto count = std::size_t{0};
  for (const auto& object : scene.objects) count += object.mesh.triangles.size();
  return count;
}

std::filesystem::path folder() {
  const auto path = std::filesystem::path(testing::TempDir()) / "luxel-scenes";
  std::filesystem::create_directories(path);
  return path;
}

TEST(SceneList, has_ten_scenes_of_at_most_a_hundred_thousand_triangles) {
  EXPECT_GE(all().size(), 10u);
  for (const auto& [name, scene] : all()) {
    EXPECT_GT(triangle_count(scene), 10u) << name;
    EXPECT_LE(triangle_count(scene), 100'000u) << name;
  }
}

TEST(SceneList, gives_every_triangle_area) {
  for (const auto& [name, scene] : all()) {
    for (const auto& object : scene.objects) {
      for (const auto& triangle : object.mesh.triangles) {
        ASSERT_GT(glm::length(area_vector(object.mesh, triangle)), 1e-8)
            << name << ", " << object.name;  // m²
      }
    }
  }
}

TEST(SceneList, bounds_each_closed_object_on_all_sides_with_its_faces_outwards) {
  for (const auto& [name, scene] : all()) {
    for (const auto& object : scene.objects) {
      if (!object.closed) continue;
      EXPECT_EQ(open_edges(object.mesh), 0) << name << ", " << object.name;
      EXPECT_GT(enclosed_volume(object.mesh), 0.0) << name << ", " << object.name;
    }
  }
}

TEST(SceneList, leaves_no_two_triangles_in_one_place) {
  using Corner = std::array<double, 3>;
  for (const auto& [name, scene] : all()) {
    auto seen = std::set<std::array<Corner, 3>>{};
    for (const auto& object : scene.objects) {
      for (const auto& triangle : object.mesh.triangles) {
        auto key = std::array<Corner, 3>{};
        for (auto k = 0u; k < 3; ++k) {
          const auto& p = object.mesh.points[triangle.corners[k]];
          key[k] = {p.x, p.y, p.z};
        }
        std::sort(key.begin(), key.end());
        EXPECT_TRUE(seen.insert(key).second) << name << ", " << object.name;
      }
    }
  }
}

TEST(SceneList, names_its_objects_once) {
  for (const auto& [name, scene] : all()) {
    auto names = std::set<std::string>{};
    for (const auto& object : scene.objects)
      EXPECT_TRUE(names.insert(object.name).second) << name << ", " << object.name;
  }
}

TEST(SceneList, lights_every_scene_and_names_a_camera) {
  for (const auto& [name, made] : all()) {
    const auto scene = to_scene(made, name);
    EXPECT_TRUE(has_light(scene) || !made.sky.empty()) << name;
    EXPECT_FALSE(made.views.empty()) << name;
    EXPECT_NO_THROW(check_scene(scene)) << name;
  }
}

TEST(SceneList, paints_with_reflectances_below_one_under_names_of_their_own) {
  auto names = std::set<std::string>{};
  for (const auto& pigment : palette()) {
    EXPECT_EQ(&pigment - palette().data(), static_cast<int>(pigment.paint)) << pigment.name;
    EXPECT_TRUE(names.insert(pigment.name).second) << pigment.name;
    for (auto band = 0; band < 3; ++band) {
      EXPECT_GT(pigment.reflectance[band], 0.0f) << pigment.name;
      EXPECT_LT(pigment.reflectance[band], 0.9f) << pigment.name;
    }
  }
}

TEST(SceneList, refuses_a_name_that_it_does_not_have) {
  EXPECT_THROW(make_scene("ballroom"), std::out_of_range);
}

TEST(WriteScene, writes_the_same_bytes_twice) {
  for (const auto* ending : {"obj", "glb"}) {
    const auto file = folder() / (std::string("study.") + ending);
    write_scene(file, make_scene("study"));
    const auto first = read_file(file);
    write_scene(file, make_scene("study"));
    EXPECT_EQ(first, read_file(file)) << ending;
    EXPECT_GT(first.size(), 10'000u) << ending;
  }
}

TEST(WriteScene, writes_obj_and_glb_that_load_as_the_same_triangles) {
  const auto made = make_scene("study");
  for (const auto* ending : {"obj", "glb"}) {
    const auto file = folder() / (std::string("study.") + ending);
    write_scene(file, made);
    const auto scene = load_scene(file, {.retriangulate = false});
    EXPECT_EQ(scene.triangles.size(), triangle_count(made)) << ending;
    EXPECT_EQ(scene.materials.size(), to_scene(made, "study").materials.size()) << ending;
  }
}

TEST(WriteScene, puts_cameras_the_sun_and_spots_into_glb) {
  const auto made = make_scene("study");
  const auto file = folder() / "study.glb";
  write_scene(file, made);
  const auto scene = load_scene(file);
  ASSERT_EQ(scene.cameras.size(), made.views.size());
  const auto& camera = scene.cameras.front();
  EXPECT_LT(glm::distance(Vec3d(camera.eye), made.views.front().eye), 1e-5);
  const auto ahead = glm::normalize(made.views.front().target - made.views.front().eye);
  EXPECT_LT(glm::distance(glm::normalize(Vec3d(camera.target - camera.eye)), ahead), 1e-5);
  EXPECT_NEAR(camera.vertical_fov, made.views.front().vertical_fov, 1e-3);
  const auto expected = to_scene(made, "study").point_lights;
  ASSERT_EQ(scene.point_lights.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(scene.point_lights[i].kind, expected[i].kind);
    EXPECT_LT(glm::distance(scene.point_lights[i].direction, expected[i].direction), 1e-5f);
    EXPECT_LT(glm::distance(scene.point_lights[i].intensity, expected[i].intensity), 1e-3f);
  }
}

// The committed sample is what the program writes.
TEST(WriteScene, wrote_the_sample_scene) {
  const auto file = folder() / "study.glb";
  write_scene(file, make_scene("study"));
  EXPECT_EQ(read_file(file), read_file(std::filesystem::path(LUXEL_SOURCE_DIR) / "scenes" / "study.glb"))
      << "run luxel-scenes study scenes/study.glb";
  EXPECT_LT(std::filesystem::file_size(file), 150'000u);
}

TEST(WriteScene, refuses_another_ending) {
  EXPECT_THROW(write_scene(folder() / "study.fbx", make_scene("study")), InputError);
}

}  // namespace
}  // namespace luxel::scenes
