// SPDX-License-Identifier: Apache-2.0
// Direct light against cosine rays that hit lamps: unbiased, and with a true standard error. Risk of a false
// alarm: about one in a million per comparison.
#include "luxel/lamps/direct_light.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/core/address.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/side.h"
#include "luxel/trace/patch_emitter.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

constexpr double risk_sigmas = 5.1;
constexpr double closed_form_error = 1.5e-3;  // relative; what the quadrature of the closed form may add
constexpr std::uint32_t replicates = 64;

struct Estimate {
  std::vector<double> mean, sigma;  // [band]
};

// A room of patches with what direct light needs.
struct Room {
  explicit Room(const Scene& scene, float max_edge = no_max_edge)
      : patches(make_patches(scene, {.max_edge = max_edge})), tracer(patches, Context(1)), lamps(patches) {}

  PatchSet patches;
  Tracer tracer;
  Lamps lamps;

  std::size_t first_of(const std::string& material) const {
    std::size_t p = 0;
    while (patches.material_of(p).name != material) ++p;
    return p;
  }

  // Light found by cosine rays from the side.
  Estimate truth(SideId side, std::size_t rays = 400'000) const {
    const PatchEmitter emitter(patches, side);
    const auto bands = patches.band_count();
    std::vector<double> sum(bands, 0.0);
    std::vector<double> square(bands, 0.0);
    for (std::size_t i = 0; i < rays; ++i) {
      const auto hit = tracer.nearest(emitter.ray(uniform4(stream_key(99, 0, 0), i)));
      if (!hit || hit.back) continue;
      for (std::size_t b = 0; b < bands; ++b) {
        const auto e = static_cast<double>(patches.material_of(hit.patch).emittance[b]);
        sum[b] += e;
        square[b] += e * e;
      }
    }
    const auto n = static_cast<double>(rays);
    Estimate result;
    for (std::size_t b = 0; b < bands; ++b) {
      result.mean.push_back(sum[b] / n);
      result.sigma.push_back(std::sqrt(std::max(0.0, square[b] / n - sum[b] * sum[b] / (n * n)) / n));
    }
    return result;
  }

  Estimate estimate(SideId side, const DirectOptions& options, std::uint32_t per_replicate = 64) const {
    const DirectLight direct(patches, tracer, lamps, options);
    const auto bands = patches.band_count();
    std::vector<float> out(options.replicates * bands);
    direct.estimate(side, 3, 0, per_replicate, out);
    Estimate result;
    const auto n = static_cast<double>(options.replicates);
    for (std::size_t b = 0; b < bands; ++b) {
      double sum = 0.0;
      double square = 0.0;
      for (std::size_t r = 0; r < options.replicates; ++r) {
        const auto v = static_cast<double>(out[r * bands + b]);
        sum += v;
        square += v * v;
      }
      result.mean.push_back(sum / n);
      result.sigma.push_back(std::sqrt(std::max(0.0, square / n - sum * sum / (n * n)) / (n - 1.0)));
    }
    return result;
  }

  void expect_truth(SideId side, const DirectOptions& options = {.replicates = replicates}) const {
    const auto is = estimate(side, options);
    const auto should = truth(side);
    for (std::size_t b = 0; b < is.mean.size(); ++b) {
      const auto sigma = std::hypot(is.sigma[b], should.sigma[b]);
      EXPECT_NEAR(is.mean[b], should.mean[b], risk_sigmas * sigma + closed_form_error * should.mean[b] + 1e-9)
          << "side " << side.index() << " band " << b;
    }
  }
};

// A lamp half a metre wide under the ceiling of a room of three metres, shining down, and a shelf.
truth::SceneBuilder lamp_and_floor() {
  truth::SceneBuilder b;
  b.material("lamp", 0.5f, 10.0f).quad({1, 1, 3}, {1, 1.5f, 3}, {1.5f, 1.5f, 3}, {1.5f, 1, 3});
  b.material("floor", 0.5f, 0.0f).triangle({0, 0, 0}, {0.3f, 0, 0}, {0, 0.3f, 0});
  return b;
}

