// SPDX-License-Identifier: Apache-2.0
// Difference between the light drawn over patches and the light at points.
#include <fmt/format.h>

#include "luxel/patch/make_patches.h"
#include "luxel/solve/sampled.h"
#include "luxel/surface/smooth_light.h"

#include "bench/field_error.h"
#include "bench/reconstruction_scenes.h"
#include "bench/scenes.h"
#include "bench/sections.h"
#include "bench/timing.h"

namespace luxel::bench {
namespace {

// Each patch with its own value.
Field flat(const Solution& solution) {
  return [&solution](std::size_t patch, bool back, const Vec2&, double* light) {
    const auto& h = solution.irradiance.of(back);
    const auto bands = solution.bands.size();
    for (std::size_t b = 0; b < bands; ++b) light[b] = static_cast<double>(h[patch * bands + b]);
  };
}

// Baseline: each vertex has the area-weighted mean of its patches, and contacts are ignored.
SmoothLight mean_light(PatchSet patches, const Solution& solution) {
  patches.contacts.clear();
  auto light = make_smooth_light(patches, solution);
  const auto bands = patches.band_count();
  std::vector<double> area(light.size(), 0.0);
  std::vector<double> front(light.irradiance.front.size(), 0.0), back(front.size(), 0.0);
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (const auto s : light.corners[p]) {
      const auto a = static_cast<double>(patches.area[p]);
      area[s] += a;
      for (std::size_t b = 0; b < bands; ++b) {
        front[s * bands + b] += a * static_cast<double>(solution.irradiance.front[p * bands + b]);
        back[s * bands + b] += a * static_cast<double>(solution.irradiance.back[p * bands + b]);
      }
    }
  for (std::size_t i = 0; i < front.size(); ++i) {
    light.irradiance.front[i] = static_cast<float>(front[i] / area[i / bands]);
    light.irradiance.back[i] = static_cast<float>(back[i] / area[i / bands]);
  }
  return light;
}

Json row_of(const UncutScene& subject, const PointTruth& truth, std::size_t target, double error,
            const Context& context) {
  const auto patches = make_patches(subject.scene, {.target_count = target});
  const Tracer tracer(patches, context);
  Solution solution;
  solve_sampled(patches, tracer, solution, {.error = error, .error_measure = ErrorMeasure::power}, context);
  const auto bands = patches.band_count();
  const auto as_it_is = flat(solution);
  const auto by_means = mean_light(patches, solution);
  SmoothLight smooth;
  const auto time = cost([&] { smooth = make_smooth_light(patches, solution, {}, context); });

  const auto off = truth.error(patches, as_it_is);
  const auto off_means = truth.error(patches, drawn_field(by_means, bands));
  const auto now = drawn_field(smooth, bands);
  const auto off_now = truth.error(patches, now);
  const auto plus_minus = 0.5 * truth.noise(patches, now) / off_now;
  fmt::print("{:>16} {:>9} {:>8.2f} % {:>8.2f} % {:>8.2f} % {:>6.2f} %\n", subject.name, patches.size(),
             100.0 * off, 100.0 * off_means, 100.0 * off_now, 100.0 * plus_minus);
  return {{"scene", subject.name},     {"patches", patches.size()}, {"flat", off},
          {"vertex_means", off_means}, {"reconstructed", off_now},  {"standard_error", plus_minus},
          {"cpu_seconds", time.cpu}};
}

Json cost_of_a_million(const Settings& settings, const Context& context) {
  const auto patches = make_patches(reading_room(settings.small ? 1 : 5), {.max_edge = no_max_edge});
  Solution solution;
  solution.bands = patches.bands;
  solution.irradiance.front.resize(patches.size() * patches.band_count());
  for (std::size_t i = 0; i < solution.irradiance.front.size(); ++i)
    solution.irradiance.front[i] = static_cast<float>(i % 7);
  solution.irradiance.back = solution.irradiance.front;
  solution.standard_error.front.assign(solution.irradiance.front.size(), 0.1f);
  solution.standard_error.back = solution.standard_error.front;
  std::vector<double> times;
  for (int i = 0; i < 3; ++i)
    times.push_back(cost([&] { make_smooth_light(patches, solution, {}, context); }).cpu);
  const auto each = 1e6 * median(times) / static_cast<double>(patches.size());
  fmt::print("{:>16} {:>9} {:>8.2f} CPU s, {:.2f} us a patch, both sides lit\n", "reading room",
             patches.size(), median(times), each);
  return {{"patches", patches.size()}, {"cpu_seconds", median(times)}, {"microseconds_per_patch", each}};
}

}  // namespace

Json reconstruction(const Settings& settings) {
  const Context context;
  const std::size_t points = settings.small ? 200 : 8000;
  const std::uint64_t paths = settings.small ? 16 : 512;
  const std::vector<std::size_t> targets =
      settings.small ? std::vector<std::size_t>{500} : std::vector<std::size_t>{2'000, 8'000, 32'000};
  const auto error = settings.small ? 0.1 : 0.005;
  fmt::print("\nError of the drawn field at points, relative RMS ({} points, solved to {:g} %)\n", points,
             100.0 * error);
  fmt::print("{:>16} {:>9} {:>10} {:>10} {:>10} {:>8}\n", "scene", "patches", "flat", "means", "now", "+-");
  Json rows = Json::array();
  for (const auto& subject : reconstruction_scenes()) {
    const PointTruth truth(subject.scene, subject.normal, points, paths, context);
    for (const auto target : targets) rows.push_back(row_of(subject, truth, target, error, context));
  }
  return {{"points", points},
          {"paths_a_point", 2 * paths},
          {"error_asked_for", error},
          {"scenes", rows},
          {"cost", cost_of_a_million(settings, context)}};
}

}  // namespace luxel::bench
