// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/lamps/punctual_lights.h"
#include "luxel/patch/patch_set.h"
#include "luxel/render/lamp_table.h"
#include "luxel/render/portal_table.h"
#include "luxel/render/surface_point.h"
#include "luxel/trace/panes.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Where a path continues after it hits a surface.
enum class BouncesFrom {
  points,  // from the very point: the light as it is, not constant on patches
  patches  // from a random point of the patch's side: the radiosity solution of this mesh, exactly
};

// Random numbers of one vertex of a path, uniform in [0, 1).
struct VertexNumbers {
  std::array<float, 2> direction;  // of the cosine ray
  std::array<float, 3> lamp;       // of the shadow ray: which lamp, where on it
};

// Paths that start at a surface and gather light (Kajiya 1986). Each vertex traces a shadow ray to a lamp and
// a cosine ray: light straight from lamps comes from both, weighted by the balance heuristic (Veach and
// Guibas 1995), so that no path carries much more than others where a lamp is near; the cosine ray continues
// the path. The sky is met by cosine rays and, where the patches have portals, by one more ray to these,
// weighted in the same way. Shares tracer, patches, portals and the choice of luminaires with the solvers,
// and no estimator.
class LightPaths {
 public:
  // Keeps references. Throws InputError where there is neither lamp nor sky.
  LightPaths(const PatchSet& patches, const Tracer& tracer);

  // The result of one path, or one ray.
  struct Trail {
    Hit first;               // of the first cosine ray
    std::uint64_t rays = 0;  // traced
    // That ray: radiance times solid_angle (sr) estimates the integral of radiance over
    // what is seen.
    Vec3d direction{0.0};
    double cosine = 0.0, solid_angle = 0.0;
    // Transmittance of the panes of glass on that ray, [band]; empty where it crosses none.
    std::vector<double> through = {};
  };

  // Adds weight * (unbiased estimate of the irradiance at x straight from lamps and sky, W/m²) to sum.
  // weight, sum: [band]. Returns the hit of the cosine ray.
  Trail direct(const SurfacePoint& x, const VertexNumbers& numbers, std::span<const double> weight,
               std::span<double> sum) const;

  // Adds an unbiased estimate of the light vector (Gershun 1939), the integral of radiance times direction
  // over what x sees, and in w of its irradiance, both W/m²: of light straight from lamps and sky. sum:
  // [band]. Half of the rays go by the cosine and half evenly, so that what comes along the surface has its
  // share.
  Trail light_vector(const SurfacePoint& x, const VertexNumbers& numbers, std::span<glm::dvec4> sum) const;

  // Adds an unbiased estimate of the whole irradiance at x, W/m², to sum, [band]. weight: [band], scratch.
  // first: the numbers of the first vertex; key: the stream of all others. A path ends by Russian roulette
  // alone, with the largest band's share of what it carries.
  Trail irradiance(const SurfacePoint& x, const VertexNumbers& first, std::uint64_t key, BouncesFrom from,
                   std::span<double> weight, std::span<double> sum) const;

 private:
  enum class Rays { by_cosine, by_cosine_or_evenly };
  template <typename Add>
  Trail arriving(const SurfacePoint& x, const VertexNumbers& numbers, Rays spread, const Add& add) const;

  SideId scatter(const Hit& hit, float u, std::span<double> weight) const;

  template <typename Add>
  void add_sky(const SurfacePoint& x, const VertexNumbers& numbers, Rays spread, Trail& trail,
               const Add& add) const;

  template <typename Add>
  void add_punctual(const SurfacePoint& x, const VertexNumbers& numbers, Trail& trail, const Add& add) const;

  const PatchSet& patches_;
  const Tracer& tracer_;
  LampTable lamps_;
  PortalTable portals_;
  PunctualLights punctual_;
  Panes panes_;
};

}  // namespace luxel
