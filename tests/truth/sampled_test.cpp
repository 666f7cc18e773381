// SPDX-License-Identifier: Apache-2.0
// The sampled solver in rooms whose light is known: the exact means of the enclosures, and every switch
// alone. Means come from eight seeds; their spread gives the standard error of the mean, of which seven are
// allowed (Student's t with seven degrees of freedom: risk 2e-4 each, far less where the stated
// tolerance leads).
#include "luxel/solve/sampled.h"

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/side.h"

#include "support/error_bars.h"
#include "support/known_rooms.h"
#include "support/truth_scenes.h"

namespace luxel {
namespace {

constexpr std::size_t seeds = 8;
constexpr double allowed = 7.0;  // standard errors of a mean over seeds

std::vector<Solution> solve_with_seeds(const PatchSet& patches, const SampledOptions& options) {
  const Context context;
  const Tracer tracer(patches, context);
  std::vector<Solution> runs(seeds);
  for (std::size_t s = 0; s < seeds; ++s) {
    auto with_seed = options;
    with_seed.seed = s + 1;
    solve_sampled(patches, tracer, runs[s], with_seed, context);
  }
  return runs;
}

struct Solved {
  Solution solution;
  SolveReport report;
};

Solved solve(const PatchSet& patches, const SampledOptions& options) {
  const Context context;
  const Tracer tracer(patches, context);
  Solved solved;
  solved.report = solve_sampled(patches, tracer, solved.solution, options, context);
  return solved;
}

truth::Measured measure(const std::vector<Solution>& runs, const std::function<double(const Solution&)>& of) {
  double mean = 0.0;
  double square = 0.0;
  for (const auto& run : runs) mean += of(run) / seeds;
  for (const auto& run : runs) square += (of(run) - mean) * (of(run) - mean);
  return {mean, std::sqrt(square / (seeds - 1) / seeds)};
}

// Means over parts of the continuous room; tolerances are those of the patches.
void expect_means(const PatchSet& patches, const std::map<std::string, double>& exact, double tolerance) {
  const auto runs = solve_with_seeds(patches, {.error = 0.03, .error_measure = ErrorMeasure::power});
  for (const auto& [name, value] : exact) {
    const auto& material = name;
    const auto mean = measure(runs, [&](const Solution& run) {
      return truth::mean_irradiance(patches, run.irradiance.front, material);
    });
    EXPECT_NEAR(mean.value / value, 1.0, tolerance + allowed * mean.standard_error / value)
        << name << ": expected " << value << ", found " << mean.value << " +- " << mean.standard_error;
    EXPECT_LT(mean.standard_error / value, 0.005) << name << ": too noisy to tell";
  }
}

TEST(SampledEnclosures, a_cube_with_a_luminous_ceiling_has_the_exact_mean_irradiances) {
  expect_means(make_patches(truth::cube_a(), {.max_edge = 0.05f}),
               {{"wall_x0", 0.36221119},
                {"wall_x1", 0.36221119},
                {"wall_y0", 0.36221119},
                {"wall_y1", 0.36221119},
                {"floor", 0.34243212},
                {"ceiling", 0.20872313}},
               0.002);
}

TEST(SampledEnclosures, an_l_shaped_room_is_lit_round_the_corner) {
  const auto patches = make_patches(truth::l_room(), {.max_edge = 0.05f});
  expect_means(patches,
               {{"ceiling", 0.1391531},
                {"wall_y0", 0.2038067},
                {"end_x2", 0.1689368},
                {"inner_y1", 0.3212263},
                {"wall_x0", 0.0836591},
                {"floor_corner", 0.0966175},
                {"floor_lit", 0.3307676},
                {"inner_x1", 0.0214627},
                {"end_y2", 0.0208882},
                {"floor_dark", 0.0312427}},
               0.005);
}

TEST(SampledEnclosures, open_plates_lose_the_light_that_passes_between_them) {
  expect_means(make_patches(truth::plates(), {.max_edge = 0.05f}),
               {{"lower", 0.02043611012}, {"upper", 0.20189437848}}, 0.002);
}

// In a sphere every point sees every other alike: H = E_mean / (1 - rho), with the cap's share of the area as
// tessellated.
TEST(SampledEnclosures, a_sphere_is_lit_alike_everywhere) {
  const auto patches = make_patches(truth::sphere(32, 0.5f), {.max_edge = no_max_edge});
  double area = 0.0;
  double cap = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    area += patches.area[p];
    if (patches.material_of(p).name == "cap") cap += patches.area[p];
  }
  expect_means(patches, {{"shell", cap / area / 0.5}, {"cap", cap / area / 0.5}}, 0.003);
}

// Every surface emits 1 - rho, so B = H = 1 on every patch, whatever the shape.
TEST(SampledEnclosures, a_furnace_is_exact) {
  const auto patches =
      make_patches(truth::furnace({0.8f, 0.5f, 0.2f}, {0.14f, 0.45f, 0.091f}), {.max_edge = 0.1f});
  expect_means(patches, {{"walls", 1.0}, {"block", 1.0}}, 0.0005);
  const auto solved = solve(patches, {.error = 0.01, .error_measure = ErrorMeasure::power});
  double worst = 0.0;
  for (std::size_t i = 0; i < solved.solution.irradiance.front.size(); ++i) {
    const double H = solved.solution.irradiance.front[i];
    worst = std::max(worst, std::abs(H - 1.0));
  }
  EXPECT_LT(worst, 0.1) << "one patch is far off";
  for (std::size_t b = 0; b < 3; ++b)
    EXPECT_LT(solved.report.energy.escaped[b], 1e-6 * solved.report.energy.emitted[b]);
}

// Every switch for itself against its default, in the two rooms where most is different: coloured lamps that
// everything sees, and one lamp with a shadow. A switch changes the cost, never the answer.
struct Switch {
  const char* name;
  bool SampledOptions::*option;
};

class SampledSwitch : public testing::TestWithParam<Switch> {
 protected:
  static void expect_truth(const truth::KnownRoom& room, SampledOptions options) {
    options.error = 0.03;
    options.error_measure = ErrorMeasure::power;
    options.*(GetParam().option) = !(options.*(GetParam().option));
    const auto runs = solve_with_seeds(room.patches, options);
    for (const bool back : {false, true})
      for (std::size_t material = 0; material < room.patches.materials.size(); ++material)
        for (std::size_t band = 0; band < room.patches.band_count(); ++band)
          expect_mean_of(room, runs, back, material, band);
  }

