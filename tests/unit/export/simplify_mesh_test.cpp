// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/simplify_mesh.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "luxel/core/address.h"
#include "luxel/core/barycentric.h"
#include "luxel/core/triangle.h"
#include "luxel/export/close_t_junctions.h"
#include "luxel/image/image.h"
#include "luxel/patch/make_patches.h"
#include "luxel/scene/band_colours.h"
#include "luxel/surface/hanging_vertices.h"

#include "support/lit_rooms.h"

namespace luxel {
namespace {

using test::LitPatches;
using test::plain_material;

using Light = std::function<float(const Vec3&)>;

// Input triangles cut finely, with the light of a function at their vertices.
struct Lit {
  PatchSet patches;
  Solution solution;
  SmoothLight light;
};

Lit lit_by(PatchSet patches, const Light& front) {
  Lit lit{std::move(patches), {}, {}};
  auto& s = lit.solution;
  s.bands = lit.patches.bands;
  for (std::size_t p = 0; p < lit.patches.size(); ++p)
    for (std::size_t b = 0; b < 3; ++b) {
      s.irradiance.front.push_back(front(lit.patches.centroid(p)));
      s.irradiance.back.push_back(0.0f);
      s.radiosity.front.push_back(lit.patches.reflectance(p, b) * s.irradiance.front.back());
      s.radiosity.back.push_back(0.0f);
    }
  lit.light = make_smooth_light(lit.patches, s);
  for (std::size_t i = 0; i < lit.light.size(); ++i)
    for (std::size_t b = 0; b < 3; ++b)
      lit.light.irradiance.front[3 * i + b] = front(lit.patches.vertices[lit.light.vertex[i]]);
  return lit;
}

// A floor and a wall of 2 m x 2 m that share an edge, two triangles each.
Scene corner_of_a_room() {
  Scene scene;
  scene.positions = {{0, 0, 0}, {2, 0, 0}, {2, 0, 2}, {0, 0, 2}, {0, 2, 0}, {2, 2, 0}};
  scene.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}};
  scene.triangle_material.assign(4, MaterialId(0));
  scene.triangle_line.resize(4);
  scene.triangle_group.resize(4);
  scene.groups = {"room"};
  Material grey;
  grey.name = "grey";
  grey.reflectance = Vec3(0.5f);
  scene.materials = {grey};
  return scene;
}

PatchSet fine_corner() { return make_patches(corner_of_a_room(), {.max_edge = 0.1f}); }

const ToneCurve curve{.options = {.op = ToneOperator::clamp}, .scale = 1.0f};

// Bright and dark with a soft edge 0.2 m wide, darker towards the corner.
float shadow(const Vec3& at) {
  const auto edge = std::clamp((at.x + 0.5f * at.z - 1.0f) / 0.2f, 0.0f, 1.0f);
  return 0.2f + 3.0f * edge * edge * (3.0f - 2.0f * edge) + 0.3f * std::min(1.0f, at.y + at.z);
}

float code_at(const Lit& lit, std::uint32_t smooth) {
  const auto& colours = lit.patches.colours();
  const auto irradiance = irradiance_at(lit.light, smooth, false, 3);
  return curve(in_gamut(radiance_of(lit.patches.materials[0], false, irradiance, colours))).g;
}

// There is a shadow on the backs, which no viewpoint sees.
TEST(SimplifyMesh, hidden_backs_need_no_triangles_and_are_dark) {
  auto lit = lit_by(fine_corner(), [](const Vec3&) { return 1.0f; });
  for (std::size_t p = 0; p < lit.patches.size(); ++p)
    for (std::size_t b = 0; b < 3; ++b)
      lit.solution.irradiance.back[3 * p + b] = shadow(lit.patches.centroid(p));
  lit.light.irradiance.back = lit.light.irradiance.front;
  for (std::size_t i = 0; i < lit.light.size(); ++i)
    for (std::size_t b = 0; b < 3; ++b)
      lit.light.irradiance.back[3 * i + b] = shadow(lit.patches.vertices[lit.light.vertex[i]]);
  const auto seen = simplify_mesh(lit.patches, lit.solution, lit.light, curve);
  EXPECT_GT(seen.patches.size(), 100u);
  EXPECT_GT(seen.solution.irradiance.back[0], 0.0f);
  SimplifyOptions options;
  options.hidden.back.assign(lit.patches.size(), 1);
  const auto hidden = simplify_mesh(lit.patches, lit.solution, lit.light, curve, options);
  EXPECT_EQ(hidden.patches.size(), 4u);
  EXPECT_EQ(hidden.solution.irradiance.back, std::vector<float>(12, 0.0f));
  EXPECT_EQ(hidden.solution.irradiance.front, std::vector<float>(12, 1.0f));
}

