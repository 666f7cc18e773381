// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/render.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

#include "luxel/core/address.h"
#include "luxel/core/error.h"
#include "luxel/patch/colour_patches.h"
#include "luxel/render/pinhole.h"
#include "luxel/scene/band_colours.h"
#include "luxel/solution/solution_file.h"
#include "luxel/surface/smooth_irradiance.h"

namespace luxel {
namespace {

constexpr int max_samples_per_side = 64;
constexpr std::size_t rays_between_calls =
    1u
    // between polls of the monitor: about a tenth of a second on two cores
    << 18;
constexpr std::size_t pixels_per_chunk = 64;

void check(const PatchSet& patches, const SmoothLight& light, const RenderOptions& options) {
  if (light.corners.size() != patches.size())
    throw MismatchError(
        fmt::format("the smooth light is of {} patches but the scene has {}: make it from "
                    "this scene's solution",
                    light.corners.size(), patches.size()));
  if (options.samples_per_side < 1 || options.samples_per_side > max_samples_per_side)
    throw InputError(fmt::format("samples_per_side must be from 1 to {}, but it is {}", max_samples_per_side,
                                 options.samples_per_side));
}

// Constant data of a picture.
struct Shot {
  const PatchSet& patches;
  const SmoothLight& light;
  const Tracer& tracer;
  const Pinhole& pinhole;
  const RenderOptions& options;
  const BandColours& colours;
  const FineColours& fine;
  Vec3d sky;  // W/(m² sr)
};

// here: scratch, [band].
Vec3d radiance_at(const Shot& shot, const Hit& hit, std::vector<float>& here) {
  if (!hit) return shot.sky;
  for (std::size_t band = 0; band < here.size(); ++band)
    here[band] = smooth_irradiance<float>(shot.light, hit.side(), {hit.u, hit.v}, band, here.size());
  const auto fraction = texture_ratio_at(shot.patches, shot.fine, hit.patch, hit.u, hit.v);
  return radiance_of(shot.patches.material_of(hit.patch), hit.back, here.data(), shot.colours, fraction);
}

// The mean over the pixel's square (a box filter), one jittered sample in each cell of a grid.
Vec3 pixel_radiance(const Shot& shot, int x, int y, std::vector<float>& scratch) {
  const auto side = shot.options.samples_per_side;
  const auto pixel = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(shot.options.width) +
                     static_cast<std::uint32_t>(x);
  const auto key = stream_key(shot.options.seed, 0, pixel);
  Vec3d sum(0.0);
  for (int cell = 0; cell < side * side; ++cell) {
    const auto jitter = uniform4(key, static_cast<std::uint64_t>(cell));
    const auto dx = (cell % side + static_cast<double>(jitter[0])) / side;
    const auto dy = (cell / side + static_cast<double>(jitter[1])) / side;
    sum += radiance_at(shot, shot.tracer.nearest(shot.pinhole.ray(x + dx, y + dy)), scratch);
  }
  return in_gamut(sum / static_cast<double>(side * side));
}

}  // namespace

Image render(const PatchSet& patches, const SmoothLight& light, const Tracer& tracer, const Camera& camera,
             const RenderOptions& options, const Context& context) {
  check(patches, light, options);
  const Pinhole pinhole(camera, options.width, options.height);
  const auto colours = patches.colours();
  const auto& sky = patches.sky;
  const FineColours fine(patches, context);
  const Shot shot{patches, light,   tracer, pinhole,
                  options, colours, fine,   sky.empty() ? Vec3d(0.0) : colours.rgb(sky)};
  Image picture(options.width, options.height);

  const auto width = static_cast<std::size_t>(options.width);
  const auto height = static_cast<std::size_t>(options.height);
  const auto rays_per_row =
      width * static_cast<std::size_t>(options.samples_per_side * options.samples_per_side);
  const auto band_rows = std::max<std::size_t>(1, rays_between_calls / rays_per_row);
  for (std::size_t row = 0; row < height; row += band_rows) {
    const Progress progress{"picture", static_cast<double>(row) / static_cast<double>(height),
                            row * rays_per_row};
    if (context.report(progress) == Next::stop) return picture;
    const auto first = row * width;
    const auto count = std::min(band_rows, height - row) * width;
    context.for_chunks(count, pixels_per_chunk, [&](std::size_t begin, std::size_t end, int) {
      std::vector<float> scratch(colours.bands());
      for (auto i = first + begin; i < first + end; ++i)
        picture.pixels[i] =
            pixel_radiance(shot, static_cast<int>(i % width), static_cast<int>(i / width), scratch);
    });
  }
  context.report({"picture", 1.0, height * rays_per_row});
  return picture;
}

Image render(const Baked& baked, const Camera& camera, const RenderOptions& options, const Context& context) {
  const Tracer tracer(baked.patches, context);
  const auto light = make_smooth_light(baked.patches, baked.solution, {}, context);
  return render(baked.patches, light, tracer, camera, options, context);
}

}  // namespace luxel
