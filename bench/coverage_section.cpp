// SPDX-License-Identifier: Apache-2.0
// Tests whether stated errors are true: compares intervals and the seen error with known light.
#include <fmt/format.h>

#include "luxel/lamps/choose_portals.h"

#include "bench/coverage.h"
#include "bench/mesher.h"
#include "bench/scenes.h"

namespace luxel::bench {
namespace {

constexpr double errors[] = {0.20, 0.10, 0.05, 0.02, 0.01, 0.003};
constexpr double large_error = errors[4];  // smallest in large scenes, which take too long otherwise
constexpr std::uint32_t truth_runs = 8;
constexpr double truth_factor = 16.0;  // rays of the truth over those of a run at the least error
constexpr std::uint64_t probe_seed = 999;

struct Subject {
  std::string name;
  Scene scene;
  double smallest_error = errors[5];
};

// A room of 5 x 4 x 3 m with a hole of 1 m² in one wall, under a sky as bright all over.
Scene window_room(float cell) {
  Mesher mesher(cell);
  mesher.material("plaster", Vec3(0.6f));
  const auto strip = [&](float x0, float x1, float z0, float z1) {
    mesher.quad({x0, 0, z0}, {x0, 0, z1}, {x1, 0, z1}, {x1, 0, z0});
  };
  constexpr std::array<float, 4> columns = {0, 2, 3, 5}, rows = {0, 1, 2, 3};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (i != 1 || j != 1) strip(columns[i], columns[i + 1], rows[j], rows[j + 1]);
  mesher.material("far wall", {0.6f, 0.5f, 0.4f});
  mesher.quad({0, 4, 0}, {5, 4, 0}, {5, 4, 3}, {0, 4, 3});
  mesher.material("sides", Vec3(0.6f));
  mesher.quad({0, 0, 0}, {0, 4, 0}, {0, 4, 3}, {0, 0, 3});
  mesher.quad({5, 0, 0}, {5, 0, 3}, {5, 4, 3}, {5, 4, 0});
  mesher.material("ceiling", Vec3(0.8f));
  mesher.quad({0, 0, 3}, {0, 4, 3}, {5, 4, 3}, {5, 0, 3});
  mesher.material("floor", {0.35f, 0.25f, 0.15f});
  mesher.quad({0, 0, 0}, {5, 0, 0}, {5, 4, 0}, {0, 4, 0});
  auto scene = mesher.take();
  scene.sky = Vec3(1.0f);
  return scene;
}

// A closed room with three boxes and a lamp under the ceiling, all but the lamp of reflectance 0.98.
Scene white_room(float cell) {
  Mesher mesher(cell);
  mesher.material("walls", Vec3(0.98f));
  mesher.box({0, 0, 0}, {5, 4, 2.8f}, true);
  mesher.material("boxes", Vec3(0.98f));
  mesher.box({0.6f, 0.5f, 0.001f}, {1.4f, 1.5f, 0.9f});
  mesher.box({2.8f, 2.2f, 0.001f}, {3.6f, 3.2f, 1.6f});
  mesher.box({3.4f, 0.4f, 0.001f}, {4.6f, 0.9f, 0.5f});
  mesher.material("lamp", Vec3(0.0f), Vec3(30.0f));
  mesher.quad({2.2f, 1.7f, 2.7f}, {2.2f, 2.3f, 2.7f}, {2.8f, 2.3f, 2.7f}, {2.8f, 1.7f, 2.7f});
  return mesher.take();
}

std::string percent(const Held& held) {
  return fmt::format("{:.1f} +- {:.1f}", 100.0 * held.fraction, 196.0 * held.error);
}

Json to_json(const Held& held) {
  return {{"fraction", held.fraction}, {"standard_error", held.error}, {"intervals", held.intervals}};
}

Json to_json(const Coverage& c) {
  return {{"asked", c.asked},
          {"seeds", c.seeds},
          {"sides", to_json(c.sides)},
          {"sides_by_area", to_json(c.sides_by_area)},
          {"surfaces", to_json(c.surfaces)},
          {"power", to_json(c.power)},
          {"stated_seen_error", c.stated},
          {"true_seen_error", c.true_error},
          {"power_bias", c.power_bias},
          {"power_bias_standard_error", c.power_bias_error},
          {"truth_error_over_stated", c.truth_part},
          {"cpu_seconds", c.cpu_seconds},
          {"rays", c.rays}};
}

Json coverage_of_scene(const Subject& subject, const Settings& settings, const Context& context) {
  Stage stage(subject.name, subject.scene, context);
  set_portals(subject.scene, stage.tracer, stage.patches, context);
  const auto views = place_views(stage.patches, stage.tracer, context).stating;
  const auto least = settings.small ? errors[2] : subject.smallest_error;
  Solution probe;
  const auto rays =
      solve_sampled(stage.patches, stage.tracer, probe, {.error = least, .seed = probe_seed}, context).rays;
  fmt::print("\n{}: {} patches, {:.1f} Mrays to {:g} %\n", stage.name, stage.patches.size(),
             1e-6 * static_cast<double>(rays), 100.0 * least);
  const auto truth = known_light(stage, static_cast<std::uint64_t>(truth_factor * static_cast<double>(rays)),
                                 truth_runs, settings, context);
  fmt::print("truth of {:.0f} Mrays\n", 1e-6 * static_cast<double>(truth.rays));
  fmt::print("{:>7} {:>9} {:>9} {:>6} {:>14} {:>14} {:>14} {:>14} {:>18} {:>7} {:>7} {:>6}\n", "asked",
             "stated", "true", "ratio", "sides", "by area", "surfaces", "power", "power bias", "truth",
             "Mrays", "CPU s");
  Json rows = Json::array();
  std::uint64_t seed = 1;
  for (const auto error : errors) {
    if (error < least) break;
    const std::size_t seeds = settings.small ? 3 : 20;
    const auto c = coverage_of(stage, views, truth, error, seeds, seed, context);
    seed += 1000;  // independent of the errors before
    fmt::print(
        "{:>5.1f} % {:>7.3f} % {:>7.3f} % {:>6.3f} {:>14} {:>14} {:>14} {:>14} {:>7.3f} +- {:.3f} % {:>7.3f} "
        "{:>7.2f} {:>6.2f}\n",
        100.0 * c.asked, 100.0 * c.stated, 100.0 * c.true_error, c.true_error / c.stated, percent(c.sides),
        percent(c.sides_by_area), percent(c.surfaces), percent(c.power), 100.0 * c.power_bias,
        196.0 * c.power_bias_error, c.truth_part, 1e-6 * c.rays, c.cpu_seconds);
    rows.push_back(to_json(c));
  }
  return {
      {"scene", stage.name}, {"patches", stage.patches.size()}, {"truth_rays", truth.rays}, {"rows", rows}};
}

}  // namespace

Json stated_against_true(const Settings& settings) {
  fmt::print("\ncoverage: intervals of 95 % and stated seen errors against known light, 20 seeds each\n");
  const Context context;
  const auto size = [&](std::size_t triangles) { return settings.small ? triangles / 10 : triangles; };
  const float coarser = settings.small ? 3.0f : 1.0f;
  Json scenes = Json::array();
  for (const auto& subject :
       {Subject{"cornell box", cornell_box(size(5'500))},
        Subject{"large cornell box", cornell_box(size(50'000)), large_error},
        Subject{"room with a window", window_room(0.21f * coarser)},
        Subject{"white room, reflectance 0.98", white_room(0.23f * coarser)},
        Subject{"office", office(size(6'000))}, Subject{"large office", office(size(50'000)), large_error}})
    scenes.push_back(coverage_of_scene(subject, settings, context));
  return {{"scenes", scenes}};
}

}  // namespace luxel::bench
