// SPDX-License-Identifier: Apache-2.0
// Points of openings for receivers close to them. Numbers are those of a Sobol sequence: errors are those of
// its quadrature.
#include "luxel/photometry/near_opening.h"

#include <array>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "luxel/core/sobol.h"
#include "luxel/photometry/opening.h"

namespace luxel {
namespace {

constexpr std::uint32_t samples = 1u << 15;

// Mean over the opening's surface, and mean square of what is averaged.
template <typename Point, typename Value>
std::array<double, 2> mean_and_square(const Point& point, const Value& value) {
  const OwenSobol numbers(7);
  double sum = 0.0, square = 0.0;
  for (std::uint32_t i = 0; i < samples; ++i) {
    const OpeningPoint chosen =
        point(std::array<double, 2>{double{numbers.at(i, 0)}, double{numbers.at(i, 1)}});
    const auto x = chosen.weight > 0.0 ? chosen.weight * value(chosen.at) : 0.0;
    sum += x;
    square += x * x;
  }
  return {sum / samples, square / samples};
}

TEST(NearOpening, has_the_means_of_even_points) {
  const Vec3d receivers[] = {{0.2, 0.1, 0.3}, {-0.5, 0.4, -0.2}, {0.9, 0.1, 0.05}, {0.1, 0.7, 0.3}};
  for (const auto& opening : {LuminousOpening{OpeningShape::rectangle, {1.2, 0.6, 0.0}},
                              LuminousOpening{OpeningShape::ellipse, {1.2, 0.6, 0.0}},
                              LuminousOpening{OpeningShape::vertical_disk, {0.0, 0.9, 0.7}},
                              LuminousOpening{OpeningShape::box, {1.2, 0.6, 0.1}},
                              LuminousOpening{OpeningShape::cylinder_along_x, {1.2, 0.1, 0.1}}})
    for (const auto& receiver : receivers) {
      const auto near = [&](const auto& u) { return sample_opening_from(opening, receiver, u); };
      const auto even = [&](const auto& u) { return OpeningPoint{sample_opening(opening, u)}; };
      const auto value = [](const Vec3d& at) { return 1.0 + at.x - 2.0 * at.y * at.y + 5.0 * at.z; };
      const auto shape = static_cast<int>(opening.shape);
      EXPECT_NEAR(mean_and_square(near, [](const Vec3d&) { return 1.0; })[0], 1.0, 5e-3) << shape;
      EXPECT_NEAR(mean_and_square(near, value)[0], mean_and_square(even, value)[0], 5e-3) << shape;
    }
}

// A square that emits as the cosine is a diffuse surface: above its middle, Lambert's closed form.
TEST(NearOpening, has_the_light_of_a_diffuse_square_and_little_noise) {
  const LuminousOpening square{OpeningShape::rectangle, {1.0, 1.0, 0.0}};
  for (const auto height : {0.3, 0.05, 0.006}) {
    const Vec3d receiver(0.0, 0.0, height);
    ASSERT_TRUE(is_close_to(square, receiver));
    // Cosine at the square times cosine at the receiver over the squared distance; the area is 1.
    const auto light = [&](const Vec3d& at) {
      const auto d2 = glm::dot(at - receiver, at - receiver);
      return height * height / (d2 * d2);
    };
    const auto half = 0.5 / std::hypot(0.5, height);
    const auto truth = 4.0 * half * std::atan(half);
    const auto [mean, mean_square] =
        mean_and_square([&](const auto& u) { return sample_opening_from(square, receiver, u); }, light);
    EXPECT_NEAR(mean, truth, 5e-3 * truth) << height;
    EXPECT_LT(mean_square, 1.5 * truth * truth) << height;
    const auto even =
        mean_and_square([&](const auto& u) { return OpeningPoint{sample_opening(square, u)}; }, light);
    if (height < 0.1) {
      EXPECT_GT(even[1], 10.0 * truth * truth) << height;
    }
  }
}

TEST(NearOpening, is_for_receivers_beside_it_alone) {
  const LuminousOpening tube{OpeningShape::cylinder_along_x, {1.2, 0.03, 0.03}};
  EXPECT_TRUE(is_close_to(tube, {0.0, 0.0, 0.5}));
  EXPECT_FALSE(is_close_to(tube, {0.0, 0.0, 0.7}));
  EXPECT_FALSE(is_close_to(tube, {1.3, 0.0, 0.0}));
  EXPECT_FALSE(is_close_to({}, {0.0, 0.0, 0.001})) << "a point has no extent";
  // In the plane of a sheet no face is seen.
  const LuminousOpening sheet{OpeningShape::rectangle, {1.0, 1.0, 0.0}};
  EXPECT_EQ(sample_opening_from(sheet, {0.8, 0.0, 0.0}, {0.3, 0.4}).weight, 0.0);
}

}  // namespace
}  // namespace luxel
