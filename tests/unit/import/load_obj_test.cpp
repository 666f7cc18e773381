// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "luxel/core/triangle.h"

#include "support/scene_files.h"

namespace luxel {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(LoadObj, positions_are_the_nearest_floats_of_the_text) {
  SceneFiles files;
  const auto scene = files.load_text("v 0.1 +2. -.7e+2\nv 1e-60 3 16777217\nv 1 2 3 4\nf 1 2 3\n");
  EXPECT_EQ(scene.positions,
            (std::vector<Vec3>{Vec3(0.1f, 2.0f, -70.0f), Vec3(0, 3, 16777216.0f), Vec3(1, 2, 3)}));
  check_scene(scene);
}

TEST(LoadObj, vertex_colours_and_weights_are_passed_over) {
  SceneFiles files;
  const auto scene = files.load_text("v 0 0 0 1 0 0\nv 1 0 0 0.5\nv 0 1 0 1 1 1\nf 1 2 3\n");
  EXPECT_EQ(scene.positions[1], Vec3(1, 0, 0));
}

TEST(LoadObj, corners_may_name_textures_and_normals) {
  SceneFiles files;
  const auto scene = files.load_text(
      square + "vt 0 0\nvn 0 0 1\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 3/1/1\nf 1/ 2// 3/1/\n");
  EXPECT_EQ(scene.triangles, std::vector<Triangle>(4, Triangle{0, 1, 2}));
}

TEST(LoadObj, negative_indices_count_back_from_the_last_vertex) {
  SceneFiles files;
  const auto scene = files.load_text(square + "f -4 -3 -2\nv 2 2 2\nf -1 1 2\n");
  EXPECT_EQ(scene.triangles, (std::vector<Triangle>{{0, 1, 2}, {4, 0, 1}}));
}

TEST(LoadObj, a_face_may_come_before_its_vertices) {
  SceneFiles files;
  EXPECT_EQ(files.load_text("f 1 2 3\n" + square).triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(LoadObj, each_triangle_knows_its_line) {
  SceneFiles files;
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const auto text = "v 0 0 0" + end + "v 1 0 0" + end + "v 1 1 0" + end + "# a comment" + end + "v 0 1 0" +
                      end + end + "f 1 2 3 4" + end + "f 1 2 3";
    EXPECT_EQ(files.load_text(text).triangle_line, (std::vector<std::uint32_t>{7, 7, 8}));
  }
}

TEST(LoadObj, a_statement_may_go_on_behind_a_backslash) {
  SceneFiles files;
  const auto scene = files.load_text(square + "f 1 2 \\\n 3 4\nf 1 2 3\n");
  EXPECT_EQ(scene.triangle_line, (std::vector<std::uint32_t>{5, 5, 7}));
}

TEST(LoadObj, a_comment_may_stand_behind_corners_and_coordinates) {
  SceneFiles files;
  EXPECT_EQ(files.load_text("v 0 0 0 # origin\nv 1 0 0#x\nv 0 1 0\nf 1 2 3 # 4 5\n").triangles.size(), 1u);
}

TEST(LoadObj, blanks_and_tabs_are_all_the_same) {
  SceneFiles files;
  const auto scene = files.load_text("  v   0 0\t0  \n\tv\t1 0 0\nv 0   1 0\n  f  1\t2   3   \n");
  EXPECT_EQ(scene.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(LoadObj, a_byte_order_mark_is_no_text) {
  SceneFiles files;
  EXPECT_EQ(files.load_text("\xEF\xBB\xBF" + square + "f 1 2 3\n").triangles.size(), 1u);
}

TEST(LoadObj, utf16_is_told_to_become_utf8) {
  SceneFiles files;
  for (const std::string mark : {"\xFF\xFE", "\xFE\xFF"})
    EXPECT_EQ(files.refusal_of_text(mark + "v"),
              "room.obj: expected UTF-8 text, found UTF-16 or UTF-32; save it as UTF-8");
}

TEST(LoadObj, a_binary_file_is_refused) {
  SceneFiles files;
  EXPECT_EQ(files.refusal_of_text(square + std::string("f 1\0 2 3", 8)),
            "room.obj:5: expected text, found a zero byte; the file is binary or damaged");
}

TEST(LoadObj, an_empty_file_is_refused) {
  SceneFiles files;
  EXPECT_EQ(files.refusal_of_text(""), "room.obj: no faces found; the file is empty");
}

TEST(LoadObj, a_file_without_faces_is_refused) {
  SceneFiles files;
  EXPECT_EQ(files.refusal_of_text(square + "l 1 2 3\np 1 2\n"),
            "room.obj: no faces found; expected lines such as 'f 1 2 3', found 4 vertex positions");
}

TEST(LoadObj, lines_and_points_are_passed_over) {
  SceneFiles files;
  EXPECT_EQ(files.load_text(square + "l 1 2 3\np 1 2\nf 1 2 3\n").triangles.size(), 1u);
}

TEST(LoadObj, coordinates_that_are_no_numbers_name_their_line) {
  SceneFiles files;
  const auto refusal = [&](const std::string& line) {
    return files.refusal_of_text("v 0 0 0\n" + line + "\n");
  };
  EXPECT_EQ(refusal("v 1 2 3.1+e2"), "room.obj:2: expected three finite numbers after v, found '1 2 3.1+e2'");
  EXPECT_EQ(refusal("v 1 abc 3"), "room.obj:2: expected three finite numbers after v, found '1 abc 3'");
  EXPECT_EQ(refusal("v 1 2"), "room.obj:2: expected three finite numbers after v, found '1 2'");
  EXPECT_EQ(refusal("v"), "room.obj:2: expected three finite numbers after v, found ''");
  for (const std::string number : {"nan", "-inf", "1.#INF", "1e40", "1e99999999999"})
    EXPECT_EQ(refusal("v 0 " + number + " 0"),
              "room.obj:2: expected three finite numbers after v, found '0 " + number + " 0'");
}

TEST(LoadObj, a_long_wrong_line_is_shown_in_part) {
  SceneFiles files;
  const auto refusal = files.refusal_of_text("v " + std::string(10'000, 'x'));
  EXPECT_LT(refusal.size(), 200u);
}

TEST(LoadObj, a_face_with_index_zero_names_its_line) {
  SceneFiles files;
  EXPECT_EQ(files.refusal_of_text(square + "f 1 0 2\n"),
            "room.obj:5: a corner names vertex 0, expected indices that count from 1");
}

TEST(LoadObj, an_index_out_of_range_names_its_line) {
  SceneFiles files;
  EXPECT_EQ(files.refusal_of_text(square + "f 1 2 3\nf 1 2 5\n"),
            "room.obj:6: a corner names vertex 5, but the file gives only 4");
  EXPECT_EQ(files.refusal_of_text(square + "f 1 2 -5\n"),
            "room.obj:5: a corner names vertex -5, but only 4 were given before this line");
  EXPECT_EQ(files.refusal_of_text(square + "vn 0 0 1\nf 1//1 2//1 3//2\n"),
            "room.obj:6: a corner names normal 2, but the file gives only 1");
}

TEST(LoadObj, corners_that_are_no_indices_name_their_line) {
  SceneFiles files;
  for (const std::string corner :
       {"1.5", "x", "1/x", "/1", "1/2/3/4", "--1", "1-", "99999999999999999999", "0x1"})
    EXPECT_EQ(files.refusal_of_text(square + "f 1 2 " + corner + "\n"),
              "room.obj:5: expected corners such as 3, 3/1 or 3/1/2 after f, found '" + corner + "'");
}

TEST(LoadObj, faces_of_fewer_than_three_corners_are_dropped_and_counted) {
  SceneFiles files;
  EXPECT_EQ(files.load_text(square + "usemtl a\nf 1 2\nf 1\nf 1 2 3\n").triangles.size(), 1u);
  EXPECT_NE(
      files.all_warnings().find("room.obj: 2 faces of fewer than three corners (first: line 6); dropped\n"),
      std::string::npos)
      << files.all_warnings();
}

TEST(LoadObj, faces_without_area_are_kept) {
  SceneFiles files;
  const auto scene = files.load_text(square + "v 2 0 0\nf 1 1 2\nf 1 2 5\nf 1 2 3\n");
  EXPECT_EQ(scene.triangles, (std::vector<Triangle>{{0, 0, 1}, {0, 1, 4}, {0, 1, 2}}));
  check_scene(scene);
}

TEST(LoadObj, a_convex_polygon_is_a_fan) {
  SceneFiles files;
  EXPECT_EQ(files.load_text(square + "f 1 2 3 4\n").triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(LoadObj, a_dent_in_a_polygon_stays_a_dent) {
  SceneFiles files;
  const auto scene = files.load_text("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n");
  double area = 0.0;
  for (const auto& [a, b, c] : scene.triangles)
    area += triangle_area(scene.positions[a], scene.positions[b], scene.positions[c]);
  EXPECT_EQ(scene.triangles.size(), 3u);
  EXPECT_EQ(area, 10.0);
}

TEST(LoadObj, vertex_normals_say_which_side_is_the_front) {
  SceneFiles files;
  const auto scene =
      files.load_text(square + "usemtl a\nvn 0 0 -1\nvn 0 0 1\nf 1//1 2//1 3//1\nf 1//2 2//2 3//2\n");
  EXPECT_EQ(scene.triangles, (std::vector<Triangle>{{0, 2, 1}, {0, 1, 2}}));
  EXPECT_NE(files.all_warnings().find(
                "room.obj: 1 triangle wound against the vertex normals (first: line 8); turned round\n"),
            std::string::npos)
      << files.all_warnings();
}

TEST(LoadObj, a_face_with_one_corner_without_normal_stays_as_it_is_wound) {
  SceneFiles files;
  const auto scene = files.load_text(square + "vn 0 0 -1\nf 1//1 2//1 3\n");
  EXPECT_EQ(scene.triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(LoadObj, a_normal_that_is_no_direction_says_nothing) {
  SceneFiles files;
  const auto scene = files.load_text(square + "vn nan nan nan\nf 1//1 2//1 3//1\n");
  EXPECT_EQ(scene.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_NE(
      files.all_warnings().find("1 vertex normal not of three finite numbers (first: line 5); passed over"),
      std::string::npos)
      << files.all_warnings();
}

TEST(LoadObj, the_last_g_or_o_names_the_group) {
  SceneFiles files;
  const auto scene = files.load_text(
      square + "f 1 2 3\no box \nf 1 2 3\ng front side\nf 1 2 3\ng box\nf 1 2 3\ng\nf 1 2 3\n");
  EXPECT_EQ(scene.groups, (std::vector<std::string>{"default", "box", "front side"}));
  EXPECT_EQ(scene.triangle_group, (std::vector<std::uint32_t>{0, 1, 2, 1, 0}));
}

TEST(LoadObj, objects_hold_across_groups_and_are_none_where_the_file_names_none) {
  SceneFiles files;
  const auto scene = files.load_text(square + "f 1 2 3\no box\nf 1 2 3\ng lid\nf 1 2 3\no\nf 1 2 3\n");
  EXPECT_EQ(scene.objects, (std::vector<std::string>{"default", "box"}));
  EXPECT_EQ(scene.triangle_object, (std::vector<std::uint32_t>{0, 1, 1, 0}));
  const auto plain = files.load_text(square + "g lid\nf 1 2 3\n");
  EXPECT_TRUE(plain.objects.empty());
  EXPECT_TRUE(plain.triangle_object.empty());
}

TEST(LoadObj, usemtl_holds_across_o_and_g) {
  SceneFiles files;
  const auto scene =
      files.load_text(square + "usemtl a\no one\nf 1 2 3\ng two\nf 1 2 3\nusemtl b\nf 1 2 3\n");
  EXPECT_EQ(scene.triangle_material, (std::vector{MaterialId{0}, MaterialId{0}, MaterialId{1}}));
  EXPECT_EQ(scene.materials[0].name, "a");
  EXPECT_EQ(scene.materials[1].name, "b");
}

TEST(LoadObj, faces_before_any_usemtl_are_grey) {
  SceneFiles files;
  const auto scene = files.load_text(square + "f 1 2 3\nf 1 2 3\nusemtl a\nf 1 2 3\n");
  EXPECT_EQ(scene.materials[0].name, "default");
  EXPECT_EQ(scene.materials[0].reflectance, Vec3(0.5f));
  EXPECT_EQ(files.warnings().at(1),
            "room.obj: 2 faces before any usemtl (first: line 5); the material 'default' is taken");
}

TEST(LoadObj, materials_no_face_uses_do_not_appear) {
  SceneFiles files;
  EXPECT_EQ(files.load_text(square + "usemtl a\nusemtl b\nf 1 2 3\n").materials.size(), 1u);
}

// Place of a vertex in the file.
Vec3d in_file(const Scene& scene, std::size_t vertex) {
  return scene.origin + Vec3d(scene.positions[vertex]);
}

TEST(LoadObj, coordinates_far_from_zero_keep_their_micrometres) {
  SceneFiles files;
  const auto scene = files.load_text(
      "v 100000.123456 -999999.000001 4.5\nv 100005.000001 -999998.999 4.5\nv 100000.5 -999995.25 7\n"
      "f 1 2 3\n");
  EXPECT_EQ(scene.origin, Vec3d(100'000.0, -1'000'000.0, 8.0));  // multiples of 8, the power of two above 5
  const std::vector<Vec3d> expected = {
      {100000.123456, -999999.000001, 4.5}, {100005.000001, -999998.999, 4.5}, {100000.5, -999995.25, 7.0}};
  for (std::size_t v = 0; v < 3; ++v) EXPECT_LT(glm::distance(in_file(scene, v), expected[v]), 1e-6);
  check_scene(scene);
}

TEST(LoadObj, a_scene_has_an_origin_from_eight_times_its_size_on) {
  SceneFiles files;
  const auto at = [&](double x) {
    return files.load_text(fmt::format("v {0} 0 0\nv {1} 0 0\nv {0} 1 0\nv 1e9 0 0\nf 1 2 3\n", x - 1.0, x));
  };
  EXPECT_EQ(at(8.0).origin, Vec3d(0.0));
  EXPECT_EQ(at(8.001).origin, Vec3d(8.0, 0.0, 0.0)) << "a vertex that no face uses does not count";
  EXPECT_EQ(at(-100.0).origin, Vec3d(-100.0, 0.0, 0.0));
}

TEST(LoadObj, the_scale_of_a_scene_far_from_zero_is_exact) {
  SceneFiles files;
  const auto scene =
      files.load_text("v 1e8 0 0\nv 100001000.5 0 0\nv 1e8 1000 0\nf 1 2 3\n", {.scale = 0.001});
  EXPECT_NEAR(in_file(scene, 0).x, 100'000.0, 1e-9);
  EXPECT_NEAR(in_file(scene, 1).x, 100'001.0005, 1e-7);
}

TEST(LoadObj, loading_can_be_stopped) {
  SceneFiles files;
  files.write("room.obj", square + "f 1 2 3\n");
  for (const std::string stage : {"load", "triangles"}) {
    const auto stop_there = [&](const Progress& progress) {
      return progress.stage == stage ? Next::stop : Next::go_on;
    };
    const auto scene = load_scene(files.path("room.obj"), {}, Context().with_monitor(stop_there));
    EXPECT_TRUE(scene.triangles.empty()) << stage;
  }
}

}  // namespace
}  // namespace luxel
