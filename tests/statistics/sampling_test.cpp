// SPDX-License-Identifier: Apache-2.0
// Points, directions and rays follow their densities. Risk of a false alarm: one in a million per test.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "luxel/core/address.h"
#include "luxel/core/triangle.h"
#include "luxel/core/warp.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/side.h"
#include "luxel/trace/patch_emitter.h"

#include "support/chi_square.h"
#include "support/truth_scenes.h"

namespace luxel {
namespace {

constexpr std::size_t samples = 1'000'000;

std::size_t cell(double fraction, std::size_t cells) {
  return std::min(cells - 1, static_cast<std::size_t>(std::max(0.0, fraction) * static_cast<double>(cells)));
}

// A cell index for barycentric weights, all cells of one area: the warp's own inverse, written the other way
// round.
std::size_t triangle_cell(double b, double c, std::size_t n) {
  const double root = b + c;
  return cell(root * root, n) * n + cell(root > 0.0 ? c / root : 0.0, n);
}

// Cells of one solid-angle-times-cosine measure: sin² of the polar angle, and azimuth.
std::size_t direction_cell(const Vec3& d, std::size_t n) {
  const double azimuth = std::atan2(static_cast<double>(d.y), static_cast<double>(d.x)) / (2.0 * M_PI) + 0.5;
  return cell(1.0 - static_cast<double>(d.z) * d.z, n) * n + cell(azimuth, n);
}

void expect_uniform(const std::vector<std::size_t>& counts) {
  const auto expected = static_cast<double>(samples) / static_cast<double>(counts.size());
  const auto k = static_cast<double>(counts.size() - 1);
  const auto chi2 = statistics::chi_square(counts, expected);
  EXPECT_LT(chi2, statistics::chi_square_limit(k));
  EXPECT_GT(chi2, statistics::chi_square_lower_limit(k)) << "more even than chance: not independent";
}

TEST(Sampling, numbers_of_one_stream_are_uniform_in_every_dimension_and_pair) {
  const auto key = stream_key(1, 2, 3);
  for (std::size_t first = 0; first < 4; ++first)
    for (std::size_t second = first + 1; second < 4; ++second) {
      std::vector<std::size_t> counts(32 * 32, 0);
      for (std::size_t i = 0; i < samples; ++i) {
        const auto u = uniform4(key, i);
        ++counts[cell(u[first], 32) * 32 + cell(u[second], 32)];
      }
      expect_uniform(counts);
    }
}

TEST(Sampling, first_numbers_of_neighbouring_streams_are_independent) {
  std::vector<std::size_t> counts(32 * 32, 0);
  for (std::uint32_t e = 0; e < samples; ++e)
    ++counts[cell(uniform4(stream_key(7, 0, e), 0)[0], 32) * 32 +
             cell(uniform4(stream_key(7, 0, e + 1), 0)[0], 32)];
  expect_uniform(counts);
}

TEST(Sampling, a_number_depends_on_its_address_alone) {
  const RandomAddress at{.seed = 42, .step = 3, .element = 17, .sample = 1'000'000'007};
  const auto first = uniform4(at);
  (void)uniform4({.seed = 1, .step = 1, .element = 1, .sample = 1});
  EXPECT_EQ(uniform4(at), first);
  for (const auto u : first) {
    EXPECT_GE(u, 0.0f);
    EXPECT_LT(u, 1.0f);
  }
  EXPECT_NE(uniform4({.seed = 43, .step = 3, .element = 17, .sample = 1'000'000'007}), first);
}

TEST(Sampling, points_on_a_triangle_are_uniform) {
  std::vector<std::size_t> counts(16 * 16, 0);
  for (std::size_t i = 0; i < samples; ++i) {
    const auto u = uniform4(stream_key(1, 0, 0), i);
    const auto p = uniform_triangle(u[0], u[1]);
    EXPECT_TRUE(p.x >= 0.0f && p.y >= 0.0f && p.x + p.y <= 1.0f + 1e-6f);
    ++counts[triangle_cell(p.x, p.y, 16)];
  }
  expect_uniform(counts);
}

TEST(Sampling, directions_follow_the_cosine) {
  std::vector<std::size_t> counts(16 * 16, 0);
  for (std::size_t i = 0; i < samples; ++i) {
    const auto u = uniform4(stream_key(2, 0, 0), i);
    const auto d = cosine_hemisphere(u[2], u[3]);
    ASSERT_NEAR(glm::length(d), 1.0f, 1e-6f);
    ++counts[direction_cell(d, 16)];
  }
  expect_uniform(counts);
}

// Cells of equal height and equal angle about the axis are of equal area (Archimedes).
TEST(Sampling, even_directions_are_distributed_evenly) {
  std::vector<std::size_t> counts(16 * 16, 0);
  for (std::size_t i = 0; i < samples; ++i) {
    const auto u = uniform4(stream_key(12, 0, 0), i);
    const auto d = uniform_hemisphere(u[2], u[3]);
    ASSERT_NEAR(glm::length(d), 1.0f, 1e-6f);
    const auto turn = std::atan2(static_cast<double>(d.y), static_cast<double>(d.x)) / (2.0 * M_PI) + 0.5;
    const auto cell = [](double fraction) {
      return std::min<std::size_t>(15, static_cast<std::size_t>(16.0 * fraction));
    };
    ++counts[16 * cell(static_cast<double>(d.z)) + cell(turn)];
  }
  expect_uniform(counts);
}

// The density integrates to one, and the mean of f / density over samples is the integral of f: here f = 1
// gives 2 pi.
TEST(Sampling, the_cosine_density_is_the_density_of_its_samples) {
  double solid_angle = 0.0;
  for (std::size_t i = 0; i < samples; ++i) {
    const auto u = uniform4(stream_key(3, 0, 0), i);
    const auto d = cosine_hemisphere(u[0], u[1]);
    if (d.z > 0.05f) solid_angle += 1.0 / static_cast<double>(cosine_hemisphere_density(d));
  }
  const double exact =
      2.0 * M_PI * 0.95;  // the part above z = 0.05, where 1 / density has a bounded variance
  // E[1 / density²] = pi integral of d(omega) / cos = 2 pi² ln(20).
  const double sigma =
      std::sqrt((2.0 * M_PI * M_PI * std::log(20.0) - exact * exact) / static_cast<double>(samples));
  EXPECT_NEAR(solid_angle / static_cast<double>(samples), exact, 4.9 * sigma);
  EXPECT_FLOAT_EQ(concentric_disk_density({0.5f, 0.5f}), 1.0f / pi);
  EXPECT_EQ(concentric_disk_density({0.8f, 0.8f}), 0.0f);
  EXPECT_FLOAT_EQ(uniform_triangle_density(0.25f), 4.0f);
}

TEST(Sampling, sine_and_cosine_of_an_octant_are_good_to_a_float) {
  for (int i = -1000; i <= 1000; ++i) {
    const float angle = pi / 4.0f * static_cast<float>(i) / 1000.0f;
    float s = 0.0f;
    float c = 0.0f;
    sin_cos_octant(angle, s, c);
    EXPECT_NEAR(s, std::sin(static_cast<double>(angle)), 1e-7);
    EXPECT_NEAR(c, std::cos(static_cast<double>(angle)), 1e-7);
  }
}

TEST(Sampling, a_frame_is_orthonormal_and_right_handed_for_every_normal) {
  for (std::size_t i = 0; i < 10'000; ++i) {
    const auto u = uniform4(stream_key(4, 0, 0), i);
    const auto d = cosine_hemisphere(u[0], u[1]);
    const auto n = glm::normalize(u[2] < 0.5f ? d : -d);
    const Frame f(n);
    EXPECT_NEAR(glm::length(glm::cross(f.s, f.t) - f.n), 0.0f, 1e-6f);
    EXPECT_NEAR(glm::dot(f.s, f.n), 0.0f, 1e-6f);
  }
  EXPECT_NEAR(glm::length(glm::cross(Frame({0, 0, -1}).s, Frame({0, 0, -1}).t) - Vec3(0, 0, -1)), 0.0f,
              1e-6f);
}

TEST(Sampling, rays_leave_each_side_of_a_patch_uniformly_and_by_the_cosine) {
  truth::SceneBuilder builder;
  builder.material("m", 0.5f, 1.0f).triangle({1, 2, 3}, {1.5f, 2.2f, 3.1f}, {0.9f, 2.9f, 3.4f});
  const auto patches = make_patches(builder.scene(), {.max_edge = no_max_edge});
  const auto [a, b, c] = patches.points(0);
  const auto normal2 = area_vector2(a, b, c);
  const auto n2 = glm::dot(normal2, normal2);
  for (const bool back : {false, true}) {
    const PatchEmitter emitter(patches, SideId(0, back));
    const Frame frame(back ? -patches.normal[0] : patches.normal[0]);
    std::vector<std::size_t> points(64, 0);
    std::vector<std::size_t> directions(64, 0);
    for (std::size_t i = 0; i < samples; ++i) {
      const auto ray = emitter.ray(uniform4(stream_key(5, 0, back), i));
      const auto p = Vec3d(ray.origin);
      const auto beta = glm::dot(glm::cross(p - Vec3d(a), Vec3d(c) - Vec3d(a)), normal2) / n2;
      const auto gamma = glm::dot(glm::cross(Vec3d(b) - Vec3d(a), p - Vec3d(a)), normal2) / n2;
      ++points[triangle_cell(beta, gamma, 8)];
      const Vec3 local(glm::dot(ray.direction, frame.s), glm::dot(ray.direction, frame.t),
                       glm::dot(ray.direction, frame.n));
      ++directions[direction_cell(local, 8)];
    }
    expect_uniform(points);
    expect_uniform(directions);
  }
}

}  // namespace
}  // namespace luxel
