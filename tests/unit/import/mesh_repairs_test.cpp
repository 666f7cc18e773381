// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "luxel/scene/orient_windings.h"
#include "luxel/scene/t_junctions.h"
#include "luxel/scene/weld_vertices.h"

#include "support/scene_files.h"

namespace luxel {
namespace {

struct Topology {
  VertexWeld weld;
  CleanTriangles clean;
  Edges edges;
  Components components;

  explicit Topology(const Scene& scene)
      : clean(clean_triangles(scene, weld)),
        edges(find_edges(clean.kept, weld.positions().size())),
        components(find_components(weld.positions(), clean.kept, edges)) {}

  std::size_t open() const {
    std::size_t count = 0;
    for (std::size_t e = 0; e < edges.size(); ++e) count += edges.is_open(e) ? 1 : 0;
    return count;
  }
  std::size_t inconsistent() const {
    std::size_t count = 0;
    for (std::size_t e = 0; e < edges.size(); ++e) count += edges.winds_inconsistently(e) ? 1 : 0;
    return count;
  }
};

// A cube of 1 m around `at`, wound outwards but for the faces named in `turned`, each face with four vertices
// of its own, which lie up to `apart` m off the corner.
std::string cube(const Vec3d& at, const std::string& turned, double apart) {
  std::string text;
  int jitter = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      for (int k = 0; k < 4; ++k) {
        Vec3d p(0.0);
        p[axis] = 0.5 * sign;
        p[(axis + 1) % 3] = (k == 1 || k == 2 ? 0.5 : -0.5) * sign;
        p[(axis + 2) % 3] = k >= 2 ? 0.5 : -0.5;
        p += at;
        p[jitter % 3] += apart * ((jitter * 7) % 5 - 2) / 4.0;
        ++jitter;
        text += "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
      }
      const auto name = std::string(sign < 0 ? "-" : "+") + "xyz"[axis];
      text += turned.find(name) == std::string::npos ? "f -4 -3 -2 -1\n" : "f -1 -2 -3 -4\n";
    }
  return text;
}

TEST(Weld, thins_a_chain_out_and_moves_nothing_farther_than_asked) {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {2.4f, 0, 0}};
  EXPECT_EQ(weld_points(points, 1.2), (std::vector<std::uint32_t>{0, 0, 2, 2, 2}));
  EXPECT_EQ(weld_points(points, 0.0), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
  EXPECT_THROW(weld_points(points, -1.0), InputError);
  EXPECT_THROW(weld_points(points, INFINITY), InputError);
  // Cell numbers out of range: far away, with a distance below the float resolution there.
  const std::vector<Vec3> far = {{1e12f, 0, 0}, {1e12f, 1e-9f, 0}, {-1e12f, 0, 0}};
  EXPECT_EQ(weld_points(far, 1e-8), (std::vector<std::uint32_t>{0, 0, 2}));
}

TEST(Weld, makes_a_cube_of_loose_faces_closed_again_and_says_so) {
  SceneFiles files;
  files.write("cube.obj", "usemtl wall\n" + cube(Vec3d(0.0), "", 0.0004));
  EXPECT_EQ(Topology(files.load("cube.obj")).open(), 24u);
  const auto scene = files.load("cube.obj", {.weld = 0.001f});
  EXPECT_NE(files.all_warnings().find("vertices moved onto another one, by 0.000"), std::string::npos)
      << files.all_warnings();
  const Topology mesh(scene);
  EXPECT_EQ(mesh.weld.positions().size(), 8u);
  EXPECT_EQ(mesh.open(), 0u);
  ASSERT_EQ(mesh.components.components.size(), 1u);
  EXPECT_TRUE(mesh.components.components[0].is_closed);
  EXPECT_NEAR(mesh.components.components[0].volume, 1.0, 0.005);
}

TEST(Weld, tells_the_triangles_it_takes_the_area_of) {
  SceneFiles files;
  files.load_text("v 0 0 0\nv 1 0 0\nv 1 0.0005 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n", {.weld = 0.001f});
  EXPECT_NE(files.all_warnings().find("1 triangle lost its area"), std::string::npos) << files.all_warnings();
}

TEST(Orient, makes_a_closed_piece_face_outwards_and_says_what_it_turned) {
  for (const char* turned : {"", "+x", "+x-y", "-x+x-y+y-z+z"}) {
    SceneFiles files;
    const auto scene = files.load_text(cube(Vec3d(5.0, 0.0, 0.0), turned, 0.0), {.orient = true});
    const Topology mesh(scene);
    EXPECT_EQ(mesh.inconsistent(), 0u) << turned;
    EXPECT_NEAR(mesh.components.components[0].volume, 1.0, 1e-6) << turned;
    const auto count = std::string(turned).size();  // two letters a face of two triangles
    const auto expected = count == 0
                              ? std::string("nothing was flipped")
                              : std::to_string(count) + " triangles flipped in 1 of 1 connected components";
    EXPECT_NE(files.all_warnings().find(expected), std::string::npos) << files.all_warnings();
  }
}

TEST(Orient, goes_by_the_greater_area_in_an_open_piece) {
  SceneFiles files;
  // Three squares in a row; the middle one faces the other way.
  const auto scene = files.load_text(
      "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 1 0\n"
      "f 1 2 6 5\nf 2 6 7 3\nf 3 4 8 7\n",
      {.orient = true});
  EXPECT_EQ(Topology(scene).inconsistent(), 0u);
  for (const auto& t : scene.triangles) {
    const auto a = scene.positions[t[0]], b = scene.positions[t[1]], c = scene.positions[t[2]];
    EXPECT_GT(glm::cross(b - a, c - a).z, 0.0f);
  }
}

TEST(Orient, never_turns_a_lamp_and_follows_it) {
  SceneFiles files;
  files.write("room.mtl", "newmtl lamp\nKe 1 1 1\n");
  // The face +y shines inwards, to where the rest of the cube does not look.
  const auto text = cube(Vec3d(0.0), "+y", 0.0);
  std::string with_lamp = "mtllib room.mtl\nusemtl wall\n";
  const auto face = text.find("f -1 -2 -3 -4\n");
  with_lamp += text.substr(0, face) + "usemtl lamp\n" + text.substr(face, 14) + "usemtl wall\n" +
               text.substr(face + 14);
  const auto scene = files.load_text(with_lamp, {.orient = true});
  const Topology mesh(scene);
  EXPECT_EQ(mesh.inconsistent(), 0u);
  EXPECT_NEAR(mesh.components.components[0].volume, -1.0, 1e-6) << "inwards, as its lamp";
  EXPECT_NE(files.all_warnings().find("1 that follow their lamps"), std::string::npos)
      << files.all_warnings();
}

TEST(Orient, leaves_what_has_no_consistent_side) {
  // A Moebius strip of five quads.
  std::string text;
  constexpr int parts = 5;
  for (int i = 0; i < parts; ++i) {
    const double turn = 2.0 * 3.14159265358979 * i / parts;
    for (const double side : {-0.3, 0.3}) {
      const double r = 1.0 + side * std::cos(turn / 2.0);
      text += "v " + std::to_string(r * std::cos(turn)) + " " + std::to_string(r * std::sin(turn)) + " " +
              std::to_string(side * std::sin(turn / 2.0)) + "\n";
    }
  }
  for (int i = 0; i < parts; ++i) {
    const int a = 2 * i + 1, b = a + 1;
    const bool last = i == parts - 1;
    const int c = last ? 1 : a + 3, d = last ? 2 : a + 2;
    text += "f " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + " " +
            std::to_string(d) + "\n";
  }
  SceneFiles files;
  const auto scene = files.load_text(text, {.orient = true});
  EXPECT_NE(files.all_warnings().find("1 components cannot be oriented consistently"), std::string::npos)
      << files.all_warnings();
}

TEST(TJunctions, are_found_in_a_million_times_the_size_and_far_away) {
  for (const double scale : {1e-3, 1.0, 1e3}) {
    SceneFiles files;
    const auto scene = files.load_text(
        "v 0 0 0\nv 3 1 2\nv 0 3 0\nv 1 0.33333333 0.66666667\nv 2 -3 1\nv 1 -3 0\n"
        "f 1 2 3\nf 4 1 6\nf 2 4 5\n",
        {.scale = static_cast<float>(scale)});
    const Topology mesh(scene);
    const auto& places = mesh.weld.positions();
    const auto junctions = find_t_junctions(places, mesh.edges, rounding_distance(places));
    EXPECT_EQ(junctions.found.size(), 1u) << scale;
  }
}

}  // namespace
}  // namespace luxel
