// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/raster_colours.h"

#include <algorithm>

namespace luxel {
namespace {

std::size_t pixels_of(const Raster& raster) { return raster.index(0, raster.height); }

float metal_at(const Raster& metal, std::size_t pixel) {
  if (metal.codes.empty()) return std::clamp(metal.linear[pixel].b, 0.0f, 1.0f);
  return static_cast<float>(metal.codes[pixel][2]) / 255.0f;
}

// Returns the pixel of `other` at the place of (x, y).
std::size_t pixel_there(const Raster& other, const Raster& raster, int x, int y) {
  const auto along = [](int at, int count, int other_count) {
    return static_cast<int>((2 * std::int64_t{at} + 1) * other_count / (2 * std::int64_t{count}));
  };
  return other.index(along(x, raster.width, other.width), along(y, raster.height, other.height));
}

}  // namespace

Vec3 mean_colour(const Raster& raster) {
  Vec3d sum(0.0);
  for (std::size_t i = 0; i < pixels_of(raster); ++i) sum += Vec3d(raster.colour(i));
  return glm::max(Vec3(sum / static_cast<double>(std::max<std::size_t>(pixels_of(raster), 1))), Vec3(0.0f));
}

float mean_alpha(const Raster& raster) {
  double sum = 0.0;
  for (std::size_t i = 0; i < pixels_of(raster); ++i) sum += raster.alpha(i);
  return static_cast<float>(sum / static_cast<double>(std::max<std::size_t>(pixels_of(raster), 1)));
}

float min_alpha(const Raster& raster) {
  float least = 1.0f;
  for (std::size_t i = 0; i < pixels_of(raster); ++i) least = std::min(least, raster.alpha(i));
  return least;
}

Raster with_grey_as_alpha(const Raster& raster) {
  Raster mask;
  mask.width = raster.width;
  mask.height = raster.height;
  mask.codes.reserve(pixels_of(raster));
  for (std::size_t i = 0; i < pixels_of(raster); ++i) {
    float grey = 0.0f;
    if (raster.codes.empty())
      grey = 255.0f * std::clamp(luminance(raster.linear[i]), 0.0f, 1.0f);
    else
      grey = luminance(Vec3(raster.codes[i][0], raster.codes[i][1], raster.codes[i][2]));
    mask.codes.push_back({255, 255, 255, static_cast<std::uint8_t>(grey + 0.5f)});
  }
  return mask;
}

MetalRange metal_range(const Raster& raster) {
  MetalRange range{.least = 1.0f};
  double sum = 0.0;
  for (std::size_t i = 0; i < pixels_of(raster); ++i) {
    const auto metal = metal_at(raster, i);
    range.least = std::min(range.least, metal);
    range.most = std::max(range.most, metal);
    sum += metal;
  }
  range.mean = static_cast<float>(sum / static_cast<double>(std::max<std::size_t>(pixels_of(raster), 1)));
  return range;
}

Raster with_lowered_metal(const Raster* base, const Raster& metal, float factor, float most) {
  Raster lowered;
  lowered.width = base ? base->width : metal.width;
  lowered.height = base ? base->height : metal.height;
  const bool has_codes = !base || !base->codes.empty();
  for (int y = 0; y < lowered.height; ++y)
    for (int x = 0; x < lowered.width; ++x) {
      const auto metallic = factor * metal_at(metal, pixel_there(metal, lowered, x, y));
      const auto pixel = lowered.index(x, y);
      const auto whole = base ? base->colour(pixel) : Vec3(1.0f);
      const auto colour = whole - metallic * glm::max(whole - most, Vec3(0.0f));
      if (has_codes)
        lowered.codes.push_back({srgb_code(colour.r), srgb_code(colour.g), srgb_code(colour.b),
                                 base ? base->codes[pixel][3] : std::uint8_t{255}});
      else
        lowered.linear.push_back(colour);
    }
  return lowered;
}

}  // namespace luxel
