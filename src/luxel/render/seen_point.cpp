// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/seen_point.h"

#include "luxel/core/address.h"
#include "luxel/scene/band_colours.h"

namespace luxel {

SeenPoints::Batch::Batch(std::uint64_t batch_key, std::uint32_t side)
    : key(batch_key),
      pixel(key, 0, side),
      direction(key, 1, side),
      lamp(key, 2, side),
      choice(key, 3, side) {}

std::uint64_t SeenPoints::Batch::path_key(std::uint32_t i) const { return luxel::path_key(key, i); }

SeenPoints::SeenPoints(const PatchSet& patches, const Tracer& tracer, const Camera& camera, int width,
                       int height, const Context& context)
    : patches_(patches),
      tracer_(tracer),
      pinhole_(camera, width, height),
      colours_(patches.colours()),
      fine_(patches, context),
      luminaires_(patches, colours_),
      sky_(patches, colours_),
      panes_(patches, colours_),
      width_(static_cast<std::size_t>(width)),
      height_(static_cast<std::size_t>(height)) {}

SeenPoints::Numbers SeenPoints::numbers_of(const Batch& batch, std::uint32_t i, std::uint64_t path_key) {
  // A counter that the vertices of the path do not reach.
  const auto u = uniform4(path_key, ~std::uint64_t{0});
  const auto v = uniform4(path_key, ~std::uint64_t{1});
  const auto direction = batch.direction.pair(i, u[2], u[3]);
  const auto lamp = batch.lamp.pair(i, v[0], v[1]);
  return {batch.pixel.pair(i, u[0], u[1]),
          {{direction.x, direction.y}, {batch.choice.number(i, v[2]), lamp.x, lamp.y}}};
}

Ray SeenPoints::ray_of(std::size_t pixel, const Vec2& at) const {
  const auto x = static_cast<double>(pixel % width_) + static_cast<double>(at.x);
  const auto y = static_cast<double>(pixel / width_) + static_cast<double>(at.y);
  return pinhole_.ray(x, y);
}

}  // namespace luxel
