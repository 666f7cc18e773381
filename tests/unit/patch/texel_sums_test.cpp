// SPDX-License-Identifier: Apache-2.0
// Means of textures over triangles, against laws and brute force. No risk: seeds are fixed.
#include "luxel/patch/texel_sums.h"

#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace luxel {
namespace {

using Places = std::array<Vec2, 3>;

std::shared_ptr<const Raster> noise(int width, int height) {
  std::mt19937 random(5);
  auto raster = std::make_shared<Raster>();
  raster->width = width;
  raster->height = height;
  for (int i = 0; i < width * height; ++i) {
    const auto bits = random();
    raster->codes.push_back({static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
                             static_cast<std::uint8_t>(bits >> 16), static_cast<std::uint8_t>(bits >> 24)});
  }
  return raster;
}

double area(const Places& t) {
  return 0.5 * std::fabs(double{t[1].x - t[0].x} * double{t[2].y - t[0].y} -
                         double{t[2].x - t[0].x} * double{t[1].y - t[0].y});
}

Places triangle(std::mt19937& random, float reach) {
  std::uniform_real_distribution<float> place(-reach, reach);
  Places t;
  for (auto& p : t) p = {place(random), place(random)};
  return t;
}

constexpr std::array all_wraps = {std::array{Wrap::repeat, Wrap::repeat},
                                  std::array{Wrap::mirror, Wrap::clamp},
                                  std::array{Wrap::clamp, Wrap::mirror}};

// Counts points of a fine grid.
TexelSums::Mean by_force(const Raster& raster, const TextureUse& use, const Places& t, float threshold) {
  constexpr int steps = 1200;
  Vec3d sum(0.0);
  double covered = 0.0, all = 0.0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; i + j < steps; ++j) {
      const auto u = (static_cast<float>(i) + 1.0f / 3.0f) / steps,
                 v = (static_cast<float>(j) + 1.0f / 3.0f) / steps;
      const auto pixel = pixel_at(raster, use, (1.0f - u - v) * t[0] + u * t[1] + v * t[2]);
      all += 1.0;
      if (raster.alpha(pixel) < threshold) continue;
      covered += 1.0;
      sum += Vec3d(raster.colour(pixel));
    }
  return {Vec3(sum / covered), static_cast<float>(covered / all)};
}

TEST(TexelSums, AgreeWithCountingPoints) {
  const auto raster = noise(37, 21);
  std::mt19937 random(7);
  for (const auto& wrap : all_wraps)
    for (int i = 0; i < 6; ++i) {
      const auto t = triangle(random, 1.7f);
      TextureUse use;
      use.wrap = wrap;
      const auto found = TexelSums(raster, wrap, 0.4f).over(t);
      const auto counted = by_force(*raster, use, t, 0.4f);
      // A grid errs on the pixels' borders: one point in its 1200 along each, a fraction of which differ.
      EXPECT_NEAR(found.covered, counted.covered, 2e-3);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(found.colour[c], counted.colour[c], 2e-3);
    }
}

// The part of a convex polygon where sign * p[axis] >= sign * at.
std::vector<glm::dvec2> clipped(const std::vector<glm::dvec2>& polygon, int axis, double at, double sign) {
  std::vector<glm::dvec2> part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const auto from = sign * (a[axis] - at), to = sign * (b[axis] - at);
    if (from >= 0.0) part.push_back(a);
    if ((from > 0.0 && to < 0.0) || (from < 0.0 && to > 0.0))
      part.push_back(a + from / (from - to) * (b - a));
  }
  return part;
}

double area(const std::vector<glm::dvec2>& polygon) {
  double twice = 0.0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const auto a = polygon[i - 1] - polygon[0], b = polygon[i] - polygon[0];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * std::fabs(twice);
}

// Weighs each pixel by the area that the triangle has in it.
TexelSums::Mean by_clipping(const Raster& raster, const std::array<Wrap, 2>& wrap, const Places& t,
                            float threshold) {
  std::vector<glm::dvec2> triangle;
  for (const auto& p : t) triangle.emplace_back(double{p.x} * raster.width, double{p.y} * raster.height);
  glm::dvec2 low = triangle[0], high = triangle[0];
  for (const auto& p : triangle) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  Vec3d sum(0.0);
  double covered = 0.0;
  for (auto y = std::floor(low.y); y < high.y; y += 1.0)
    for (auto x = std::floor(low.x); x < high.x; x += 1.0) {
      const auto row = clipped(clipped(triangle, 1, y, 1.0), 1, y + 1.0, -1.0);
      const auto fraction = area(clipped(clipped(row, 0, x, 1.0), 0, x + 1.0, -1.0));
      const auto pixel =
          raster.index(static_cast<int>(wrapped(static_cast<std::int64_t>(x), raster.width, wrap[0])),
                       static_cast<int>(wrapped(static_cast<std::int64_t>(y), raster.height, wrap[1])));
      if (raster.alpha(pixel) < threshold) continue;
      covered += fraction;
      sum += fraction * Vec3d(raster.colour(pixel));
    }
  return {Vec3(sum / covered), static_cast<float>(covered / area(triangle))};
}

