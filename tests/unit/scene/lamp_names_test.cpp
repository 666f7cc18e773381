// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/lamp_names.h"

#include <gtest/gtest.h>

namespace luxel {
namespace {

TEST(LampNames, are_those_with_a_word_for_a_lamp_or_that_end_in_light) {
  for (const char* name : {"lamp", "Lamp.001", "CeilingLight", "ceiling_light-2", "LIGHTS", "bulb",
                           "desk lamp shade", "LED", "MatEmissive", "neonSign", "light"})
    EXPECT_TRUE(is_lamp_name(name)) << name;
}

TEST(LampNames, are_not_those_where_light_is_a_shade_or_a_part_of_a_word) {
  for (const char* name :
       {"", "001", "light wood", "LightGrey", "lightblue", "slight", "clamp", "delight", "ledge", "wall"})
    EXPECT_FALSE(is_lamp_name(name)) << name;
}

}  // namespace
}  // namespace luxel
