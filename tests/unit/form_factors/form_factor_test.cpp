// SPDX-License-Identifier: Apache-2.0
// Two patches and the occluders between them: shafts, shadows, and rooms whose rows must sum to one.
#include "luxel/form_factors/form_factor.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/core/address.h"
#include "luxel/core/warp.h"
#include "luxel/form_factors/obstructed_exchange.h"
#include "luxel/form_factors/polygon_form_factor.h"
#include "luxel/form_factors/ray_exchange.h"
#include "luxel/form_factors/visible_irradiance.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/side.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

using Triangle = std::array<Vec3d, 3>;
using Screens = std::vector<OccludingPolygon>;

// An uncut scene, with the input of its factors.
struct Asked {
  Context context{1};
  PatchSet patches;
  Tracer tracer;
  FormFactors factors;

  explicit Asked(const Scene& scene, float max_edge = no_max_edge)
      : patches(make_patches(scene, {.max_edge = max_edge})),
        tracer(patches, context),
        factors(patches, tracer) {}

  // From all fronts (or backs) of one material to those of another.
  FormFactor between(const std::string& from, bool from_back, const std::string& to, bool to_back,
                     double tolerance) const {
    FormFactor sum;
    double area = 0.0;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      if (patches.material_of(p).name != from) continue;
      area += static_cast<double>(patches.area[p]);
      for (std::size_t q = 0; q < patches.size(); ++q) {
        if (patches.material_of(q).name != to) continue;
        const auto one = factors.between(SideId(p, from_back), SideId(q, to_back), tolerance);
        sum.value += static_cast<double>(patches.area[p]) * one.value;
        sum.error += static_cast<double>(patches.area[p]) * one.error;
        sum.exact = sum.exact && one.exact;
      }
    }
    return {sum.value / area, sum.error / area, sum.exact};
  }
};

// Unit squares face to face, a metre apart; between them, half way, a square of this width.
Scene shielded(float width) {
  const auto low = 0.5f - 0.5f * width, high = 0.5f + 0.5f * width;
  truth::SceneBuilder b;
  b.material("lower", 0.5f, 0.0f).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  b.material("upper", 0.5f, 0.0f).quad({0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1});
  b.material("shield", 0.5f, 0.0f);
  b.quad({low, low, 0.5f}, {high, low, 0.5f}, {high, high, 0.5f}, {low, high, 0.5f});
  return b.scene();
}

TEST(Shaft, never_misses_a_triangle_that_a_line_between_the_two_crosses) {
  int met = 0, missed = 0, crossed = 0;
  for (std::uint64_t i = 0; i < 1500; ++i) {
    std::array<Vec3d, 9> p;
    for (std::uint64_t k = 0; k < 9; ++k) {
      const auto u = uniform4(stream_key(3, 0, 0), 9 * i + k);
      p[k] = Vec3d(u[0], u[1], u[2]);
    }
    const Triangle a = {p[0], p[1], p[2]}, b = {p[3], p[4], p[5]};
    const Triangle t = {p[6], p[6] + 0.3 * (p[7] - p[6]), p[6] + 0.3 * (p[8] - p[6])};
    const Shaft shaft(a, b, 1e-9);
    const bool is_missed = shaft.misses(t);
    (is_missed ? missed : met) += 1;
    Bounds box;
    for (const auto& corner : t) box.add(Vec3(corner));
    EXPECT_TRUE(is_missed || !shaft.misses(box));
    const auto inside = [](const Triangle& c, float u1, float u2) {
      const auto w = uniform_triangle(u1, u2);
      return c[0] + static_cast<double>(w.x) * (c[1] - c[0]) + static_cast<double>(w.y) * (c[2] - c[0]);
    };
    for (std::uint64_t k = 0; k < 1500; ++k) {
      const auto u = uniform4(stream_key(4, 0, static_cast<std::uint32_t>(i)), k);
      const auto x = inside(a, u[0], u[1]), d = inside(b, u[2], u[3]) - x;
      const auto n = glm::cross(t[1] - t[0], t[2] - t[0]);
      const auto s = glm::dot(n, t[0] - x) / glm::dot(n, d);
      const auto h = x + s * d;
      bool hit = s > 0.0 && s < 1.0;
      for (std::size_t e = 0; e < 3; ++e)
        hit = hit && glm::dot(n, glm::cross(t[(e + 1) % 3] - t[e], h - t[e])) > 0.0;
      if (!hit) continue;
      ++crossed;
      ASSERT_FALSE(is_missed);
      break;
    }
  }
  EXPECT_GT(crossed, 0.7 * met);  // and finds few that no line crosses
  EXPECT_GT(missed, 250);
}

