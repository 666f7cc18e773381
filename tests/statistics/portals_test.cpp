// SPDX-License-Identifier: Apache-2.0
// The sky through portals: closed forms, cosine rays, and any set of portals against none. Risk of a false
// alarm: about one in a million per comparison.
#include "luxel/lamps/portals.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <gtest/gtest.h>

#include "luxel/core/address.h"
#include "luxel/lamps/direct_light.h"
#include "luxel/patch/light_groups.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/patch/side.h"
#include "luxel/solution/solution_file.h"
#include "luxel/solve/hit_store.h"
#include "luxel/solve/relight.h"
#include "luxel/solve/sampled.h"
#include "luxel/trace/patch_emitter.h"

#include "support/sample_solution.h"
#include "support/window_rooms.h"

namespace luxel {
namespace {

constexpr double risk_sigmas = 5.1;
constexpr std::uint32_t replicates = 32;

struct Estimate {
  double mean = 0.0, sigma = 0.0;
};

Estimate estimate_of(const std::vector<double>& values) {
  Estimate e;
  for (const auto v : values) e.mean += v / static_cast<double>(values.size());
  for (const auto v : values) e.sigma += (v - e.mean) * (v - e.mean);
  const auto n = static_cast<double>(values.size());
  e.sigma = std::sqrt(e.sigma / (n * (n - 1.0)));
  return e;
}

struct Room {
  explicit Room(const Scene& scene, std::vector<Portal> portals = {}, float max_edge = 1.0f)
      : patches(make_patches(scene, {.max_edge = max_edge})), tracer(patches, Context(1)) {
    patches.portals = std::move(portals);
  }

  PatchSet patches;
  Tracer tracer;

  // Light of the sky found by cosine rays, W/m².
  Estimate sky_by_cosine(SideId side) const {
    constexpr std::size_t rays = 20'000;
    const PatchEmitter emitter(patches, side);
    double escaped = 0.0;
    for (std::size_t i = 0; i < rays; ++i)
      if (!tracer.nearest(emitter.ray(uniform4(stream_key(77, 0, 0), i)))) escaped += 1.0 / rays;
    return {std::numbers::pi * escaped, std::numbers::pi * std::sqrt(escaped * (1.0 - escaped) / rays)};
  }

  // Light of the sky through portals, replicate by replicate, [side][replicate].
  std::vector<std::vector<double>> direct(const DirectOptions& options, std::uint32_t samples = 16) const {
    const Lamps lamps(patches);
    const DirectLight light(patches, tracer, lamps, options);
    const auto width = patches.group_count() * patches.band_count();
    std::vector<float> out(options.replicates * width);
    std::vector<std::vector<double>> values(side_count(patches.size()));
    for (std::size_t side = 0; side < values.size(); ++side) {
      light.estimate(SideId::at(side), 0, 0, samples, out);
      for (std::size_t r = 0; r < options.replicates; ++r)
        values[side].push_back(static_cast<double>(out[r * width]));
    }
    return values;
  }