// Everything the options can switch.
std::vector<DirectOptions> all_options() {
  std::vector<DirectOptions> all;
  for (int i = 0; i < 24; ++i)
    all.push_back({.seed = 5,
                   .replicates = replicates,
                   .low_discrepancy = (i & 1) != 0,
                   .stratified = (i & 2) != 0,
                   .importance = (i & 4) != 0,
                   .control_variate = (i & 8) != 0,
                   .multiple_importance = (i & 16) != 0});
  return all;
}

TEST(DirectLight, a_side_that_sees_the_lamp_wholly_has_no_noise) {
  const Room room(lamp_and_floor().scene());
  const auto side = SideId(room.first_of("floor"), false);
  EXPECT_EQ(room.estimate(side, {.replicates = replicates}).sigma[0], 0.0);
  room.expect_truth(side);
}

TEST(DirectLight, a_lamp_half_hidden_is_unbiased_with_every_option) {
  auto builder = lamp_and_floor();
  builder.material("shelf", 0.5f, 0.0f).quad({0.5f, 0, 1}, {0.9f, 0, 1}, {0.9f, 2, 1}, {0.5f, 2, 1});
  const Room room(builder.scene());
  for (const auto& options : all_options()) room.expect_truth(SideId(room.first_of("floor"), false), options);
}

// A tilted panel of 72 triangles: one lamp, whose triangles do not hide others.
TEST(DirectLight, a_meshed_panel_half_hidden_is_unbiased_with_every_option) {
  truth::SceneBuilder builder;
  builder.material("floor", 0.5f, 0.0f).triangle({0, 0, 0}, {0.3f, 0, 0}, {0, 0.3f, 0});
  builder.material("shelf", 0.5f, 0.0f).quad({0.5f, 0, 1}, {0.9f, 0, 1}, {0.9f, 2, 1}, {0.5f, 2, 1});
  builder.material("lamp", 0.5f, 10.0f);
  const auto at = [](int i, int j) {
    return Vec3(0.9f, 0.8f, 2.8f) + static_cast<float>(i) / 6.0f * Vec3(0.1f, 0.9f, 0.3f) +
           static_cast<float>(j) / 6.0f * Vec3(0.8f, -0.1f, 0.2f);
  };
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) builder.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  const Room room(builder.scene());
  ASSERT_EQ(room.lamps.size(), 2u);
  for (const auto& options : all_options()) room.expect_truth(SideId(room.first_of("floor"), false), options);
}

TEST(DirectLight, a_side_that_sees_no_lamp_is_dark) {
  auto builder = lamp_and_floor();
  builder.material("cover", 0.5f, 0.0f).quad({0, 0, 2}, {3, 0, 2}, {3, 3, 2}, {0, 3, 2});
  const Room room(builder.scene());
  const auto dark = room.estimate(SideId(room.first_of("floor"), false), {.replicates = replicates});
  EXPECT_EQ(dark.mean[0], 0.0);
  EXPECT_EQ(dark.sigma[0], 0.0);
}

TEST(DirectLight, no_ray_is_traced_where_no_lamp_is_above_the_horizon) {
  const Room room(lamp_and_floor().scene());
  const DirectLight direct(room.patches, room.tracer, room.lamps, {});
  std::vector<float> out(8 * room.patches.band_count(), 1.0f);
  EXPECT_EQ(direct.estimate(SideId(room.first_of("floor"), true), 0, 0, 16, out), 0u);
  EXPECT_EQ(*std::max_element(out.begin(), out.end()), 0.0f);
  EXPECT_EQ(direct.estimate(SideId(room.first_of("lamp"), false), 0, 0, 16, out), 0u);
}

TEST(DirectLight, the_back_of_a_patch_is_lit_too) {
  auto builder = lamp_and_floor();
  builder.material("awning", 0.5f, 0.0f).triangle({0, 0, 1}, {0, 0.3f, 1}, {0.3f, 0, 1.1f});
  const Room room(builder.scene());
  const auto back = SideId(room.first_of("awning"), true);
  EXPECT_GT(room.estimate(back, {.replicates = replicates}).mean[0], 0.05);
  room.expect_truth(back);
}

