// SPDX-License-Identifier: Apache-2.0
// How fast the shooting solver is, as ratios measured in one run.
#include <cmath>
#include <thread>

#include <fmt/format.h>

#include "luxel/classical/stochastic_jacobi.h"
#include "luxel/patch/make_patches.h"

#include "bench/rooms.h"
#include "bench/same_rays.h"
#include "bench/sections.h"
#include "bench/timing.h"

namespace luxel::bench {
namespace {

SolveReport solve(const PatchSet& patches, const Tracer& tracer, std::uint64_t rays, const Context& context) {
  Solution solution;
  return solve_stochastic_jacobi(patches, tracer, solution, {.rays = rays, .tolerance = 1e-3}, context);
}

}  // namespace

// The limit of the solver is Embree on the same rays; the ratio measures the distance from it.
Json against_embree(const Settings& settings) {
  fmt::print(
      "\nlimit: whole solve against Embree alone on the very same rays (1 is the limit; at least 0.7 is "
      "asked)\n");
  fmt::print("{:>10} {:>8} {:>14} {:>14} {:>8} {:>17}\n", "patches", "threads", "solve Mray/s",
             "Embree Mray/s", "ratio", "(low to high)");
  Json rows = Json::array();
  for (const float edge : {1.0f, settings.small ? 0.5f : 0.1f})
    for (const int threads : {1, static_cast<int>(std::thread::hardware_concurrency())}) {
      const Context context(threads);
      const auto patches = make_patches(furnished_room(100), {.max_edge = edge});
      const Tracer tracer(patches, context);
      const StochasticJacobiOptions options{
          .rays = std::max<std::uint64_t>(settings.small ? 50'000 : 1'500'000, 80 * patches.size()),
          .tolerance = 1e-3};
      const auto rays = rays_of_solve(patches, tracer, options, context);
      const BareEmbree embree(patches);
      std::uint64_t hits = 0;
      std::uint64_t solved_rays = 0;
      double embree_time = 0.0;
      const auto ratio = paired(
          3, [&] { embree_time = seconds([&] { hits = embree.trace(rays, context); }); },
          [&] { solved_rays = solve(patches, tracer, options.rays, context).rays; });
      if (solved_rays != rays.size() || hits == 0)
        throw std::runtime_error("the two sides do not trace the same rays");
      const auto embree_speed = 1e-6 * static_cast<double>(rays.size()) / embree_time;
      fmt::print("{:>10} {:>8} {:>14.2f} {:>14.2f} {:>8.2f} {:>8.2f} to {:.2f}\n", patches.size(), threads,
                 embree_speed * ratio.median, embree_speed, ratio.median, ratio.low, ratio.high);
      rows.push_back({{"patches", patches.size()},
                      {"threads", threads},
                      {"rays", rays.size()},
                      {"embree_mray_per_s", embree_speed},
                      {"ratio", ratio.median},
                      {"ratio_low", ratio.low},
                      {"ratio_high", ratio.high}});
    }
  return rows;
}

// The document's chart: at a fixed number of rays the time grows like the logarithm of the number of
// polygons.
Json against_polygons(const Settings& settings) {
  fmt::print("\npolygons: time against polygons at a fixed number of rays (grows like the logarithm)\n");
  fmt::print("{:>10} {:>12} {:>12} {:>16}\n", "polygons", "ns a ray", "to first", "to log(polygons)");
  const Context context;
  Json rows = Json::array();
  double first = 0.0;
  double first_log = 0.0;
  for (const int boxes : {10, 100, 1'000, 10'000, 100'000}) {
    if (settings.small && boxes > 1'000) break;
    const auto patches = make_patches(furnished_room(boxes), {.max_edge = no_max_edge, .contacts = false});
    const Tracer tracer(patches, context);
    std::uint64_t rays = 0;
    const std::uint64_t asked = settings.small ? 200'000 : 4'000'000;
    std::vector<double> times;
    for (int i = 0; i < 3; ++i)
      times.push_back(seconds([&] { rays = solve(patches, tracer, asked, context).rays; }));
    const auto time = median(times);
    const auto cost = 1e9 * time / static_cast<double>(rays);
    const auto logarithm = std::log(static_cast<double>(patches.size()));
    if (first == 0.0) {
      first = cost;
      first_log = logarithm;
    }
    fmt::print("{:>10} {:>12.0f} {:>12.2f} {:>16.2f}\n", patches.size(), cost, cost / first,
               cost / first / (logarithm / first_log));
    rows.push_back(
        {{"polygons", patches.size()}, {"nanoseconds_per_ray", cost}, {"ratio_to_first", cost / first}});
  }
  return rows;
}

// The document's other chart: the number of lamps does not matter, for rays go by power.
Json against_lamps(const Settings& settings) {
  fmt::print(
      "\nlamps: a lamp of many triangles against a lamp of 2 of the same power (1 is asked, within noise)\n");
  fmt::print("{:>10} {:>12} {:>17}\n", "triangles", "to 2", "(low to high)");
  const Context context;
  const std::uint64_t rays = settings.small ? 50'000 : 1'000'000;
  const auto two = make_patches(furnished_room(200, 2), {.max_edge = no_max_edge});
  const Tracer tracer_two(two, context);
  Json rows = Json::array();
  for (const int triangles : {2, 8, 32, 128}) {
    const auto many = make_patches(furnished_room(200, triangles), {.max_edge = no_max_edge});
    const Tracer tracer_many(many, context);
    const auto ratio = paired(
        7, [&] { solve(many, tracer_many, rays, context); }, [&] { solve(two, tracer_two, rays, context); });
    fmt::print("{:>10} {:>12.3f} {:>8.3f} to {:.3f}\n", triangles, ratio.median, ratio.low, ratio.high);
    rows.push_back({{"triangles", triangles},
                    {"ratio", ratio.median},
                    {"ratio_low", ratio.low},
                    {"ratio_high", ratio.high}});
  }
  return rows;
}

Json against_threads(const Settings& settings) {
  const auto cores = static_cast<int>(std::thread::hardware_concurrency());
  fmt::print("\nthreads: speed-up over one thread, {} cores\n", cores);
  const auto patches = make_patches(furnished_room(200), {.max_edge = 0.05f});
  const std::uint64_t rays = settings.small ? 50'000 : 1'000'000;
  Json rows = Json::array();
  const Context one(1);
  const Tracer tracer(patches, one);
  for (int threads = 1; threads <= 2 * cores; threads *= 2) {
    const Context context(threads);
    const auto ratio = paired(
        3, [&] { solve(patches, tracer, rays, one); }, [&] { solve(patches, tracer, rays, context); });
    fmt::print("{:>3} threads: {:.2f} ({:.2f} to {:.2f})\n", threads, ratio.median, ratio.low, ratio.high);
    rows.push_back({{"threads", threads}, {"speed_up", ratio.median}});
  }
  return rows;
}

}  // namespace luxel::bench
