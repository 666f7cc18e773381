// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/scene/texture.h"

namespace luxel {

// The mean of a texture over a triangle, in linear light: exact for pixels of even colour, but for the
// rounding of doubles, whatever the triangle's size. Immutable once made, and then safe to use from many
// threads. Memory: 8 bytes per pixel.
//
// The integral over the triangle is, by Green's theorem, that of the row's sum from column 0 to the edge,
// along the three edges (dy). These sums come from a table per row (a summed-area table in one direction; F.
// C. Crow, "Summed-Area Tables for Texture Mapping", SIGGRAPH 1984). So the cost grows with the triangle's
// outline in pixels, not with its area.
class TexelSums {
 public:
  // threshold: pixels of less alpha are holes, and have no part in the mean colour. Cost: 15 ns per pixel and
  // thread.
  TexelSums(std::shared_ptr<const Raster> raster, std::array<Wrap, 2> wrap,
            std::optional<float> threshold = {}, const Context& context = Context());

  struct Mean {
    Vec3 colour = Vec3(0.0f);  // of what is not a hole; of all where all is
    float covered = 1.0f;      // the share that is not a hole
  };
  // places: of the corners on the picture (TextureUse::place), either way round. A triangle without area
  // there gives the mean along its longest side; one that lies over the picture dozens of times, that of the
  // whole picture. Cost: about 25 ns for each row of pixels that an edge crosses, and 5 ns for each column.
  Mean over(const std::array<Vec2, 3>& places) const;
  const Mean& whole() const { return whole_; }

 private:
  using Sum = glm::dvec4;    // red, green, blue of what is no hole, and how much that is
  using Point = glm::dvec2;  // pixels: x to the right, y down
  using Triangle = std::array<Point, 3>;

  // The data of a row for some of its pixels, in one cache line of the processor.
  static constexpr std::int64_t block = 8;  // pixels
  struct alignas(64) Block {
    Sum before{0.0};                        // of the row's pixels before the block
    std::array<Raster::Code, block> codes;  // where the raster has codes
  };
  class Row;

  Sum value(const Raster::Code& code) const;
  Sum value(const Vec3& colour) const;
  Row row_at(std::int64_t y) const;
  Sum along_edge(const Point& a, const Point& b) const;
  Sum along_side(const Triangle& triangle) const;
  static Mean mean_of(const Sum& sum, double area, const Mean& otherwise);

  std::shared_ptr<const Raster> raster_;
  std::array<Wrap, 2> wrap_;
  int first_solid_ = 0;                // smallest alpha code that is no hole; 256 where all are
  std::array<double, 256> decoded_{};  // linear sRGB of an 8-bit code, as Raster::colour has it
  std::vector<Block> table_;           // [block][row]: edges mostly go down
  Mean whole_;
};

}  // namespace luxel