  // Light of the sky by both ways together: all sides, replicate by replicate, [side][replicate].
  std::vector<std::vector<double>> sky_by_both(const DirectOptions& options, std::uint32_t samples) const {
    const Context context(2);
    const auto tree = make_patch_tree(patches, context);
    HitStore hits(patches, all_gather_sides(patches, tree), tracer, {.replicates = options.replicates});
    std::vector<std::uint32_t> all(hits.sides().size());
    for (std::uint32_t s = 0; s < all.size(); ++s) all[s] = s;
    constexpr std::uint32_t rays = 64;
    hits.double_rays(all, rays, context);
    auto values = direct(options, samples);
    for (std::uint32_t r = 0; r < options.replicates; ++r)
      for (std::size_t block = 0; block < hits.blocks(); ++block)
        hits.for_each_hit(r, block, [&](std::uint32_t receiver, std::uint32_t element) {
          if (element == hits.escaped())
            values[hits.sides().side[receiver].index()][r] += std::numbers::pi / rays;
        });
    return values;
  }
};

// Each side's mean by both ways against cosine rays.
void expect_unbiased(const Room& room, const DirectOptions& options, const std::string& what,
                     std::uint32_t samples = 16) {
  const auto values = room.sky_by_both(options, samples);
  for (std::size_t side = 0; side < values.size(); side += 5) {
    const auto own = estimate_of(values[side]);
    const auto truth = room.sky_by_cosine(SideId::at(side));
    // 1.5e-3: of the closed form's quadrature; 8e-4: cosine rays that found almost nothing have no spread.
    const auto allowed =
        risk_sigmas * std::hypot(own.sigma, truth.sigma) + 1.5e-3 * truth.mean + std::numbers::pi * 8e-4;
    EXPECT_NEAR(own.mean, truth.mean, allowed) << what << ", side " << side;
  }
}

TEST(Portals, an_open_window_gives_its_closed_form_without_noise) {
  const Room room(truth::under_sky(truth::window_room()), truth::window_portals());
  const auto direct = room.direct({.replicates = replicates});
  std::size_t lit = 0;
  for (std::size_t patch = 0; patch < room.patches.size(); ++patch) {
    if (room.patches.material_of(patch).name == "front") continue;
    for (const bool back : {false, true}) {
      const auto side = SideId(patch, back);
      const auto own = estimate_of(direct[side.index()]);
      const auto truth = room.sky_by_cosine(side);
      if (truth.mean > 1.0 || truth.mean == 0.0) {  // outside
        EXPECT_NEAR(own.mean, 0.0, 1e-6);
        continue;
      }
      ++lit;
      EXPECT_NEAR(own.mean, truth.mean, risk_sigmas * truth.sigma + 1.5e-3 * truth.mean);
      EXPECT_LT(own.sigma, 1e-5 * own.mean) << "side " << side.index();
    }
  }
  EXPECT_GT(lit, 10u);
}

TEST(Portals, an_obstructed_window_is_unbiased_with_every_option) {
  auto builder = truth::window_room();
  // A panel before the window outside, and a table inside.
  builder.material("panel", 0.5f, 0.0f)
      .quad({0.6f, -0.3f, 0.4f}, {1.0f, -0.3f, 0.4f}, {1.0f, -0.3f, 1.2f}, {0.6f, -0.3f, 1.2f})
      .quad({0.5f, 0.4f, 0.6f}, {1.5f, 0.4f, 0.6f}, {1.5f, 1.2f, 0.6f}, {0.5f, 1.2f, 0.6f});
  const Room room(truth::under_sky(builder), truth::window_portals());
  expect_unbiased(room, {.replicates = replicates}, "by default");
  expect_unbiased(room, {.replicates = replicates, .low_discrepancy = false}, "random numbers");
  expect_unbiased(room, {.replicates = replicates, .importance = false}, "by area");
  expect_unbiased(room, {.replicates = replicates, .control_variate = false}, "no control variate");
  expect_unbiased(room, {.replicates = replicates, .multiple_importance = true}, "multiple importance");
}

// Random triangles anywhere, some lit both ways; the window twice over, one behind the other, and turned
// round; one without area.
std::vector<Portal> bogus_portals(std::size_t count) {
  std::vector<Portal> portals;
  for (std::uint32_t i = 0; i < count; ++i) {
    Portal portal;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto u = uniform4(stream_key(5, 0, i), k);
      portal.corner[k] = {2.6f * u[0] - 0.3f, 2.6f * u[1] - 0.3f, 2.0f * u[2] - 0.2f};
    }
    portal.both_ways = i % 2 == 0;
    portals.push_back(portal);
  }
  for (const auto& more :
       {truth::window_portals(), truth::window_portals(), truth::window_portals(0.1f, true)})
    portals.insert(portals.end(), more.begin(), more.end());
  portals.push_back({{Vec3(0.0f), Vec3(1.0f), Vec3(2.0f)}, true});
  return portals;
}

TEST(Portals, any_set_of_portals_changes_no_mean) {
  const auto scene = truth::under_sky(truth::window_room());
  expect_unbiased(Room(scene, bogus_portals(7)), {.replicates = replicates}, "few");
  // More than stand alone: chosen by the tree. Few samples find the window behind the others.
  expect_unbiased(Room(scene, bogus_portals(40)), {.replicates = replicates}, "many", 512);
  expect_unbiased(Room(scene, bogus_portals(7)), {.replicates = replicates, .multiple_importance = true},
                  "multiple importance");
}

TEST(Portals, without_a_sky_do_nothing) {
  auto builder = truth::window_room();
  builder.material("lamp", 0.0f, 3.0f)
      .quad({0.5f, 1, 1.4f}, {0.5f, 1.5f, 1.4f}, {1, 1.5f, 1.4f}, {1, 1, 1.4f});
  const Room without(builder.scene());
  const Room with(builder.scene(), truth::window_portals());
  EXPECT_EQ(Lamps(with.patches).size(), Lamps(without.patches).size());
}

// ---- Whole solves ----

struct Run {
  Solution solution;
  std::vector<std::shared_ptr<const SampleState>> states;
};

Run solve(const Room& room, const SampledOptions& options, int threads = 2,
          std::shared_ptr<const SampleState> from = nullptr) {
  Run run;
  const SolveHooks keeping{std::move(from), [&](auto state) { run.states.push_back(std::move(state)); }};
  solve_sampled(room.patches, room.tracer, run.solution, options, keeping, Context(threads));
  return run;
}

TEST(Portals, a_solve_with_them_has_the_light_of_one_without) {
  const auto scene = truth::under_sky(truth::window_room());
  const Room without(scene, {}, 0.2f);
  const Room with(scene, truth::window_portals(), 0.2f);
  for (const auto* material : {"floor", "walls", "front"}) {
    std::vector<double> a, b;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const SampledOptions options = {.error = 0.0, .rays = 60'000, .seed = seed};
      const auto mean = [&](const Room& room) {
        return truth::mean_irradiance(room.patches, solve(room, options).solution.irradiance.front, material);
      };
      a.push_back(mean(without));
      b.push_back(mean(with));
    }
    const auto own = estimate_of(b), other = estimate_of(a);
    // Eight seeds each: Student's t of 14 degrees of freedom, risk 1e-4.
    EXPECT_NEAR(own.mean, other.mean, 5.4 * std::hypot(own.sigma, other.sigma) + 1e-3 * other.mean)
        << material;
  }
}

TEST(Portals, the_sky_is_relit_with_its_light_through_portals) {
  auto builder = truth::window_room();
  builder.material("lamp", 0.0f, 1.0f)
      .quad({0.5f, 1, 1.4f}, {0.5f, 1.5f, 1.4f}, {1, 1.5f, 1.4f}, {1, 1, 1.4f});
  const auto scene = truth::under_sky(builder);
  Room room(scene, truth::window_portals(), 0.2f);
  set_light_groups(scene, {}, room.patches);
  ASSERT_EQ(room.patches.light_groups.back(), sky_group);
  const SampledOptions options = {.error = 0.02, .error_measure = ErrorMeasure::power, .rays = 200'000};
  const auto run = solve(room, options);
  const Context context(2);
  Relighter relighter(room.patches, room.tracer, run.states.back(), options, context);
  const auto light_of = [&](float lamp, float sky) {
    relighter.set_lamps({lamp, lamp, lamp, sky, sky, sky});
    return truth::mean_irradiance(room.patches, relighter.light().irradiance.front, "floor");
  };
  const auto both = light_of(1.0f, 1.0f), lamp = light_of(1.0f, 0.0f), sky = light_of(0.0f, 1.0f);
  EXPECT_NEAR(both, lamp + sky, 1e-4 * both);
  EXPECT_NEAR(light_of(0.0f, 3.0f), 3.0 * sky, 1e-4 * sky);
  // The lamp alone lights the floor as where there is no sky at all.
  const Room dark(builder.scene(), {}, 0.2f);
  const auto alone =
      truth::mean_irradiance(dark.patches, solve(dark, options).solution.irradiance.front, "floor");
  EXPECT_NEAR(lamp, alone, 0.02 * alone);
}

TEST(Portals, threads_streams_and_resumed_files_give_the_same_bytes) {
  const Room room(truth::under_sky(truth::window_room()), truth::window_portals(), 0.12f);
  const SampledOptions options = {.error = 0.0, .error_measure = ErrorMeasure::power, .rays = 3'000'000};
  const auto whole = solve(room, options);
  ASSERT_GE(whole.states.size(), 2u);
  EXPECT_EQ(sample::difference(whole.solution, solve(room, options, 1).solution), "");
  auto streamed = options;
  streamed.memory = 1;
  EXPECT_EQ(sample::difference(whole.solution, solve(room, streamed, 3).solution), "");
  const auto path = std::filesystem::path(testing::TempDir()) / "luxel_portals.vtkhdf";
  write_solution(path, room.patches, whole.solution, whole.states[0].get());
  const auto kept = read_stored_run(path);
  EXPECT_EQ(kept.baked.patches.portals, room.patches.portals);
  Room again(truth::under_sky(truth::window_room()), kept.baked.patches.portals, 0.12f);
  EXPECT_EQ(sample::difference(whole.solution, solve(again, options, 2, kept.samples).solution), "");
}

}  // namespace
}  // namespace luxel