// A ceiling of ten metres, four centimetres above a shelf, with a beam between.
TEST(DirectLight, a_huge_near_ceiling_is_as_accurate_as_a_small_lamp) {
  truth::SceneBuilder b;
  b.material("lamp", 0.5f, 2.0f).quad({0, 0, 3}, {0, 10, 3}, {10, 10, 3}, {10, 0, 3});
  b.material("shelf", 0.5f, 0.0f).triangle({4, 4, 2.96f}, {4.5f, 4, 2.96f}, {4, 4.5f, 2.96f});
  b.material("beam", 0.5f, 0.0f)
      .quad({4.1f, 3, 2.98f}, {4.12f, 3, 2.98f}, {4.12f, 6, 2.98f}, {4.1f, 6, 2.98f});
  b.material("wall", 0.5f, 0.0f).triangle({9.9f, 5, 1}, {9.9f, 6, 1}, {9.9f, 5, 2.9f});
  const Room room(b.scene());
  for (const bool multiple_importance : {false, true}) {
    const DirectOptions options{.replicates = replicates, .multiple_importance = multiple_importance};
    room.expect_truth(SideId(room.first_of("shelf"), false), options);
    room.expect_truth(SideId(room.first_of("wall"), true), options);
    room.expect_truth(SideId(room.first_of("wall"), false), options);
  }
}

// Against the closed form, where nothing is hidden: no other estimate's noise.
TEST(DirectLight, multiple_importance_gives_the_closed_form) {
  truth::SceneBuilder huge;
  huge.material("lamp", 0.5f, 2.0f).quad({0, 0, 3}, {0, 10, 3}, {10, 10, 3}, {10, 0, 3});
  huge.material("floor", 0.5f, 0.0f).triangle({4, 4, 2.8f}, {4.5f, 4, 2.8f}, {4, 4.5f, 2.8f});
  for (const auto& scene : {huge.scene(), lamp_and_floor().scene()}) {
    const Room room(scene);
    const auto side = SideId(room.first_of("floor"), false);
    const auto exact = room.estimate(side, {.replicates = replicates}).mean[0];
    const auto is = room.estimate(side, {.replicates = replicates, .multiple_importance = true}, 1024);
    EXPECT_NEAR(is.mean[0], exact, risk_sigmas * is.sigma[0] + closed_form_error * exact);
    EXPECT_LT(is.sigma[0], 0.01 * exact);
  }
}

TEST(DirectLight, multiple_importance_counts_its_cosine_rays) {
  const Room room(lamp_and_floor().scene());
  std::vector<float> out(8 * room.patches.band_count());
  const auto rays = [&](bool multiple_importance) {
    const DirectLight direct(room.patches, room.tracer, room.lamps,
                             {.multiple_importance = multiple_importance});
    return direct.estimate(SideId(room.first_of("floor"), false), 0, 0, 16, out);
  };
  EXPECT_EQ(rays(false), 128u);
  EXPECT_EQ(rays(true), 256u);
}

// Walls that meet the luminous ceiling of a cube at its edges, cut finer and finer.
TEST(DirectLight, patches_that_touch_the_edge_of_a_lamp_are_right) {
  for (const float max_edge : {2.0f, 0.4f, 0.1f}) {
    const Room room(truth::cube_a(), max_edge);
    const auto ceiling_edge = [&](std::size_t p) {
      const auto corners = room.patches.points(p);
      return std::count_if(corners.begin(), corners.end(), [](const Vec3& v) { return v.z == 1.0f; });
    };
    std::size_t tried = 0;
    for (std::size_t p = 0; p < room.patches.size() && tried < 6; ++p) {
      if (room.patches.material_of(p).name == "ceiling" || ceiling_edge(p) == 0) continue;
      ++tried;
      room.expect_truth(SideId(p, false));
    }
    EXPECT_GT(tried, 3u);
  }
}

