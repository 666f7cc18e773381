// SPDX-License-Identifier: Apache-2.0
// Lamps and colours changed after the solve: the same as a fresh solve of the changed scene, within errors
// that are still right. Rooms whose light is known patch by patch; means over eight seeds, of which seven
// standard errors are allowed (risk 2e-4 each).
#include "luxel/solve/relight.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/patch/light_groups.h"
#include "luxel/patch/make_patches.h"

#include "support/error_bars.h"
#include "support/known_rooms.h"
#include "support/sample_solution.h"
#include "support/stored_run.h"
#include "support/truth_scenes.h"

namespace luxel {
namespace {

constexpr std::size_t seeds = 8;

// Each lamp's material a group of its own.
void group_by_material(PatchSet& patches) {
  for (auto& material : patches.materials)
    if (material.is_lamp()) {
      material.light_group = static_cast<std::uint32_t>(patches.light_groups.size());
      patches.light_groups.push_back(material.name);
    }
}

// The largest difference over the largest number.
double difference(const std::vector<float>& a, const std::vector<float>& b) {
  double most = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
    largest = std::max(largest, std::abs(static_cast<double>(a[i])));
  }
  return most / largest;
}

TEST(Relight, with_nothing_changed_is_the_light_of_the_run) {
  auto patches = make_patches(truth::l_room(), {.max_edge = 0.12f});
  group_by_material(patches);
  const Context context;
  const Tracer tracer(patches, context);
  const auto kept =
      truth::stored_run(patches, tracer, {.error = 0.02, .error_measure = ErrorMeasure::power}, context);
  const Relighter relighter(patches, tracer, kept.state,
                            {.error = 0.02, .error_measure = ErrorMeasure::power}, context);
  const auto again = relighter.light();
  // The two iterations have different starts and end within 1e-6 of the whole each.
  EXPECT_LT(difference(kept.solution.irradiance.front, again.irradiance.front), 1e-4);
  EXPECT_LT(difference(kept.solution.radiosity.front, again.radiosity.front), 1e-4);
  EXPECT_NEAR(again.predicted_error, kept.solution.predicted_error, 0.02 * kept.solution.predicted_error);
  EXPECT_EQ(again.provenance.scene_fingerprint, patches.scene_fingerprint);
}

TEST(Relight, is_linear_in_the_lamps) {
  const auto room = truth::coloured_room();
  auto patches = room.patches;
  group_by_material(patches);
  ASSERT_EQ(patches.light_groups.size(), 2u);
  const Context context;
  const Tracer tracer(patches, context);
  const auto kept =
      truth::stored_run(patches, tracer, {.error = 0.02, .error_measure = ErrorMeasure::power}, context);
  Relighter relighter(patches, tracer, kept.state, {.error = 0.02, .error_measure = ErrorMeasure::power},
                      context);
  const auto lit = [&](std::vector<float> weight) {
    relighter.set_lamps(std::move(weight));
    return relighter.light().irradiance.front;
  };
  const auto first = lit({1, 1, 1, 0, 0, 0});
  const auto second = lit({0, 0, 0, 1, 1, 1});
  auto sum = lit({2, 2, 2, 0.5f, 0.5f, 0.5f});
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] -= 2.0f * first[i] + 0.5f * second[i];
  for (std::size_t i = 0; i < sum.size(); ++i) EXPECT_NEAR(sum[i], 0.0, 1e-5) << i;
  EXPECT_EQ(lit({0, 0, 0, 0, 0, 0}), std::vector<float>(sum.size(), 0.0f));
}

