// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "luxel/core/discrete_distribution.h"
#include "luxel/lamps/portals.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Directions towards portals: a portal is chosen by its area times the part of rays through it that meet the
// sky, and a point evenly on it. The direction counts only where this portal is the last one on the ray, so
// that portals may overlap and stand one behind the other. Deliberately simple, as LampTable is. Read-only;
// safe for any number of threads.
class PortalTable {
 public:
  // Keeps no reference. Empty where there is no portal. Traces 64 rays per portal.
  PortalTable(const PatchSet& patches, const Tracer& tracer);

  bool empty() const { return corners_.empty(); }

  // Samples a ray from this point by `density`, or nothing; the table is not empty. u: uniform in [0, 1):
  // portal and place on it.
  std::optional<Ray> sample(const Vec3& from, const std::array<float, 3>& u) const;
  // Returns the probability density of the ray's direction, per steradian; 0 where it meets no portal.
  double density(const Ray& ray) const;

 private:
  struct Crossing {
    std::size_t portal;
    double distance;  // m
  };
  std::optional<Crossing> last_crossed(const Ray& ray) const;

  Portals portals_;
  std::vector<std::array<Vec3, 3>> corners_;  // [portal], m
  Vec3 centre_{0.0f};                         // of a sphere around all of them
  float radius_ = 0.0f;                       // m
  DiscreteDistribution by_sky_;               // m²
};

}  // namespace luxel
