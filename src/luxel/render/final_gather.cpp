// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/final_gather.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "luxel/core/address.h"
#include "luxel/core/error.h"
#include "luxel/render/seen_point.h"

namespace luxel {
namespace {

constexpr std::size_t samples_between_calls =
    1 << 17;  // between polls of the monitor; each traces two to three rays
constexpr std::size_t pixels_per_chunk = 16;
constexpr int max_rays = 65536;

void check(const PatchSet& patches, const Solution& solution, const GatherOptions& options) {
  if (solution.radiosity.front.size() != patches.size() * patches.band_count() ||
      solution.radiosity.back.size() != solution.radiosity.front.size())
    throw MismatchError(
        fmt::format("the solution's light is not of these {} patches: solve this scene", patches.size()));
  if (options.rays < 1 || options.rays > max_rays)
    throw InputError(
        fmt::format("a final gather takes 1 to {} rays per pixel, not {}", max_rays, options.rays));
}

}  // namespace

std::uint32_t gather_grid(int rays) {
  std::uint32_t side = 1;
  while (side * side < static_cast<std::uint32_t>(rays)) ++side;
  return side;
}

Image gather_picture(const PatchSet& patches, const Solution& solution, const Tracer& tracer,
                     const Camera& camera, const GatherOptions& options, const Context& context) {
  check(patches, solution, options);
  const SeenPoints seen(patches, tracer, camera, options.width, options.height, context);
  const LightPaths paths(patches, tracer);
  const auto side = gather_grid(options.rays);
  const auto samples = side * side;
  const auto bands = seen.bands();
  const std::vector<double> one(bands, 1.0);

  // Irradiance at x: direct light from lamps and sky, plus the light reflected where the cosine ray hits.
  const auto gather = [&](const SurfacePoint& x, const VertexNumbers& numbers, std::uint64_t,
                          std::span<double> H) {
    const auto trail = paths.direct(x, numbers, one, H);
    const auto& hit = trail.first;
    if (!hit || !is_reflecting(patches, hit.patch, hit.back)) return;
    for (std::size_t b = 0; b < bands; ++b) {
      const auto at = bands * hit.patch + b;
      const auto reflected = hit.back ? static_cast<double>(solution.radiosity.back[at])
                                      : static_cast<double>(solution.radiosity.front[at]) -
                                            static_cast<double>(patches.emittance(hit.patch, b));
      H[b] += in_band(trail.through, b) * reflected;
    }
  };
  const auto radiance_of_pixel = [&](std::size_t pixel) {
    const SeenPoints::Batch batch(
        stream_key(options.seed, RandomPurpose::final_gather, static_cast<std::uint32_t>(pixel)), side);
    SeenPoints::Sums sums;
    for (std::uint32_t i = 0; i < samples; ++i) seen.look(pixel, batch, i, sums, gather);
    return in_gamut(sums.radiance / static_cast<double>(samples));
  };

  Image picture(options.width, options.height);
  const auto width = static_cast<std::size_t>(options.width);
  const auto rows = std::max<std::size_t>(1, samples_between_calls / (width * samples));
  for (std::size_t first = 0; first < seen.pixels(); first += rows * width) {
    const auto fraction = static_cast<double>(first) / static_cast<double>(seen.pixels());
    if (context.report({"picture", fraction, 3 * samples * first}) == Next::stop) return picture;
    context.for_chunks(std::min(rows * width, seen.pixels() - first), pixels_per_chunk,
                       [&](std::size_t begin, std::size_t end, int) {
                         for (auto i = first + begin; i < first + end; ++i)
                           picture.pixels[i] = radiance_of_pixel(i);
                       });
  }
  context.report({"picture", 1.0, 3 * samples * seen.pixels()});
  return picture;
}

}  // namespace luxel
