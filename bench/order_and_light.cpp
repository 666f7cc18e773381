// SPDX-License-Identifier: Apache-2.0
// At a million triangles: the gain of the ray order, and the time to a first picture.
#include <chrono>
#include <optional>

#include <fmt/format.h>

#include "luxel/patch/make_patches.h"
#include "luxel/solve/sampled.h"

#include "bench/gather_rays.h"
#include "bench/same_rays.h"
#include "bench/scenes.h"
#include "bench/sections.h"
#include "bench/timing.h"

namespace luxel::bench {
namespace {

struct Large {
  const char* name;
  PatchSet patches;
};

PatchSet as_it_comes(const Scene& scene) { return make_patches(scene, {.max_edge = no_max_edge}); }

std::vector<Large> large_scenes(const Settings& settings) {
  std::vector<Large> result;
  result.push_back({"cornell box", as_it_comes(cornell_box(settings.small ? 20'000 : 1'000'000))});
  result.push_back({"reading room", as_it_comes(reading_room(settings.small ? 1 : 6))});
  return result;
}

// Seconds from before the hierarchy is built until a first picture is there.
struct FirstLight {
  double hierarchy = 0.0;
  std::optional<double> light;
};
FirstLight first_light(const PatchSet& patches, const Context& context) {
  FirstLight result;
  const auto begin = std::chrono::steady_clock::now();
  const auto since = [begin] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  const Tracer tracer(patches, context);
  result.hierarchy = since();
  Solution solution;
  bool has_light = false;
  const auto on_light = [&](const Solution&, const Progress&) {
    result.light = since();
    has_light = true;
  };
  const auto stop_at_light = [&](const Progress&) { return has_light ? Next::stop : Next::go_on; };
  solve_sampled(patches, tracer, solution, {.error = 0.2, .error_measure = ErrorMeasure::power},
                {.on_light = on_light}, context.with_monitor(stop_at_light));
  return result;
}

}  // namespace

Json ray_order(const Settings& settings) {
  fmt::print(
      "\norder: Embree alone on 64 gather rays a patch in the solver's order, against the same rays "
      "shuffled\n");
  fmt::print("{:>14} {:>10} {:>10} {:>14} {:>14} {:>14}\n", "scene", "patches", "Mrays", "shuffled ns",
             "by patch", "as traced");
  const Context context;
  Json rows = Json::array();
  for (const auto& [name, patches] : large_scenes(settings)) {
    const std::size_t most = settings.small ? 200'000 : 4'000'000;
    const BareEmbree embree(patches);
    const auto sides = fronts_of(patches, context);
    const auto traced = gather_rays(patches, sides, {.most = most}, RayOrder::traced);
    const auto by_patch = gather_rays(patches, sides, {.most = most}, RayOrder::by_patch);
    const auto shuffled = gather_rays(patches, sides, {.most = most}, RayOrder::shuffled);
    double shuffled_time = 0.0;
    const auto trace_shuffled = [&] { shuffled_time = seconds([&] { embree.trace(shuffled, context); }); };
    const auto traced_gain = paired(3, trace_shuffled, [&] { embree.trace(traced, context); });
    const auto patch_gain = paired(3, trace_shuffled, [&] { embree.trace(by_patch, context); });
    const auto nanoseconds = 1e9 * shuffled_time / static_cast<double>(shuffled.size());
    fmt::print("{:>14} {:>10} {:>10.2f} {:>14.0f} {:>12.2f} x {:>12.2f} x\n", name, patches.size(),
               1e-6 * static_cast<double>(shuffled.size()), nanoseconds, patch_gain.median,
               traced_gain.median);
    rows.push_back({{"scene", name},
                    {"patches", patches.size()},
                    {"rays", shuffled.size()},
                    {"shuffled_ns_per_ray", nanoseconds},
                    {"by_patch_gain", patch_gain.median},
                    {"traced_gain", traced_gain.median},
                    {"traced_gain_low", traced_gain.low},
                    {"traced_gain_high", traced_gain.high}});
  }
  return rows;
}

Json time_to_first_light(const Settings& settings) {
  fmt::print("\nlight: seconds until a first picture of the whole scene, hierarchy included\n");
  fmt::print("{:>14} {:>10} {:>12} {:>12}\n", "scene", "patches", "hierarchy", "first light");
  const Context context;
  auto scenes = large_scenes(settings);
  scenes.insert(scenes.begin(), {"cornell box", as_it_comes(cornell_box(10'000))});
  Json rows = Json::array();
  for (const auto& [name, patches] : scenes) {
    const auto [hierarchy, light] = first_light(patches, context);
    fmt::print("{:>14} {:>10} {:>12.3f} {:>12}\n", name, patches.size(), hierarchy,
               light ? fmt::format("{:.3f}", *light) : "never");
    rows.push_back({{"scene", name},
                    {"patches", patches.size()},
                    {"hierarchy_seconds", hierarchy},
                    {"first_light_seconds", light ? Json(*light) : Json()}});
  }
  return rows;
}

}  // namespace luxel::bench