// Light from half of the sky on one side of a line, none on the other.
TEST(DirectLight, a_wall_that_pokes_through_the_plane_of_the_lamp_is_right) {
  truth::SceneBuilder b;
  b.material("lamp", 0.5f, 2.0f).quad({0, 0, 2.6f}, {0, 4, 2.6f}, {4, 4, 2.6f}, {4, 0, 2.6f});
  b.material("wall", 0.5f, 0.0f).triangle({0, 1, 2}, {0, 3, 2.1f}, {0, 1.5f, 3});
  const Room room(b.scene());
  const auto side = SideId(room.first_of("wall"), false);
  EXPECT_GT(room.estimate(side, {.replicates = replicates}).mean[0], 0.4);
  room.expect_truth(side);
}

// The red lamp is hidden from half the patch, the blue one from none, the green one shines away.
TEST(DirectLight, lamps_of_different_colours_keep_apart) {
  truth::SceneBuilder b;
  b.material("red", Vec3(0.5f), Vec3(10, 0, 0)).quad({1, 1, 3}, {1, 1.5f, 3}, {1.5f, 1.5f, 3}, {1.5f, 1, 3});
  b.material("blue", Vec3(0.5f), Vec3(1, 0, 5)).quad({-1, 1, 3}, {-1, 2, 3}, {0, 2, 3}, {0, 1, 3});
  b.material("green", Vec3(0.5f), Vec3(0, 7, 0)).quad({-1, 0, 3}, {0, 0, 3}, {0, 1, 3}, {-1, 1, 3});
  b.material("shelf", 0.5f, 0.0f).quad({0.3f, 0, 1}, {0.45f, 0, 1}, {0.45f, 2, 1}, {0.3f, 2, 1});
  b.material("floor", 0.5f, 0.0f).triangle({0, 0, 0}, {0.3f, 0, 0}, {0, 0.3f, 0});
  const Room room(b.scene());
  for (const auto& options : all_options()) room.expect_truth(SideId(room.first_of("floor"), false), options);
}

// Small triangles every which way under the ceiling of a room; the floor and a shelf see some through others.
Scene swarm(int count) {
  truth::SceneBuilder b;
  for (int i = 0; i < count; ++i) {
    const auto u = uniform4(stream_key(8, 0, 0), static_cast<std::uint64_t>(2 * i));
    const auto v = uniform4(stream_key(8, 0, 0), static_cast<std::uint64_t>(2 * i + 1));
    const Vec3 at(4.0f * u[0], 4.0f * u[1], 1.7f + 1.3f * u[2]);
    const Vec3 p(v[0] - 0.5f, v[1] - 0.5f, v[2] - 0.5f);
    const Vec3 q(u[3] - 0.5f, v[0] - 0.5f, v[3] - 0.5f);
    if (i % 125 == 0)
      b.material("lamp" + std::to_string(i), Vec3(0.5f),
                 Vec3(1.0f + v[0], 3.0f * v[1], static_cast<float>(i % 3)));
    b.triangle(at, at + 0.4f * p, at + 0.4f * q);
  }
  b.material("floor", 0.5f, 0.0f).triangle({1, 1, 0}, {2, 1, 0}, {1, 2, 0});
  b.material("shelf", 0.5f, 0.0f).triangle({1, 1, 1}, {1.3f, 2, 1}, {2, 1, 1.3f});
  return b.scene();
}

TEST(DirectLight, five_hundred_lamps_are_unbiased_with_every_option) {
  const Room room(swarm(500));
  for (const auto& options : all_options())
    for (const auto* name : {"floor", "shelf"})
      for (const bool back : {false, true}) room.expect_truth(SideId(room.first_of(name), back), options);
}