 private:
  // Area-weighted sum over the patches of a material.
  template <typename Number>
  static double sum_of(const PatchSet& patches, const std::vector<Number>& irradiance, std::size_t material,
                       std::size_t band) {
    double sum = 0.0;
    for (std::size_t p = 0; p < patches.size(); ++p)
      if (static_cast<std::size_t>(patches.material[p]) == material)
        sum += static_cast<double>(patches.area[p]) *
               static_cast<double>(irradiance[p * patches.band_count() + band]);
    return sum;
  }

  static void expect_mean_of(const truth::KnownRoom& room, const std::vector<Solution>& runs, bool back,
                             std::size_t material, std::size_t band) {
    const auto exact = sum_of(room.patches, room.truth.irradiance.of(back), material, band);
    const auto mean = measure(runs, [&](const Solution& run) {
      return sum_of(room.patches, run.irradiance.of(back), material, band);
    });
    EXPECT_NEAR(mean.value, exact, 0.003 * exact + allowed * mean.standard_error)
        << room.name << ", " << room.patches.materials[material].name << (back ? ", back" : "") << ", band "
        << band << ", +- " << mean.standard_error;
    EXPECT_LT(mean.standard_error, 0.025 * exact + 1e-12) << "too noisy to tell";
  }
};

TEST_P(SampledSwitch, flipped_alone_gives_the_same_light) {
  expect_truth(truth::coloured_room(), {});
  expect_truth(truth::hung_plate(), {});
}

INSTANTIATE_TEST_SUITE_P(EverySwitch, SampledSwitch,
                         testing::Values(Switch{"low_discrepancy", &SampledOptions::low_discrepancy},
                                         Switch{"stratified", &SampledOptions::stratified},
                                         Switch{"importance", &SampledOptions::importance},
                                         Switch{"control_variate", &SampledOptions::control_variate},
                                         Switch{"multiple_importance", &SampledOptions::multiple_importance},
                                         Switch{"share", &SampledOptions::smoothing}),
                         [](const testing::TestParamInfo<Switch>& one) { return one.param.name; });

// A room where all three fates of a ray occur: a lamp below, a one-sided plate above it that shows its back,
// a wall beside both; open to the rest.
truth::KnownRoom leaky_room() {
  truth::SceneBuilder b;
  b.material("lamp", Vec3(0.5f), {1.0f, 0.1f, 3.0f}).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  b.material("turned_away", 0.5f, 0.0f, false).quad({0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1});
  b.material("beside", 0.7f, 0.0f).quad({1, 0, 0}, {1, 0, 2}, {1, 1, 2}, {1, 1, 0});
  truth::KnownRoom room;
  room.name = "leaky";
  room.patches = make_patches(b.scene(), {.max_edge = 0.3f});
  return room;
}

TEST(SampledSides, rays_that_meet_the_back_of_a_one_sided_material_are_absorbed) {
  auto room = leaky_room();
  const std::array<Vec3, 4> turned_away = {{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
  const Context context;
  const auto factors = truth::form_factors(room.patches, {truth::convex_polygon(turned_away)}, context);
  room.truth = truth::true_light(room.patches, factors);
  std::vector<double> lost(3, 0.0);  // absorbed by the plate's back
  const auto sides = side_count(room.patches.size());
  for (std::size_t from = 0; from < sides; from += 2) {
    const auto p = from / 2;
    double to_back = 0.0;
    for (std::size_t to = 1; to < sides; to += 2)
      if (!room.patches.material_of(to / 2).two_sided) to_back += factors[from * sides + to];
    for (std::size_t band = 0; band < 3; ++band) {
      const auto& m = room.patches.material_of(p);
      const auto B = m.emittance[band] + m.reflectance[band] * room.truth.irradiance.front[3 * p + band];
      lost[band] += room.patches.area[p] * B * to_back;
    }
  }

  const auto [solution, report] = solve(room.patches, {.error = 0.005, .error_measure = ErrorMeasure::power});
  EXPECT_LT(truth::true_error(room, solution), 0.01);
  for (std::size_t p = 0; p < room.patches.size(); ++p)
    if (!room.patches.material_of(p).two_sided) {
      EXPECT_EQ(solution.irradiance.back[3 * p], 0.0f);
    }
  double of_material = 0.0;
  for (std::size_t band = 0; band < 3; ++band) {
    EXPECT_NEAR(report.energy.lost_at_backs[band] / lost[band], 1.0, 0.01) << "band " << band;
    of_material += report.energy.lost_at_backs[band];
  }
  ASSERT_EQ(report.back_loss.size(), 3u);
  EXPECT_NEAR(report.back_loss[1], of_material, 1e-6 * of_material);
  EXPECT_EQ(report.back_loss[0] + report.back_loss[2], 0.0);
}

// Light of a lamp by shadow rays and light carried away by gather rays are separate estimates: they agree
// within the error of the light.
TEST(SampledSides, emitted_equals_absorbed_escaped_lost_and_unshot) {
  const auto [solution, report] =
      solve(leaky_room().patches, {.error = 0.02, .error_measure = ErrorMeasure::power});
  const double emitted[3] = {1.0, 0.1, 3.0};  // W: one square metre
  for (std::size_t band = 0; band < 3; ++band) {
    const auto& e = report.energy;
    EXPECT_NEAR(e.emitted[band], emitted[band], 1e-6 * emitted[band]);
    EXPECT_NEAR(e.absorbed[band] + e.escaped[band] + e.lost_at_backs[band] + e.unshot[band], e.emitted[band],
                report.predicted_error * e.emitted[band]);
    EXPECT_GT(e.escaped[band], 0.0);
  }
}

TEST(SampledSides, radiosity_is_emittance_and_what_is_reflected) {
  const auto room = truth::hung_plate();
  const auto [solution, report] = solve(room.patches, {.error = 0.03, .error_measure = ErrorMeasure::power});
  for (std::size_t p = 0; p < room.patches.size(); ++p)
    for (std::size_t band = 0; band < 3; ++band) {
      const auto& m = room.patches.material_of(p);
      const auto i = 3 * p + band;
      EXPECT_NEAR(solution.radiosity.front[i],
                  m.emittance[band] + m.reflectance[band] * solution.irradiance.front[i],
                  1e-6 * (1.0 + solution.radiosity.front[i]));
      EXPECT_NEAR(solution.radiosity.back[i], m.reflectance[band] * solution.irradiance.back[i],
                  1e-6 * (1.0 + solution.radiosity.back[i]));
    }
}

// A lamp that shines upwards, as large as floor and ceiling: the floor sees its dark back and nothing else.
TEST(SampledSides, a_lamp_seen_from_its_back_lights_nothing) {
  truth::SceneBuilder b;
  b.material("floor", 0.5f, 0.0f).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  b.material("lamp", 0.5f, 1.0f).quad({0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1});
  b.material("ceiling", 0.5f, 0.0f).quad({0, 1, 2}, {1, 1, 2}, {1, 0, 2}, {0, 0, 2});
  const auto patches = make_patches(b.scene(), {.max_edge = 0.3f});
  const auto [solution, report] = solve(patches, {.error = 0.02, .error_measure = ErrorMeasure::power});
  EXPECT_EQ(truth::mean_irradiance(patches, solution.irradiance.front, "floor"), 0.0);
  EXPECT_EQ(truth::mean_irradiance(patches, solution.irradiance.back, "lamp"), 0.0);
  EXPECT_EQ(truth::mean_irradiance(patches, solution.standard_error.front, "floor"), 0.0);
  EXPECT_NEAR(truth::mean_irradiance(patches, solution.irradiance.front, "ceiling"), 0.20189, 0.002);
}

TEST(SampledSides, a_two_sided_patch_is_lit_on_its_back) {
  truth::SceneBuilder b;
  b.material("lower", 0.5f, 1.0f).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  b.material("upper", 0.5f, 0.0f).quad({0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1});
  const auto patches = make_patches(b.scene(), {.max_edge = 0.1f});
  const auto [solution, report] = solve(patches, {.error = 0.01, .error_measure = ErrorMeasure::power});
  EXPECT_NEAR(truth::mean_irradiance(patches, solution.irradiance.back, "upper"), 0.20189437848, 0.001);
  EXPECT_NEAR(truth::mean_irradiance(patches, solution.radiosity.back, "upper"), 0.10094718924, 0.0005);
  EXPECT_EQ(truth::mean_irradiance(patches, solution.irradiance.front, "upper"), 0.0);
  EXPECT_NEAR(truth::mean_irradiance(patches, solution.irradiance.front, "lower"), 0.02043611012, 0.0004);
}

TEST(SampledSides, a_scene_without_a_lamp_is_refused_with_advice) {
  auto scene = truth::cube_a();
  for (auto& m : scene.materials) m.emittance = Vec3(0.0f);
  const auto patches = make_patches(scene, {.max_edge = no_max_edge});
  try {
    solve(patches, {});
    FAIL() << "expected an InputError";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("Ke"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace luxel
