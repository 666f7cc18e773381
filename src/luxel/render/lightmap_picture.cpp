// SPDX-License-Identifier: Apache-2.0
#include "luxel/render/lightmap_picture.h"

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/patch/colour_patches.h"
#include "luxel/render/pane_colours.h"
#include "luxel/render/pinhole.h"
#include "luxel/render/sky_colours.h"
#include "luxel/scene/band_colours.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {
namespace {

constexpr std::size_t pixels_per_chunk = 64;

// Constant data of a picture.
struct Shot {
  const PatchSet& patches;
  const Lightmap& lightmap;
  const FineColours& fine;
  const BandColours& colours;
  const SkyColours& sky;
};

Vec3d radiance_at(const Shot& shot, const Ray& ray, const Hit& hit) {
  if (!hit) return shot.sky.at(Vec3d(ray.direction));
  const auto& atlas = shot.lightmap.atlas;
  const auto side = hit.side();
  Vec3 irradiance(0.0f);
  if (atlas.has(side)) {
    const auto& t = atlas.corners[side.index()];
    const auto at = t[0] + hit.u * (t[1] - t[0]) + hit.v * (t[2] - t[0]);
    irradiance = look_up(shot.lightmap.pages[atlas.page_of(side)].irradiance, at);
  }
  const auto fraction = texture_ratio_at(shot.patches, shot.fine, hit.patch, hit.u, hit.v);
  return radiance_of(shot.patches.material_of(hit.patch), hit.back, {&irradiance.x, &irradiance.x},
                     shot.colours, fraction);
}

}  // namespace

Image lightmap_picture(const PatchSet& patches, const Lightmap& lightmap, const Tracer& tracer,
                       const Camera& camera, const RenderOptions& options, const Context& context) {
  check_is_of(patches, lightmap);
  if (!patches.has_colours())
    throw MismatchError("a picture from a lightmap needs light that was solved in plain colour");
  if (options.samples_per_side < 1)
    throw InputError(
        fmt::format("samples_per_side must be at least 1, but it is {}", options.samples_per_side));

  const Pinhole pinhole(camera, options.width, options.height);
  const FineColours fine(patches, context);
  const auto colours = patches.colours();
  const SkyColours sky(patches, colours);
  const PaneColours panes(patches, colours);
  const Shot shot{patches, lightmap, fine, colours, sky};
  const auto side = options.samples_per_side;
  const auto width = static_cast<std::size_t>(options.width);
  Image picture(options.width, options.height);
  context.for_chunks(picture.pixels.size(), pixels_per_chunk, [&](std::size_t begin, std::size_t end, int) {
    for (auto i = begin; i < end; ++i) {
      const auto x = static_cast<double>(i % width), y = static_cast<double>(i / width);
      Vec3d sum(0.0);
      for (int cell = 0; cell < side * side; ++cell) {
        const auto ray = pinhole.ray(x + (cell % side + 0.5) / side, y + (cell / side + 0.5) / side);
        const auto hit = tracer.nearest(ray);
        sum += panes.along(ray, hit.distance) * radiance_at(shot, ray, hit);
      }
      picture.pixels[i] = in_gamut(sum / static_cast<double>(side * side));
    }
  });
  return picture;
}

}  // namespace luxel
