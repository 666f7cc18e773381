// SPDX-License-Identifier: Apache-2.0
// Statistical limits are at a risk of one in a million each.
#include "luxel/solve/share_light.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "luxel/patch/make_patches.h"
#include "luxel/random/address.h"
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
  Workers workers;
  PatchTree tree;
  GatherSides sides;
  std::vector<float> area;  // [slot]

  explicit Floor(int threads = 2, bool two_sided = false, float max_edge = 0.2f)
      : patches(make_patches(truth::SceneBuilder()
                                 .material("floor", 0.5f, 1.0f, two_sided)
                                 .quad({0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0})
                                 .scene(),
                             {.max_edge = max_edge})),
        workers(threads),
        tree(make_patch_tree(patches, workers)),
        sides(all_gather_sides(patches, tree)) {
    for (const auto s : sides.side) area.push_back(patches.area[s / 2]);
  }
  Vec3 centroid(std::size_t slot) const {
    const auto [a, b, c] = patches.points(sides.side[slot] / 2);
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

struct Shared {
  std::vector<std::vector<float>> values;
  std::vector<float> bias;
};
Shared share(const Floor& f, std::vector<std::vector<float>> values) {
  std::vector<float> bias(values[0].size(), 0.0f);
  share_light(f.patches, f.tree, f.sides, values, bias, f.workers);
  return {std::move(values), std::move(bias)};
}

// Sum of area times squared error of the mean, all bands.
double true_error2(const Floor& f, const std::vector<std::vector<float>>& values, const Field& field) {
  double sum = 0.0;
  for (std::size_t i = 0; i < values[0].size(); ++i) {
    double mean = 0.0;
    for (const auto& v : values) mean += static_cast<double>(v[i]) / static_cast<double>(values.size());
    const auto wrong = mean - static_cast<double>(field(f.centroid(i / bands)));
    sum += static_cast<double>(f.area[i / bands]) * wrong * wrong;
  }
  return sum;
}

// A field that one fit to the whole floor can be: so many numbers a band, each of the variance of a mean over
// 8 replicates. So the error is that of so many of the patches.
void expect_noise_of(double numbers, const Field& field) {
  const Floor f;
  constexpr int runs = 200;
  constexpr float sigma = 0.5f;
  double error2 = 0.0;
  double spread = 0.0;
  double bias = 0.0;
  for (int run = 0; run < runs; ++run) {
    const auto shared = share(f, noisy(f, field, sigma, static_cast<std::uint64_t>(run)));
    error2 += true_error2(f, shared.values, field);
    const std::vector<float> none(shared.bias.size(), 0.0f);
    spread += spread_of(shared.values, none, bands, f.area, f.workers).error2;
    for (std::size_t i = 0; i < shared.bias.size(); ++i)
      bias += static_cast<double>(f.area[i / bands] * shared.bias[i]);
  }
  const auto expected = runs * static_cast<double>(sigma * sigma) / 8.0 * 16.0 * bands * numbers /
                        static_cast<double>(f.sides.size());
  // Noise makes some finer fits look better: 1.25 is how much worse that may be on the average.
  const auto freedom = bands * numbers * runs;
  EXPECT_GT(error2 / expected, statistics::chi_square_lower_limit(freedom) / freedom);
  EXPECT_LT(error2 / expected, 1.25 * statistics::chi_square_limit(freedom) / freedom);
  // The spread has seven times the freedom of the error: what their ratio varies by.
  EXPECT_NEAR(spread / error2, 1.0, 5.0 * std::sqrt(2.0 / freedom * 8.0 / 7.0));
  // There is no bias to find; what was found is noise, and what the choice of fits makes of it.
  EXPECT_NEAR(bias / error2, 0.0, 0.3);
}

TEST(ShareLight, leaves_of_noise_about_a_plane_what_three_numbers_carry_and_says_so) {
  expect_noise_of(3.0, linear);
}

TEST(ShareLight, leaves_of_noise_about_a_bowl_what_six_numbers_carry_and_says_so) {
  expect_noise_of(
      6.0, [](const Vec3& p) { return linear(p) + 0.4f * p.x * p.x - 0.3f * p.x * p.y + 0.5f * p.y * p.y; });
}

TEST(ShareLight, leaves_a_step_where_it_is) {
  const Floor f;
  const Field step = [](const Vec3& p) { return p.x < 1.7f ? 1.0f : 3.0f; };
  constexpr float sigma = 0.1f;
  const auto shared = share(f, noisy(f, step, sigma, 1));
  const auto spread = spread_of(shared.values, shared.bias, bands, f.area, f.workers);
  // Six standard errors of a patch's own mean; risk: 3072 times two in a thousand million.
  for (std::size_t i = 0; i < spread.mean.size(); ++i)
    ASSERT_NEAR(spread.mean[i], step(f.centroid(i / bands)), 6.0f * sigma / std::sqrt(8.0f));
  EXPECT_LT(true_error2(f, shared.values, step), 0.5 * true_error2(f, noisy(f, step, sigma, 1), step));
}

TEST(ShareLight, counts_the_bias_of_light_that_is_almost_a_plane) {
  const Floor f;
  const Field bent = [](const Vec3& p) { return 2.0f + 0.05f * p.x * p.x; };
  double error2 = 0.0;
  double predicted = 0.0;
  for (std::uint64_t run = 0; run < 200; ++run) {
    const auto shared = share(f, noisy(f, bent, 0.5f, run));
    error2 += true_error2(f, shared.values, bent);
    predicted += spread_of(shared.values, shared.bias, bands, f.area, f.workers).error2;
  }
  EXPECT_NEAR(predicted / error2, 1.0, 0.45);
}

TEST(ShareLight, does_not_touch_what_has_no_noise) {
  const Floor f;
  for (const Field& field : {Field(linear), Field([](const Vec3& p) { return 1.0f + p.x * p.y; })}) {
    const auto exact = noisy(f, field, 0.0f, 1);
    const auto shared = share(f, exact);
    EXPECT_EQ(shared.values, exact);
    EXPECT_EQ(shared.bias, std::vector<float>(exact[0].size(), 0.0f));
  }
}

TEST(ShareLight, gives_the_same_bits_on_any_number_of_threads) {
  const Floor one(1, true);
  const auto expected = share(one, noisy(one, linear, 0.5f, 1, 5));
  for (const int threads : {2, 5}) {
    const Floor f(threads, true);
    const auto shared = share(f, noisy(f, linear, 0.5f, 1, 5));
    EXPECT_EQ(shared.values, expected.values);
    EXPECT_EQ(shared.bias, expected.bias);
  }
}

// A region of several tasks, and fits that reach over the slots of two ranks.
TEST(ShareLight, ranks_get_for_their_slots_the_bits_of_one) {
  const Floor f(1, true, 0.05f);
  ASSERT_GT(f.sides.fronts, 16'000u);
  const auto field = [](const Vec3& p) { return p.x < 1.5f ? linear(p) : 2.0f + std::sin(6.0f * p.y); };
  const auto noise = noisy(f, field, 0.05f, 5);
  auto alone = noise;
  std::vector<float> bias(alone[0].size(), 0.0f);
  share_light(f.patches, f.tree, f.sides, alone, bias, f.workers);
  ASSERT_NE(alone, noise);
  for (const std::size_t count : {2u, 5u})
    ThreadRanks::run(count, [&](const Ranks& ranks) {
      const Workers workers(1);
      auto values = noise;
      std::vector<float> own_bias(bias.size(), 0.0f);
      const auto mine = spread_share(&ranks, f.sides.size());
      LightSharing(f.patches, f.tree, f.sides, workers).share(values, own_bias, workers, mine);
      const auto is_same = [&](const std::vector<float>& a, const std::vector<float>& b) {
        const auto at = [&](std::size_t slot) { return static_cast<std::ptrdiff_t>(slot * bands); };
        return std::equal(a.begin() + at(mine.begin()), a.begin() + at(mine.end()),
                          b.begin() + at(mine.begin()));
      };
      for (std::size_t r = 0; r < values.size(); ++r) EXPECT_TRUE(is_same(values[r], alone[r])) << r;
      EXPECT_TRUE(is_same(own_bias, bias));
    });
}

TEST(ShareLight, does_with_one_band_what_it_does_with_three_alike) {
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
  const auto expected = share(three, of_three);
  const auto shared = share(one, of_one);
  for (std::size_t r = 0; r < of_one.size(); ++r)
    for (std::size_t s = 0; s < three.sides.size(); ++s)
      ASSERT_EQ(shared.values[r][s], expected.values[r][3 * s]);
}

}  // namespace
}  // namespace luxel
