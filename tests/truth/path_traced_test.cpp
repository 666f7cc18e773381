// SPDX-License-Identifier: Apache-2.0
// Path tracing in rooms whose light is known. Errors of different sides are independent, so z² of n numbers
// has a mean near 1 with a standard deviation of about sqrt(2 / n); the three bands of a side lie on the same
// paths, so n counts sides. Five standard deviations are allowed above, and a bar must not be far too wide.
// Noise of few paths is skewed: measured over seeds, bars of 1,600 paths hold the truth 92 to 96 times in
// 100, those of 6,400 paths 93 to 96 times; the coloured room, where a lamp has one colour, is the worst.
#include "luxel/render/path_traced.h"

#include <array>
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/patch/make_patches.h"

#include "support/known_rooms.h"
#include "support/truth_scenes.h"

namespace luxel {
namespace {

struct Traced {
  Solution solution;
  PathReport report;
};

Traced trace(const PatchSet& patches, const PathOptions& options) {
  const Context context;
  const Tracer tracer(patches, context);
  Traced traced;
  traced.report = trace_light(patches, tracer, traced.solution, options, context);
  return traced;
}

// Mean of z² and fraction of |z| < 1.96 over lit sides, band by band.
struct Scores {
  double z2 = 0.0, within = 0.0, sides = 0.0, bias = 0.0, bias_error = 0.0;
};
Scores score(const truth::KnownRoom& room, const Solution& solution) {
  Scores s;
  double numbers = 0.0;
  double light = 0.0;
  double variance = 0.0;
  for (const bool back : {false, true}) {
    const auto& truth = room.truth.irradiance.of(back);
    const auto& found = solution.irradiance.of(back);
    const auto& error = solution.standard_error.of(back);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (truth[i] < 1e-9) {
        EXPECT_EQ(found[i], 0.0f) << "light in the dark";
        continue;
      }
      const double area = room.patches.area[i / 3];
      const auto off = static_cast<double>(found[i]) - truth[i];
      const auto z = off / static_cast<double>(error[i]);
      s.z2 += z * z;
      s.within += std::abs(z) < 1.96 ? 1.0 : 0.0;
      s.bias += area * off;
      variance += area * area * static_cast<double>(error[i]) * static_cast<double>(error[i]);
      light += area * truth[i];
      numbers += 1.0;
    }
  }
  s.z2 /= numbers;
  s.within /= numbers;
  s.sides = numbers / 3.0;
  s.bias /= light;
  s.bias_error = std::sqrt(3.0 * variance) / light;  // bands lie on the same paths
  return s;
}

class PathTracedRoom : public testing::TestWithParam<truth::RoomMaker> {};

TEST_P(PathTracedRoom, has_the_radiosity_of_its_patches_within_its_error_bars) {
  const auto room = GetParam().make();
  const auto traced =
      trace(room.patches, {.limits = {.samples = 1600}, .bounces_from = BouncesFrom::patches});
  const auto s = score(room, traced.solution);
  const auto spread = std::sqrt(2.0 / s.sides);
  EXPECT_LT(s.z2, 1.0 + 5.0 * spread) << "noise above what is stated";
  EXPECT_GT(s.z2, 0.5) << "noise far below what is stated";
  EXPECT_GT(s.within, 0.90);
  EXPECT_LT(std::abs(s.bias), 5.0 * s.bias_error + room.truth_error) << "+- " << s.bias_error;
  EXPECT_LT(s.bias_error, 0.004) << "too noisy to tell";
  EXPECT_TRUE(traced.report.complete);
}

INSTANTIATE_TEST_SUITE_P(Every, PathTracedRoom, testing::ValuesIn(truth::known_rooms()),
                         [](const testing::TestParamInfo<truth::RoomMaker>& one) { return one.param.name; });

// Few large patches: true light shows variation that light constant per patch would hide.
void expect_means(const PatchSet& patches, const std::map<std::string, double>& exact) {
  const auto traced = trace(patches, {.limits = {.samples = 60'000}});
  const auto& s = traced.solution;
  for (const auto& [name, value] : exact) {
    double area = 0.0;
    double mean = 0.0;
    double variance = 0.0;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      if (patches.material_of(p).name != name) continue;
      const double a = patches.area[p];
      const double error = s.standard_error.front[3 * p];
      area += a;
      mean += a * static_cast<double>(s.irradiance.front[3 * p]);
      variance += a * a * error * error;
    }
    const auto error = std::sqrt(variance) / area;
    EXPECT_NEAR(mean / area, value, 4.5 * error) << name << " +- " << error;
    EXPECT_LT(error, 0.013 * value) << name << ": too noisy to tell";
  }
}

TEST(PathTraced, a_cube_of_twelve_patches_has_the_light_of_the_continuous_cube) {
  const auto patches = make_patches(truth::cube_a(), {.max_edge = no_max_edge});
  ASSERT_EQ(patches.size(), 12u);
  expect_means(patches, {{"wall_x0", 0.36221119},
                         {"wall_x1", 0.36221119},
                         {"wall_y0", 0.36221119},
                         {"wall_y1", 0.36221119},
                         {"floor", 0.34243212},
                         {"ceiling", 0.20872313}});
}

TEST(PathTraced, an_l_shaped_room_of_large_patches_is_lit_round_the_corner) {
  expect_means(make_patches(truth::l_room(), {.max_edge = no_max_edge}), {{"ceiling", 0.1391531},
                                                                          {"wall_y0", 0.2038067},
                                                                          {"end_x2", 0.1689368},
                                                                          {"inner_y1", 0.3212263},
                                                                          {"wall_x0", 0.0836591}});
}

// The same cube, as radiosity on twelve patches: another number, which dense truth gives.
TEST(PathTraced, bounces_from_patches_keep_the_error_of_the_mesh) {
  const Context context;
  truth::KnownRoom room;
  room.patches = make_patches(truth::cube_a(), {.max_edge = no_max_edge});
  room.truth = truth::true_light(room.patches, truth::form_factors(room.patches, {}, context));
  const auto traced =
      trace(room.patches, {.limits = {.samples = 40'000}, .bounces_from = BouncesFrom::patches});
  for (std::size_t i = 0; i < room.truth.irradiance.front.size(); ++i)
    EXPECT_NEAR(traced.solution.irradiance.front[i], room.truth.irradiance.front[i],
                4.5 * traced.solution.standard_error.front[i]);
}

TEST(PathTraced, a_furnace_glows_alike_everywhere_however_white) {
  for (const float white : {0.1f, 0.5f, 0.9f}) {
    const auto patches = make_patches(truth::furnace(Vec3(white), Vec3(0.5f * white)), {.max_edge = 0.5f});
    for (const auto from : {BouncesFrom::points, BouncesFrom::patches}) {
      const auto [s, report] = trace(patches, {.limits = {.samples = 1024}, .bounces_from = from});
      double sum = 0.0;
      double variance = 0.0;
      for (std::size_t p = 0; p < patches.size(); ++p) {
        const double error = s.standard_error.front[3 * p];
        sum += static_cast<double>(s.irradiance.front[3 * p]) - 1.0;
        variance += error * error;
        EXPECT_NEAR(s.irradiance.front[3 * p], 1.0, 5.5 * error)
            << "patch " << p << " of reflectance " << white;
      }
      EXPECT_LT(std::abs(sum), 5.0 * std::sqrt(variance)) << white;
      EXPECT_EQ(report.escaped, std::vector<double>(3, 0.0)) << "nothing leaks";
      EXPECT_EQ(report.lost_at_backs, std::vector<double>(3, 0.0));
    }
  }
}

// A lamp below, a one-sided plate above that shows its back, a wall beside both; open to the rest.
PatchSet leaky_room() {
  truth::SceneBuilder b;
  b.material("lamp", Vec3(0.5f), {1.0f, 0.1f, 3.0f}).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  b.material("turned_away", 0.5f, 0.0f, false).quad({0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1});
  b.material("beside", 0.7f, 0.0f).quad({1, 0, 0}, {1, 0, 2}, {1, 1, 2}, {1, 1, 0});
  return make_patches(b.scene(), {.max_edge = 0.3f});
}

TEST(PathTraced, backs_of_one_sided_materials_absorb_what_meets_them) {
  truth::KnownRoom room;
  room.patches = leaky_room();
  const Context context;
  const std::array<Vec3, 4> turned_away = {{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
  room.truth = truth::true_light(
      room.patches, truth::form_factors(room.patches, {truth::convex_polygon(turned_away)}, context));
  // Light at the back of a one-sided material counts nowhere.
  for (std::size_t p = 0; p < room.patches.size(); ++p)
    if (!room.patches.material_of(p).two_sided)
      for (std::size_t b = 0; b < 3; ++b) room.truth.irradiance.back[3 * p + b] = 0.0;
  const auto traced =
      trace(room.patches, {.limits = {.samples = 8000}, .bounces_from = BouncesFrom::patches});
  const auto s = score(room, traced.solution);
  EXPECT_LT(s.z2, 1.0 + 5.0 * std::sqrt(2.0 / s.sides));
  const auto& r = traced.report;
  for (std::size_t b = 0; b < 3; ++b) {
    EXPECT_GT(r.lost_at_backs[b], 0.1 * r.emitted[b]);
    EXPECT_GT(r.escaped[b], 0.1 * r.emitted[b]);
    EXPECT_NEAR(r.absorbed[b] + r.escaped[b] + r.lost_at_backs[b], r.emitted[b], 0.01 * r.emitted[b]);
  }
}

TEST(PathTraced, stops_at_the_error_asked_for_and_says_what_it_reached) {
  const auto patches = make_patches(truth::cube_a(), {.max_edge = 0.3f});
  const auto [s, report] = trace(patches, {.limits = {.error = 0.02}});
  EXPECT_EQ(report.stop, StopReason::error_reached);
  EXPECT_LE(report.predicted_error, 0.02);
  EXPECT_GT(report.predicted_error, 0.012) << "far more was done than asked";
  EXPECT_EQ(s.predicted_error, report.predicted_error);
  EXPECT_EQ(s.provenance.method, "path-traced");
}

TEST(PathTraced, gives_the_same_bits_on_any_number_of_threads) {
  const auto patches = leaky_room();
  Solution first;
  for (const int threads : {1, 2, 5}) {
    const Context context(threads);
    const Tracer tracer(patches, context);
    Solution solution;
    trace_light(patches, tracer, solution, {.limits = {.error = 0.03}}, context);
    if (threads == 1) first = solution;
    EXPECT_EQ(solution.irradiance.front, first.irradiance.front);
    EXPECT_EQ(solution.irradiance.back, first.irradiance.back);
    EXPECT_EQ(solution.standard_error.front, first.standard_error.front);
    EXPECT_EQ(solution.provenance.rays, first.provenance.rays);
  }
}

TEST(PathTraced, that_is_stopped_has_the_light_of_the_paths_so_far) {
  const auto patches = make_patches(truth::cube_a(), {.max_edge = 0.2f});
  const Context context;
  const Tracer tracer(patches, context);
  Solution solution;
  int calls = 0;
  const auto stop_after = [&](const Progress&) { return ++calls > 8 ? Next::stop : Next::go_on; };
  const auto report =
      trace_light(patches, tracer, solution, {.limits = {.error = 1e-5}}, context.with_monitor(stop_after));
  EXPECT_EQ(report.stop, StopReason::stopped_by_user);
  EXPECT_TRUE(report.complete);
  EXPECT_NEAR(truth::mean_irradiance(patches, solution.irradiance.front, "floor"), 0.34243, 0.03);
  calls = 1000;
  EXPECT_FALSE(trace_light(patches, tracer, solution, {}, context.with_monitor(stop_after)).complete);
}

TEST(PathTraced, a_scene_without_a_lamp_is_refused_with_advice) {
  auto scene = truth::cube_a();
  for (auto& m : scene.materials) m.emittance = Vec3(0.0f);
  try {
    trace(make_patches(scene, {.max_edge = no_max_edge}), {});
    FAIL() << "expected an InputError";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("Ke"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace luxel
