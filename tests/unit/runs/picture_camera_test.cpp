// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/picture_camera.h"

#include <cmath>

#include <gtest/gtest.h>

#include "luxel/solution/solution_file.h"

#include "support/lit_rooms.h"

namespace luxel {
namespace {

// A lit room whose scene has two cameras, as its file gives it back.
Baked stored_room(const std::string& name, std::vector<Camera> cameras) {
  test::LitPatches lit;
  test::add_box(lit, Vec3(0.0f), Vec3(4.0f, 3.0f, 5.0f), test::Facing::inwards, 1.0f, false);
  lit.patches.cameras = std::move(cameras);
  const auto path = testing::TempDir() + name;
  write_solution(path, lit.patches, lit.solution);
  return read_solution(path);
}

Camera found(const PictureSettings& settings, const Baked& baked) {
  const Context context(2);
  return camera_of(settings, {}, baked, Tracer(baked.patches, context), context);
}

const Camera of_file{Vec3(1.0f, 1.5f, 4.0f), Vec3(2.0f, 1.0f, 0.0f), Vec3(0.0f, 1.0f, 0.0f), 40.0f};
const Camera another{Vec3(3.0f, 1.5f, 4.0f), Vec3(2.0f, 1.0f, 0.0f), Vec3(0.0f, 1.0f, 0.0f), 50.0f};

TEST(PictureCamera, is_the_first_of_the_scenes_file_for_a_stored_solution_too) {
  const auto camera = found({}, stored_room("of_file.vtkhdf", {of_file, another}));
  EXPECT_EQ(camera.eye, of_file.eye);
  EXPECT_EQ(camera.target, of_file.target);
  EXPECT_EQ(camera.vertical_fov, of_file.vertical_fov);
}

TEST(PictureCamera, of_the_file_shows_as_much_from_left_to_right_in_a_narrower_picture) {
  auto wide = of_file;
  wide.aspect = 16.0f / 9.0f;
  const auto baked = stored_room("wide.vtkhdf", {wide});
  const auto half_width = [&](int width, int height) {
    PictureSettings settings;
    settings.render.width = width;
    settings.render.height = height;
    const auto tangent = std::tan(0.5 * glm::radians(double{found(settings, baked).vertical_fov}));
    return tangent * width / height;
  };
  const auto meant = std::tan(glm::radians(20.0)) * 16.0 / 9.0;
  EXPECT_NEAR(half_width(640, 480), meant, 1e-5);
  EXPECT_NEAR(half_width(300, 400), meant, 1e-5);
  EXPECT_NEAR(half_width(1280, 720), meant, 1e-5);
  EXPECT_NEAR(half_width(2000, 1000), std::tan(glm::radians(20.0)) * 2.0, 1e-5);  // a wider one shows more
}

TEST(PictureCamera, that_is_given_comes_before_that_of_the_file) {
  PictureSettings given;
  given.eye = Vec3d(2.0, 1.0, 1.0);
  given.target = Vec3d(2.0, 1.0, 3.0);
  const auto camera = found(given, stored_room("given.vtkhdf", {of_file}));
  EXPECT_EQ(camera.eye, Vec3(2.0f, 1.0f, 1.0f));
  EXPECT_EQ(camera.target, Vec3(2.0f, 1.0f, 3.0f));
}

}  // namespace
}  // namespace luxel
