// SPDX-License-Identifier: Apache-2.0
#include <cstdint>

#include <gtest/gtest.h>

#include "support/scene_files.h"

namespace luxel {
namespace {

// Every kind of statement the loader acts on.
const std::string good_obj = R"(# a room with a lamp
mtllib room.mtl gone.mtl
v -1.5 0 -1.5
v 1.5 0 -1.5
v 1.5 0 1.5e0
v -1.5 0 +1.5
v -1.5 2.5 -1.5
v 1.5 2.5 -1.5
v 1.5 2.5 1.5
v -1.5 2.5 1.5
vt 0 0
vt 1 0
vt 1 1
vn 0 1 0
vn 0 -1 0
vn 0 0 1
o room
g floor
usemtl wood
f 4/1/1 3/2/1 2/3/1 1/1/1
g ceiling
usemtl white paint
f 5//2 6//2 7//2 8//2
g walls
f 1 2 6 5
f -8 -5 -1 -4 # left
f 3 4 8 7
usemtl gone
v 0 2.4 0
v 0.5 2.4 0
v 0.5 2.4 0.5
v 0.2 2.4 0.1
v 0 2.4 0.5
usemtl lamp
g lamp \
  shade
s off
f 9 10 11 \
  12 13
f 9 10
l 1 2
f 9 9 10
)";

const std::string good_mtl = R"(# materials
newmtl wood
Kd 0.4 0.3 0.2
map_Kd -s 2 2 1 fine wood.png
illum 2

newmtl white paint
Kd 0.8
d 1

newmtl lamp
Kd 0 0 0
Ke 10 9 8
map_Ke -clamp on shade.png
Tr 0.9
)";

// Returns true where the file is a sound scene, false where it is refused in one sentence; anything else
// fails the test.
bool is_answered(SceneFiles& files) {
  try {
    check_scene(files.load("room.obj"));
    return true;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("room."), std::string::npos) << error.what();
    return false;
  }
}

// Numerical Recipes' linear congruential generator: the same damage on every host.
class Dice {
 public:
  std::size_t below(std::size_t n) { return ((state_ = state_ * 1664525u + 1013904223u) >> 8) % n; }

 private:
  std::uint32_t state_ = 2017;
};

// Changes, doubles or removes one to four bytes, mostly using bytes with a meaning in the format.
std::string damage(std::string text, Dice& dice) {
  static const std::string tongue = "0123456789.-+e/# \\\r\n\tvfnagouKsdmtl\x01\xFF*\"";
  for (auto times = 1 + dice.below(4); times > 0; --times) {
    const auto at = dice.below(text.size());
    switch (dice.below(4)) {
      case 0:
        text.erase(at, 1 + dice.below(8));
        break;
      case 1:
        text.insert(at, text.substr(dice.below(text.size()), 1 + dice.below(12)));
        break;
      default:
        text[at] = tongue[dice.below(tongue.size())];
    }
  }
  return text;
}

TEST(LoadDamaged, the_undamaged_files_load) {
  SceneFiles files;
  files.write("room.obj", good_obj);
  files.write("room.mtl", good_mtl);
  const auto scene = files.load("room.obj");
  EXPECT_EQ(scene.triangles.size(), 14u);
  EXPECT_EQ(scene.materials.size(), 3u);
}

TEST(LoadDamaged, every_truncation_of_an_obj_is_a_scene_or_an_error) {
  SceneFiles files;
  files.write("room.mtl", good_mtl);
  std::size_t scenes = 0;
  for (std::size_t size = 0; size < good_obj.size(); ++size) {
    files.write("room.obj", good_obj.substr(0, size));
    scenes += is_answered(files);
  }
  EXPECT_GT(scenes, good_obj.size() / 4);
  EXPECT_LT(scenes, good_obj.size());
}

TEST(LoadDamaged, every_truncation_of_an_mtl_is_a_scene_or_an_error) {
  SceneFiles files;
  files.write("room.obj", good_obj);
  std::size_t scenes = 0;
  for (std::size_t size = 0; size < good_mtl.size(); ++size) {
    files.write("room.mtl", good_mtl.substr(0, size));
    scenes += is_answered(files);
  }
  EXPECT_GT(scenes, good_mtl.size() / 4);
  EXPECT_LT(scenes, good_mtl.size());
}

TEST(LoadDamaged, every_mutation_is_a_scene_or_an_error) {
  SceneFiles files;
  Dice dice;
  std::size_t scenes = 0;
  const std::size_t trials = 3000;
  for (std::size_t i = 0; i < trials; ++i) {
    files.write("room.obj", i % 4 == 0 ? good_obj : damage(good_obj, dice));
    files.write("room.mtl", i % 4 == 0 ? damage(good_mtl, dice) : good_mtl);
    scenes += is_answered(files);
  }
  EXPECT_GT(scenes, trials / 10);
  EXPECT_LT(scenes, trials);
}

TEST(LoadDamaged, the_same_damage_gives_the_same_scene_and_warnings) {
  SceneFiles files;
  Dice dice;
  files.write("room.mtl", good_mtl);
  for (int i = 0; i < 50; ++i) {
    files.write("room.obj", damage(good_obj, dice));
    if (!is_answered(files)) continue;
    const auto first = fingerprint(files.load("room.obj"));
    const auto warnings = files.all_warnings();
    EXPECT_EQ(fingerprint(files.load("room.obj")), first);
    EXPECT_EQ(files.all_warnings(), warnings);
  }
}

}  // namespace
}  // namespace luxel
