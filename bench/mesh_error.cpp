// SPDX-License-Identifier: Apache-2.0
// Error of the drawn light with patches of one size, and with patches refined by the light.
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "luxel/patch/make_patches.h"
#include "luxel/solve/refine_to_light.h"
#include "luxel/solve/sampled.h"
#include "luxel/surface/smooth_light.h"

#include "bench/field_error.h"
#include "bench/reconstruction_scenes.h"
#include "bench/scenes.h"
#include "bench/sections.h"
#include "bench/timing.h"

namespace luxel::bench {
namespace {

constexpr std::size_t coarse = 800;  // what refinement begins from

// The same power from a lamp of that share of the size either way: the smaller, the sharper its shadows.
Scene with_small_lamp(Scene scene, float smoothing) {
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
    scene.positions[v] = middle + smoothing * (scene.positions[v] - middle);
  });
  for (auto& m : scene.materials) m.emittance /= smoothing * smoothing;
  return scene;
}

struct Subject {
  UncutScene uncut;
  Vec3 up;
};

// Restricts points to surfaces flat on the ground.
PatchChoice floor_of(const Scene& scene, const Vec3& up) {
  auto lowest = std::numeric_limits<float>::infinity();
  for (const auto& p : scene.positions) lowest = std::min(lowest, glm::dot(p, up));
  return [lowest, up](const PatchSet& patches, std::size_t p) {
    return glm::dot(patches.normal[p], up) > 0.999f &&
           glm::dot(patches.centroid(p), up) < lowest + 1e-4f * std::abs(lowest) + 1e-4f;
  };
}

// Compares a field over the floor, or over all surfaces, with the light at points.
struct Measured {
  std::size_t patches = 0;
  double error = 0.0;
  double noise = 0.0;  // of the error
};

struct Row {
  const char* how = "";
  Measured whole, on_floor;
  double stated = 0.0;  // 0: nothing is
  double rays = 0.0, cpu_seconds = 0.0;
};

class Comparison {
 public:
  Comparison(const Settings& settings, const Subject& subject, const Context& context)
      : settings_(settings),
        uncut_(subject.uncut),
        context_(context),
        is_floor_(floor_of(uncut_.scene, subject.up)),
        truth_(truth({})),
        floor_truth_(truth(is_floor_)) {}

  Json measure() {
    Json rows = Json::array();
    for (std::size_t target = 2000; target <= (settings_.small ? 2000u : 256'000u); target *= 2)
      rows.push_back(noted(of("one size", make_patches(uncut_.scene, {.target_count = target}))));
    for (double error = settings_.small ? 0.16 : 0.04; error >= (settings_.small ? 0.16 : 0.005);
         error *= 0.5) {
      RefineReport report;
      PatchSet patches;
      const auto time = cost([&] {
        patches = refine_to_light(make_patches(uncut_.scene, {.target_count = coarse}), {.mesh_error = error},
                                  report, context_);
      });
      auto row = of("refined", patches);
      row.stated = report.mesh_error;
      row.cpu_seconds = time.cpu;
      for (const auto& level : report.levels) row.rays += static_cast<double>(level.rays);
      rows.push_back(noted(row));
    }
    return {{"scene", uncut_.name}, {"rows", rows}};
  }

 private:
  PointTruth truth(const PatchChoice& only_on) const {
    return {uncut_.scene, uncut_.normal, settings_.small ? 200u : 10'000u, settings_.small ? 16u : 512u,
            context_,     only_on};
  }

  Json noted(const Row& row) const {
    const auto percent = [](double smoothing) { return fmt::format("{:.2f} %", 100.0 * smoothing); };
    const auto field = [&](const Measured& m) {
      return fmt::format("{:>8} {:>8} {:>7}", m.patches, percent(m.error), percent(m.noise));
    };
    fmt::print("{:>24} {:>8} {} {} {:>8} {:>7.1f} {:>7.1f}\n", uncut_.name, row.how, field(row.whole),
               field(row.on_floor), row.stated > 0.0 ? percent(row.stated) : "", 1e-6 * row.rays,
               row.cpu_seconds);
    const auto json = [](const Measured& m) -> Json {
      return {{"patches", m.patches}, {"error", m.error}, {"standard_error", m.noise}};
    };
    return {{"how", row.how},       {"whole", json(row.whole)}, {"floor", json(row.on_floor)},
            {"stated", row.stated}, {"rays", row.rays},         {"cpu_seconds", row.cpu_seconds}};
  }

  Row of(const char* how, const PatchSet& patches) const {
    const Tracer tracer(patches, context_);
    Solution solution;
    solve_sampled(patches, tracer, solution,
                  {.error = settings_.small ? 0.1 : 0.004, .error_measure = ErrorMeasure::power}, context_);
    const auto smooth = make_smooth_light(patches, solution, {}, context_);
    const auto field = drawn_field(smooth, patches.band_count());
    const auto held_to = [&](const PointTruth& truth, std::size_t count) -> Measured {
      const auto error = truth.error(patches, field);
      return {count, error, 0.5 * truth.noise(patches, field) / error};
    };
    std::size_t on_floor = 0;
    for (std::size_t p = 0; p < patches.size(); ++p) on_floor += is_floor_(patches, p) ? 1u : 0u;
    return {
        .how = how, .whole = held_to(truth_, patches.size()), .on_floor = held_to(floor_truth_, on_floor)};
  }

  const Settings& settings_;
  const UncutScene& uncut_;
  const Context& context_;
  PatchChoice is_floor_;
  PointTruth truth_, floor_truth_;
};

std::vector<Subject> subjects(const Settings& settings) {
  const auto all = reconstruction_scenes();
  const auto box_under = [&](const char* name, float smoothing) {
    return Subject{{name, with_small_lamp(all[0].scene, smoothing), all[0].normal}, {0.0f, 1.0f, 0.0f}};
  };
  std::vector<Subject> result = {box_under("Cornell box, small lamp", 0.25f)};
  if (settings.small) return result;
  result.push_back(box_under("Cornell box, tiny lamp", 0.1f));
  for (const auto i : {2u, 3u}) result.push_back({all[i], {0.0f, 0.0f, 1.0f}});  // two rooms, wall on floor
  return result;
}

}  // namespace

Json error_against_patches(const Settings& settings) {
  const Context context;
  fmt::print("\nError of the drawn field at points against the number of patches, relative RMS\n");
  fmt::print("{:>24} {:>8} {:>25} {:>25} {:>8} {:>7} {:>7}\n", "scene", "patches", "all: number, error, +-",
             "floor: number, error, +-", "stated", "Mrays", "CPU s");
  Json scenes = Json::array();
  for (const auto& subject : subjects(settings))
    scenes.push_back(Comparison(settings, subject, context).measure());
  return {{"scenes", scenes}};
}

}  // namespace luxel::bench
