// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/texture.h"

#include <algorithm>
#include <cmath>

namespace luxel {
namespace {

// In pixels; beyond the coordinates of any surface, and small enough that integers stay exact.
double pixels_along(float place, int count) {
  constexpr double farthest_pixel = 1e15;
  const auto pixels = static_cast<double>(place) * count;
  return std::isfinite(pixels) ? std::clamp(pixels, -farthest_pixel, farthest_pixel) : 0.0;
}

int pixel_along(double pixels, int count, Wrap wrap) {
  return static_cast<int>(wrapped(static_cast<std::int64_t>(std::floor(pixels)), count, wrap));
}

}  // namespace

std::int64_t wrapped(std::int64_t pixel, std::int64_t count, Wrap wrap) {
  if (wrap == Wrap::clamp) return std::clamp<std::int64_t>(pixel, 0, count - 1);
  const auto period = wrap == Wrap::mirror ? 2 * count : count;
  auto within = pixel % period;
  if (within < 0) within += period;
  return within < count ? within : period - 1 - within;
}

std::size_t pixel_at(const Raster& raster, const TextureUse& use, const Vec2& place) {
  return raster.index(pixel_along(pixels_along(place.x, raster.width), raster.width, use.wrap[0]),
                      pixel_along(pixels_along(place.y, raster.height), raster.height, use.wrap[1]));
}

Vec3 colour_at(const Raster& raster, const TextureUse& use, const Vec2& place) {
  const auto x = pixels_along(place.x, raster.width) - 0.5;
  const auto y = pixels_along(place.y, raster.height) - 0.5;
  const auto left = pixel_along(x, raster.width, use.wrap[0]);
  const auto right = pixel_along(x + 1.0, raster.width, use.wrap[0]);
  const auto top = pixel_along(y, raster.height, use.wrap[1]);
  const auto bottom = pixel_along(y + 1.0, raster.height, use.wrap[1]);
  const auto s = static_cast<float>(x - std::floor(x)), t = static_cast<float>(y - std::floor(y));
  const auto row = [&](int at) {
    return (1.0f - s) * raster.colour(raster.index(left, at)) + s * raster.colour(raster.index(right, at));
  };
  return (1.0f - t) * row(top) + t * row(bottom);
}

}  // namespace luxel
