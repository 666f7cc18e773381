// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/opening.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/core/sobol.h"

namespace luxel {
namespace {

constexpr double exact_pi = std::numbers::pi;

std::vector<LuminousOpening> shapes() {
  using enum OpeningShape;
  std::vector<LuminousOpening> all;
  for (const auto shape : {rectangle, ellipse, box, vertical_cylinder, cylinder_along_x, cylinder_along_y,
                           ellipsoid, vertical_disk})
    all.push_back({shape, {shape == vertical_disk ? 0.0 : 1.2, 0.5, 0.3}});
  return all;
}

TEST(Opening, has_the_known_projected_areas) {
  using enum OpeningShape;
  const Vec3d down(0.0, 0.0, -2.0), along(1.0, 0.0, 0.0), slanted(0.6, 0.0, -0.8);
  EXPECT_NEAR(projected_area({rectangle, {1.2, 0.5, 0.0}}, slanted), 0.6 * 0.8, 1e-12);
  EXPECT_NEAR(projected_area({ellipse, {1.0, 1.0, 0.0}}, down), exact_pi / 4.0, 1e-12);
  EXPECT_NEAR(projected_area({box, {1.2, 0.5, 0.3}}, slanted), 1.2 * 0.5 * 0.8 + 0.5 * 0.3 * 0.6, 1e-12);
  EXPECT_NEAR(projected_area({vertical_cylinder, {0.4, 0.4, 1.0}}, along), 0.4, 1e-12);
  EXPECT_NEAR(projected_area({vertical_cylinder, {0.4, 0.4, 1.0}}, down), exact_pi * 0.04, 1e-12);
  EXPECT_NEAR(projected_area({cylinder_along_x, {1.5, 0.03, 0.03}}, down), 1.5 * 0.03, 1e-12);
  EXPECT_NEAR(projected_area({ellipsoid, {0.2, 0.2, 0.2}}, slanted), exact_pi * 0.01, 1e-12);
  EXPECT_NEAR(projected_area({ellipsoid, {0.2, 0.4, 0.6}}, along), exact_pi * 0.2 * 0.3, 1e-12);
  EXPECT_NEAR(projected_area({vertical_disk, {0.0, 0.4, 0.4}}, along), exact_pi * 0.04, 1e-12);
  EXPECT_EQ(projected_area({point, {}}, down), 0.0);
}

// Points lie within the extents; of shapes that are symmetric about their centre the mean is the centre.
TEST(Opening, is_sampled_within_its_extents_and_about_its_centre) {
  for (const auto& opening : shapes()) {
    const OwenSobol numbers(7);
    constexpr std::uint32_t count = 4096;
    Vec3d mean(0.0);
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto at = sample_opening(opening, {double{numbers.at(i, 0)}, double{numbers.at(i, 1)}});
      EXPECT_LE(glm::length(at), bounding_radius(opening) + 1e-9);
      for (int axis = 0; axis < 3; ++axis) EXPECT_LE(std::abs(at[axis]), 0.5 * opening.size[axis] + 1e-9);
      mean += at / double{count};
    }
    EXPECT_LT(glm::length(mean), 2e-3) << static_cast<int>(opening.shape);
  }
}

// Parts of the area: half of a disk's area is within 1/sqrt(2) of its radius; faces of a box and caps of a
// cylinder get their parts; a sphere's zones of equal height are equal.
TEST(Opening, is_sampled_evenly_over_its_area) {
  using enum OpeningShape;
  const OwenSobol numbers(11);
  constexpr std::uint32_t count = 1u << 16;
  const auto part = [&](const LuminousOpening& opening, auto is_in) {
    double found = 0.0;
    for (std::uint32_t i = 0; i < count; ++i)
      found +=
          is_in(sample_opening(opening, {double{numbers.at(i, 0)}, double{numbers.at(i, 1)}})) ? 1.0 : 0.0;
    return found / count;
  };
  EXPECT_NEAR(part({ellipse, {2.0, 2.0, 0.0}}, [](const Vec3d& p) { return glm::dot(p, p) < 0.5; }), 0.5,
              1e-3);
  EXPECT_NEAR(part({box, {1.2, 0.5, 0.3}}, [](const Vec3d& p) { return p.z > 0.1499999; }),
              0.6 / (2.0 * (0.6 + 0.15 + 0.36)), 1e-3);
  EXPECT_NEAR(
      part({cylinder_along_x, {2.0, 0.2, 0.2}}, [](const Vec3d& p) { return std::abs(p.x) > 0.9999999; }),
      2.0 * 0.01 / (2.0 * 0.01 + 0.4), 1e-3);
  EXPECT_NEAR(part({ellipsoid, {2.0, 2.0, 2.0}}, [](const Vec3d& p) { return p.x > 0.5; }), 0.25, 1e-3);
}

}  // namespace
}  // namespace luxel
