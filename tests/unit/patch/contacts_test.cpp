// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include <gtest/gtest.h>

#include "luxel/core/address.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/plane_parts.h"

#include "support/axes.h"
#include "support/truth_scenes.h"

namespace luxel {
namespace {

using test::up;

using truth::SceneBuilder;

double area_of(const PatchSet& patches) {
  double sum = 0.0;
  for (const auto a : patches.area) sum += a;
  return sum;
}

using Edge = std::array<std::uint32_t, 2>;
std::map<Edge, int> directed_edges(const PatchSet& patches) {
  std::map<Edge, int> uses;
  for (const auto& c : patches.corners)
    for (std::size_t k = 0; k < 3; ++k) ++uses[{c[k], c[(k + 1) % 3]}];
  return uses;
}

// Total length of contacts in this direction whose ends both fit, m.
double length_of_contacts(
    const PatchSet& patches, const Vec3& into,
    const std::function<bool(const Vec3&)>& fits = [](const Vec3&) { return true; }) {
  double sum = 0.0;
  for (const auto& c : patches.contacts) {
    const auto a = patches.vertices[c.edge[0]];
    const auto b = patches.vertices[c.edge[1]];
    if (glm::dot(c.into, into) > 0.99f && fits(a) && fits(b)) sum += glm::distance(Vec3d(a), Vec3d(b));
  }
  return sum;
}

// Invariants of every cut.
void expect_sound(const Scene& scene, const PatchOptions& options, const PatchSet& patches) {
  auto without = options;
  without.contacts = false;
  const auto whole = make_patches(scene, without);
  EXPECT_TRUE(whole.contacts.empty());
  EXPECT_NEAR(area_of(patches) / area_of(whole), 1.0, 1e-6);
  const auto uses = directed_edges(patches);
  for (const auto& c : patches.contacts) {
    EXPECT_LT(c.edge[0], c.edge[1]);
    EXPECT_TRUE(uses.count(c.edge) > 0 || uses.count({c.edge[1], c.edge[0]}) > 0) << "no patch has the edge";
    EXPECT_NEAR(glm::length(c.into), 1.0f, 1e-5f);
    const auto along =
        glm::normalize(Vec3d(patches.vertices[c.edge[1]]) - Vec3d(patches.vertices[c.edge[0]]));
    EXPECT_NEAR(glm::dot(along, Vec3d(c.into)), 0.0, 1e-5);
  }
  EXPECT_TRUE(std::is_sorted(patches.contacts.begin(), patches.contacts.end(),
                             [](const Contact& a, const Contact& b) { return a.edge < b.edge; }));
  std::map<std::uint32_t, Vec3> normal;
  for (std::size_t p = 0; p < whole.size(); ++p) normal[whole.triangle[p]] = whole.normal[p];
  for (std::size_t p = 0; p < patches.size(); ++p) {
    EXPECT_EQ(patches.normal[p], normal[patches.triangle[p]]);
    const auto [a, b, c] = patches.points(p);
    EXPECT_GT(glm::dot(glm::cross(b - a, c - a), patches.normal[p]), 0.0f) << "a piece is turned over";
  }
}

// Each edge is met as often in one direction as in the other: no cracks, no T-vertices. (Surfaces that cross
// may share edges of a cut.)
void expect_closed(const PatchSet& patches) {
  const auto uses = directed_edges(patches);
  std::size_t open = 0;
  for (const auto& [edge, count] : uses) {
    const auto back = uses.find({edge[1], edge[0]});
    if (back == uses.end() || back->second != count) ++open;
  }
  EXPECT_EQ(open, 0u) << "of " << uses.size();
}

// The longest interval, m, along which a triangle of the scene passes through the inside of a patch, `margin`
// (m) or more from its edges.
double longest_passage(const Scene& scene, const PatchSet& patches, double margin) {
  double longest = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto c = patches.points(p);
    const Vec3d n(patches.normal[p]);
    for (const auto& t : scene.triangles) {
      std::array<Vec3d, 3> q{scene.positions[t[0]], scene.positions[t[1]], scene.positions[t[2]]};
      std::array<double, 3> h{};
      for (std::size_t k = 0; k < 3; ++k) h[k] = glm::dot(n, q[k] - Vec3d(c[0]));
      if (std::min({h[0], h[1], h[2]}) > -margin || std::max({h[0], h[1], h[2]}) < margin) continue;
      std::vector<Vec3d> ends;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto l = (k + 1) % 3;
        if (h[k] * h[l] < 0.0) ends.push_back(q[k] + h[k] / (h[k] - h[l]) * (q[l] - q[k]));
      }
      if (ends.size() != 2) continue;
      double begin = 0.0, end = 1.0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d a(c[k]);
        const auto inward = glm::normalize(glm::cross(n, Vec3d(c[(k + 1) % 3]) - a));
        const auto s = glm::dot(inward, ends[0] - a) - margin;
        const auto e = glm::dot(inward, ends[1] - a) - margin;
        if (s < 0.0 && e < 0.0) end = -1.0;
        if (s < 0.0 && e >= 0.0) begin = std::max(begin, s / (s - e));
        if (s >= 0.0 && e < 0.0) end = std::min(end, s / (s - e));
      }
      longest = std::max(longest, (end - begin) * glm::distance(ends[0], ends[1]));
    }
  }
  return longest;
}