TEST(SimplifyMesh, linear_light_on_a_wall_needs_the_triangles_of_the_file_alone) {
  const auto lit = lit_by(fine_corner(), [](const Vec3& p) { return 1.0f + 0.25f * p.x + 0.125f * p.y; });
  ASSERT_GT(lit.patches.size(), 1000u);
  const auto simple = simplify_mesh(lit.patches, lit.solution, lit.light, curve);
  EXPECT_EQ(simple.patches.size(), 4u);
  EXPECT_EQ(simple.patches.triangle, (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

// Difference of what is displayed at a place of an input triangle from a linear value: the smallest over the
// patches that meet there.
double difference_at(const SimplifiedMesh& simple, std::uint32_t triangle, const Vec3& at, float was) {
  const Lit after{simple.patches, simple.solution, simple.light};
  double smallest = 1.0;
  for (std::size_t q = 0; q < simple.patches.size(); ++q) {
    if (simple.patches.triangle[q] != triangle) continue;
    const auto w = barycentric(simple.patches.points(q), at);
    if (std::min({w.x, w.y, w.z}) < -1e-4) continue;
    double shown = 0.0;
    for (int c = 0; c < 3; ++c)
      shown +=
          w[c] * static_cast<double>(code_at(after, simple.light.corners[q][static_cast<std::size_t>(c)]));
    const auto off = srgb_encode(static_cast<float>(shown)) - srgb_encode(was);
    smallest = std::min(smallest, std::abs(static_cast<double>(off)));
  }
  return smallest;
}

TEST(SimplifyMesh, every_vertex_is_displayed_within_the_error_asked) {
  const auto lit = lit_by(fine_corner(), shadow);
  for (const float codes : {0.75f, 3.0f}) {
    const auto simple =
        simplify_mesh(lit.patches, lit.solution, lit.light, curve, {.max_error = codes / 255.0f});
    EXPECT_LT(simple.patches.size(), (codes < 1.0f ? 0.6 : 0.3) * static_cast<double>(lit.patches.size()));
    double largest = 0.0;
    for (std::size_t p = 0; p < lit.patches.size(); ++p)
      for (std::size_t k = 0; k < 3; ++k)
        largest = std::max(largest, difference_at(simple, lit.patches.triangle[p],
                                                  lit.patches.vertices[lit.patches.corners[p][k]],
                                                  code_at(lit, lit.light.corners[p][k])));
    // The error is measured by the slope of the encoding at the vertex, which changes over a code by a
    // hundredth.
    EXPECT_LE(255.0 * largest, 1.02 * static_cast<double>(codes));
    EXPECT_GT(largest, 0.0);
  }
}

// Light that jumps from vertex to vertex, with pairs of vertices so close that one says all about the other:
// where such a one goes, edges turn.
TEST(SimplifyMesh, between_vertices_the_error_is_small_too) {
  Scene scene = corner_of_a_room();
  auto patches = make_patches(scene, {.max_edge = 0.3f});
  const auto value = [](const Vec3& at) {
    const auto cell = [](float x) { return static_cast<std::uint32_t>(std::lround(x / 0.3f)); };
    return 0.5f +
           2.0f * uniform4({.seed = 3, .step = cell(at.y), .element = cell(at.x), .sample = cell(at.z)})[0];
  };
  const auto lit = lit_by(std::move(patches), value);
  const auto simple = simplify_mesh(lit.patches, lit.solution, lit.light, curve);
  EXPECT_LT(simple.patches.size(), lit.patches.size());
  for (std::size_t p = 0; p < lit.patches.size(); ++p) {
    const auto q = lit.patches.points(p);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto next = (k + 1) % 3;
      const auto was =
          0.5f * (code_at(lit, lit.light.corners[p][k]) + code_at(lit, lit.light.corners[p][next]));
      EXPECT_LT(255.0 * difference_at(simple, lit.patches.triangle[p], 0.5f * (q[k] + q[next]), was), 1.5);
    }
  }
}

TEST(SimplifyMesh, neighbours_stay_joined_and_areas_stay) {
  const auto lit = lit_by(fine_corner(), shadow);
  ASSERT_TRUE(find_hanging_vertices(lit.patches).empty());
  const auto simple = simplify_mesh(lit.patches, lit.solution, lit.light, curve);
  EXPECT_TRUE(find_hanging_vertices(simple.patches).empty());
  std::vector<double> area(4, 0.0);
  for (std::size_t p = 0; p < simple.patches.size(); ++p)
    area[simple.patches.triangle[p]] += static_cast<double>(simple.patches.area[p]);
  for (const auto a : area) EXPECT_NEAR(a, 2.0, 1e-5);
}

TEST(SimplifyMesh, the_edge_of_a_sharp_shadow_stays_where_it_is) {
  const auto lit = lit_by(fine_corner(), [](const Vec3& p) { return p.x < 1.0f ? 0.3f : 2.0f; });
  const auto simple = simplify_mesh(lit.patches, lit.solution, lit.light, curve);
  EXPECT_LT(simple.patches.size(), lit.patches.size() / 4);
  for (std::size_t i = 0; i < simple.light.corners.size(); ++i)
    for (const auto s : simple.light.corners[i]) {
      const auto x = simple.patches.vertices[simple.light.vertex[s]].x;
      EXPECT_EQ(simple.light.irradiance.front[3 * s], x < 1.0f ? 0.3f : 2.0f);
    }
}

// One long patch above two short ones: their common corner hangs on its edge.
TEST(CloseTJunctions, a_patch_is_cut_where_a_vertex_lies_on_its_edge) {
  LitPatches lit({plain_material("grey", 0.5f)});
  const auto a = lit.vertex({0, 0, 0}), b = lit.vertex({2, 0, 0}), top = lit.vertex({1, 1, 0}),
             middle = lit.vertex({0.5f, 0, 0}), left = lit.vertex({0, -1, 0}), right = lit.vertex({2, -1, 0});
  lit.patch({a, b, top}, 1.0f);
  lit.patch({left, middle, a}, 1.0f);
  lit.patch({left, right, middle}, 1.0f);
  lit.patch({right, b, middle}, 1.0f);
  const auto light = make_smooth_light(lit.patches, lit.solution);
  SimplifiedMesh mesh{lit.patches, lit.solution, light};
  for (std::size_t i = 0; i < mesh.light.size(); ++i)
    for (std::size_t band = 0; band < 3; ++band)
      mesh.light.irradiance.front[3 * i + band] = 1.0f + mesh.patches.vertices[mesh.light.vertex[i]].x;
  ASSERT_EQ(find_hanging_vertices(mesh.patches).size(), 1u);
  close_t_junctions(mesh);
  EXPECT_TRUE(find_hanging_vertices(mesh.patches).empty());
  ASSERT_EQ(mesh.patches.size(), 5u);
  EXPECT_EQ(mesh.patches.triangle, (std::vector<std::uint32_t>{0, 0, 1, 2, 3}));
  EXPECT_NEAR(mesh.patches.area[0] + mesh.patches.area[1], 1.0, 1e-6);
  for (const auto& corners : mesh.light.corners)
    for (const auto s : corners)
      EXPECT_FLOAT_EQ(mesh.light.irradiance.front[3 * s],
                      1.0f + mesh.patches.vertices[mesh.light.vertex[s]].x);
  EXPECT_EQ(mesh.solution.irradiance.front.size(), 15u);
}

}  // namespace
}  // namespace luxel