// Means of few samples in many places: a bias of the ratio of small sums would show.
TEST(DirectLight, few_samples_have_no_bias_and_their_spread_is_honest) {
  auto builder = lamp_and_floor();
  builder.material("shelf", 0.5f, 0.0f).quad({0.5f, 0, 1}, {0.9f, 0, 1}, {0.9f, 2, 1}, {0.5f, 2, 1});
  const Room room(builder.scene());
  const auto side = SideId(room.first_of("floor"), false);
  const auto much = room.estimate(side, {.replicates = 64}, 16384);
  const auto exact = much.mean[0];
  const auto bands = room.patches.band_count();
  for (const std::uint32_t per_replicate : {1u, 2u, 4u}) {
    const DirectLight direct(room.patches, room.tracer, room.lamps, {.replicates = 8});
    std::vector<float> out(8 * bands);
    constexpr int trials = 20'000;
    double sum = 0.0;
    double square = 0.0;
    double claimed = 0.0;
    for (int i = 0; i < trials; ++i) {
      direct.estimate(side, 0, static_cast<std::uint32_t>(i), per_replicate, out);
      double mean = 0.0;
      double mean_square = 0.0;
      for (std::size_t r = 0; r < 8; ++r) {
        const auto v = static_cast<double>(out[r * bands]);
        mean += v / 8;
        mean_square += v * v / 8;
      }
      sum += mean;
      square += (mean - exact) * (mean - exact);
      claimed += (mean_square - mean * mean) / 7;
    }
    const auto sigma = std::sqrt(square / trials);
    EXPECT_NEAR(sum / trials, exact,
                risk_sigmas * std::hypot(sigma / std::sqrt(1.0 * trials), much.sigma[0]));
    EXPECT_NEAR(std::sqrt(claimed / trials), sigma, 0.1 * sigma);
  }
}

TEST(DirectLight, the_same_call_gives_the_same_bits_in_any_order) {
  const Room room(truth::cube_a(), 0.4f);
  const DirectLight direct(room.patches, room.tracer, room.lamps, {});
  const auto size = 8 * room.patches.band_count();
  const auto sides = side_count(room.patches.size());
  std::vector<std::vector<float>> first(sides, std::vector<float>(size));
  for (std::size_t s = 0; s < sides; ++s)
    direct.estimate(SideId::at(s), static_cast<std::uint32_t>(s / 2), 1, 4, first[s]);
  std::vector<float> again(size);
  for (std::size_t s = sides; s-- > 0;) {
    direct.estimate(SideId::at(s), static_cast<std::uint32_t>(s / 2), 1, 4, again);
    ASSERT_EQ(again, first[s]);
  }
}

// A sphere of 20 x 10 quads that shine outwards, none at the poles.
void add_bulb(truth::SceneBuilder& b, const Vec3& centre, float radius) {
  const auto point = [&](int ring, int column) {
    const auto up = pi * (static_cast<float>(ring) + 0.5f) / 11.0f;
    const auto round = 2.0f * pi * static_cast<float>(column % 20) / 20.0f;
    return centre +
           radius * Vec3(std::sin(up) * std::cos(round), std::sin(up) * std::sin(round), std::cos(up));
  };
  for (int ring = 0; ring < 10; ++ring)
    for (int column = 0; column < 20; ++column)
      b.quad(point(ring, column), point(ring + 1, column), point(ring + 1, column + 1),
             point(ring, column + 1));
}

// Facets are sampled by the sphere around a bulb, but where the patch is too near.
TEST(DirectLight, of_bulbs_with_many_facets_is_unbiased) {
  truth::SceneBuilder b;
  b.material("floor", 0.5f, 0.0f).triangle({0, 0, 0}, {0.3f, 0, 0}, {0, 0.3f, 0});
  b.material("near", 0.5f, 0.0f).triangle({0.9f, 0.9f, 0.78f}, {1.1f, 0.9f, 0.78f}, {1, 1.1f, 0.78f});
  b.material("shade", 0.5f, 0.0f)
      .quad({0.5f, 0.5f, 0.6f}, {0.5f, 0.9f, 0.6f}, {0.9f, 0.9f, 0.6f}, {0.9f, 0.5f, 0.6f});
  b.material("lamp", 0.5f, 10.0f);
  add_bulb(b, {1, 1, 1}, 0.2f);
  add_bulb(b, {0.2f, 1.5f, 0.1f}, 0.15f);  // half of it below the floor's plane
  const Room room(b.scene());
  const std::vector<DirectOptions> chosen = {{.replicates = replicates},
                                             {.replicates = replicates, .importance = false},
                                             {.replicates = replicates, .control_variate = false},
                                             {.replicates = replicates, .multiple_importance = true}};
  for (const auto* name : {"floor", "near", "shade"})
    for (const bool back : {false, true})
      for (const auto& options : chosen) room.expect_truth(SideId(room.first_of(name), back), options);
}

}  // namespace
}  // namespace luxel
