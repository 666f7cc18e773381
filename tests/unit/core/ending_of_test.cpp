// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/ending_of.h"

#include <gtest/gtest.h>

#include "luxel/import/is_gltf.h"

namespace luxel {
namespace {

TEST(EndingOf, large_letters_make_no_other_ending) {
  EXPECT_EQ(ending_of("a/Room.GLB"), ".glb");
  EXPECT_EQ(ending_of("room.1.VtkHdf"), ".vtkhdf");
  EXPECT_EQ(ending_of("a.glb/room"), "");
  EXPECT_EQ(ending_of(".glb"), "") << "a name, not an ending";
}

TEST(IsGltf, is_told_by_the_ending_alone) {
  for (const auto* name : {"room.glb", "room.gltf", "Room.Glb", "ROOM.GLTF", "room.gLtF"})
    EXPECT_TRUE(is_gltf(name)) << name;
  for (const auto* name : {"room.obj", "glb", "room.glb.png", "room.glbx", ""})
    EXPECT_FALSE(is_gltf(name)) << name;
}

}  // namespace
}  // namespace luxel
