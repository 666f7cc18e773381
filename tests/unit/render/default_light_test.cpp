// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/default_light.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/scene/luminous_efficacy.h"
#include "luxel/scene/scene.h"

#include "support/scene_files.h"

namespace luxel {
namespace {

enum class Facing { inwards, outwards };

// OBJ text of boxes of quads, one object each.
class Boxes {
 public:
  Boxes& add(const Vec3& low, const Vec3& size, Facing facing, const std::string& material = "wall") {
    constexpr int quads[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                 {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
    for (int i = 0; i < 8; ++i) vertex(low + size * Vec3(i / 4, i / 2 % 2, i % 2));
    text_ += "usemtl " + material + "\n";
    for (const auto& quad : quads) {
      text_ += "f";
      for (int i = 0; i < 4; ++i)
        text_ += " " + std::to_string(vertices_ - 7 + quad[facing == Facing::outwards ? i : 3 - i]);
      text_ += "\n";
    }
    return *this;
  }
  // A square below the ceiling at height y, facing down.
  Boxes& add_panel(float y, const std::string& material) {
    for (const auto& p : {Vec3(1, y, 1), Vec3(2, y, 1), Vec3(2, y, 2), Vec3(1, y, 2)}) vertex(p);
    text_ += "usemtl " + material + "\nf -4 -3 -2 -1\n";
    return *this;
  }
  const std::string& text() const { return text_; }

 private:
  void vertex(const Vec3& p) {
    text_ += "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
    ++vertices_;
  }

  std::string text_;
  int vertices_ = 0;
};

constexpr Vec3 room(4.0f, 2.7f, 5.0f);

class DefaultLightTest : public testing::Test {
 protected:
  // Adds the light twice, on one and on three threads: the same.
  DefaultLight light(const Boxes& boxes) {
    scene_ = files_.load_text(boxes.text());
    auto again = scene_;
    const auto added = add_default_light(scene_, Context(1));
    add_default_light(again, Context(3));
    EXPECT_EQ(fingerprint(scene_), fingerprint(again)) << "it depends on the number of threads";
    EXPECT_NO_THROW(check_scene(scene_));
    EXPECT_TRUE(has_light(scene_));
    return added;
  }

  // lm, of all lamps with a surface.
  double flux() const {
    double sum = 0.0;
    for (std::size_t t = 0; t < scene_.triangles.size(); ++t) {
      const auto& m = scene_.materials[static_cast<std::size_t>(scene_.triangle_material[t])];
      const auto [a, b, c] = scene_.triangles[t];
      const auto& p = scene_.positions;
      sum += 0.5 * glm::length(glm::cross(p[b] - p[a], p[c] - p[a])) *
             lumens(m.emittance.r, m.emittance.g, m.emittance.b);
    }
    return sum;
  }

  SceneFiles files_;
  Scene scene_;
};

TEST_F(DefaultLightTest, a_scene_with_a_lamp_stays_as_it_is) {
  scene_ = files_.load_text(Boxes().add({}, room, Facing::inwards).text());
  scene_.materials[0].emittance = Vec3(1.0f);
  const auto before = fingerprint(scene_);
  const auto added = add_default_light(scene_);
  EXPECT_EQ(added.kind, DefaultLightKind::not_needed);
  EXPECT_TRUE(added.as_text().empty());
  EXPECT_TRUE(added.hints().empty());
  EXPECT_EQ(fingerprint(scene_), before);
}

TEST_F(DefaultLightTest, a_black_sky_around_a_sun_is_reported_with_the_one_that_suits_it) {
  const auto add_sun = [&] {
    scene_.point_lights.push_back({});
    scene_.point_lights.back().kind = PointLightKind::directional;
    scene_.point_lights.back().intensity = Vec3(150.0f);
  };
  scene_ = files_.load_text(Boxes().add({}, room, Facing::outwards).text());
  add_sun();
  const auto before = fingerprint(scene_);
  const auto added = add_default_light(scene_);
  EXPECT_EQ(added.kind, DefaultLightKind::sun_without_sky);
  EXPECT_EQ(fingerprint(scene_), before) << "it stays as it is";
  const auto& sky = added.suitable_sky;
  EXPECT_NEAR(std::numbers::pi * lumens(sky.r, sky.g, sky.b), 0.12 * lumens(150.0, 150.0, 150.0), 60.0);
  EXPECT_EQ(added.hints(), (std::vector<Hint>{{Setting::sky, "3.7,5.9,10"}}));
  EXPECT_FALSE(added.as_text().empty());

  scene_.sky = Vec3(1.0f);
  EXPECT_EQ(add_default_light(scene_).kind, DefaultLightKind::not_needed) << "there is a sky";
  scene_ = files_.load_text(Boxes().add({}, room, Facing::inwards).text());
  add_sun();
  EXPECT_EQ(add_default_light(scene_).kind, DefaultLightKind::not_needed) << "nothing sees the sky";
}

TEST_F(DefaultLightTest, a_solid_gets_a_sky_that_gives_the_stated_illuminance) {
  const auto added = light(Boxes().add({}, room, Facing::outwards));
  EXPECT_EQ(added.kind, DefaultLightKind::daylight);
  ASSERT_EQ(scene_.sky_radiance.size(), 2u);
  const auto& sky = scene_.sky_radiance[1];
  EXPECT_NEAR(std::numbers::pi * lumens(sky.r, sky.g, sky.b), default_daylight, 1e-6 * default_daylight);
  EXPECT_EQ(scene_.sky_patches.patch_of({0.0, 0.1, 0.99}), 1u) << "up is +Y";
  EXPECT_EQ(scene_.sky_patches.patch_of({0.0, -0.1, 0.99}), 0u);
  EXPECT_EQ(scene_.sky_radiance[0], sky * static_cast<float>(default_albedo));
  EXPECT_EQ(scene_.added_triangles, 0u);
  EXPECT_EQ(added.hints(), (std::vector<Hint>{{Setting::sky, "RADIANCE"}}));
}

TEST_F(DefaultLightTest, the_sky_of_all_directions_is_uniform) {
  scene_ = files_.load_text(Boxes().add({}, room, Facing::outwards).text());
  add_default_light(scene_, {}, DefaultSky::all_around);
  EXPECT_TRUE(scene_.sky_patches.is_one());
  EXPECT_TRUE(scene_.sky_radiance.empty());
  const auto& sky = scene_.sky;
  EXPECT_NEAR(std::numbers::pi * lumens(sky.r, sky.g, sky.b), default_daylight, 1e-6 * default_daylight);
}

TEST_F(DefaultLightTest, a_closed_room_gets_one_luminaire_that_faces_down_from_the_middle_of_its_ceiling) {
  // The inside of the desk does not count as a room.
  const auto added =
      light(Boxes().add({}, room, Facing::inwards).add({1, 0.01f, 1}, {1, 0.75f, 0.6f}, Facing::outwards));
  ASSERT_EQ(added.kind, DefaultLightKind::ceiling_luminaires) << added.as_text();
  EXPECT_EQ(added.luminaires, 1u);
  EXPECT_EQ(scene_.sky, Vec3(0.0f));
  ASSERT_EQ(scene_.added_triangles, 2u);
  Vec3 middle(0.0f);
  for (auto t = scene_.triangles.size() - 2; t < scene_.triangles.size(); ++t) {
    const auto [a, b, c] = scene_.triangles[t];
    const auto& p = scene_.positions;
    const auto normal = glm::normalize(glm::cross(p[b] - p[a], p[c] - p[a]));
    EXPECT_NEAR(normal.y, -1.0f, 1e-4f);
    middle += (p[a] + p[b] + p[c]) / 6.0f;
  }
  EXPECT_NEAR(middle.x, 0.5f * room.x, 0.5f);
  EXPECT_NEAR(middle.z, 0.5f * room.z, 0.5f);
  EXPECT_GT(middle.y, 0.95f * room.y);
  EXPECT_LT(middle.y, room.y);
  double area = 2.0 * (4.0 * 2.7 + 2.7 * 5.0 + 4.0 * 5.0) + 2.0 * (0.75 + 0.45 + 0.6);
  EXPECT_NEAR(flux(), 0.5 * default_lamp_light * area, 0.01 * flux());
}

TEST_F(DefaultLightTest, each_closed_room_gets_a_luminaire) {
  const auto added =
      light(Boxes().add({}, room, Facing::inwards).add({4.2f, 0, 0}, {2, 2.7f, 5}, Facing::inwards));
  EXPECT_EQ(added.luminaires, 2u) << added.as_text();
}

TEST_F(DefaultLightTest, a_room_whose_walls_face_outwards_is_a_room_if_most_of_its_surfaces_are_inside) {
  Boxes boxes;
  boxes.add({}, room, Facing::outwards);
  for (int i = 0; i < 6; ++i)
    boxes.add({0.3f + 0.6f * static_cast<float>(i), 0.01f, 1.0f}, {0.4f, 0.75f, 0.4f}, Facing::outwards);
  EXPECT_EQ(light(boxes).kind, DefaultLightKind::ceiling_luminaires);
}

TEST_F(DefaultLightTest, in_a_closed_room_materials_named_like_lamps_emit) {
  const auto added = light(Boxes()
                               .add({}, room, Facing::inwards)
                               .add_panel(2.6f, "CeilingLight.001")
                               .add_panel(2.5f, "light_wood"));
  ASSERT_EQ(added.kind, DefaultLightKind::lamp_materials) << added.as_text();
  EXPECT_EQ(added.materials, std::vector<std::string>{"CeilingLight.001"});
  EXPECT_EQ(scene_.added_triangles, 0u);
  EXPECT_NEAR(flux(), 0.5 * default_lamp_light * (2.0 * (4.0 * 2.7 + 2.7 * 5.0 + 4.0 * 5.0) + 2.0),
              0.01 * flux());
}

TEST_F(DefaultLightTest, an_open_scene_has_daylight_even_where_a_material_is_named_like_a_lamp) {
  EXPECT_EQ(light(Boxes().add_panel(2.6f, "lamp")).kind, DefaultLightKind::daylight);
}

TEST_F(DefaultLightTest, a_camera_inside_of_a_closed_box_makes_it_a_room) {
  scene_ = files_.load_text(Boxes().add({}, room, Facing::outwards).text());
  scene_.cameras.push_back({.eye = 0.5f * room, .target = Vec3(0.0f)});
  EXPECT_EQ(add_default_light(scene_).kind, DefaultLightKind::ceiling_luminaires);
}

}  // namespace
}  // namespace luxel
