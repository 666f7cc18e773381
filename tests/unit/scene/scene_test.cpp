// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/scene.h"

#include <limits>
#include <memory>
#include <span>
#include <string>

#include <gtest/gtest.h>

#include "luxel/core/error.h"

namespace luxel {
namespace {

// Two triangles of a unit square in the plane z = 0, the second one a lamp, and an unused vertex.
Scene square() {
  Scene scene;
  scene.source = "square.obj";
  scene.positions = {Vec3(0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(9, 9, 9)};
  scene.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.triangle_material = {MaterialId{0}, MaterialId{1}};
  scene.triangle_line = {6, 7};
  scene.triangle_group = {0, 0};
  scene.groups = {"default"};
  scene.materials.resize(2);
  scene.materials[0].name = "wall";
  scene.materials[1].name = "lamp";
  scene.materials[1].emittance = Vec3(3.0f, 2.0f, 1.0f);
  return scene;
}

std::string refusal(const Scene& scene) {
  try {
    check_scene(scene);
  } catch (const InputError& error) {
    return error.what();
  }
  return "found nothing wrong";
}

TEST(Bounds, hold_all_triangles_and_no_unused_vertex) {
  const auto box = bounds(square());
  EXPECT_EQ(box.low, Vec3(0, 0, 0));
  EXPECT_EQ(box.high, Vec3(1, 1, 0));
}

TEST(CheckScene, a_good_scene_passes) {
  auto scene = square();
  scene.cameras.push_back({});
  EXPECT_EQ(refusal(scene), "found nothing wrong");
}

TEST(CheckScene, an_index_past_the_vertices_is_named_with_its_line) {
  auto scene = square();
  scene.triangles[1][2] = 5;
  EXPECT_EQ(refusal(scene),
            "square.obj:7: triangle 1 names vertex 5, but there are only 5 (numbered from 0)");
}

TEST(CheckScene, an_index_past_the_materials_or_groups_is_refused) {
  auto scene = square();
  scene.triangle_material[0] = MaterialId{2};
  EXPECT_NE(refusal(scene).find("names material 2"), std::string::npos);
  scene = square();
  scene.triangle_group[0] = 1;
  EXPECT_NE(refusal(scene).find("names group 1"), std::string::npos);
  scene = square();
  scene.objects = {"box"};
  EXPECT_NE(refusal(scene).find("triangle_object"), std::string::npos);
  scene.triangle_object = {0, 1};
  EXPECT_NE(refusal(scene).find("names object 1"), std::string::npos);
}

TEST(CheckScene, arrays_of_unlike_length_are_refused) {
  auto scene = square();
  scene.triangle_line.pop_back();
  EXPECT_EQ(refusal(scene), "square.obj: expected one triangle_line for each of the 2 triangles, found 1");
  scene = square();
  scene.triangle_material.pop_back();
  EXPECT_NE(refusal(scene).find("triangle_material"), std::string::npos);
  scene = square();
  scene.triangle_group.push_back(0);
  EXPECT_NE(refusal(scene).find("triangle_group"), std::string::npos);
}

TEST(CheckScene, nothing_to_light_is_refused) {
  EXPECT_NE(refusal(Scene{}).find("at least one triangle"), std::string::npos);
  auto scene = square();
  scene.materials.clear();
  EXPECT_NE(refusal(scene).find("at least one material"), std::string::npos);
  scene = square();
  scene.groups.clear();
  EXPECT_NE(refusal(scene).find("at least one group"), std::string::npos);
}

TEST(CheckScene, a_vertex_at_infinity_is_refused_even_unused) {
  auto scene = square();
  for (const float y :
       {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(), -2e12f}) {
    scene.positions[4].y = y;
    EXPECT_EQ(refusal(scene), "square.obj: vertex 4 is not finite, or lies beyond 1e+12 m") << y;
  }
}

TEST(CheckScene, a_surface_that_reflects_all_light_is_refused) {
  for (const float rho : {1.0f, -0.1f, std::numeric_limits<float>::quiet_NaN()}) {
    auto scene = square();
    scene.materials[0].reflectance.g = rho;
    EXPECT_NE(refusal(scene).find("reflectance of material 'wall'"), std::string::npos) << rho;
  }
}

TEST(CheckScene, a_lamp_that_swallows_light_is_refused) {
  for (const float emitted : {-1.0f, std::numeric_limits<float>::infinity()}) {
    auto scene = square();
    scene.materials[1].emittance.b = emitted;
    EXPECT_NE(refusal(scene).find("emittance of material 'lamp'"), std::string::npos) << emitted;
  }
}

TEST(CheckScene, a_sky_that_swallows_light_is_refused) {
  for (const float radiance : {-1.0f, std::numeric_limits<float>::quiet_NaN()}) {
    auto scene = square();
    scene.sky.g = radiance;
    EXPECT_NE(refusal(scene).find("radiance of the sky"), std::string::npos) << radiance;
  }
}

TEST(CheckScene, a_camera_that_looks_along_its_up_is_refused) {
  auto scene = square();
  scene.cameras.push_back({.eye = Vec3(0, 3, 0), .target = Vec3(0), .up = Vec3(0, 1, 0)});
  EXPECT_NE(refusal(scene).find("camera"), std::string::npos);
  scene.cameras.back() = {.vertical_fov = 180.0f};
  EXPECT_NE(refusal(scene).find("field of view"), std::string::npos);
}

// The value is part of every solution file, so it may never change.
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

// A change of a good scene, and a part of the sentence with which it is refused.
struct Change {
  void (*make)(Scene&);
  const char* sentence;
};

void expect_refusals(const Scene& good, std::span<const Change> changes) {
  ASSERT_EQ(refusal(good), "found nothing wrong");
  for (const auto& [make, sentence] : changes) {
    auto scene = good;
    make(scene);
    EXPECT_NE(refusal(scene).find(sentence), std::string::npos)
        << refusal(scene) << "; expected " << sentence;
  }
}

TEST(CheckScene, lamps_without_a_surface_that_make_no_sense_are_refused) {
  auto scene = square();
  PointLight luminaire;
  luminaire.name = "panel";
  luminaire.kind = PointLightKind::luminaire;
  luminaire.photometry = std::make_shared<Photometry>();
  PointLight spot;
  spot.kind = PointLightKind::spot;
  spot.name = "spot";
  scene.point_lights = {luminaire, spot};
  const Change changes[] = {
      {[](Scene& s) { s.point_lights[0].position.y = not_a_number; },
       "lamp 'panel': expected a finite position"},
      {[](Scene& s) { s.point_lights[0].direction *= 2.0f; }, "a direction of length 1"},
      {[](Scene& s) { s.point_lights[0].intensity.g = -1.0f; }, "an intensity of 0 or more"},
      {[](Scene& s) { s.point_lights[0].photometry = nullptr; }, "the distribution of a photometric file"},
      {[](Scene& s) { s.point_lights[0].local_x = s.point_lights[0].local_y; },
       "axes of length 1 at right angles"},
      {[](Scene& s) { s.point_lights[0].dimming = not_a_number; }, "a dimming of 0 or more"},
      {[](Scene& s) { s.point_lights[0].maintenance = 0.0f; }, "a maintenance factor above 0, at most 1"},
      {[](Scene& s) { s.point_lights[1].cos_inner = s.point_lights[1].cos_outer; },
       "lamp 'spot': expected an inner angle smaller than the outer one"},
      {[](Scene& s) { s.point_lights[1].angular_radius = 0.6f; }, "an angular radius from 0 to 0.5 rad"}};
  expect_refusals(scene, changes);
}

TEST(CheckScene, textures_that_are_not_there_are_refused) {
  auto scene = square();
  auto raster = std::make_shared<Raster>();
  raster->width = raster->height = 1;
  raster->codes = {{255, 255, 255, 255}};
  scene.textures.push_back({});
  scene.textures[0].name = "tiles";
  scene.textures[0].raster = raster;
  scene.uv_sets.resize(1);
  scene.uv_sets[0].resize(2);
  scene.corner_colours.resize(2, {Vec3(1.0f), Vec3(1.0f), Vec3(1.0f)});
  scene.materials[0].textures.reflectance = TextureUse{};
  const Change changes[] = {
      {[](Scene& s) { s.materials[0].textures.reflectance->texture = 1; },
       "material 'wall': it names texture 1, but there are only 1"},
      {[](Scene& s) { s.materials[0].textures.reflectance->uv_set = 1; },
       "it names set 1 of texture coordinates, but there are only 1"},
      {[](Scene& s) { s.materials[0].textures.reflectance->placement[2] = not_a_number; },
       "finite numbers for where its texture lies"},
      {[](Scene& s) { s.textures[0].raster = nullptr; }, "expected pixels in texture 'tiles'"},
      {[](Scene& s) { s.uv_sets[0][1][2].x = not_a_number; },
       "square.obj:7: expected finite texture coordinates for triangle 1"},
      {[](Scene& s) { s.corner_colours[0][0].r = 1.5f; },
       "expected colours of corners in [0, 1], found 1.5"}};
  expect_refusals(scene, changes);
}

TEST(CheckScene, a_sky_of_patches_has_a_radiance_for_each) {
  auto scene = square();
  scene.sky_patches = SkyPatches(1, Vec3d(0, 0, 1), Vec3d(0, 1, 0));
  scene.sky_radiance.resize(scene.sky_patches.size(), Vec3(1.0f));
  const Change changes[] = {
      {[](Scene& s) { s.sky_radiance.pop_back(); }, "expected a radiance for each of the"},
      {[](Scene& s) { s.sky_radiance.clear(); }, "expected a radiance for each of the"},
      {[](Scene& s) { s.sky = Vec3(1.0f); }, "either a sky of one radiance or one of a radiance per patch"},
      {[](Scene& s) { s.sky_radiance[3].b = -1.0f; },
       "the radiance of each patch of the sky to be 0 or more"}};
  expect_refusals(scene, changes);
}

TEST(CheckScene, spectra_ascend_and_are_light_or_reflectance) {
  auto scene = square();
  scene.wavelengths = {500.0, 600.0};
  scene.materials[0].reflectance_spectrum = Spectrum({{500.0, 0.5}, {600.0, 0.5}});
  const Change changes[] = {
      {[](Scene& s) { s.wavelengths.pop_back(); }, "expected no wavelengths, or at least two, found one"},
      {[](Scene& s) {
         s.wavelengths = {600.0, 500.0};
       },
       "expected wavelengths that ascend from"},
      {[](Scene& s) {
         s.wavelengths = {10.0, 500.0};
       },
       "expected wavelengths that ascend from"},
      {[](Scene& s) {
         s.materials[0].reflectance_spectrum = Spectrum({{600.0, 0.5}, {500.0, 0.5}});
       },
       "the wavelengths of the reflectance of material 'wall' to ascend, found 500 nm after 600 nm"},
      {[](Scene& s) {
         s.materials[0].reflectance_spectrum = Spectrum({{500.0, 1.5}, {600.0, 0.5}});
       },
       "the reflectance of material 'wall' at 500 nm to be 0 or more and below 1, found 1.5"}};
  expect_refusals(scene, changes);
}

TEST(Fingerprint, of_a_known_scene_is_a_known_number) {
  EXPECT_EQ(fingerprint(square()), 17355894178984871049u);
}

TEST(Fingerprint, takes_minus_zero_for_zero) {
  auto scene = square();
  scene.positions[0].x = -0.0f;
  EXPECT_EQ(fingerprint(scene), fingerprint(square()));
}

TEST(Fingerprint, is_blind_to_names_lines_groups_and_cameras) {
  auto scene = square();
  scene.source = "copy.obj";
  scene.materials[0].name = "paper";
  scene.triangle_line = {1, 2};
  scene.groups = {"a", "b"};
  scene.triangle_group = {1, 0};
  scene.cameras.push_back({});
  EXPECT_EQ(fingerprint(scene), fingerprint(square()));
}

TEST(Fingerprint, sees_all_that_light_depends_on) {
  const auto before = fingerprint(square());
  const auto changed = [&](auto change) {
    auto scene = square();
    change(scene);
    return fingerprint(scene) != before;
  };
  EXPECT_TRUE(changed([](Scene& s) { s.positions[3].z = std::numeric_limits<float>::denorm_min(); }));
  EXPECT_TRUE(changed([](Scene& s) { std::swap(s.positions[0], s.positions[1]); }));
  EXPECT_TRUE(changed([](Scene& s) { s.positions.pop_back(); }));
  EXPECT_TRUE(changed([](Scene& s) { std::swap(s.triangles[0][0], s.triangles[0][1]); }));
  EXPECT_TRUE(changed([](Scene& s) { std::swap(s.triangles[0], s.triangles[1]); }));
  EXPECT_TRUE(changed([](Scene& s) { s.triangle_material[0] = MaterialId{1}; }));
  EXPECT_TRUE(changed([](Scene& s) { s.materials[0].reflectance.r = 0.25f; }));
  EXPECT_TRUE(changed([](Scene& s) { s.materials[1].emittance.r = 3.5f; }));
  EXPECT_TRUE(changed([](Scene& s) { s.materials[0].two_sided = false; }));
  EXPECT_TRUE(changed([](Scene& s) { s.origin.z = 1e6; }));
  EXPECT_TRUE(changed([](Scene& s) { s.sky.b = 1.0f; }));
}

}  // namespace
}  // namespace luxel