TEST(TexelSums, AreExact) {
  const auto raster = noise(43, 29);
  auto linear = std::make_shared<Raster>(*raster);
  linear->codes.clear();
  for (std::size_t i = 0; i < raster->codes.size(); ++i) linear->linear.push_back(raster->colour(i));
  std::mt19937 random(9);
  for (const auto& wrap : all_wraps) {
    const TexelSums with_holes(raster, wrap, 0.4f), of_numbers(linear, wrap);
    for (int i = 0; i < 40; ++i) {
      // From a hundredth of a pixel to two pictures; some corners on borders of pixels.
      auto t = triangle(random, 2.0f);
      const auto size = std::array{2e-4f, 0.02f, 0.3f, 1.0f}[static_cast<std::size_t>(i % 4)];
      for (std::size_t k = 1; k < 3; ++k) t[k] = t[0] + size * (t[k] - t[0]);
      if (i % 5 == 0) t[1] = {1.0f, t[0].y};
      const auto found = with_holes.over(t), clipped = by_clipping(*raster, wrap, t, 0.4f);
      EXPECT_NEAR(found.covered, clipped.covered, 1e-6);
      for (int c = 0; c < 3 && clipped.covered > 0.0f; ++c)
        EXPECT_NEAR(found.colour[c], clipped.colour[c], 1e-6) << i;
      const auto numbers = of_numbers.over(t), expected = by_clipping(*linear, wrap, t, 0.0f);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(numbers.colour[c], expected.colour[c], 1e-6) << i;
    }
  }
}

TEST(TexelSums, OfPartsAddUp) {
  const auto raster = noise(64, 50);
  std::mt19937 random(8);
  for (const auto& wrap : all_wraps)
    for (int i = 0; i < 30; ++i) {
      const TexelSums sums(raster, wrap, 0.3f);
      const auto t = triangle(random, i < 15 ? 0.02f : 3.0f);
      const auto middle = 0.3f * t[0] + 0.2f * t[1] + 0.5f * t[2];
      const auto whole = sums.over(t);
      double covered = 0.0, parts = 0.0;
      Vec3d colour(0.0);
      for (std::size_t k = 0; k < 3; ++k) {
        const Places part = {t[k], t[(k + 1) % 3], middle};
        const auto mean = sums.over(part);
        covered += area(part) * double{mean.covered};
        colour += area(part) * double{mean.covered} * Vec3d(mean.colour);
        parts += area(part);
      }
      EXPECT_NEAR(covered, parts * double{whole.covered}, 1e-4 * parts);
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(colour[c], parts * double{whole.covered} * double{whole.colour[c]}, 1e-4 * parts);
    }
}

TEST(TexelSums, OfTheWholePictureIsItsMean) {
  const auto raster = noise(33, 65);
  const TexelSums sums(raster, {});
  const auto mean = mean_color(as_image(*raster));
  const auto lower = sums.over({Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)});
  const auto upper = sums.over({Vec2(0, 0), Vec2(0, 1), Vec2(1, 1)});
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(sums.whole().colour[c], mean[c], 1e-6);
    EXPECT_NEAR(0.5f * (lower.colour[c] + upper.colour[c]), mean[c], 1e-6);
  }
  EXPECT_EQ(sums.over({Vec2(0, 0), Vec2(500, 0), Vec2(0, 900)}).colour, sums.whole().colour);
  EXPECT_EQ(sums.over({Vec2(NAN, 0), Vec2(1, 0), Vec2(1, 1)}).colour, sums.whole().colour);
}

TEST(TexelSums, OfALineIsTheMeanAlongIt) {
  auto raster = std::make_shared<Raster>();
  raster->width = 2;
  raster->height = 1;
  raster->codes = {{255, 255, 255, 255}, {0, 0, 0, 255}};
  const TexelSums sums(raster, {Wrap::clamp, Wrap::clamp});
  EXPECT_NEAR(sums.over({Vec2(0.25f, 0.5f), Vec2(1.0f, 0.5f), Vec2(0.5f, 0.5f)}).colour.r, 1.0 / 3.0, 0.01);
  EXPECT_EQ(sums.over({Vec2(0.1f, 0.2f), Vec2(0.1f, 0.2f), Vec2(0.1f, 0.2f)}).colour.r, 1.0f);
}

}  // namespace
}  // namespace luxel
