// SPDX-License-Identifier: Apache-2.0
// Statistical limits are at a risk of one in a million each.
#include "luxel/surface/smoothing.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "luxel/core/address.h"
#include "luxel/patch/make_patches.h"
#include "luxel/solve/replicate_spread.h"

#include "support/chi_square.h"
#include "support/thread_ranks.h"
#include "support/truth_scenes.h"

namespace luxel {
namespace {

constexpr std::size_t bands = 3;

// One-sided squares of 4 x 4 m, 1024 patches each.
struct Floor {
  PatchSet patches;
  Context context;
  PatchTree tree;
  GatherSides sides;
  std::vector<float> area;  // [receiver]

  explicit Floor(int threads = 2, bool two_sided = false, float max_edge = 0.2f)
      : patches(make_patches(truth::SceneBuilder()
                                 .material("floor", 0.5f, 1.0f, two_sided)
                                 .quad({0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0})
                                 .scene(),
                             {.max_edge = max_edge})),
        context(threads),
        tree(make_patch_tree(patches, context)),
        sides(all_gather_sides(patches, tree)) {
    for (const auto s : sides.side) area.push_back(patches.area[s.patch()]);
  }
  Vec3 centroid(std::size_t receiver) const {
    const auto [a, b, c] = patches.points(sides.side[receiver].patch());
    return (a + b + c) / 3.0f;
  }
};

using Field = std::function<float(const Vec3&)>;

float linear(const Vec3& p) { return 1.0f + 0.2f * p.x - 0.1f * p.y; }

// The field with uniform noise of standard deviation sigma.
std::vector<std::vector<float>> noisy(const Floor& f, const Field& field, float sigma, std::uint64_t seed,
                                      std::size_t replicates = 8) {
  std::vector<std::vector<float>> values(replicates, std::vector<float>(f.sides.size() * bands));
  for (std::uint32_t r = 0; r < replicates; ++r)
    for (std::size_t s = 0; s < f.sides.size(); ++s) {
      const auto u = uniform4({seed, r, static_cast<std::uint32_t>(s), 0});
      for (std::size_t b = 0; b < bands; ++b)
        values[r][s * bands + b] = field(f.centroid(s)) + sigma * std::sqrt(12.0f) * (u[b] - 0.5f);
    }
  return values;
}

struct Smooth {
  std::vector<std::vector<float>> values;
  std::vector<float> bias;
};
// The values as gathered light; there is no direct light.
Smooth smooth(const Floor& f, std::vector<std::vector<float>> values) {
  std::vector<float> bias(values[0].size(), 0.0f);
  std::vector<std::vector<float>> direct(values.size(), std::vector<float>(values[0].size(), 0.0f));
  Smoothing(f.patches, f.tree, f.sides).smooth(direct, values, bias, f.context, {{}, f.sides.size(), 1});
  return {std::move(values), std::move(bias)};
}

// Sum of area times squared error of the mean, all bands.
double true_squared_error(const Floor& f, const std::vector<std::vector<float>>& values, const Field& field) {
  double sum = 0.0;
  for (std::size_t i = 0; i < values[0].size(); ++i) {
    double mean = 0.0;
    for (const auto& v : values) mean += static_cast<double>(v[i]) / static_cast<double>(values.size());
    const auto wrong = mean - static_cast<double>(field(f.centroid(i / bands)));
    sum += static_cast<double>(f.area[i / bands]) * wrong * wrong;
  }
  return sum;
}

// A field that one fit to the whole floor can represent: its number of coefficients per band, each with the
// variance of a mean over 8 replicates. So the error is that of as many patches.
void expect_noise_of(double numbers, const Field& field) {
  const Floor f;
  constexpr int runs = 200;
  constexpr float sigma = 0.5f;
  double total_squared_error = 0.0;
  double spread = 0.0;
  double bias = 0.0;
  for (int run = 0; run < runs; ++run) {
    const auto smoothed = smooth(f, noisy(f, field, sigma, static_cast<std::uint64_t>(run)));
    total_squared_error += true_squared_error(f, smoothed.values, field);
    const std::vector<float> none(smoothed.bias.size(), 0.0f);
    spread += spread_of(smoothed.values, {none, bands, f.area}, f.context).total_squared_error;
    for (std::size_t i = 0; i < smoothed.bias.size(); ++i)
      bias += static_cast<double>(f.area[i / bands] * smoothed.bias[i]);
  }
  const auto expected = runs * static_cast<double>(sigma * sigma) / 8.0 * 16.0 * bands * numbers /
                        static_cast<double>(f.sides.size());
  // The fractions that windows move by are estimates: a fit that knew the field would have half the error.
  const auto degrees_of_freedom = bands * numbers * runs;
  EXPECT_GT(total_squared_error / expected,
            statistics::chi_square_lower_limit(degrees_of_freedom) / degrees_of_freedom);
  EXPECT_LT(total_squared_error / expected,
            2.0 * statistics::chi_square_limit(degrees_of_freedom) / degrees_of_freedom);
  // The spread has seven times the degrees of freedom of the error: what their ratio varies by.
  EXPECT_NEAR(spread / total_squared_error, 1.0, 5.0 * std::sqrt(2.0 / degrees_of_freedom * 8.0 / 7.0));
  // There is no bias; the stated bias is noise and the effect of choosing among fits.
  EXPECT_NEAR(bias / total_squared_error, 0.0, 0.3);
}

TEST(Smoothing, leaves_of_noise_about_a_plane_twice_what_three_numbers_carry_at_most) {
  expect_noise_of(3.0, linear);
}

TEST(Smoothing, leaves_of_noise_about_a_bowl_twice_what_six_numbers_carry_at_most) {
  expect_noise_of(
      6.0, [](const Vec3& p) { return linear(p) + 0.4f * p.x * p.x - 0.3f * p.x * p.y + 0.5f * p.y * p.y; });
}

TEST(Smoothing, leaves_a_step_where_it_is) {
  const Floor f;
  const Field step = [](const Vec3& p) { return p.x < 1.7f ? 1.0f : 3.0f; };
  constexpr float sigma = 0.1f;
  const auto smoothed = smooth(f, noisy(f, step, sigma, 1));
  const auto spread = spread_of(smoothed.values, {smoothed.bias, bands, f.area}, f.context);
  // Six standard errors of a patch's own mean; risk: 3072 times two in a thousand million.
  for (std::size_t i = 0; i < spread.mean.size(); ++i)
    ASSERT_NEAR(spread.mean[i], step(f.centroid(i / bands)), 6.0f * sigma / std::sqrt(8.0f));
  EXPECT_LT(true_squared_error(f, smoothed.values, step),
            0.5 * true_squared_error(f, noisy(f, step, sigma, 1), step));
}

// With light that bends so little that its noise hides it: over many runs the stated bias is the true one.
TEST(Smoothing, counts_the_bias_of_light_that_is_almost_a_plane) {
  const Floor f;
  const Field bent = [](const Vec3& p) { return 2.0f + 0.05f * p.x * p.x * p.x * p.x; };
  double total_squared_error = 0.0;
  double variance = 0.0;
  double bias = 0.0;
  for (std::uint64_t run = 0; run < 200; ++run) {
    const auto smoothed = smooth(f, noisy(f, bent, 0.5f, run));
    total_squared_error += true_squared_error(f, smoothed.values, bent);
    const std::vector<float> none(smoothed.bias.size(), 0.0f);
    variance += spread_of(smoothed.values, {none, bands, f.area}, f.context).total_squared_error;
    for (std::size_t i = 0; i < smoothed.bias.size(); ++i)
      bias += static_cast<double>(f.area[i / bands] * smoothed.bias[i]);
  }
  EXPECT_GT(total_squared_error, 1.1 * variance);
  EXPECT_NEAR((variance + bias) / total_squared_error, 1.0, 0.2);
}

TEST(Smoothing, does_not_touch_what_has_no_noise) {
  const Floor f;
  for (const Field& field : {Field(linear), Field([](const Vec3& p) { return 1.0f + p.x * p.y; })}) {
    const auto exact = noisy(f, field, 0.0f, 1);
    const auto smoothed = smooth(f, exact);
    EXPECT_EQ(smoothed.values, exact);
    EXPECT_EQ(smoothed.bias, std::vector<float>(exact[0].size(), 0.0f));
  }
}

TEST(Smoothing, gives_the_same_bits_on_any_number_of_threads) {
  const Floor one(1, true);
  const auto expected = smooth(one, noisy(one, linear, 0.5f, 1, 5));
  for (const int threads : {2, 5}) {
    const Floor f(threads, true);
    const auto smoothed = smooth(f, noisy(f, linear, 0.5f, 1, 5));
    EXPECT_EQ(smoothed.values, expected.values);
    EXPECT_EQ(smoothed.bias, expected.bias);
  }
}

// A region of several tasks, and fits that reach over the receivers of two ranks.
TEST(Smoothing, ranks_get_for_their_receivers_the_bits_of_one) {
  const Floor f(1, true, 0.05f);
  ASSERT_GT(f.sides.fronts, 16'000u);
  const auto field = [](const Vec3& p) { return p.x < 1.5f ? linear(p) : 2.0f + std::sin(6.0f * p.y); };
  const auto noise = noisy(f, field, 0.05f, 5);
  const auto alone = smooth(f, noise);
  ASSERT_NE(alone.values, noise);
  for (const std::size_t count : {2u, 5u})
    ThreadRanks::run(count, [&](const Ranks& ranks) {
      const Context context({.threads = 1, .ranks = &ranks});
      auto values = noise;
      std::vector<std::vector<float>> direct(values.size(), std::vector<float>(values[0].size(), 0.0f));
      std::vector<float> own_bias(alone.bias.size(), 0.0f);
      const auto mine = spread_partition(SharedWork(context), f.sides.size());
      Smoothing(f.patches, f.tree, f.sides).smooth(direct, values, own_bias, context, mine);
      const auto is_same = [&](const std::vector<float>& a, const std::vector<float>& b) {
        const auto at = [&](std::size_t receiver) { return static_cast<std::ptrdiff_t>(receiver * bands); };
        return std::equal(a.begin() + at(mine.begin()), a.begin() + at(mine.end()),
                          b.begin() + at(mine.begin()));
      };
      for (std::size_t r = 0; r < values.size(); ++r) EXPECT_TRUE(is_same(values[r], alone.values[r])) << r;
      EXPECT_TRUE(is_same(own_bias, alone.bias));
    });
}

TEST(Smoothing, does_with_one_band_what_it_does_with_three_alike) {
  const Floor three;
  Floor one;
  one.patches.bands = {"grey"};
  for (auto& m : one.patches.materials) m.reflectance = m.emittance = {0.5f};
  auto of_three = noisy(three, linear, 0.5f, 1);
  std::vector<std::vector<float>> of_one;
  for (auto& v : of_three) {
    of_one.emplace_back();
    for (std::size_t s = 0; s < three.sides.size(); ++s) {
      of_one.back().push_back(v[3 * s]);
      v[3 * s + 1] = v[3 * s + 2] = v[3 * s];
    }
  }
  const auto expected = smooth(three, of_three);
  const auto smoothed = smooth(one, of_one);
  for (std::size_t r = 0; r < of_one.size(); ++r)
    for (std::size_t s = 0; s < three.sides.size(); ++s)
      ASSERT_NEAR(smoothed.values[r][s], expected.values[r][3 * s], 1e-4f);
}

// The area-weighted mean over the floor in each replicate is preserved by smoothing.
TEST(Smoothing, keeps_the_mean_over_a_surface) {
  const Floor f;
  const auto given = noisy(
      f, [](const Vec3& p) { return p.x < 1.7f ? 1.0f : 3.0f; }, 0.3f, 1);
  const auto smoothed = smooth(f, given);
  ASSERT_NE(smoothed.values, given);
  for (std::size_t r = 0; r < given.size(); ++r) {
    double before = 0.0;
    double after = 0.0;
    double areas = 0.0;
    for (std::size_t s = 0; s < f.sides.size(); ++s) {
      before += static_cast<double>(f.area[s] * given[r][s * bands]);
      after += static_cast<double>(f.area[s] * smoothed.values[r][s * bands]);
      areas += static_cast<double>(f.area[s]);
    }
    EXPECT_NEAR(after / areas, before / areas, 1e-5);
  }
}

// A closed tube of 24 faces, each of few patches: all of them are one surface.
TEST(Smoothing, goes_on_round_curved_surfaces) {
  truth::SceneBuilder builder;
  builder.material("tube", 0.5f, 1.0f, false);
  constexpr int faces = 24;
  for (int i = 0; i < faces; ++i) {
    const auto at = [&](int k, float z) {
      const auto angle = 2.0f * 3.14159265f * static_cast<float>(k % faces) / faces;
      return Vec3(std::cos(angle), std::sin(angle), z);
    };
    builder.quad(at(i, 0.0f), at(i + 1, 0.0f), at(i + 1, 4.0f), at(i, 4.0f));
  }
  const Context context(2);
  const auto patches = make_patches(builder.scene(), {.max_edge = 0.3f});
  const auto tree = make_patch_tree(patches, context);
  const auto sides = all_gather_sides(patches, tree);
  const auto sheets = make_light_sheets(patches, tree, sides);
  ASSERT_EQ(sheets.size(), 1u);
  ASSERT_FALSE(sheets[0].is_flat());
  std::vector<std::vector<float>> direct(8, std::vector<float>(sides.size() * bands, 0.0f));
  auto values = direct;
  const auto light = [&](std::size_t s) { return 2.0f + patches.normal[sides.side[s].patch()].x; };
  constexpr float sigma = 0.5f;
  for (std::uint32_t r = 0; r < values.size(); ++r)
    for (std::uint32_t s = 0; s < sides.size(); ++s)
      for (std::uint32_t b = 0; b < bands; ++b)
        values[r][s * bands + b] = light(s) + sigma * std::sqrt(12.0f) * (uniform4({1, r, s, b})[0] - 0.5f);
  std::vector<float> bias(sides.size() * bands, 0.0f);
  Smoothing(patches, tree, sides).smooth(direct, values, bias, context, {{}, sides.size(), 1});
  double total_squared_error = 0.0;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    double mean = 0.0;
    for (const auto& v : values) mean += static_cast<double>(v[s * bands]) / 8.0;
    total_squared_error += (mean - static_cast<double>(light(s))) * (mean - static_cast<double>(light(s)));
  }
  // A fifth of the variance that the patches' own rays have.
  EXPECT_LT(total_squared_error / static_cast<double>(sides.size()),
            0.2 * static_cast<double>(sigma * sigma) / 8.0);
}

}  // namespace
}  // namespace luxel