// A floor 4 m wide in the plane z = 0, one quad.
SceneBuilder& floor(SceneBuilder& b, float scale = 1.0f, const Vec3& at = Vec3(0.0f)) {
  const auto s = 4.0f * scale;
  return b.material("floor", 0.5f, 1.0f).quad(at, at + Vec3(s, 0, 0), at + Vec3(s, s, 0), at + Vec3(0, s, 0));
}

// A wall from one place to another, between two heights.
SceneBuilder& wall(SceneBuilder& b, const Vec3& from, const Vec3& to, float low, float high) {
  return b.quad(from + low * up, to + low * up, to + high * up, from + high * up);
}

SceneBuilder& box(
    SceneBuilder& b, const Vec3& low, const Vec3& high,
    const std::function<Vec3(const Vec3&)>& turned = [](const Vec3& p) { return p; }) {
  const auto at = [&](int x, int y, int z) {
    return turned({x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z});
  };
  return b.quad(at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0))
      .quad(at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1))
      .quad(at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1))
      .quad(at(1, 1, 0), at(0, 1, 0), at(0, 1, 1), at(1, 1, 1))
      .quad(at(0, 1, 0), at(0, 0, 0), at(0, 0, 1), at(0, 1, 1))
      .quad(at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1));
}

TEST(Contacts, a_wall_on_one_floor_polygon_parts_it_at_any_scale_and_far_away) {
  for (const float scale : {1e-3f, 1.0f, 1e3f})
    for (const float edge : {no_max_edge, 0.3f * scale}) {
      SceneBuilder b;
      floor(b, scale);
      wall(b, Vec3(0.9f, 1.7f, 0) * scale, Vec3(3.1f, 2.3f, 0) * scale, 0.0f, 2.5f * scale);
      const auto patches = make_patches(b.scene(), {.max_edge = edge});
      expect_sound(b.scene(), {.max_edge = edge}, patches);
      EXPECT_NEAR(length_of_contacts(patches, up), std::hypot(2.2, 0.6) * scale, 1e-4 * scale);
      EXPECT_EQ(length_of_contacts(patches, -up), 0.0);
    }
  SceneBuilder b;
  const Vec3 far(1e5f, -1e5f, 10.0f);  // where floats are 8 mm apart
  floor(b, 1.0f, far);
  wall(b, far + Vec3(0.9f, 1.7f, 0), far + Vec3(3.1f, 2.3f, 0), 0.0f, 2.5f);
  const auto patches = make_patches(b.scene(), {.max_edge = 0.3f});
  EXPECT_NEAR(length_of_contacts(patches, up), std::hypot(2.2, 0.6), 0.05);
  EXPECT_NEAR(area_of(patches), 4.0 * 4.0 + std::hypot(2.2, 0.6) * 2.5, 0.1);
}

