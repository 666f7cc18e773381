// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/light_sheets.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

constexpr int tiles = 8;  // in each direction

// Tiles of 0.2 m with joints of 1 cm, one-sided, at some height over a floor of mortar.
Scene tiled_floor(float height) {
  truth::SceneBuilder b;
  constexpr float pitch = 0.21f, edge = 0.2f;
  b.material("mortar", 0.5f, 1.0f, false)
      .quad({0, 0, 0}, {pitch * tiles, 0, 0}, {pitch * tiles, pitch * tiles, 0}, {0, pitch * tiles, 0});
  b.material("tile", 0.5f, 1.0f, false);
  for (int i = 0; i < tiles; ++i)
    for (int k = 0; k < tiles; ++k) {
      const auto x = pitch * static_cast<float>(i), y = pitch * static_cast<float>(k);
      b.quad({x, y, height}, {x + edge, y, height}, {x + edge, y + edge, height}, {x, y + edge, height});
    }
  return b.scene();
}

// The materials of each sheet.
std::vector<std::set<std::string>> materials_of_sheets(const Scene& scene) {
  const auto patches = make_patches(scene, {.max_edge = 0.1f});
  const auto tree = make_patch_tree(patches, Context(1));
  const auto sides = all_gather_sides(patches, tree);
  std::vector<std::set<std::string>> result;
  for (const auto& sheet : make_light_sheets(patches, tree, sides)) {
    auto& materials = result.emplace_back();
    for (const auto receiver : sheet.receivers)
      materials.insert(patches.material_of(sides.side[receiver].patch()).name);
  }
  return result;
}

TEST(LightSheets, tiles_are_one_sheet_and_the_mortar_below_them_another) {
  for (const auto height : {0.001f, 0.1f}) {
    const auto sheets = materials_of_sheets(tiled_floor(height));
    ASSERT_EQ(sheets.size(), 2u) << height;
    EXPECT_EQ(sheets[0], std::set<std::string>{"mortar"});
    EXPECT_EQ(sheets[1], std::set<std::string>{"tile"});
  }
}

TEST(LightSheets, pieces_of_one_plane_are_one_sheet_although_they_do_not_touch) {
  truth::SceneBuilder b;
  b.material("tile", 0.5f, 1.0f, false);
  for (int i = 0; i < tiles; ++i) {
    // Heights as a file with five digits rounds them.
    const auto x = 0.21f * static_cast<float>(i), z = 1e-5f * static_cast<float>(i % 2);
    b.quad({x, 0, z}, {x + 0.2f, 0, z}, {x + 0.2f, 0.2f, z}, {x, 0.2f, z});
  }
  EXPECT_EQ(materials_of_sheets(b.scene()).size(), 1u);
}

}  // namespace
}  // namespace luxel
