// SPDX-License-Identifier: Apache-2.0
// Cost of a slider: other lamps and colours for light that was solved once.
#include "luxel/solve/relight.h"

#include <memory>

#include <fmt/format.h>

#include "luxel/patch/light_groups.h"
#include "luxel/patch/make_patches.h"

#include "bench/scenes.h"
#include "bench/sections.h"
#include "bench/timing.h"

namespace luxel::bench {
namespace {

constexpr int repetitions = 7;

// Wall-clock seconds of one change, median.
template <typename Change>
double timed(const Change& change) {
  std::vector<double> times;
  for (int i = 0; i < repetitions; ++i) times.push_back(seconds([&] { change(i); }));
  return median(times);
}

Json measure(const char* name, const Scene& scene, const Context& context) {
  auto patches = make_patches(scene, {.max_edge = no_max_edge});
  set_light_groups(scene, {}, patches);
  const Tracer tracer(patches, context);
  const SampledOptions options = {.error = 0.01, .error_measure = ErrorMeasure::power};
  Solution solution;
  std::shared_ptr<const SampleState> state;
  const SolveHooks keeping{nullptr, [&](auto kept) { state = std::move(kept); }};
  const auto solve = seconds([&] { solve_sampled(patches, tracer, solution, options, keeping, context); });
  std::unique_ptr<Relighter> relighter;
  const auto groups =
      seconds([&] { relighter = std::make_unique<Relighter>(patches, tracer, state, options, context); });

  const auto numbers = patches.group_count() * patches.band_count();
  const auto lamps = timed([&](int i) {
    relighter->set_lamps(std::vector(numbers, 1.0f + 0.1f * static_cast<float>(i)));
    static_cast<void>(relighter->light());
  });
  const auto colours = timed([&](int i) {
    relighter->set_reflectance(
        std::vector(patches.materials.size() * patches.band_count(), 0.4f + 0.05f * static_cast<float>(i)));
    static_cast<void>(relighter->light());
  });
  fmt::print("{:>12} {:>9} {:>7} {:>9} {:>9.2f} {:>9.2f} {:>9.1f} {:>9.1f}\n", name, patches.size(),
             patches.group_count(), solution.provenance.rays, solve, groups, 1e3 * lamps, 1e3 * colours);
  return {{"scene", name},
          {"patches", patches.size()},
          {"light_groups", patches.group_count()},
          {"rays", solution.provenance.rays},
          {"solve_s", solve},
          {"groups_s", groups},
          {"lamps_s", lamps},
          {"reflectances_s", colours}};
}

}  // namespace

Json changed_lamps_and_colours(const Settings& settings) {
  const std::size_t triangles = settings.small ? 2000 : 50'000;
  const Context context;
  fmt::print("\nOther lamps and colours of light solved to 1 %, {} threads\n", context.threads());
  fmt::print("{:>12} {:>9} {:>7} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "scene", "patches", "groups", "rays",
             "solve s", "groups s", "lamps ms", "walls ms");
  auto table = Json::array();
  table.push_back(measure("Cornell box", cornell_box(triangles), context));
  table.push_back(measure("office", office(triangles), context));
  table.push_back(measure("two rooms", two_rooms(triangles), context));
  return table;
}

}  // namespace luxel::bench
