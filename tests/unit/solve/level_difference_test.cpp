// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/level_difference.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/patch/refine_patches.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

constexpr int faces = 24;

// A round column of 24 flat faces.
PatchSet column() {
  truth::SceneBuilder b;
  b.material("column", 0.5f, 0.0f);
  const auto corner = [](int i, float z) {
    const auto angle = 2.0f * 3.14159265f * static_cast<float>(i) / faces;
    return Vec3(std::cos(angle), std::sin(angle), z);
  };
  for (int i = 0; i < faces; ++i)
    b.quad(corner(i, 0.0f), corner(i + 1, 0.0f), corner(i + 1, 1.0f), corner(i, 1.0f));
  return make_patches(b.scene(), {.max_edge = no_max_edge});
}

// Irradiance by a function of the patch, the same in both answers.
template <typename Light>
Answers answers_of(const PatchSet& patches, Light light) {
  Answers answers;
  for (auto& answer : answers) {
    auto& s = answer.solution;
    s.bands = patches.bands;
    s.irradiance.back.assign(patches.size() * patches.band_count(), 0.0f);
    for (std::size_t p = 0; p < patches.size(); ++p)
      s.irradiance.front.insert(s.irradiance.front.end(), patches.band_count(), light(p));
    s.provenance.scene_fingerprint = patches.scene_fingerprint;
    answer.smooth = make_smooth_light(patches, s);
  }
  return answers;
}

double sum_of(const FieldDifference& difference) {
  double sum = 0.0;
  for (const auto x : difference.squared.front) sum += x;
  return sum;
}

// Light from one side: each face has its own, and all of a face has the same.
float by_normal(const PatchSet& patches, std::size_t p) { return 1.0f + patches.normal[p].x; }
// As this, with the edge of a shadow half way up.
float with_shadow(const PatchSet& patches, std::size_t p) {
  return patches.centroid(p).z < 0.5f ? 0.2f : by_normal(patches, p);
}

RefinedPatches cut_all(const PatchSet& wholes) {
  return refine_patches(wholes, std::vector<std::uint8_t>(wholes.size(), 1));
}

TEST(LevelDifference, light_that_steps_from_face_to_face_of_a_curved_surface_asks_for_no_cuts) {
  const auto wholes = column();
  const auto parts = cut_all(wholes);
  const auto& fine = parts.patches;
  const auto coarse = answers_of(wholes, [&](std::size_t p) { return by_normal(wholes, p); });
  const auto steps = answers_of(fine, [&](std::size_t p) { return by_normal(fine, p); });
  EXPECT_NEAR(sum_of(residual_within_patches(fine, steps, {})), 0.0, 1e-9);
  EXPECT_NEAR(sum_of(difference_of_levels(wholes, coarse, fine, steps, parts.parent, {})), 0.0, 1e-9);
  EXPECT_NEAR(sum_of(variation_within_wholes(wholes, coarse, fine, steps, parts.parent, {})), 0.0, 1e-9);
}

TEST(LevelDifference, a_shadow_on_a_curved_surface_asks_for_cuts) {
  const auto wholes = column();
  const auto parts = cut_all(wholes);
  const auto& fine = parts.patches;
  const auto coarse = answers_of(wholes, [&](std::size_t p) { return 0.5f * (0.2f + by_normal(wholes, p)); });
  const auto shadowed = answers_of(fine, [&](std::size_t p) { return with_shadow(fine, p); });
  EXPECT_GT(sum_of(residual_within_patches(fine, shadowed, {})), 0.1);
  EXPECT_GT(sum_of(difference_of_levels(wholes, coarse, fine, shadowed, parts.parent, {})), 1.0);
  EXPECT_GT(sum_of(variation_within_wholes(wholes, coarse, fine, shadowed, parts.parent, {})), 0.1);
}

}  // namespace
}  // namespace luxel
