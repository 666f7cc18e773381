// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "luxel/scene/scene.h"

#include "support/scene_files.h"
#include "support/small_mesh_files.h"

namespace luxel {
namespace {

class LoadStl : public testing::Test {
 protected:
  Scene load(const std::string& bytes, const LoadOptions& options = {}) {
    files_.write("part.stl", bytes);
    auto scene = files_.load("part.stl", options);
    check_scene(scene);
    return scene;
  }
  std::string refusal(const std::string& bytes) {
    files_.write("part.stl", bytes);
    return files_.refusal("part.stl");
  }
  SceneFiles files_;
};

// The positions of all corners, triangle by triangle.
std::vector<Vec3> corners_of(const Scene& scene) {
  std::vector<Vec3> all;
  for (const auto& triangle : scene.triangles)
    for (const auto i : triangle) all.push_back(scene.positions[i]);
  return all;
}

TEST_F(LoadStl, text_and_binary_files_are_the_same_scene_with_shared_corners) {
  const SmallCube cube;
  std::vector<Vec3> expected;
  for (const auto& triangle : cube.triangles())
    for (const auto i : triangle) expected.push_back(cube.positions[i]);
  const auto text = load(cube.stl_text("cube"));
  const auto binary = load(cube.stl_binary());
  EXPECT_EQ(corners_of(text), expected);
  EXPECT_EQ(corners_of(binary), expected);
  EXPECT_EQ(text.positions.size(), 8u);
  EXPECT_EQ(fingerprint(binary), fingerprint(text));
  EXPECT_EQ(files_.all_warnings(), "part.stl: STL has no colours; a grey of 0.5 is taken\n");
}

TEST_F(LoadStl, solids_are_groups_and_objects) {
  const SmallCube cube;
  const auto scene = load(cube.stl_text("left wall") + cube.stl_text("chair") + cube.stl_text("left wall"));
  EXPECT_EQ(scene.groups, (std::vector<std::string>{"left wall", "chair"}));
  EXPECT_EQ(scene.objects, scene.groups);
  EXPECT_EQ(scene.triangle_object[0], 0u);
  EXPECT_EQ(scene.triangle_object[12], 1u);
  EXPECT_EQ(scene.triangle_object[24], 0u);
}

TEST_F(LoadStl, a_text_without_a_name_has_no_objects) {
  const auto scene = load(SmallCube().stl_text(""));
  EXPECT_EQ(scene.groups, std::vector<std::string>{"default"});
  EXPECT_TRUE(scene.objects.empty());
  EXPECT_EQ(scene.triangle_line[0], 7u) << "where the loop ends";
}

TEST_F(LoadStl, the_scale_applies) {
  EXPECT_EQ(load(SmallCube().stl_binary(), {.scale = 0.001}).positions[6], Vec3(0.002f));
}

TEST_F(LoadStl, capitals_and_bytes_behind_the_triangles_are_fine) {
  auto text = SmallCube().stl_text("cube");
  for (auto& c : text) c = static_cast<char>(std::toupper(c));
  EXPECT_EQ(load(text).triangles.size(), 12u);
  EXPECT_EQ(load(SmallCube().stl_binary("made by hand") + "notes").triangles.size(), 12u);
}

TEST_F(LoadStl, what_is_wrong_is_one_sentence) {
  const SmallCube cube;
  const auto binary = cube.stl_binary("made by hand");
  EXPECT_EQ(
      refusal(binary.substr(0, 300)),
      "part.stl: expected 684 bytes for the 12 triangles of this binary STL, found 300; it is cut off, or is "
      "no STL");
  EXPECT_EQ(refusal("abc"), "part.stl: expected an STL file, found neither 'solid' nor a binary one");
  EXPECT_EQ(refusal("solid nothing\nendsolid\n"), "part.stl: no triangles found");
  EXPECT_EQ(refusal("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 zero\n"),
            "part.stl:4: expected three finite numbers up to 1e+12 m after vertex, found '0 0 zero'");
  EXPECT_EQ(refusal("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"),
            "part.stl:4: the file ends within a facet; it is cut off");
  EXPECT_EQ(refusal("solid a\nf 1 2 3\n"),
            "part.stl:2: expected a statement of STL such as facet or vertex, found 'f'");
  auto nan = binary;
  const auto number = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(nan.data() + 84 + 12, &number, sizeof(number));
  EXPECT_EQ(refusal(nan),
            "part.stl: triangle 1: expected finite coordinates up to 1e+12 m, found nan 0 0 at 1 m a "
            "unit");
}

}  // namespace
}  // namespace luxel
