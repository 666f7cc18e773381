// SPDX-License-Identifier: Apache-2.0
// Scenes in which surfaces pierce one another in too many places.
#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "luxel/core/hint.h"
#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

using truth::SceneBuilder;

// Adds n triangles at random places of the unit cube, each of which pierces many others.
SceneBuilder& tangle(SceneBuilder& b, std::uint32_t n) {
  b.material("grey", 0.5f, 0.0f);
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto point = [&](std::uint32_t k) {
      const auto u = uniform4(7, 3 * i + k);
      return Vec3(u[0], u[1], u[2]);
    };
    b.triangle(point(0), point(1), point(2));
  }
  return b;
}

TEST(DenseLines, in_more_places_than_a_given_limit_are_refused) {
  SceneBuilder b;
  const auto scene = tangle(b, 200).scene();
  const auto many = make_patches(scene, {.max_edge = no_max_edge});
  EXPECT_GT(many.size(), 1000u);
  EXPECT_LT(many.size(), 200'000u);
  // The lines themselves are more; and only the patches that they add.
  for (const std::size_t limit : {std::size_t{1000}, many.size() / 2}) {
    try {
      make_patches(scene, {.max_edge = no_max_edge, .max_contacts = limit});
      FAIL() << "expected an InputError";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(fmt::format("more than {} lines or patches", limit)),
                std::string::npos)
          << error.what();
      EXPECT_EQ(hints_of(error).front().setting, Setting::max_contacts);
    }
  }
}

TEST(DenseLines, of_a_tangle_are_left_out_and_those_of_a_wall_beside_it_stay) {
  SceneBuilder b;
  tangle(b, 700);
  b.quad({2, 2, 0}, {6, 2, 0}, {6, 6, 0}, {2, 6, 0});  // a floor, and a wall on it
  b.quad({3, 4, 0}, {4, 4, 0}, {4, 4, 1}, {3, 4, 1});
  std::vector<Message> heard;
  const auto log = Context().with_log([&](const Message& m) { heard.push_back(m); });
  const auto patches = make_patches(b.scene(), {.max_edge = no_max_edge}, log);
  EXPECT_LT(patches.size(), 200'000u);
  double at_wall = 0.0;  // m, of the floor, on one side of the line
  for (const auto& c : patches.contacts) {
    const auto a = patches.vertices[c.edge[0]], b = patches.vertices[c.edge[1]];
    if (a.y == 4.0f && b.y == 4.0f && c.into.z > 0.99f) at_wall += glm::distance(Vec3d(a), Vec3d(b));
  }
  EXPECT_NEAR(at_wall, 1.0, 1e-5);
  const auto warning = std::find_if(heard.begin(), heard.end(),
                                    [](const Message& m) { return m.severity == Severity::warning; });
  ASSERT_NE(warning, heard.end());
  EXPECT_NE(warning->text.find("triangles with the densest contacts are not cut: light may leak there"),
            std::string::npos)
      << warning->text;
  ASSERT_FALSE(warning->hints.empty());
  EXPECT_EQ(warning->hints.front().setting, Setting::max_contacts);
}

}  // namespace
}  // namespace luxel
