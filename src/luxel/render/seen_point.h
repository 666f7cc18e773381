// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "luxel/core/address.h"
#include "luxel/core/context.h"
#include "luxel/patch/colour_patches.h"
#include "luxel/render/light_paths.h"
#include "luxel/render/pane_colours.h"
#include "luxel/render/pinhole.h"
#include "luxel/render/sky_colours.h"
#include "luxel/render/strata.h"
#include "luxel/render/visible_luminaires.h"
#include "luxel/scene/band_colours.h"

namespace luxel {

// The surface points seen by a picture's pixels, and the random numbers of their rays. Read-only: any number
// of threads may call.
class SeenPoints {
 public:
  // Keeps references. Throws MismatchError where the bands have no colour (PatchSet::colours), and what
  // Pinhole throws.
  SeenPoints(const PatchSet& patches, const Tracer& tracer, const Camera& camera, int width, int height,
             const Context& context);

  std::size_t pixels() const { return width_ * height_; }
  std::size_t bands() const { return colours_.bands(); }

  // Samples that belong together: side² of them, spread evenly over the pixel, directions and lamps.
  struct Batch {
    Batch(std::uint64_t batch_key, std::uint32_t side);
    std::uint64_t path_key(std::uint32_t i) const;
    std::uint64_t key;
    Strata pixel, direction, lamp, choice;
  };

  // Sums over samples, W/(m² sr), linear RGB, and memory for H.
  struct Sums {
    Vec3d radiance{0.0};
    Vec3d reflected{0.0};  // the part of it that is not of lamps or sky
    std::vector<double> scratch;
  };

  // Calls irradiance(point, numbers, path key, H) for the light that arrives where sample i of a pixel meets
  // a surface, and on the other side of a diffuser; H: [band], 0 at first. Adds the colour of what leaves
  // towards the eye, with the textures' detail there, or the sky's, to the sums.
  template <typename Irradiance>
  void look(std::size_t pixel, const Batch& batch, std::uint32_t i, Sums& sums,
            const Irradiance& irradiance) const {
    const auto path_key = batch.path_key(i);
    const auto numbers = numbers_of(batch, i, path_key);
    const auto ray = ray_of(pixel, numbers.pixel);
    const auto hit = tracer_.nearest(ray);
    if (!luminaires_.empty())
      if (const auto lamp = luminaires_.first(ray, hit.distance)) {
        sums.radiance += panes_.along(ray, lamp->distance) * lamp->radiance;
        return;
      }
    const auto through = panes_.along(ray, hit.distance);
    if (!hit) sums.radiance += through * sky_.at(Vec3d(ray.direction));
    if (!hit || !is_reflecting(patches_, hit.patch, hit.back)) return;
    auto& scratch = sums.scratch;
    scratch.assign(2 * bands(), 0.0);
    irradiance(surface_point(patches_, hit.patch, hit.back, {hit.u, hit.v}), numbers.vertex, path_key,
               std::span<double>(scratch).first(bands()));
    if (patches_.material_of(hit.patch).is_diffuser())
      irradiance(surface_point(patches_, hit.patch, !hit.back, {hit.u, hit.v}), numbers.vertex,
                 nth_key(path_key, 1), std::span<double>(scratch).last(bands()));
    Vec3d reflected(0.0), transmitted(0.0), emitted(0.0);
    for (std::size_t b = 0; b < bands(); ++b) {
      const auto colour = per_pi * colours_.of(b);
      reflected += static_cast<double>(patches_.reflectance(hit.patch, b)) * scratch[b] * colour;
      transmitted +=
          static_cast<double>(patches_.diffuse_transmittance(hit.patch, b)) * scratch[bands() + b] * colour;
      if (!hit.back) emitted += static_cast<double>(patches_.emittance(hit.patch, b)) * colour;
    }
    reflected *= Vec3d(fine_.reflectance(hit.patch, hit.u, hit.v));
    emitted *= Vec3d(fine_.emittance(hit.patch, hit.u, hit.v));
    sums.radiance += through * (emitted + reflected + transmitted);
    sums.reflected += through * (reflected + transmitted);
  }

 private:
  static constexpr double per_pi = 0.31830988618379067;
  struct Numbers {
    Vec2 pixel;
    VertexNumbers vertex;
  };
  static Numbers numbers_of(const Batch& batch, std::uint32_t i, std::uint64_t path_key);
  Ray ray_of(std::size_t pixel, const Vec2& at) const;

  const PatchSet& patches_;
  const Tracer& tracer_;
  Pinhole pinhole_;
  BandColours colours_;
  FineColours fine_;
  VisibleLuminaires luminaires_;
  SkyColours sky_;
  PaneColours panes_;
  std::size_t width_, height_;
};

}  // namespace luxel