// Within a fifth of a third of an edge, 2 cm here, its foot divides the light too (near_lines.h).
TEST(Contacts, a_wall_that_ends_a_little_above_or_below_the_floor_stands_on_it) {
  for (const float low : {-5e-5f, 5e-5f, 1e-3f, 3e-2f}) {
    SceneBuilder b;
    floor(b);
    wall(b, Vec3(1, 2, 0), Vec3(3, 2, 0), low, 2.5f);
    const auto patches = make_patches(b.scene(), {.max_edge = 0.3f});
    EXPECT_NEAR(length_of_contacts(patches, up), low < 2e-2f ? 2.0 : 0.0, 1e-5);
    EXPECT_EQ(length_of_contacts(patches, -up), 0.0);
  }
}

TEST(Contacts, a_wall_through_a_floor_parts_it_above_and_below_and_the_floor_parts_the_wall) {
  SceneBuilder b;
  floor(b);
  wall(b, Vec3(1, 2, 0), Vec3(3, 2, 0), -1.0f, 1.3f);
  const auto patches = make_patches(b.scene(), {.max_edge = 0.3f});
  expect_sound(b.scene(), {.max_edge = 0.3f}, patches);
  for (const auto& into : {up, -up, Vec3(0, 1, 0), Vec3(0, -1, 0)})
    EXPECT_NEAR(length_of_contacts(patches, into), 2.0, 1e-5);
  EXPECT_LT(longest_passage(b.scene(), patches, 1e-5), 1e-5);
}

TEST(Contacts, a_box_that_juts_out_over_a_table_parts_the_table_top_and_its_own_bottom) {
  SceneBuilder b;
  b.material("wood", 0.5f, 1.0f);
  box(b, Vec3(0, 0, 0), Vec3(1, 1, 1));
  box(b, Vec3(0.5f, 0.5f, 1), Vec3(1.5f, 1.5f, 2));
  for (const float edge : {no_max_edge, 0.3f, 0.07f}) {
    const auto patches = make_patches(b.scene(), {.max_edge = edge});
    expect_sound(b.scene(), {.max_edge = edge}, patches);
    expect_closed(patches);
    EXPECT_NEAR(length_of_contacts(patches, up), 1.0, 1e-5);
    EXPECT_NEAR(length_of_contacts(patches, -up), 1.0, 1e-5);
  }
}

TEST(Contacts, the_rim_of_a_carpet_parts_the_floor) {
  for (const float height : {0.0f, 5e-5f}) {
    SceneBuilder b;
    floor(b).quad({1, 1, height}, {3, 1, height}, {3, 2, height}, {1, 2, height});
    const auto patches = make_patches(b.scene(), {.max_edge = 0.3f});
    EXPECT_NEAR(length_of_contacts(patches, up), 6.0, 1e-4);
    EXPECT_NEAR(length_of_contacts(patches, -up), height == 0.0f ? 6.0 : 0.0, 1e-4);
  }
}

TEST(Contacts, a_wall_on_lines_of_the_floor_is_found_though_nothing_fits) {
  SceneBuilder b;
  b.material("floor", 0.5f, 1.0f);
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 8; ++y) {
      const auto at = 0.5f * Vec3(static_cast<float>(x), static_cast<float>(y), 0);
      b.quad(at, at + Vec3(0.5f, 0, 0), at + Vec3(0.5f, 0.5f, 0), at + Vec3(0, 0.5f, 0));
    }
  // Along y = 2, in fragments of 0.3 m; and along diagonals of the floor's triangles.
  for (int i = 0; i < 10; ++i) {
    const auto x = 0.3f * static_cast<float>(i);
    wall(b, Vec3(x, 2, 0), Vec3(0.3f * static_cast<float>(i + 1), 2, 0), 0.0f, 1.0f);
  }
  wall(b, Vec3(2.25f, 2.25f, 0), Vec3(3.25f, 3.25f, 0), 0.0f, 1.0f);
  const auto patches = make_patches(b.scene(), {.max_edge = 0.4f});
  expect_sound(b.scene(), {.max_edge = 0.4f}, patches);
  EXPECT_NEAR(length_of_contacts(patches, up), 3.0 + std::sqrt(2.0), 1e-5);
}

