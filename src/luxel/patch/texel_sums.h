// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "luxel/scene/texture.h"

namespace luxel {

// What a texture is in the mean over a triangle: exactly so for pixels of even colour, linear, over the area.
class TexelSums {
 public:
  // What is less opaque than the threshold is a hole, and has no say in the mean colour. Keeps the raster.
  // Cost: 10 ns a pixel.
  TexelSums(std::shared_ptr<const Raster> raster, std::array<Wrap, 2> wrap,
            std::optional<float> threshold = {});

  struct Mean {
    Vec3 colour = Vec3(0.0f);  // of what is not a hole; of all where all is
    float covered = 1.0f;      // the share that is not a hole
  };
  // places: of the corners on the picture (TextureUse::place), either way round. A triangle without area
  // there gives the mean along its longest side; one that lies over the picture dozens of times, that of the
  // whole picture. Cost: about 50 ns for each row of pixels and each pixel on the border.
  Mean over(const std::array<Vec2, 3>& places) const;
  const Mean& whole() const { return whole_; }

 private:
  struct Sum {
    Vec3d colour = Vec3d(0.0);
    double covered = 0.0, area = 0.0;
  };
  using Polygon = std::vector<std::array<double, 2>>;

  Sum pixel(std::int64_t x, std::int64_t y) const;
  Sum run(std::int64_t row, std::int64_t x) const;  // from column 0 to before x, which may be below 0
  Sum within(std::size_t row, std::int64_t x) const;
  Sum of_row(const Polygon& part, std::int64_t row) const;
  Sum over_area(const Polygon& triangle) const;
  Sum along(const Polygon& triangle) const;
  static Mean mean_of(const Sum& sum, const Mean& otherwise);

  std::shared_ptr<const Raster> raster_;
  std::array<Wrap, 2> wrap_;
  std::optional<float> threshold_;
  std::size_t blocks_ = 0;   // a row
  std::vector<Sum> before_;  // [row][block]: of the row's pixels before the block; the last one: all of them
  Mean whole_;
};

}  // namespace luxel