TEST(Relight, lamps_and_reflectances_give_the_light_of_the_changed_room_with_honest_errors) {
  auto before = truth::coloured_room();
  group_by_material(before.patches);
  const auto bands = before.patches.band_count();

  // The changed room: one lamp dimmed and tinted, and every wall of another colour.
  const std::vector<float> weight = {0.3f, 0.2f, 0.1f, 1.0f, 2.0f, 1.0f};
  std::vector<float> reflectance;
  for (std::size_t m = 0; m < before.patches.materials.size(); ++m)
    for (std::size_t b = 0; b < bands; ++b)
      reflectance.push_back(0.2f + 0.1f * static_cast<float>((m + 2 * b) % 6));
  auto after = before;
  for (std::size_t m = 0; m < after.patches.materials.size(); ++m)
    for (std::size_t b = 0; b < bands; ++b) {
      auto& material = after.patches.materials[m];
      material.reflectance[b] = reflectance[m * bands + b];
      material.emittance[b] *= weight[material.light_group * bands + b];
    }
  const Context context;
  after.truth = truth::true_light(after.patches, truth::form_factors(after.patches, {}, context));

  const Tracer tracer(before.patches, context);
  std::vector<Solution> runs;
  for (std::size_t s = 0; s < seeds; ++s) {
    const SampledOptions options = {.error = 0.02, .error_measure = ErrorMeasure::power, .seed = s + 1};
    const auto kept = truth::stored_run(before.patches, tracer, options, context);
    Relighter relighter(before.patches, tracer, kept.state, options, context);
    relighter.set_lamps(weight);
    relighter.set_reflectance(reflectance);
    runs.push_back(relighter.light());
    // Nothing else of the patches has changed, so the result is that of the new room.
    for (std::size_t m = 0; m < after.patches.materials.size(); ++m)
      EXPECT_EQ(relighter.patches().materials[m].emittance, after.patches.materials[m].emittance);
  }
  const auto verdict = truth::judge(after, runs);
  EXPECT_NEAR(verdict.bias.value, 0.0, 7.0 * verdict.bias.standard_error);
  EXPECT_GT(verdict.coverage.value, 0.92 - 3.0 * verdict.coverage.standard_error);
  EXPECT_NEAR(verdict.ratio.value, 1.0, 0.1 + 3.0 * verdict.ratio.standard_error);
}

TEST(Relight, the_sky_is_a_group_of_its_own) {
  truth::SceneBuilder builder;
  builder.material("floor", 0.5f, 0.0f).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  builder.material("lamp", 0.0f, 2.0f).quad({0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1});
  auto scene = builder.scene();
  scene.sky = Vec3(0.5f);
  auto patches = make_patches(scene, {.max_edge = 0.25f});
  set_light_groups(scene, {}, patches);
  ASSERT_EQ(patches.light_groups, (std::vector<std::string>{"lamp", "sky"}));
  const Context context;
  const Tracer tracer(patches, context);
  const auto kept =
      truth::stored_run(patches, tracer, {.error = 0.01, .error_measure = ErrorMeasure::power}, context);
  Relighter relighter(patches, tracer, kept.state, {.error = 0.01, .error_measure = ErrorMeasure::power},
                      context);

  const auto expect_fresh = [&](const std::vector<float>& weight) {
    auto changed = scene;
    changed.materials[1].emittance *= weight[0];
    changed.sky *= weight[3];
    const auto fresh_patches = make_patches(changed, {.max_edge = 0.25f});
    const auto fresh = truth::stored_run(fresh_patches, tracer,
                                         {.error = 0.01, .error_measure = ErrorMeasure::power}, context);
    relighter.set_lamps(weight);
    const auto relit = relighter.light();
    // The same seed, so the same rays: only the lamps' choice of samples could differ.
    EXPECT_LT(difference(fresh.solution.irradiance.front, relit.irradiance.front), 0.02);
    EXPECT_EQ(relighter.patches().has_sky(), fresh_patches.has_sky());
    EXPECT_EQ(relighter.patches().sky_radiosity(0, 1), fresh_patches.sky_radiosity(0, 1));
  };
  expect_fresh({1, 1, 1, 0, 0, 0});
  expect_fresh({0.25f, 0.25f, 0.25f, 3, 3, 3});
}