TEST(Contacts, five_hundred_legs_stand_on_one_floor) {
  SceneBuilder b;
  floor(b);
  constexpr float width = 0.03f;
  for (int i = 0; i < 500; ++i) {
    const auto at =
        Vec3(0.1f + 0.15f * static_cast<float>(i % 25), 0.1f + 0.19f * static_cast<float>(i / 25), 0);
    const auto x = Vec3(width, 0.01f, 0), y = Vec3(-0.01f, width, 0);
    wall(b, at, at + x, 0.0f, 0.5f);
    wall(b, at + x, at + x + y, 0.0f, 0.5f);
    wall(b, at + x + y, at + y, 0.0f, 0.5f);
    wall(b, at + y, at, 0.0f, 0.5f);
  }
  for (const float edge : {no_max_edge, 0.2f}) {
    const auto patches = make_patches(b.scene(), {.max_edge = edge});
    expect_sound(b.scene(), {.max_edge = edge}, patches);
    EXPECT_NEAR(length_of_contacts(patches, up), 500 * 4 * std::hypot(width, 0.01), 1e-3);
  }
}

TEST(Contacts, a_box_that_another_ones_corner_pierces_by_a_tenth_of_a_millimetre_is_parted_there) {
  for (const float scale : {1.0f, 1e3f}) {
    SceneBuilder b;
    b.material("box", 0.5f, 1.0f);
    box(b, Vec3(-1, -1, -2) * scale, Vec3(1, 1, 0) * scale);
    // A cube that stands on its corner, at (0.3, 0.2), 0.1 mm deep in the other one's lid.
    const auto turned = [&](const Vec3& p) {
      const Vec3 u(std::sqrt(0.5f), -std::sqrt(0.5f), 0), w(std::sqrt(1 / 3.0f));
      const auto v = glm::cross(w, u);
      return Vec3(0.3f, 0.2f, -1e-4f) * scale + Vec3(glm::dot(p, u), glm::dot(p, v), glm::dot(p, w));
    };
    box(b, Vec3(0.0f), Vec3(scale), turned);
    const auto patches = make_patches(b.scene(), {.max_edge = 0.4f * scale});
    expect_sound(b.scene(), {.max_edge = 0.4f * scale}, patches);
    expect_closed(patches);
    EXPECT_GT(patches.contacts.size(), 11u);  // three lines, on the lid and on the faces, above and below
    EXPECT_LT(longest_passage(b.scene(), patches, 2e-6 * scale), 2e-6 * scale);
  }
}

TEST(Contacts, a_soup_of_tetrahedra_is_parted_everywhere_stays_closed_and_keeps_its_area) {
  SceneBuilder b;
  b.material("soup", 0.5f, 1.0f);
  std::uint64_t draw = 0;
  const auto point = [&] {
    const auto u = uniform4(stream_key(7, 0, 0), draw++);
    return Vec3(u[0], u[1], u[2]);
  };
  for (int i = 0; i < 500; ++i) {
    const auto at = 8.0f * point();
    std::array<Vec3, 4> p{at + point(), at + point(), at + point(), at + point()};
    if (glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) > 0.0f) std::swap(p[1], p[2]);
    b.triangle(p[0], p[1], p[2])
        .triangle(p[0], p[3], p[1])
        .triangle(p[1], p[3], p[2])
        .triangle(p[2], p[3], p[0]);
  }
  const PatchOptions options{.max_edge = 0.5f};
  const auto patches = make_patches(b.scene(), options);
  expect_sound(b.scene(), options, patches);
  expect_closed(patches);
  EXPECT_GT(patches.contacts.size(), 1000u);
  EXPECT_LT(longest_passage(b.scene(), patches, 1e-5), 1e-5);
  const auto again = make_patches(b.scene(), options);
  EXPECT_EQ(again.corners, patches.corners);
  EXPECT_EQ(again.contacts, patches.contacts);
}

