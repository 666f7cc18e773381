// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/smallest_rectangle.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace luxel {
namespace {

// Corners and points inside a rectangle of 3 x 1, turned and moved.
std::vector<glm::dvec2> turned(double angle) {
  std::vector<glm::dvec2> points;
  const glm::dvec2 x(std::cos(angle), std::sin(angle)), y(-x.y, x.x);
  for (const double u : {0.0, 1.0, 3.0})
    for (const double v : {0.0, 0.25, 1.0}) points.push_back(glm::dvec2(5.0, -2.0) + u * x + v * y);
  return points;
}

TEST(SmallestRectangle, lies_along_the_points) {
  for (const double angle : {0.3, 1.2, 2.0, -0.7}) {
    const auto found = smallest_rectangle(turned(angle));
    EXPECT_NEAR(std::abs(glm::dot(found.along, glm::dvec2(std::cos(angle), std::sin(angle)))), 1.0, 1e-12);
    EXPECT_NEAR(found.box.size().x, 3.0, 1e-12);
    EXPECT_NEAR(found.box.size().y, 1.0, 1e-12);
  }
}

TEST(SmallestRectangle, keeps_the_axes_where_nothing_is_smaller) {
  const auto square = smallest_rectangle({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  EXPECT_EQ(square.along, glm::dvec2(1.0, 0.0));
}

}  // namespace
}  // namespace luxel
