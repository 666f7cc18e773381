// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Finds the portal that a ray crosses first. A ray that meets no surface and whose first portal it crosses on
// a side that is lit gets its light from the shadow rays towards that portal; a gather ray on the same line
// then counts as dark. All other rays that meet no surface see the sky. So each line counts once for any set
// of portals: overlapping ones, coincident ones, one behind the other.
//
// Side 2k of portal k is the one that it always lights, side 2k + 1 the one that it lights where it lights
// both ways. Immutable; safe for any number of threads. A crossing costs a ray through the portals alone,
// about 0.1 us. Without portals, or without a sky, it is empty.
class Portals {
 public:
  // Keeps no reference.
  explicit Portals(const PatchSet& patches);

  bool empty() const { return tracer_ == nullptr; }
  // Returns the side that the ray comes from; none if it meets no portal, or first one that does not light
  // this side.
  std::uint32_t first_crossed(const Ray& ray) const;
  // Returns the first portal that the ray meets, whether or not it lights that side: Hit::patch is the
  // portal.
  Hit nearest(const Ray& ray) const;
  // Returns the distance to it, m; infinite if there is none.
  float distance(const Ray& ray) const { return nearest(ray).distance; }

 private:
  std::shared_ptr<const Tracer> tracer_;
  std::vector<std::uint8_t> both_ways_;  // [portal]
};

}  // namespace luxel
