// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include "luxel/core/context.h"
#include "luxel/core/none.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"

namespace luxel {

struct Ray {
  Vec3 origin;     ///< m
  Vec3 direction;  ///< unit
};

struct Hit {
  std::uint32_t patch = none;
  bool back = false;                                        ///< met from behind
  float distance = std::numeric_limits<float>::infinity();  ///< m
  float u = 0.0f, v = 0.0f;  ///< barycentric: the point is (1-u-v) a + u b + v c

  explicit operator bool() const { return patch != none; }
  SideId side() const { return {patch, back}; }
};

/// Visibility: nearest hit and occlusion over the patches of a scene, by Embree (robust,
/// high-quality build, instruction set pinned, so that hosts agree to the bit). Immutable after construction;
/// every method may be called from any number of threads. Build cost about half a second per million patches;
/// memory about 150 bytes per patch.
class Tracer {
 public:
  /// Keeps no reference to patches. Throws DeviceError where Embree cannot start or runs out of memory,
  /// InputError where the patches would need more memory than is free.
  explicit Tracer(const PatchSet& patches, const Context& context = {});
  ~Tracer();
  Tracer(Tracer&&) noexcept;
  Tracer& operator=(Tracer&&) noexcept;

  Hit nearest(const Ray& ray) const;
  /// The same hits as nearest() gives one by one, bit for bit; hits.size() == rays.size().
  void nearest(std::span<const Ray> rays, std::span<Hit> hits) const;
  /// Returns whether the ray meets a surface before max_distance.
  bool occluded(const Ray& ray, float max_distance) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// How far an origin must be lifted off a patch along its normal so that rounding cannot make a ray that
/// leaves the patch hit it or a coplanar neighbour: a bound on the rounding of a point computed from the
/// corners and of the intersection arithmetic, proportional to the largest coordinate (Higham 2002, gamma_n;
/// pbrt-v4 section 6.8). Millimetres and kilometres behave alike. In metres.
float origin_lift(const std::array<Vec3, 3>& points);

}  // namespace luxel
