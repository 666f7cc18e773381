// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/trial_cuts.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include <gtest/gtest.h>

#include "luxel/core/barycentric.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/refine_patches.h"
#include "luxel/trace/tracer.h"

#include "support/known_rooms.h"
#include "support/truth_scenes.h"

namespace luxel {
namespace {

constexpr double rough = 0.02;  // error of the answers
const Vec3 below_plate(0.3f, -0.2f, 0.0f);

// A floor of 2 m below a lamp as large; a plate of 8 cm, 2 cm above the floor if there is one.
PatchSet floor_below_plate(bool has_plate) {
  truth::SceneBuilder b;
  b.material("floor", 0.5f, 0.0f).quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
  b.material("lamp", 0.0f, 10.0f).quad({-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {1, -1, 1});
  const float h = 0.04f;
  const auto plate = below_plate + Vec3(0.0f, 0.0f, 0.02f);
  if (has_plate)
    b.material("plate", 0.0f, 0.0f)
        .quad(plate + Vec3(-h, -h, 0), plate + Vec3(h, -h, 0), plate + Vec3(h, h, 0), plate + Vec3(-h, h, 0));
  return make_patches(b.scene(), {.max_edge = 0.4f, .contacts = false});
}

// Two rough answers.
Answers answers_for(const PatchSet& patches, const Tracer& tracer, std::uint64_t seed,
                    const Context& context) {
  Answers answers;
  for (std::uint32_t i = 0; i < answers.size(); ++i) {
    auto& [solution, smooth] = answers[i];
    solve_sampled(patches, tracer, solution,
                  {.error = rough, .error_measure = ErrorMeasure::power, .seed = 100 * seed + i}, context);
    smooth = make_smooth_light(patches, solution, {}, context);
  }
  return answers;
}

struct Tried {
  std::vector<double> squared;
  std::uint64_t rays = 0;
};

Tried try_all(const PatchSet& patches, double max_rays, std::uint64_t seed, const Context& context) {
  const Tracer tracer(patches, context);
  const auto answers = answers_for(patches, tracer, seed, context);
  TrialCuts trial(patches.size(), {});
  const auto rays = trial.try_out(patches, answers, max_rays, {.seed = seed}, context);
  return {{trial.squared().begin(), trial.squared().end()}, rays.value_or(0)};
}

bool holds(const PatchSet& patches, std::size_t patch, const Vec3& place) {
  if (patches.material_of(patch).name != "floor") return false;
  const auto w = barycentric(patches.points(patch), Vec3d(place));
  return w.x >= 0.0 && w.y >= 0.0 && w.z >= 0.0;
}

TEST(TrialCuts, a_shadow_smaller_than_its_patch_is_found) {
  const Context context(2);
  const auto patches = floor_below_plate(true);
  constexpr double allowed = 4e5;
  const auto tried = try_all(patches, allowed, 1, context);
  EXPECT_GT(tried.rays, 0u);
  EXPECT_LT(static_cast<double>(tried.rays), 5.0 * allowed);
  const auto largest = *std::max_element(tried.squared.begin(), tried.squared.end());
  std::size_t shadowed = 0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    if (!holds(patches, p, below_plate)) continue;
    ++shadowed;
    EXPECT_GT(tried.squared[p], 0.0);
    EXPECT_EQ(tried.squared[p], largest);
  }
  EXPECT_EQ(shadowed, 1u);
  for (const auto other : try_all(floor_below_plate(false), allowed, 1, context).squared)
    EXPECT_LT(other, 0.1 * largest);
}

// Light is 1 everywhere, so that all that is found is noise of the answers: the product of two, whose sum is
// 0 in the mean, above 0 where it is found, and less than the square of either.
TEST(TrialCuts, in_a_furnace_they_find_less_than_the_noise_of_the_answers) {
  const Context context(2);
  const auto room = truth::mixed_furnace();
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto found = try_all(room.patches, 4e6, seed, context).squared;
    EXPECT_LT(std::accumulate(found.begin(), found.end(), 0.0), rough * rough);
  }
}

TEST(TrialCuts, patches_are_tried_once_and_parts_after_their_whole) {
  const Context context(2);
  const auto patches = floor_below_plate(true);
  const Tracer tracer(patches, context);
  const auto answers = answers_for(patches, tracer, 1, context);
  TrialCuts trial(patches.size(), {});
  constexpr double allowed = 4e5;
  ASSERT_GT(trial.try_out(patches, answers, allowed, {}, context).value_or(0), 0u);
  const std::vector<double> before(trial.squared().begin(), trial.squared().end());
  EXPECT_EQ(trial.try_out(patches, answers, allowed, {}, context), std::uint64_t{0});
  EXPECT_TRUE(std::equal(before.begin(), before.end(), trial.squared().begin(), trial.squared().end()));

  std::vector<std::uint8_t> marks(patches.size());
  for (std::size_t p = 0; p < marks.size(); ++p) marks[p] = before[p] > 0.0 ? 1 : 0;
  const auto refined = refine_patches(patches, marks, context);
  ASSERT_GT(refined.patches.size(), patches.size());
  trial.note_cut(refined.parent);
  ASSERT_EQ(trial.squared().size(), refined.patches.size());
  for (std::size_t p = 0; p < refined.parent.size(); ++p)
    EXPECT_EQ(trial.squared()[p], is_part(refined.parent, p) ? 0.0 : before[refined.parent[p]]);
  const Tracer through(refined.patches, context);
  const auto finer = answers_for(refined.patches, through, 2, context);
  EXPECT_GT(trial.try_out(refined.patches, finer, allowed, {}, context).value_or(0), 0u);
}

TEST(TrialCuts, a_monitor_stops_them) {
  const Context context(2);
  const auto patches = floor_below_plate(true);
  const Tracer tracer(patches, context);
  const auto answers = answers_for(patches, tracer, 1, context);
  TrialCuts trial(patches.size(), std::vector<double>(patches.size(), 1.0));
  const auto stopping = context.with_monitor([](const Progress&) { return Next::stop; });
  EXPECT_EQ(trial.try_out(patches, answers, 4e5, {}, stopping), std::nullopt);
}

}  // namespace
}  // namespace luxel
