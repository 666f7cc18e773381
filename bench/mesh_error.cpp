// SPDX-License-Identifier: Apache-2.0
// What patches of one size, and patches put where the light needs them, do to the light that is drawn.
#include <fmt/format.h>

#include "luxel/patch/make_patches.h"
#include "luxel/refine/refine_to_light.h"
#include "luxel/solve/sampled.h"
#include "luxel/surface/smooth_light.h"

#include "bench/field_error.h"
#include "bench/reconstruction_scenes.h"
#include "bench/scenes.h"
#include "bench/sections.h"
#include "bench/timing.h"

namespace luxel::bench {
namespace {

constexpr std::size_t coarse = 3000;  // what refinement begins from

// The same power from a lamp of a quarter of the size either way: shadows have sharp edges.
Scene with_small_lamp(Scene scene) {
  constexpr float share = 0.25f;
  Vec3 middle(0.0f);
  float count = 0.0f;
  const auto each_corner = [&](auto body) {
    for (std::size_t t = 0; t < scene.triangles.size(); ++t)
      if (scene.materials[static_cast<std::size_t>(scene.triangle_material[t])].is_lamp())
        for (const auto v : scene.triangles[t]) body(v);
  };
  each_corner([&](std::uint32_t v) { middle += scene.positions[v], count += 1.0f; });
  middle /= count;
  std::vector<bool> is_done(scene.positions.size(), false);
  each_corner([&](std::uint32_t v) {
    if (is_done[v]) return;
    is_done[v] = true;
    scene.positions[v] = middle + share * (scene.positions[v] - middle);
  });
  for (auto& m : scene.materials) m.emittance /= share * share;
  return scene;
}

struct Measured {
  std::size_t patches = 0;
  double error = 0.0;
  double noise = 0.0;  // of the error
};

class Subject {
 public:
  Subject(const Settings& settings, const UncutScene& uncut, const Workers& workers)
      : settings_(settings),
        uncut_(uncut),
        workers_(workers),
        truth_(uncut.scene, uncut.normal, settings.small ? 200 : 10'000, settings.small ? 16 : 512, workers) {
  }

  Json measure() {
    Json rows = Json::array();
    const auto add = [&](const char* how, const Measured& m, double stated, double seconds) {
      fmt::print("{:>24} {:>8} {:>9} {:>8.2f} % {:>6.2f} % {:>8} {:>7.1f}\n", uncut_.name, how, m.patches,
                 100.0 * m.error, 100.0 * m.noise,
                 stated > 0.0 ? fmt::format("{:.2f} %", 100.0 * stated) : std::string(), seconds);
      rows.push_back({{"patches", m.patches},
                      {"error", m.error},
                      {"standard_error", m.noise},
                      {"stated", stated},
                      {"how", how},
                      {"cpu_seconds", seconds}});
    };
    for (std::size_t target = 2000; target <= (settings_.small ? 2000u : 128'000u); target *= 2)
      add("one size", of(make_patches(uncut_.scene, {.target_count = target})), 0.0, 0.0);
    for (double error = 0.16; error >= (settings_.small ? 0.16 : 0.01); error *= 0.5) {
      RefineReport report;
      PatchSet patches;
      const auto time = cost([&] {
        patches = refine_to_light(make_patches(uncut_.scene, {.target_count = coarse}), {.mesh_error = error},
                                  report, workers_);
      });
      add("refined", of(patches), report.mesh_error, time.cpu);
    }
    return {{"scene", uncut_.name}, {"rows", rows}};
  }

 private:
  Measured of(const PatchSet& patches) const {
    const Tracer tracer(patches, workers_);
    Solution solution;
    solve_sampled(patches, tracer, solution, {.error = settings_.small ? 0.1 : 0.004}, workers_);
    const auto smooth = make_smooth_light(patches, solution, {}, workers_);
    const auto field = drawn_field(smooth, patches.band_count());
    const auto error = truth_.error(patches, field);
    return {patches.size(), error, 0.5 * truth_.noise(patches, field) / error};
  }

  const Settings& settings_;
  const UncutScene& uncut_;
  const Workers& workers_;
  PointTruth truth_;
};

}  // namespace

Json error_against_patches(const Settings& settings) {
  const Workers workers;
  fmt::print("\nError of the drawn field at points against the number of patches, relative RMS\n");
  fmt::print("{:>24} {:>8} {:>9} {:>10} {:>8} {:>8} {:>7}\n", "scene", "patches", "number", "error", "+-",
             "stated", "CPU s");
  const auto all = reconstruction_scenes();
  std::vector<UncutScene> subjects = {all[0]};
  subjects.front().name = "Cornell box, small lamp";
  subjects.front().scene = with_small_lamp(subjects.front().scene);
  if (!settings.small) subjects.insert(subjects.end(), {all[2], all[3]});  // two rooms, wall on floor
  Json scenes = Json::array();
  for (const auto& subject : subjects) scenes.push_back(Subject(settings, subject, workers).measure());
  return {{"scenes", scenes}};
}

}  // namespace luxel::bench