TEST(VisibleIrradiance, a_screen_takes_away_its_own_fraction) {
  const std::vector<Vec3d> sky = {{-4, -4, 2}, {-4, 4, 2}, {4, 4, 2}, {4, -4, 2}};
  const Triangle screen = {Vec3d(-1, -1, 1), Vec3d(-1, 1, 1), Vec3d(1, 0, 1)};
  const Triangle turned = {screen[0], screen[2], screen[1]};
  const Vec3d x(0.3, 0.1, 0.0), n(0, 0, 1);
  VisibleIrradiance visible(1e-9);
  const auto open = visible.at(x, n, sky, {}), shade = visible.at(x, n, screen, {});
  EXPECT_GT(shade, 0.5);
  EXPECT_NEAR(visible.at(x, n, sky, Screens{screen}), open - shade, 1e-13);
  EXPECT_NEAR(visible.at(x, n, sky, Screens{turned}), open - shade, 1e-13);
  EXPECT_NEAR(visible.at(x, n, sky, Screens{screen, turned, screen}), open - shade, 1e-13);
  EXPECT_NEAR(visible.at({0.3, 0.1, 1.5}, n, sky, Screens{screen}), visible.at({0.3, 0.1, 1.5}, n, sky, {}),
              1e-13);  // from above it
  EXPECT_EQ(
      visible.at({0, 0, 0.999999}, n, std::array{Vec3d(-0.1, -0.1, 2), Vec3d(-0.1, 0.1, 2), Vec3d(0.1, 0, 2)},
                 Screens{screen}),
      0.0);
}

TEST(FormFactors, all_rows_of_a_convex_room_are_exact) {
  for (const auto& scene : {truth::cube_a(), truth::sphere(12, 0.5f)}) {
    const Asked asked(scene);
    const auto step = 1 + asked.patches.size() / 12;
    for (std::size_t p = 0; p < asked.patches.size(); p += step) {
      double front = 0.0, back = 0.0;
      for (std::size_t side = 0; side < side_count(asked.patches.size()); ++side) {
        const auto factor = asked.factors.between(SideId(p, false), SideId::at(side), 1e-9);
        EXPECT_TRUE(factor.exact);
        front += factor.value;
        back += asked.factors.between(SideId(p, true), SideId::at(side), 1e-9).value;
      }
      EXPECT_NEAR(front, 1.0, 1e-12);
      EXPECT_NEAR(back, 0.0, 1e-12);
    }
  }
}

TEST(FormFactors, a_cube_has_its_two_textbook_factors) {
  const Asked asked(truth::cube_a(), 0.51f);
  const auto opposite = asked.between("floor", false, "ceiling", false, 1e-9);
  const auto adjacent = asked.between("floor", false, "wall_x0", false, 1e-9);
  EXPECT_TRUE(opposite.exact && adjacent.exact);
  EXPECT_NEAR(opposite.value, 0.19982489569838746, 1e-12);
  EXPECT_NEAR(adjacent.value, 0.20004377607540316, 1e-12);
}

// Points that do not see the upper square see the shield instead, if it covers enough of the square. Nothing
// passes a wide shield except beyond its boundary; without a shield everything passes.
TEST(FormFactors, a_shield_takes_away_what_it_hides) {
  const auto open = 0.19982489569838746;
  const Asked none(shielded(0.001f)), half(shielded(0.5f)), full(shielded(1.0f)), wide(shielded(3.0f));
  EXPECT_NEAR(none.between("lower", false, "upper", false, 1e-6).value, open, 2e-6);
  EXPECT_NEAR(wide.between("lower", false, "upper", false, 1e-6).value, 0.0, 1e-6);
  const auto seen = half.between("lower", false, "upper", false, 1e-5);
  EXPECT_FALSE(seen.exact);
  EXPECT_LT(seen.error, 5e-5);
  // By reciprocity and symmetry, and to each side of the shield in the closed form.
  EXPECT_NEAR(half.between("upper", false, "lower", false, 1e-5).value, seen.value, 2e-5);
  EXPECT_TRUE(half.between("shield", true, "lower", false, 1e-5).exact);
  EXPECT_NEAR(half.between("shield", true, "lower", false, 1e-5).value,
              half.between("shield", false, "upper", false, 1e-5).value, 1e-12);
  EXPECT_EQ(half.between("shield", false, "lower", false, 1e-5).value, 0.0);
  EXPECT_GT(seen.value, full.between("lower", false, "upper", false, 1e-5).value);
}

// Cut into a hundred times more pieces, a shield hides the same.
TEST(FormFactors, the_same_shadow_whoever_throws_it) {
  const auto scene = shielded(0.5f);
  const Asked coarse(scene), fine(scene, 0.26f);
  const auto a = coarse.between("lower", false, "upper", false, 1e-5);
  const auto b = fine.between("lower", false, "upper", false, 1e-5);
  EXPECT_NEAR(a.value, b.value, a.error + b.error);
}

