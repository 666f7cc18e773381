// SPDX-License-Identifier: Apache-2.0
// Surfaces that transmit light diffusely: closed forms, light known patch by patch, and the path-traced
// reference.
//
// Risk. Seeds are fixed. Comparisons with noise allow six standard errors (seven where they come from eight
// seeds): with other random numbers one of the some two hundred would fail with a chance of one in a
// thousand.
#include <cmath>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "luxel/classical/classical.h"
#include "luxel/classical/stochastic_jacobi.h"
#include "luxel/core/student.h"
#include "luxel/core/student_quantile.h"
#include "luxel/patch/make_patches.h"
#include "luxel/render/path_traced.h"
#include "luxel/solve/bounces.h"
#include "luxel/solve/relight.h"
#include "luxel/solve/sampled.h"

#include "support/error_bars.h"
#include "support/glass_panes.h"
#include "support/known_rooms.h"
#include "support/probe_rig.h"
#include "support/reference_light.h"
#include "support/stored_run.h"

namespace luxel {
namespace {

using test::expect_same_light;
using test::total;
using truth::SceneBuilder;

Scene with_diffuser(Scene scene, const std::string& name, const Vec3& reflectance,
                    const Vec3& transmittance) {
  for (auto& material : scene.materials) {
    if (material.name != name) continue;
    material.reflectance = reflectance;
    material.diffuse_transmittance = transmittance;
  }
  return scene;
}

// Two unit cubes, parted by a sheet that emits towards the first. All surfaces around a cube have one
// radiosity, equal to the irradiance h, so that form factors do not matter:
//
//     sheet:  h_a = E + rho h_a + tau h_b,    h_b = rho h_b + tau h_a
//     walls:  h = E + rho h
struct TwoFurnaces {
  Vec3 rho{0.58f, 0.3f, 0.1f}, tau{0.4f, 0.5f, 0.2f};
  Vec3 h_a{1.0f, 2.0f, 3.0f}, h_b = tau / (1.0f - rho) * h_a;
  PatchSet patches;

  explicit TwoFurnaces(float max_edge = 0.4f) {
    SceneBuilder b;
    const auto walls = [&](const char* name, float reflectance, const Vec3& h, float x) {
      b.material(name, Vec3(reflectance), (1.0f - reflectance) * h)
          .quad({x, 0, 0}, {x + 1, 0, 0}, {x + 1, 1, 0}, {x, 1, 0})
          .quad({x, 0, 1}, {x, 1, 1}, {x + 1, 1, 1}, {x + 1, 0, 1})
          .quad({x, 0, 0}, {x, 0, 1}, {x + 1, 0, 1}, {x + 1, 0, 0})
          .quad({x, 1, 0}, {x + 1, 1, 0}, {x + 1, 1, 1}, {x, 1, 1});
    };
    walls("a", 0.5f, h_a, 0.0f);
    b.quad({0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1});
    walls("b", 0.7f, h_b, 1.0f);
    b.quad({2, 0, 0}, {2, 0, 1}, {2, 1, 1}, {2, 1, 0});
    b.material("sheet", rho, (1.0f - rho) * h_a - tau * h_b).quad({1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0});
    patches = make_patches(with_diffuser(b.scene(), "sheet", rho, tau), {.max_edge = max_edge});
  }

