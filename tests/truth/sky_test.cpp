// SPDX-License-Identifier: Apache-2.0
// Scenes under an even sky whose light has a closed form, by every method.
//
// Risk. Seeds are fixed. With other random numbers one of the some thousand numbers of all tests would be
// more than six and a half of its standard errors off (sampled: of 32 replicates, Student's t) with a chance
// below one in ten thousand; shooting's root mean square of some hundred independent errors lies above 1.3 of
// the predicted with a chance below one in ten thousand.
#include <cmath>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "luxel/classical/classical.h"
#include "luxel/classical/stochastic_jacobi.h"
#include "luxel/form_factors/polygon_form_factor.h"
#include "luxel/patch/make_patches.h"
#include "luxel/render/path_traced.h"
#include "luxel/solve/sampled.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

constexpr float sky = 0.7f;  // W/(m² sr)
constexpr double full = M_PI * 0.7f;

struct Answer {
  Solution light;
  EnergyBalance energy;
};
using Solve = Answer (*)(const PatchSet&, const Tracer&, const Context&);

Answer sampled(const PatchSet& patches, const Tracer& tracer, const Context& context) {
  Answer a;
  a.energy = solve_sampled(patches, tracer, a.light,
                           {.error = 0.01, .error_measure = ErrorMeasure::power, .replicates = 32}, context)
                 .energy;
  return a;
}
Answer shooting(const PatchSet& patches, const Tracer& tracer, const Context& context) {
  Answer a;
  a.energy =
      solve_stochastic_jacobi(patches, tracer, a.light, {.rays = 500'000, .tolerance = 1e-6}, context).energy;
  return a;
}
Answer dense(const PatchSet& patches, const Tracer& tracer, const Context& context) {
  Answer a;
  a.energy = solve_dense(patches, tracer, a.light, {}, context).energy;
  return a;
}
Answer dense_by_parts(const PatchSet& patches, const Tracer& tracer, const Context& context) {
  Answer a;
  a.energy = solve_dense(patches, tracer, a.light, {.solver = DenseSolver::gauss_seidel}, context).energy;
  return a;
}
Answer hemicube(const PatchSet& patches, const Tracer&, const Context& context) {
  Answer a;
  a.energy = solve_hemicube(patches, a.light, {.hemicube = {.resolution = 64, .points = 4}}, context).energy;
  return a;
}
Answer lines(const PatchSet& patches, const Tracer& tracer, const Context& context) {
  Answer a;
  a.energy = solve_lines(patches, tracer, a.light, {.lines = {.lines = 4096}}, context).energy;
  return a;
}
Answer reference(const PatchSet& patches, const Tracer& tracer, const Context& context) {
  Answer a;
  PathOptions options;
  options.limits.samples = 1024;
  options.bounces_from = BouncesFrom::patches;
  const auto report = trace_light(patches, tracer, a.light, options, context);
  a.energy = {report.emitted, report.from_sky, report.absorbed, report.escaped, report.lost_at_backs, {}, {}};
  return a;
}

struct Method {
  const char* name;
  Solve solve;
  double fraction;  // of a full sky: allowed error of the method beside its standard errors
  double balance;
};

class Sky : public testing::TestWithParam<Method> {
 protected:
  // truth: of a side, as a fraction of a full sky. Shooting, which states only the error of the whole, is
  // compared as a whole.
  void expect(const Scene& built, float max_edge,
              const std::function<double(const PatchSet&, std::size_t)>& truth) {
    auto scene = built;
    scene.sky = Vec3(sky);
    patches_ = make_patches(scene, {.max_edge = max_edge});
    const Context context;
    const Tracer tracer(patches_, context);
    answer_ = GetParam().solve(patches_, tracer, context);
    const auto& s = answer_.light;
    double squared_error = 0.0, squared_light = 0.0;
    for (std::size_t p = 0; p < patches_.size(); ++p) {
      const auto H = double{s.irradiance.front[3 * p]};
      const auto off = H - full * truth(patches_, p);
      const auto stated = s.standard_error.front.empty() ? 0.0 : double{s.standard_error.front[3 * p]};
      squared_error += double{patches_.area[p]} * off * off;
      squared_light += double{patches_.area[p]} * H * H;
      if (s.provenance.method != "stochastic-jacobi") {
        EXPECT_LE(std::abs(off), 6.5 * stated + GetParam().fraction * full) << "patch " << p << " has " << H;
      }
    }
    if (s.provenance.method == "stochastic-jacobi" && squared_light > 0.0) {
      EXPECT_LE(std::sqrt(squared_error / squared_light), 1.3 * s.predicted_error);
    }
    const auto& e = answer_.energy;
    const auto light = e.emitted[0] + e.from_sky[0];
    const auto unshot = e.unshot.empty() ? 0.0 : e.unshot[0];
    EXPECT_NEAR(e.absorbed[0] + e.escaped[0] + e.lost_at_backs[0] + unshot, light,
                GetParam().balance * light + 1e-6 * full);
  }

  PatchSet patches_;
  Answer answer_;
};

// The faces of a box, seen from outside.
void block(truth::SceneBuilder& b, const Vec3& l, const Vec3& h) {
  const Vec3 p[8] = {{l.x, l.y, l.z}, {h.x, l.y, l.z}, {h.x, h.y, l.z}, {l.x, h.y, l.z},
                     {l.x, l.y, h.z}, {h.x, l.y, h.z}, {h.x, h.y, h.z}, {l.x, h.y, h.z}};
  const int faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                           {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  for (const auto& f : faces) b.quad(p[f[0]], p[f[1]], p[f[2]], p[f[3]]);
}

double all_of_it(const PatchSet&, std::size_t) { return 1.0; }

TEST_P(Sky, alone_lights_all_of_a_convex_thing_alike_and_nothing_within_it) {
  truth::SceneBuilder b;
  b.material("block", 0.6f, 0.0f);
  block(b, {0, 0, 0}, {1, 2, 1});
  expect(b.scene(), 1.2f, all_of_it);
  const auto& s = answer_.light;
  for (std::size_t i = 0; i < s.irradiance.back.size(); ++i) EXPECT_LE(s.irradiance.back[i], 1e-5 * full);
  for (std::size_t b2 = 0; b2 < 3; ++b2) {
    EXPECT_NEAR(answer_.energy.from_sky[b2], 10.0 * full, 0.01 * full) << "10 m² see nothing but the sky";
    EXPECT_NEAR(answer_.energy.absorbed[b2], 4.0 * full, 0.01 * full);
  }
}

// A scene that emits what it does not reflect, under a sky of the same radiance, is as bright as the sky
// everywhere, for any arrangement of its surfaces.
TEST_P(Sky, makes_a_furnace_of_things_that_emit_what_they_do_not_reflect) {
  truth::SceneBuilder b;
  b.material("grey", 0.5f, static_cast<float>(0.5 * full));
  block(b, {0, 0, 0}, {1, 1, 1});
  b.material("white", 0.8f, static_cast<float>(0.2 * full));
  block(b, {1.2f, 0.3f, 0.1f}, {1.6f, 0.9f, 1.3f});
  expect(b.scene(), 1.1f, all_of_it);
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    const auto B = double{answer_.light.radiosity.front[3 * p]};
    EXPECT_NEAR(B / full, 1.0, 0.1);
  }
}

// Black walls get what comes straight through the opening: the form factor to it.
TEST_P(Sky, comes_into_a_box_without_a_lid_by_the_form_factor_of_its_opening) {
  truth::SceneBuilder b;
  b.material("walls", 0.0f, 0.0f, false);
  b.quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  b.quad({0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}).quad({1, 0, 1}, {1, 1, 1}, {1, 1, 0}, {1, 0, 0});
  b.quad({0, 0, 1}, {1, 0, 1}, {1, 0, 0}, {0, 0, 0}).quad({0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1});
  const std::array<Vec3d, 4> opening = {Vec3d(0, 1, 1), Vec3d(1, 1, 1), Vec3d(1, 0, 1), Vec3d(0, 0, 1)};
  expect(b.scene(), 0.36f, [&](const PatchSet& patches, std::size_t p) {
    const auto c = patches.points(p);
    return polygon_form_factor(std::array{Vec3d(c[0]), Vec3d(c[1]), Vec3d(c[2])}, opening);
  });
  EXPECT_NEAR(answer_.energy.absorbed[0], full, 0.01 * full) << "a square metre lets light in";
  EXPECT_EQ(answer_.energy.escaped[0], 0.0);
}

TEST_P(Sky, does_not_get_into_a_closed_box) {
  auto scene = truth::cube_a();
  for (auto& m : scene.materials) {
    m.emittance = Vec3(0.0f);
    m.two_sided = false;
  }
  expect(scene, 0.75f, [](const PatchSet&, std::size_t) { return 0.0; });
}

INSTANTIATE_TEST_SUITE_P(
    Methods, Sky,
    testing::Values(Method{"sampled", sampled, 2e-3, 0.02}, Method{"shooting", shooting, 0.0, 1e-5},
                    Method{"dense", dense, 1e-6, 1e-4}, Method{"dense_by_parts", dense_by_parts, 1e-6, 1e-4},
                    Method{"hemicube", hemicube, 0.05, 0.03}, Method{"lines", lines, 1e-6, 0.05},
                    Method{"reference", reference, 1e-6, 0.05}),
    [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace luxel