TEST(Relight, same_bytes_for_any_number_of_threads) {
  auto patches = make_patches(truth::l_room(), {.max_edge = 0.12f});
  group_by_material(patches);
  const auto relit = [&](int threads) {
    const Context context(threads);
    const Tracer tracer(patches, context);
    const auto kept =
        truth::stored_run(patches, tracer, {.error = 0.02, .error_measure = ErrorMeasure::power}, context);
    Relighter relighter(patches, tracer, kept.state, {.error = 0.02, .error_measure = ErrorMeasure::power},
                        context);
    relighter.set_lamps({0.5f, 0.6f, 0.7f});
    auto lamps = relighter.light();
    relighter.set_reflectance(std::vector(3 * patches.materials.size(), 0.25f));
    return std::pair(lamps, relighter.light());
  };
  const auto one = relit(1);
  for (const int threads : {2, 5}) {
    const auto many = relit(threads);
    EXPECT_EQ(sample::difference(one.first, many.first), "");
    EXPECT_EQ(sample::difference(one.second, many.second), "");
  }
}

TEST(Relight, numbers_that_cannot_be_are_refused) {
  auto patches = make_patches(truth::cube_a(), {.max_edge = 0.5f});
  const Context context;
  const Tracer tracer(patches, context);
  const auto kept =
      truth::stored_run(patches, tracer, {.error = 0.1, .error_measure = ErrorMeasure::power}, context);
  Relighter relighter(patches, tracer, kept.state, {.error = 0.1, .error_measure = ErrorMeasure::power},
                      context);
  EXPECT_THROW(relighter.set_lamps({1.0f}), InputError);
  EXPECT_THROW(relighter.set_lamps({1.0f, -1.0f, 1.0f}), InputError);
  EXPECT_THROW(relighter.set_reflectance({0.5f}), InputError);
  EXPECT_THROW(relighter.set_reflectance(std::vector(3 * patches.materials.size(), 1.0f)), InputError);
}

// ---- Which lamp is in which group ----

TEST(LightGroups, go_by_material_unless_a_rule_says_otherwise) {
  truth::SceneBuilder builder;
  builder.material("floor", 0.5f, 0.0f).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  builder.material("desk_a", 0.0f, 1.0f).triangle({0, 0, 1}, {0, 1, 1}, {1, 1, 1});
  builder.material("desk_b", 0.0f, 1.0f).triangle({0, 0, 2}, {0, 1, 2}, {1, 1, 2});
  builder.material("spot", 0.0f, 1.0f)
      .triangle({0, 0, 3}, {0, 1, 3}, {1, 1, 3})
      .triangle({0, 0, 4}, {0, 1, 4}, {1, 1, 4});
  auto scene = builder.scene();
  scene.objects = {"room", "left spot"};
  scene.triangle_object.assign(scene.triangles.size(), 0);
  scene.triangle_object.back() = 1;
  auto patches = make_patches(scene, {.max_edge = 0.0f});
  const auto group_of = [&](std::size_t triangle) {
    for (std::size_t p = 0; p < patches.size(); ++p)
      if (patches.triangle[p] == triangle) return patches.light_groups[patches.material_of(p).light_group];
    return std::string("none");
  };

  set_light_groups(scene, {}, patches);
  EXPECT_EQ(patches.light_groups, (std::vector<std::string>{"desk_a", "desk_b", "spot"}));
  EXPECT_EQ(patches.materials.size(), scene.materials.size());

  const LightGroupRule rules[] = {{"desks", "desk_?"}, {"left", "left*"}};
  set_light_groups(scene, rules, patches);
  EXPECT_EQ(patches.light_groups, (std::vector<std::string>{"desks", "spot", "left"}));
  EXPECT_EQ(group_of(2), "desks");
  EXPECT_EQ(group_of(3), "desks");
  EXPECT_EQ(group_of(4), "spot");
  EXPECT_EQ(group_of(5), "left");
  EXPECT_EQ(patches.materials.back().name, "spot") << "one material in two groups is two of one name";

  const LightGroupRule wrong[] = {{"a", "no such lamp"}};
  EXPECT_THROW(set_light_groups(scene, wrong, patches), InputError);
}

}  // namespace
}  // namespace luxel