  // tolerance: relative, of each side beside its error where the light has one, and of the mean over all
  // sides. The error comes from eight replicates and has Student's t distribution: of all sides and bands,
  // one is beyond with a chance of one in a thousand.
  void expect_light(const Solution& light, double tolerance) const {
    constexpr double degrees = 7.0, risk = 1e-3;
    const auto errors_allowed =
        student_quantile(risk / (12.0 * static_cast<double>(patches.size())), degrees) /
        student_widening(degrees);
    double sum = 0.0, count = 0.0;
    for (std::size_t p = 0; p < patches.size(); ++p)
      for (std::size_t b = 0; b < 3; ++b) {
        const auto band = static_cast<int>(b);
        const auto i = 3 * p + b;
        const auto name = patches.material_of(p).name;
        const auto expect = [&](bool back, float truth) {
          const auto& errors = light.standard_error.of(back);
          const auto off =
              tolerance * truth + (errors.empty() ? 0.0 : errors_allowed * static_cast<double>(errors[i]));
          sum += static_cast<double>(light.irradiance.of(back)[i] / truth) - 1.0;
          count += 1.0;
          EXPECT_NEAR(light.irradiance.of(back)[i], truth, off) << name << p << back << b;
          EXPECT_NEAR(light.radiosity.of(back)[i], truth, off) << name << p << back << b;
        };
        expect(false, name == "b" ? h_b[band] : h_a[band]);
        if (name == "sheet") expect(true, h_b[band]);
      }
    EXPECT_NEAR(sum / count, 0.0, tolerance);
  }
};

void expect_balance(const EnergyBalance& energy, double tolerance) {
  const auto whole = total(energy.emitted) + total(energy.from_sky);
  EXPECT_NEAR(
      total(energy.absorbed) + total(energy.escaped) + total(energy.lost_at_backs) + total(energy.unshot),
      whole, tolerance * whole);
}

TEST(Diffusers, two_furnaces_that_a_sheet_parts_have_their_exact_light_by_the_sampled_method) {
  const TwoFurnaces room;
  const Context context(2);
  const Tracer tracer(room.patches, context);
  Solution light;
  const auto report =
      solve_sampled(room.patches, tracer, light, {.error = 0.01, .smoothing = false}, context);
  room.expect_light(light, 1e-3);
  EXPECT_LT(report.predicted_error, 0.01);
  expect_balance(report.energy, 2e-3);
  EXPECT_GT(report.views, 0u);
}

TEST(Diffusers, two_furnaces_that_a_sheet_parts_have_their_exact_light_by_the_classical_methods) {
  const TwoFurnaces room(0.8f);
  const Context context(2);
  const Tracer tracer(room.patches, context);
  for (const auto solver : {DenseSolver::direct, DenseSolver::jacobi, DenseSolver::gauss_seidel}) {
    Solution light;
    const auto report = solve_dense(room.patches, tracer, light,
                                    {.solver = solver, .iteration = {.tolerance = 1e-7}}, context);
    room.expect_light(light, 1e-3);
    expect_balance(report.energy, 1e-4);
  }
  Solution light;
  const auto lines = solve_lines(room.patches, tracer, light, {.lines = {.lines = 256}}, context);
  room.expect_light(light, 1e-2);
  expect_balance(lines.energy, 0.02);
  Solution shot;
  const auto shooting =
      solve_stochastic_jacobi(room.patches, tracer, shot, {.rays = 2'000'000, .tolerance = 1e-6}, context);
  room.expect_light(shot, 0.12);  // 200 quanta per side: three standard errors, and noise of reflections
  expect_balance(shooting.energy, 1e-9);
}

TEST(Diffusers, two_furnaces_that_a_sheet_parts_have_their_exact_light_by_paths) {
  const TwoFurnaces room;
  const Context context(2);
  const Tracer tracer(room.patches, context);
  Solution light;
  const auto report = trace_light(room.patches, tracer, light, {.limits = {.samples = 1024}}, context);
  EXPECT_NEAR(total(report.absorbed), total(report.emitted), 0.02 * total(report.emitted));
  for (const bool back : {false, true}) {
    double sum = 0.0, variance = 0.0, truth = 0.0;
    for (std::size_t p = 0; p < room.patches.size(); ++p) {
      if (room.patches.material_of(p).name != "sheet") continue;
      for (std::size_t b = 0; b < 3; ++b) {
        const auto i = 3 * p + b;
        const double area = room.patches.area[p];
        sum += area * static_cast<double>(light.irradiance.of(back)[i]);
        variance += std::pow(area * static_cast<double>(light.standard_error.of(back)[i]), 2.0);
        truth +=
            area * static_cast<double>(back ? room.h_b[static_cast<int>(b)] : room.h_a[static_cast<int>(b)]);
      }
    }
    EXPECT_NEAR(sum, truth, 6.0 * std::sqrt(variance));
    EXPECT_LT(std::sqrt(variance), 0.02 * truth);
  }
}

// The outside of the pane sees half of the sky, so its inside is a lamp of radiance tau L.
TEST(Diffusers, a_diffusing_window_under_an_even_sky_lights_a_point_by_its_form_factor) {
  const Vec3 tau(0.3f, 0.5f, 0.2f);
  auto builder = truth::window_room();
  builder.material("pane", 0.1f, 0.0f);
  auto scene = truth::under_sky(truth::add_sheet(builder));
  for (auto& material : scene.materials) material.reflectance = Vec3(0.0f);
  const auto patches = make_patches(with_diffuser(scene, "pane", Vec3(0.4f), tau), {.max_edge = 0.25f});
  const Context context(2);
  Solution light;
  const auto energy =
      solve_sampled(patches, Tracer(patches, context), light, {.error = 0.02}, context).energy;
  expect_balance(energy, 1e-4);
  const test::ProbeRig rig(patches, light);
  for (const auto& [point, normal] : {std::pair(Vec3(1.0f, 0.8f, 0.1f), Vec3(0, 0, 1)),
                                      std::pair(Vec3(1.7f, 0.3f, 0.4f), Vec3(0, -1, 0))}) {
    const auto probed = rig.at(point, normal, {.error = 0.003, .max_rays = 1u << 19});
    for (std::size_t b = 0; b < 3; ++b) {
      const auto truth = truth::irradiance_through(
          Vec3d(point), Vec3d(normal), truth::window_rectangle(),
          [&](const Vec3d&, double) { return static_cast<double>(tau[static_cast<int>(b)]); });
      const auto relative = probed.sampling_error / probed.illuminance;
      EXPECT_NEAR(probed.irradiance[b], truth, (6.0 * relative + 5e-4) * truth) << b;
    }
  }
}

TEST(Diffusers, the_sun_on_a_sheet_leaves_it_evenly_on_both_sides) {
  SceneBuilder builder;
  builder.material("sheet", 0.0f, 0.0f).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  auto scene = with_diffuser(builder.scene(), "sheet", Vec3(0.5f), Vec3(0.2f, 0.3f, 0.4f));
  const auto direction = glm::normalize(Vec3(0.6f, 0.2f, -0.7f));
  scene.point_lights = {{.name = "sun",
                         .kind = PointLightKind::directional,
                         .direction = direction,
                         .intensity = Vec3(2.0f, 3.0f, 4.0f)}};
  const auto patches = make_patches(scene, {.max_edge = 0.5f});
  const Context context(2);
  const Tracer tracer(patches, context);
  Solution light;
  const auto energy = solve_sampled(patches, tracer, light, {.error = 0.01}, context).energy;
  expect_balance(energy, 1e-4);
  for (std::size_t i = 0; i < 3 * patches.size(); ++i) {
    const auto band = static_cast<int>(i % 3);
    const auto H = -direction.z * scene.point_lights[0].intensity[band];
    EXPECT_NEAR(light.irradiance.front[i], H, 1e-4f * H);
    EXPECT_NEAR(light.irradiance.back[i], 0.0f, 1e-6f);
    EXPECT_NEAR(light.radiosity.front[i], 0.5f * H, 1e-4f * H);
    EXPECT_NEAR(light.radiosity.back[i], scene.materials[0].diffuse_transmittance[band] * H, 1e-4f * H);
  }
}

// A lamp in a recess of the ceiling, closed by an opal panel: all light of the room comes through it.
Scene opal_luminaire() {
  auto builder = SceneBuilder();
  builder.material("room", Vec3(0.7f, 0.6f, 0.5f), Vec3(0.0f));
  truth::add_box(builder, {0, 0, 0}, {2, 2, 1.5f});
  builder.material("recess", 0.8f, 0.0f)
      .quad({0.7f, 0.7f, 1.2f}, {0.7f, 1.3f, 1.2f}, {0.7f, 1.3f, 1.5f}, {0.7f, 0.7f, 1.5f})
      .quad({1.3f, 0.7f, 1.2f}, {1.3f, 1.3f, 1.2f}, {1.3f, 1.3f, 1.5f}, {1.3f, 0.7f, 1.5f})
      .quad({0.7f, 0.7f, 1.2f}, {1.3f, 0.7f, 1.2f}, {1.3f, 0.7f, 1.5f}, {0.7f, 0.7f, 1.5f})
      .quad({0.7f, 1.3f, 1.2f}, {1.3f, 1.3f, 1.2f}, {1.3f, 1.3f, 1.5f}, {0.7f, 1.3f, 1.5f});
  builder.material("lamp", 0.2f, 20.0f)
      .quad({0.9f, 0.9f, 1.45f}, {0.9f, 1.1f, 1.45f}, {1.1f, 1.1f, 1.45f}, {1.1f, 0.9f, 1.45f});
  builder.material("panel", 0.0f, 0.0f)
      .quad({0.7f, 0.7f, 1.2f}, {1.3f, 0.7f, 1.2f}, {1.3f, 1.3f, 1.2f}, {0.7f, 1.3f, 1.2f});
  return with_diffuser(builder.scene(), "panel", Vec3(0.4f, 0.3f, 0.2f), Vec3(0.5f, 0.45f, 0.3f));
}

TEST(Diffusers, a_lamp_behind_an_opal_panel_gives_the_light_of_the_reference) {
  const auto patches = make_patches(opal_luminaire(), {.max_edge = 0.4f});
  expect_balance(expect_same_light(patches, 0.0, 0.03), 2e-3);
}

TEST(Diffusers, views_stand_in_a_room_that_is_lit_through_a_diffuser_alone) {
  const auto patches = make_patches(opal_luminaire(), {.max_edge = 0.4f});
  const Context context(2);
  const Tracer tracer(patches, context);
  Solution light;
  const auto report = solve_sampled(patches, tracer, light, {.error = 0.03}, context);
  EXPECT_EQ(report.stop, StopReason::error_reached);
  EXPECT_GT(report.views, 20u);
  EXPECT_GT(light.seen_error, 0.0);
  for (std::size_t p = 0; p < patches.size(); ++p)  // the insides of the room are backs of the box
    EXPECT_GT(light.radiosity.of(patches.material_of(p).name == "room")[3 * p], 0.0f) << p;
}

TEST(Diffusers, a_sky_of_many_patches_lights_a_sealed_room_through_its_window) {
  auto builder = truth::window_room();
  builder.material("pane", 0.1f, 0.0f);
  const auto scene =
      with_diffuser(truth::under_sky(truth::add_sheet(builder)), "pane", Vec3(0.3f), Vec3(0.5f));
  auto patches = make_patches(scene, {.max_edge = 0.5f});
  patches.sky_patches = SkyPatches(1, {0, 0, 1}, {0, 1, 0}, LowerHalf::mirrored);
  patches.sky.clear();
  for (std::size_t p = 0; p < patches.sky_patches.size(); ++p)
    for (int b = 0; b < 3; ++b) patches.sky.push_back(0.5f + 0.02f * static_cast<float>(p % 60));
  expect_balance(expect_same_light(patches), 2e-3);
}

TEST(Diffusers, error_bars_hold_the_truth_as_often_as_they_say) {
  const auto room = truth::opal_plate();
  const Context context;
  const Tracer tracer(room.patches, context);
  std::vector<Solution> runs(20);
  for (std::size_t s = 0; s < runs.size(); ++s)
    solve_sampled(room.patches, tracer, runs[s],
                  {.error = 0.03, .error_measure = ErrorMeasure::power, .seed = s + 1}, context);
  const auto verdict = truth::judge(room, runs);
  EXPECT_NEAR(verdict.coverage.value, 0.95, 0.03 + 4.0 * verdict.coverage.standard_error);
  EXPECT_NEAR(verdict.ratio.value, 1.0, 0.1 + 4.0 * verdict.ratio.standard_error);
  EXPECT_LT(std::abs(verdict.bias.value), 5.0 * verdict.bias.standard_error + room.truth_error);
}

TEST(Diffusers, stored_transport_relights_them) {
  const auto before = truth::opal_plate();
  auto after = before;
  std::vector<float> reflectance;
  for (auto& material : after.patches.materials)
    for (auto& r : material.reflectance) reflectance.push_back(r = 0.2f + 0.5f * r);
  const std::vector<float> weight(3, 0.5f);
  for (auto& material : after.patches.materials)
    for (auto& e : material.emittance) e *= 0.5f;
  const Context context;
  after.truth = truth::true_light(after.patches,
                                  truth::form_factors(after.patches, truth::hung_plate_screens(), context));
  const Tracer tracer(before.patches, context);
  std::vector<Solution> runs;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const SampledOptions options{.error = 0.02, .error_measure = ErrorMeasure::power, .seed = seed};
    const auto stored = truth::stored_run(before.patches, tracer, options, context);
    Relighter relighter(before.patches, tracer, stored.state, options, context);
    relighter.set_lamps(weight);
    relighter.set_reflectance(reflectance);
    runs.push_back(relighter.light());
    if (seed > 1) continue;
    // All bounces of the stored rays give the light of the run.
    const auto bounced = Bounces(before.patches, tracer, *stored.state, options, context).light(60);
    for (std::size_t i = 0; i < bounced.radiosity.back.size(); ++i)
      EXPECT_NEAR(bounced.radiosity.back[i], stored.solution.radiosity.back[i],
                  1e-3f * (0.01f + stored.solution.radiosity.back[i]));
  }
  const auto verdict = truth::judge(after, runs);
  EXPECT_NEAR(verdict.bias.value, 0.0, 7.0 * verdict.bias.standard_error);
  EXPECT_GT(verdict.coverage.value, 0.92 - 3.0 * verdict.coverage.standard_error);
}

}  // namespace
}  // namespace luxel
