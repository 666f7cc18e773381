// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/render/surface_point.h"
#include "luxel/scene/scene.h"
#include "luxel/surface/smooth_light.h"

namespace luxel::bench {

// Returns the unit normal of a round surface that facets approximate, at a point; arguments: the patch, the
// point and the facet's own normal. Both normals face the same side.
using TrueNormal = std::function<Vec3(const PatchSet&, std::size_t patch, const Vec3&, const Vec3&)>;

using PatchChoice = std::function<bool(const PatchSet&, std::size_t patch)>;

// The light at one place of a patch side, W/m² a band. weights: barycentric, of the corners b and c.
using Field = std::function<void(std::size_t patch, bool back, const Vec2& weights, double* light)>;

// The field that is drawn: linear between the vertices. Keeps a reference.
Field drawn_field(const SmoothLight& smooth, std::size_t bands);

// Error of a field over the patches of a scene relative to the light at points, for any patches. Points
// are drawn evenly over both sides of all surfaces; the light there is path-traced, twice and
// independently.
class PointTruth {
 public:
  // Only where `only_on` returns true; empty: everywhere.
  PointTruth(const Scene& scene, const TrueNormal& normal, std::size_t points, std::uint64_t paths,
             const Context& context, const PatchChoice& only_on = {});

  // sqrt(mean of (f - t)(f - t') / mean of t t'), over points and bands: the noise of neither t is in it.
  double error(const PatchSet& patches, const Field& field) const;
  // Standard error of the square of it, from the spread of the points.
  double noise(const PatchSet& patches, const Field& field) const;

 private:
  struct Sums {
    double product = 0.0, truth = 0.0, square = 0.0;
  };
  Sums sums(const PatchSet& patches, const Field& field) const;

  std::size_t bands_;
  std::vector<SurfacePoint> points_;
  std::vector<std::uint32_t> triangle_;  // [point]: of the scene
  std::vector<double> light_, again_;    // [point][band], W/m²
};

}  // namespace luxel::bench
