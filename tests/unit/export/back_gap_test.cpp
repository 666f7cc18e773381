// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/back_gap.h"

#include <vector>

#include <gtest/gtest.h>

#include "support/lit_rooms.h"

namespace luxel {
namespace {

TEST(BackGap, is_there_where_a_program_shows_both_faces_and_is_of_the_scenes_size) {
  test::LitPatches lit;
  test::add_box(lit, Vec3(0.0f), Vec3(3.0f, 4.0f, 12.0f), test::Facing::inwards, 1.0f, false);
  EXPECT_EQ(back_gap(lit.patches, TargetApplication::any), 0.0f);
  EXPECT_NEAR(back_gap(lit.patches, TargetApplication::blender), 5e-5f * 13.0f, 1e-8f);
}

TEST(BackGap, moves_a_sheet_straight_and_leaves_points_of_no_triangle) {
  std::vector<Vec3> positions{{0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}, {5, 5, 5}};
  const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 2, 1}, {0, 3, 2}};  // facing -z
  move_outwards(positions, triangles, 0.25f);
  EXPECT_EQ(positions,
            (std::vector<Vec3>{{0, 0, 1.75f}, {1, 0, 1.75f}, {1, 1, 1.75f}, {0, 1, 1.75f}, {5, 5, 5}}));
}

}  // namespace
}  // namespace luxel