TEST(FormFactors, what_was_asked_for_is_what_comes) {
  const Asked asked(truth::furnace(Vec3(0.5f), Vec3(0.5f)), 0.6f);
  int integrated = 0;
  for (std::size_t p = 0; p < asked.patches.size(); p += 7)
    for (std::size_t q = 0; q < asked.patches.size(); q += 3) {
      if (p == q) continue;
      const auto best = asked.factors.between(SideId(p, false), SideId(q, false), 1e-5);
      if (best.exact) continue;
      ++integrated;
      const auto rough = asked.factors.between(SideId(p, false), SideId(q, false), 1e-3);
      EXPECT_LE(rough.error, 1.01e-3);
      EXPECT_NEAR(rough.value, best.value, rough.error + best.error) << p << ", " << q;
      // Reciprocity.
      const auto back = asked.factors.between(SideId(q, false), SideId(p, false), 1e-5);
      const auto area = asked.patches.area[p], other = asked.patches.area[q];
      EXPECT_NEAR(area * best.value, other * back.value, area * best.error + other * back.error);
    }
  EXPECT_GT(integrated, 30);
}

TEST(FormFactors, rows_of_a_room_with_a_block_sum_to_one) {
  const Asked asked(truth::furnace(Vec3(0.5f), Vec3(0.5f)), 0.6f);
  for (std::size_t p = 0; p < asked.patches.size(); p += 23) {
    double sum = 0.0, error = 0.0;
    for (std::size_t side = 0; side < side_count(asked.patches.size()); ++side) {
      const auto factor = asked.factors.between(SideId(p, false), SideId::at(side), 1e-5);
      sum += factor.value;
      error += factor.error;
    }
    EXPECT_NEAR(sum, 1.0, error);
    EXPECT_NEAR(sum, 1.0, 2e-4);
  }
}

// Visibility past many patches uses other methods; the result is the same.
TEST(FormFactors, shadow_rays_and_exact_shadows_agree) {
  const Asked asked(shielded(0.5f));
  const std::vector<Vec3d> lower = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}},
                           upper = {{0, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  const auto low = 0.25, high = 0.75;
  const std::vector<Vec3d> shield = {{low, low, 0.5}, {high, low, 0.5}, {high, high, 0.5}, {low, high, 0.5}};
  const Screens screens = {shield};
  const auto open = polygon_exchange_area(lower, upper);
  const auto exact = obstructed_exchange(lower, upper, screens, open, {.tolerance = 1e-6});
  ASSERT_EQ(asked.patches.normal[0].z, 1.0f);
  const auto rays = ray_exchange(asked.tracer, PatchEmitter(asked.patches, SideId(0, false)), 0.5, upper,
                                 open, {.tolerance = 1e-4, .key = 1});
  EXPECT_LT(rays.error, 1e-4);
  EXPECT_LT(exact.error, 1.01e-6);
  EXPECT_NEAR(rays.value, exact.value, 1.7 * rays.error);  // five standard errors: one in two million
  EXPECT_LT(exact.value, 0.8 * open);
}

TEST(FormFactors, behind_beside_and_without_area_there_is_nothing) {
  truth::SceneBuilder b;
  b.material("one", 0.5f, 0.0f, false).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  b.material("beside", 0.5f, 0.0f).quad({1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0});
  b.material("below", 0.5f, 0.0f).quad({0, 0, -1}, {1, 0, -1}, {1, 1, -1}, {0, 1, -1});
  auto scene = b.scene();
  const Asked asked(scene);
  EXPECT_EQ(asked.between("one", false, "beside", false, 1e-6).value, 0.0);
  EXPECT_EQ(asked.between("one", false, "below", false, 1e-6).value, 0.0);
  EXPECT_EQ(asked.between("one", true, "below", true, 1e-6).value, 0.0);
  EXPECT_NEAR(asked.between("one", true, "below", false, 1e-6).value, 0.19982489569838746, 1e-12);
  for (std::size_t side = 0; side < 4; ++side)
    EXPECT_EQ(asked.factors.between(SideId(0, false), SideId::at(side), 1e-6).value,
              0.0);  // itself, its back, its neighbour in the plane

  auto flat = asked.patches;  // a patch that shrank to a line
  flat.vertices[flat.corners[0][2]] = flat.vertices[flat.corners[0][0]];
  const Context context(1);
  const Tracer tracer(flat, context);
  const FormFactors factors(flat, tracer);
  for (std::size_t side = 0; side < 2 * flat.size(); ++side) {
    EXPECT_EQ(factors.between(SideId(0, true), SideId::at(side), 1e-6).value, 0.0);
    EXPECT_EQ(factors.between(SideId::at(side), SideId(0, true), 1e-6).value, 0.0);
  }
}

}  // namespace
}  // namespace luxel
