// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/path_picture.h"

#include <cmath>
#include <vector>

#include "luxel/core/address.h"
#include "luxel/core/warp.h"
#include "luxel/render/seen_point.h"
#include "luxel/scene/band_colours.h"

namespace luxel {
namespace {

constexpr std::size_t values = 6;  // radiance, and its reflected part
constexpr std::size_t reflected = 3;

double whole_error(const BatchMeans& means) {
  double variance = 0.0;
  double squared_light = 0.0;
  for (std::size_t pixel = 0; pixel < means.elements(); ++pixel)
    for (auto v = reflected; v < values; ++v) {
      variance += means.variance(pixel, v);
      squared_light += means.mean(pixel, v) * means.mean(pixel, v);
    }
  return squared_light > 0.0 ? std::sqrt(variance / squared_light) : 0.0;
}

}  // namespace

PathPicture trace_picture(const PatchSet& patches, const Tracer& tracer, const Camera& camera,
                          const PictureSize& size, const PathOptions& options, const Context& context) {
  const SeenPoints seen(patches, tracer, camera, size.width, size.height, context);
  const LightPaths paths(patches, tracer);
  BatchMeans means(seen.pixels(), values);
  // With bounces from patches, the light of a patch does not depend on the point.
  const auto anywhere_on = [&](const SurfacePoint& x, std::uint64_t key) {
    const auto u = uniform4(key, ~std::uint64_t{2});
    return surface_point(patches, x.patch, x.back, uniform_triangle(u[0], u[1]));
  };
  const auto draw = [&](std::size_t pixel, std::uint64_t index, std::span<double> sums) {
    const auto pixel_key =
        stream_key(options.seed, RandomPurpose::traced_pixels, static_cast<std::uint32_t>(pixel));
    const SeenPoints::Batch batch(nth_key(pixel_key, index), BatchMeans::batch_side);
    std::uint64_t rays = 0;
    SeenPoints::Sums light;
    std::vector<double> weight(seen.bands());
    for (std::uint32_t i = 0; i < BatchMeans::batch_paths; ++i)
      seen.look(
          pixel, batch, i, light,
          [&](const SurfacePoint& x, const VertexNumbers& first, std::uint64_t key, std::span<double> H) {
            const auto from = options.bounces_from == BouncesFrom::patches ? anywhere_on(x, key) : x;
            rays += paths.irradiance(from, first, key, options.bounces_from, weight, H).rays;
          });
    for (std::size_t c = 0; c < reflected; ++c) {
      sums[c] += light.radiance[static_cast<int>(c)];
      sums[reflected + c] += light.reflected[static_cast<int>(c)];
    }
    return rays;
  };

  PathPicture picture;
  picture.stop = means.run(options.limits, draw, whole_error, context, "picture");
  picture.complete = means.complete();
  picture.paths = means.batches(0) * BatchMeans::batch_paths;
  picture.rays = means.rays();
  picture.error = whole_error(means);
  picture.radiance = Image(size.width, size.height);
  picture.standard_error = Image(size.width, size.height);
  for (std::size_t pixel = 0; pixel < seen.pixels(); ++pixel) {
    picture.radiance.pixels[pixel] =
        in_gamut({means.mean(pixel, 0), means.mean(pixel, 1), means.mean(pixel, 2)});
    for (int band = 0; band < 3; ++band) {
      const auto b = static_cast<std::size_t>(band);
      picture.standard_error.pixels[pixel][band] =
          static_cast<float>(widening_of(means.batches(pixel)) * std::sqrt(means.variance(pixel, b)));
    }
  }
  return picture;
}

}  // namespace luxel
