// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/sky_look.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "luxel/core/address.h"
#include "luxel/render/pane_colours.h"
#include "luxel/render/pinhole.h"
#include "luxel/render/render.h"
#include "luxel/scene/band_colours.h"

namespace luxel {
namespace {

constexpr std::size_t pixels_per_chunk = 256;

// Unit vector of the camera's up direction; zero where up is zero.
Vec3d zenith_of(const Camera& camera) {
  const auto length = glm::length(Vec3d(camera.up));
  return length > 0.0 ? Vec3d(camera.up) / length : Vec3d(0.0);
}

}  // namespace

double ground_look(const PatchSet& patches) { return std::min(SkyLook::below, patches.ground_over_sky()); }

Vec3d sky_look(const Vec3d& radiance, double ground, double height) {
  using S = SkyLook;
  if (height < 0.0) return glm::mix(1.0, ground, std::min(1.0, -height / S::haze)) * radiance;
  const auto low = 1.0 - std::min(1.0, height);
  return glm::mix(Vec3d(S::zenith[0], S::zenith[1], S::zenith[2]), Vec3d(1.0), low * low * low * low * low) *
         radiance;
}

DisplayedSky::DisplayedSky(const PatchSet& patches, const Camera& camera)
    : colours_(patches, patches.colours()), zenith_(zenith_of(camera)), ground_(ground_look(patches)) {}

Vec3d DisplayedSky::at(const Vec3d& direction) const {
  return colours_.is_even_above() ? sky_look(colours_.above(), ground_, glm::dot(direction, zenith_))
                                  : colours_.at(direction);
}

void add_sky(const SkyPixel& pixel, SkyPixels& sky) {
  sky.pixels.push_back(pixel.pixel);
  sky.fraction.push_back(static_cast<float>(pixel.fraction));
  sky.radiance.push_back(in_gamut(pixel.radiance));
}

void append(const SkyPixels& more, SkyPixels& sky) {
  sky.pixels.insert(sky.pixels.end(), more.pixels.begin(), more.pixels.end());
  sky.fraction.insert(sky.fraction.end(), more.fraction.begin(), more.fraction.end());
  sky.radiance.insert(sky.radiance.end(), more.radiance.begin(), more.radiance.end());
}

namespace {

SkyPixels sky_pixels(const Image& radiance, const PatchSet& patches, const Tracer& tracer,
                     const Camera& camera, const RenderOptions& options, const Context& context) {
  const Pinhole pinhole(camera, radiance.width, radiance.height);
  const DisplayedSky sky(patches, camera);
  const PaneColours panes(patches, patches.colours());
  const auto side = options.samples_per_side;
  const auto width = static_cast<std::size_t>(radiance.width);
  std::vector<SkyPixels> chunks((radiance.pixels.size() + pixels_per_chunk - 1) / pixels_per_chunk);
  const auto add = [&](std::size_t pixel, SkyPixels& found) {
    const auto key = stream_key(options.seed, 0, static_cast<std::uint32_t>(pixel));
    int seen = 0;
    Vec3d shown(0.0);
    for (int cell = 0; cell < side * side; ++cell) {
      const auto ray = pinhole.ray_in_cell(static_cast<double>(pixel % width),
                                           static_cast<double>(pixel / width), key, cell, side);
      if (tracer.nearest(ray)) continue;
      ++seen;
      if (!sky.colours().is_even_above()) continue;  // displayed as it is
      const Vec3d direction(ray.direction);
      shown += panes.along(ray, std::numeric_limits<float>::infinity()) *
               (sky.at(direction) - sky.colours().at(direction));
    }
    if (seen == 0) return;
    const double samples = side * side;
    add_sky(
        {static_cast<std::uint32_t>(pixel), seen / samples, Vec3d(radiance.pixels[pixel]) + shown / samples},
        found);
  };
  context.for_chunks(radiance.pixels.size(), pixels_per_chunk, [&](std::size_t begin, std::size_t end, int) {
    for (auto i = begin; i < end; ++i) add(i, chunks[begin / pixels_per_chunk]);
  });
  SkyPixels all;
  for (const auto& chunk : chunks) append(chunk, all);
  return all;
}

}  // namespace

Picture with_sky(Image radiance, const PatchSet& patches, const Tracer& tracer, const Camera& camera,
                 const RenderOptions& options, const Context& context) {
  Picture picture{std::move(radiance), {}, {}};
  if (patches.has_sky())
    picture.sky = sky_pixels(picture.radiance, patches, tracer, camera, options, context);
  return picture;
}

}  // namespace luxel
