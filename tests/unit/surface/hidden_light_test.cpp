// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/surface/smooth_light.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

// A cupboard of 1 m x 1 m on a floor of 3 m x 3 m.
Scene cupboard_on_floor() {
  truth::SceneBuilder scene;
  scene.material("floor", 0.5f, 0.0f).quad({0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0});
  scene.material("cupboard", 0.5f, 0.0f)
      .quad({1, 1, 0}, {2, 1, 0}, {2, 1, 2}, {1, 1, 2})
      .quad({2, 1, 0}, {2, 2, 0}, {2, 2, 2}, {2, 1, 2})
      .quad({2, 2, 0}, {1, 2, 0}, {1, 2, 2}, {2, 2, 2})
      .quad({1, 2, 0}, {1, 1, 0}, {1, 1, 2}, {1, 2, 2})
      .quad({1, 1, 2}, {2, 1, 2}, {2, 2, 2}, {1, 2, 2});
  return scene.scene();
}

bool is_below_cupboard(const PatchSet& patches, std::size_t p) {
  const auto c = patches.centroid(p);
  return static_cast<std::uint32_t>(patches.material[p]) == 0 && c.x > 1 && c.x < 2 && c.y > 1 && c.y < 2;
}

// 2 W/m² on the floor, 3 on the cupboard, nearly nothing below it.
Solution light_on(const PatchSet& patches) {
  Solution solution;
  solution.bands = patches.bands;
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (std::size_t b = 0; b < patches.band_count(); ++b) {
      const bool is_floor = static_cast<std::uint32_t>(patches.material[p]) == 0;
      solution.irradiance.front.push_back(is_below_cupboard(patches, p) ? 1e-6f : is_floor ? 2.0f : 3.0f);
      solution.irradiance.back.push_back(0.0f);
    }
  solution.radiosity = solution.irradiance;
  return solution;
}

TEST(HiddenLight, the_edge_of_what_stands_on_a_floor_is_as_bright_as_the_floor_beside_it) {
  const auto patches = make_patches(cupboard_on_floor(), {.max_edge = 0.2f});
  const auto solution = light_on(patches);
  const auto plain = make_smooth_light(patches, solution);
  const auto shown = make_smooth_light(patches, solution, {.lights_hidden = true});
  ASSERT_EQ(plain.corners, shown.corners);
  std::vector<char> is_of_cupboard(patches.vertices.size(), 0);
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (static_cast<std::uint32_t>(patches.material[p]) == 1)
      for (const auto vertex : patches.corners[p]) is_of_cupboard[vertex] = 1;
  std::size_t at_edge = 0, elsewhere = 0;
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (const auto corner : plain.corners[p])
      for (std::size_t b = 0; b < patches.band_count(); ++b) {
        const auto i = corner * patches.band_count() + b;
        if (!is_below_cupboard(patches, p)) {
          EXPECT_EQ(plain.irradiance.front[i], shown.irradiance.front[i]);
          continue;
        }
        EXPECT_LT(plain.irradiance.front[i], 1e-5f);
        const bool is_edge = is_of_cupboard[plain.vertex[corner]] != 0;
        EXPECT_NEAR(shown.irradiance.front[i], is_edge ? 2.0f : 0.0f, 1e-4f);
        ++(is_edge ? at_edge : elsewhere);
      }
  EXPECT_GT(at_edge, 0u);
  EXPECT_GT(elsewhere, 0u);
}

// A board through a floor: both are cut along the line where it passes, each with vertices of its own there.
TEST(HiddenLight, the_part_of_a_board_below_the_floor_is_lit_where_it_passes_through) {
  truth::SceneBuilder scene;
  scene.material("floor", 0.5f, 0.0f).quad({0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0});
  scene.material("board", 0.5f, 0.0f)
      .quad({1.5f, 0.37f, -1.1f}, {1.5f, 2.41f, -1.1f}, {1.5f, 2.41f, 0.9f}, {1.5f, 0.37f, 0.9f});
  const auto patches = make_patches(scene.scene(), {.max_edge = 0.3f});
  Solution solution;
  solution.bands = patches.bands;
  for (std::size_t p = 0; p < patches.size(); ++p)
    solution.irradiance.front.insert(solution.irradiance.front.end(), patches.band_count(),
                                     patches.centroid(p).z < 0.0f ? 1e-6f : 2.0f);
  solution.irradiance.back.assign(solution.irradiance.front.size(), 0.0f);
  solution.radiosity = solution.irradiance;
  const auto plain = make_smooth_light(patches, solution);
  const auto shown = make_smooth_light(patches, solution, {.lights_hidden = true});
  std::size_t own_vertices = 0;
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (const auto corner : plain.corners[p]) {
      const auto& place = patches.vertices[plain.vertex[corner]];
      const auto i = corner * patches.band_count();
      const bool is_board = static_cast<std::uint32_t>(patches.material[p]) == 1;
      if (!is_board || std::abs(place.z) > 1e-5f || patches.centroid(p).z > 0.0f) {
        EXPECT_EQ(plain.irradiance.front[i], shown.irradiance.front[i]);
        continue;
      }
      EXPECT_LT(plain.irradiance.front[i], 1e-5f);
      EXPECT_NEAR(shown.irradiance.front[i], 2.0f, 1e-4f) << place.y;
      ++own_vertices;
    }
  EXPECT_GT(own_vertices, 10u);
}

// Where no other surface is, a side without light lies in a hard shadow.
TEST(HiddenLight, the_edge_of_a_shadow_stays_sharp) {
  truth::SceneBuilder scene;
  scene.material("floor", 0.5f, 0.0f).quad({0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0});
  auto patches = make_patches(scene.scene(), {.max_edge = 0.3f});
  for (std::uint32_t p = 0; p < patches.size(); ++p)  // light may jump at every edge
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = patches.corners[p][k], b = patches.corners[p][(k + 1) % 3];
      if (a < b) patches.contacts.push_back({{a, b}, Vec3(0, 0, 1)});
    }
  std::sort(patches.contacts.begin(), patches.contacts.end(),
            [](const Contact& a, const Contact& b) { return a.edge < b.edge; });
  Solution solution;
  solution.bands = patches.bands;
  for (std::size_t p = 0; p < patches.size(); ++p)
    solution.irradiance.front.insert(solution.irradiance.front.end(), patches.band_count(),
                                     patches.centroid(p).x < 1.5 ? 0.0f : 2.0f);
  solution.irradiance.back.assign(solution.irradiance.front.size(), 0.0f);
  solution.radiosity = solution.irradiance;
  EXPECT_EQ(make_smooth_light(patches, solution).irradiance.front,
            make_smooth_light(patches, solution, {.lights_hidden = true}).irradiance.front);
}

}  // namespace
}  // namespace luxel
