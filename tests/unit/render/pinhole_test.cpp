// SPDX-License-Identifier: Apache-2.0
// Places at which the rays of a pixel pass through it.
#include "luxel/render/pinhole.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "luxel/core/address.h"

namespace luxel {
namespace {

// A wall one metre off, 100 pixels to the metre.
constexpr int width = 300, height = 200;
Pinhole facing() {
  const auto fov = static_cast<float>(2.0 * std::atan(1.0) * 180.0 / 3.14159265358979323846);
  return {{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, fov}, width, height};
}

Vec2 place_on_picture(const Ray& ray) {
  const auto scale = -100.0f / ray.direction.z;
  return {0.5f * width + scale * ray.direction.x, 0.5f * height - scale * ray.direction.y};
}

TEST(Pinhole, rays_of_a_pixel_fill_its_cells_its_columns_and_its_rows) {
  const auto pinhole = facing();
  for (int side = 1; side <= 6; ++side)
    for (std::uint32_t pixel = 0; pixel < 50; ++pixel) {
      const auto column = static_cast<int>(pixel * 5), row = static_cast<int>(pixel * 3);
      std::set<int> cells, columns, rows;
      for (int cell = 0; cell < side * side; ++cell) {
        const auto at =
            place_on_picture(pinhole.ray_in_cell(column, row, stream_key(1, 0, pixel), cell, side));
        const auto x = at.x - static_cast<float>(column), y = at.y - static_cast<float>(row);
        const auto fine = [&](float u, int parts) {
          return static_cast<int>(std::floor(u * static_cast<float>(parts)));
        };
        cells.insert(fine(y, side) * side + fine(x, side));
        columns.insert(fine(x, side * side));
        rows.insert(fine(y, side * side));
      }
      const auto all = static_cast<std::size_t>(side * side);
      EXPECT_GE(cells.size() + 1, all) << side;  // a place on a border may be rounded into the next one
      EXPECT_GE(columns.size() + 1, all) << side;
      EXPECT_GE(rows.size() + 1, all) << side;
    }
}

// The mean over the pixels along an upright edge is the fraction that the edge leaves, and one pixel is
// within one sample of it: the staircase of an edge is not noisier than its rays are fine.
TEST(Pinhole, upright_edges_are_smooth) {
  const auto pinhole = facing();
  constexpr int side = 3;
  for (const float edge : {0.1f, 0.35f, 0.5f, 0.82f})
    for (std::uint32_t pixel = 0; pixel < 100; ++pixel) {
      int left = 0;
      for (int cell = 0; cell < side * side; ++cell)
        left += place_on_picture(pinhole.ray_in_cell(40, pixel, stream_key(1, 0, pixel), cell, side)).x <
                40.0f + edge;
      EXPECT_LE(std::fabs(static_cast<float>(left) - edge * side * side), 1.001f) << edge;
    }
}

}  // namespace
}  // namespace luxel
