// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/hidden_sides.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

// A closed room of 4 m x 3 m x 2.5 m with a lamp below its ceiling, and a cupboard of 1 m x 1 m on its floor.
// A dark wall, half of whose surface is wound the other way.
Scene room_with_cupboard() {
  truth::SceneBuilder scene;
  scene.material("floor", 0.5f, 0.0f).quad({0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0});
  scene.material("ceiling", 0.5f, 0.0f).quad({0, 0, 2.5f}, {0, 3, 2.5f}, {4, 3, 2.5f}, {4, 0, 2.5f});
  scene.material("wall", 0.5f, 0.0f)
      .quad({0, 0, 0}, {0, 0, 2.5f}, {4, 0, 2.5f}, {4, 0, 0})
      .quad({4, 0, 0}, {4, 0, 2.5f}, {4, 3, 2.5f}, {4, 3, 0})
      .quad({4, 3, 0}, {4, 3, 2.5f}, {0, 3, 2.5f}, {0, 3, 0});
  scene.material("dark wall", 0.5f, 0.0f).quad({0, 3, 0}, {0, 3, 2.5f}, {0, 1.5f, 2.5f}, {0, 1.5f, 0});
  scene.material("dark wall, turned", 0.5f, 0.0f)
      .quad({0, 0, 0}, {0, 0, 2.5f}, {0, 1.5f, 2.5f}, {0, 1.5f, 0});
  scene.material("lamp", 0.0f, 10.0f).quad({1, 1, 2.4f}, {1, 2, 2.4f}, {2, 2, 2.4f}, {2, 1, 2.4f});
  scene.material("cupboard", 0.5f, 0.0f)
      .quad({2.5f, 1, 0}, {3.5f, 1, 0}, {3.5f, 1, 1}, {2.5f, 1, 1})
      .quad({3.5f, 1, 0}, {3.5f, 2, 0}, {3.5f, 2, 1}, {3.5f, 1, 1})
      .quad({3.5f, 2, 0}, {2.5f, 2, 0}, {2.5f, 2, 1}, {3.5f, 2, 1})
      .quad({2.5f, 2, 0}, {2.5f, 1, 0}, {2.5f, 1, 1}, {2.5f, 2, 1})
      .quad({2.5f, 1, 1}, {3.5f, 1, 1}, {3.5f, 2, 1}, {2.5f, 2, 1});
  return scene.scene();
}

class HiddenSides : public testing::Test {
 protected:
  HiddenSides() {
    solution_.bands = patches_.bands;
    for (std::uint32_t p = 0; p < patches_.size(); ++p)
      for (std::size_t b = 0; b < patches_.band_count(); ++b) {
        const bool is_dark = is("dark wall", p) || is("dark wall, turned", p) || is_below_cupboard(p);
        solution_.irradiance.front.push_back(is_dark ? 0.0f : 1.0f);
        solution_.irradiance.back.push_back(is("cupboard", p) ? 1e-5f : 0.0f);
      }
    solution_.radiosity = solution_.irradiance;
  }

  bool is(const char* material, std::uint32_t p) const { return patches_.material_of(p).name == material; }
  bool is_below_cupboard(std::uint32_t p) const {
    const auto c = patches_.centroid(p);
    return is("floor", p) && c.x > 2.5f && c.x < 3.5f && c.y > 1.0f && c.y < 2.0f;
  }

  Context context_{1};
  PatchSet patches_ = make_patches(room_with_cupboard(), {.max_edge = 0.25f});
  Tracer tracer_{patches_, context_};
  Solution solution_;
};

TEST_F(HiddenSides, are_those_within_a_cupboard_and_below_it_and_not_a_dark_wall) {
  const auto hidden = hidden_sides(patches_, solution_, tracer_, context_);
  std::size_t below = 0;
  for (std::uint32_t p = 0; p < patches_.size(); ++p) {
    const bool faces_outwards = is("dark wall, turned", p);
    below += is_below_cupboard(p) ? 1 : 0;
    EXPECT_EQ(hidden.front[p], is_below_cupboard(p) || faces_outwards) << patches_.material_of(p).name;
    EXPECT_EQ(hidden.back[p], !faces_outwards) << patches_.material_of(p).name;
  }
  EXPECT_GT(below, 8u);
}

TEST_F(HiddenSides, are_none_where_the_views_are_restricted_or_no_light_is_found) {
  patches_.focuses_on_cameras = true;
  const auto of_cameras = hidden_sides(patches_, solution_, tracer_, context_);
  EXPECT_EQ(std::count(of_cameras.back.begin(), of_cameras.back.end(), 1), 0);
  patches_ = make_patches(truth::SceneBuilder()
                              .material("wall", 0.5f, 0.0f)
                              .quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0})
                              .scene(),
                          {.max_edge = 0.25f});
  solution_.irradiance.front.assign(3 * patches_.size(), 0.0f);
  solution_.irradiance.back = solution_.irradiance.front;
  const auto unlit = hidden_sides(patches_, solution_, Tracer(patches_, context_), context_);
  EXPECT_EQ(std::count(unlit.front.begin(), unlit.front.end(), 1), 0);
}

}  // namespace
}  // namespace luxel
