// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/render/light_paths.h"
#include "luxel/render/pinhole.h"
#include "luxel/render/strata.h"

namespace luxel {

// What a picture's pixels see, and the numbers they look with. Read-only: any number of threads may ask.
class SeenPoints {
 public:
  // Keeps references. Throws MismatchError where the bands have no colour (PatchSet::colours), and what
  // Pinhole throws.
  SeenPoints(const PatchSet& patches, const Tracer& tracer, const Camera& camera, int width, int height);

  std::size_t pixels() const { return width_ * height_; }
  std::size_t bands() const { return colours_.bands(); }

  // Samples that belong together: side² of them, spread evenly over the pixel, directions and lamps.
  struct Batch {
    Batch(std::uint64_t batch_key, std::uint32_t side);
    std::uint64_t path_key(std::uint32_t i) const;
    std::uint64_t key;
    Strata pixel, direction, lamp, choice;
  };

  // Asks irradiance(point, numbers, path key, H) for the light that arrives where sample i of a pixel meets a
  // surface; H: [band], 0 at first, kept in `scratch`. Adds the colour of what leaves towards the eye, or the
  // sky's, to radiance, and of the part of it that is reflected to reflected; W/(m² sr), linear RGB.
  template <typename Irradiance>
  void look(std::size_t pixel, const Batch& batch, std::uint32_t i, Vec3d& radiance, Vec3d& reflected,
            std::vector<double>& scratch, const Irradiance& irradiance) const {
    const auto path_key = batch.path_key(i);
    const auto numbers = numbers_of(batch, i, path_key);
    const auto hit = hit_of(pixel, numbers.pixel);
    if (!hit) radiance += sky_;
    if (!hit || !is_reflecting(patches_, hit.patch, hit.back)) return;
    scratch.assign(bands(), 0.0);
    irradiance(surface_point(patches_, hit.patch, hit.back, {hit.u, hit.v}), numbers.vertex, path_key,
               std::span<double>(scratch));
    for (std::size_t b = 0; b < bands(); ++b) {
      const auto back_to_eye = static_cast<double>(patches_.reflectance(hit.patch, b)) * scratch[b] * per_pi;
      const auto own = hit.back ? 0.0 : static_cast<double>(patches_.emittance(hit.patch, b)) * per_pi;
      radiance += (own + back_to_eye) * colours_.of(b);
      reflected += back_to_eye * colours_.of(b);
    }
  }

 private:
  static constexpr double per_pi = 0.31830988618379067;
  struct Numbers {
    Vec2 pixel;
    VertexNumbers vertex;
  };
  static Numbers numbers_of(const Batch& batch, std::uint32_t i, std::uint64_t path_key);
  Hit hit_of(std::size_t pixel, const Vec2& at) const;

  const PatchSet& patches_;
  const Tracer& tracer_;
  Pinhole pinhole_;
  BandColours colours_;
  Vec3d sky_;  // W/(m² sr), linear RGB
  std::size_t width_, height_;
};

}  // namespace luxel