TEST(Contacts, the_floor_in_a_closed_hut_is_a_plane_of_its_own_beside_a_wall_it_is_not) {
  SceneBuilder b;
  floor(b);
  const std::array corners{Vec3(1.1f, 1, 0), Vec3(3, 1.2f, 0), Vec3(2.8f, 2, 0), Vec3(1, 1.9f, 0)};
  for (std::size_t i = 0; i < 4; ++i) wall(b, corners[i], corners[(i + 1) % 4], 0.0f, 1.0f);
  wall(b, Vec3(0.5f, 3, 0), Vec3(3.5f, 3.3f, 0), 0.0f, 1.0f);
  const auto patches = make_patches(b.scene(), {.max_edge = 0.3f});
  const auto parts = plane_parts(patches);
  const auto part_at = [&](const Vec3& p) {
    std::uint32_t nearest = 0;
    for (std::uint32_t i = 0; i < patches.size(); ++i)
      if (patches.triangle[i] < 2 &&
          glm::distance(patches.centroid(i), p) < glm::distance(patches.centroid(nearest), p))
        nearest = i;
    return parts[nearest];
  };
  EXPECT_NE(part_at(Vec3(2, 1.5f, 0)), part_at(Vec3(2, 0.5f, 0)));
  EXPECT_EQ(part_at(Vec3(1.4f, 1.3f, 0)), part_at(Vec3(2.6f, 1.7f, 0)));
  EXPECT_EQ(part_at(Vec3(2, 2.6f, 0)), part_at(Vec3(2, 3.6f, 0)));
}

TEST(Contacts, what_only_meets_at_its_own_edges_stays_as_it_is) {
  SceneBuilder rooms;  // two rooms side by side that do not share vertices: walls end at the rims of floors
  rooms.material("room", 0.5f, 1.0f);
  floor(rooms);
  for (int i = 0; i < 7; ++i) {
    const auto x = static_cast<float>(i) * 4.0f / 7.0f;
    wall(rooms, Vec3(x, 0, 0), Vec3(static_cast<float>(i + 1) * 4.0f / 7.0f, 0, 0), 0.0f, 2.5f);
  }
  for (const auto& scene : {truth::l_room(), truth::sphere(12, 0.5f), truth::cube_a(), rooms.scene()}) {
    const auto patches = make_patches(scene, {.max_edge = 0.3f});
    const auto whole = make_patches(scene, {.max_edge = 0.3f, .contacts = false});
    EXPECT_TRUE(patches.contacts.empty());
    EXPECT_EQ(patches.corners, whole.corners);
    EXPECT_EQ(patches.vertices, whole.vertices);
  }
}

TEST(Contacts, are_the_same_for_any_number_of_threads) {
  SceneBuilder b;  // so many triangles that their pairs are the work of several threads
  b.material("floor", 0.5f, 0.0f);
  for (int x = 0; x < 70; ++x)
    for (int y = 0; y < 70; ++y) {
      const Vec3 corner(x, y, 0);
      b.quad(corner, corner + Vec3(1, 0, 0), corner + Vec3(1, 1, 0), corner + Vec3(0, 1, 0));
    }
  for (int i = 0; i < 20; ++i) {
    const auto x = 3.0f * static_cast<float>(i) + 2.3f;
    wall(b, Vec3(x, 0.4f, 0), Vec3(x + 5.1f, 69.7f, 0), -0.5f, 2.0f);
  }
  const auto scene = b.scene();
  const Context one(1), five(5);
  const auto a = make_patches(scene, {.max_edge = no_max_edge}, one);
  const auto z = make_patches(scene, {.max_edge = no_max_edge}, five);
  EXPECT_GT(a.contacts.size(), 1000u);
  EXPECT_EQ(a.corners, z.corners);
  EXPECT_EQ(a.vertices, z.vertices);
  ASSERT_EQ(a.contacts.size(), z.contacts.size());
  for (std::size_t i = 0; i < a.contacts.size(); ++i) {
    EXPECT_EQ(a.contacts[i].edge, z.contacts[i].edge);
    EXPECT_EQ(a.contacts[i].into, z.contacts[i].into);
  }
}

}  // namespace
}  // namespace luxel
