// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/lamps/lamps.h"
#include "luxel/lamps/light_tree.h"
#include "luxel/lamps/portals.h"
#include "luxel/lamps/punctual_lights.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/panes.h"
#include "luxel/trace/tracer.h"

namespace luxel {

class LampChoices;

// One ray towards the lamps, or one that may meet a lamp.
struct LampTerm {
  std::size_t choice = 0;
  std::uint32_t lamp = 0;
  std::uint32_t sky_patch = 0;  // where the lamp is a portal: what lies behind
  double given = 0.0;           // W/m² at unit radiance, were nothing between: the sample over its density
  double seen = 0.0;            // 0: hidden; 1: seen; between: luminous transmittance of the panes between
  std::uint64_t rays = 0;       // traced
  // Where there are tinted panes, the visible fraction of each band, [band]; else empty. Valid until the next
  // ray of the thread.
  std::span<const double> of_band = {};

  // Irradiance of the sample at unit radiance, W/m²; of_band is a factor of it.
  double value() const { return of_band.empty() ? given * seen : given; }
};

// The two ends of such a ray, m; the second is on the lamp.
struct LampRayEnds {
  Vec3 from{0.0f}, to{0.0f};
};

// Start of a lamp ray.
struct LampRayOrigin {
  Vec3 position{0.0f};  // m, lifted off its surface
  Vec3 normal{0.0f};    // unit, of the side that is lit
  float lift = 0.0f;    // m; see origin_lift()
};

// Samples of the light straight from area lamps and portals, at points: one lamp is chosen (LampChoices),
// then a direction towards it, then its visibility is traced. A lamp of many facets is sampled by its
// bounding sphere. Used by DirectLight for patches and by PointLamps for single points. Read-only: any number
// of threads may call.
class LampRays {
 public:
  // Keeps references to patches, tracer and lamps. multiple_importance: samples are weighted by the balance
  // heuristic against cosine rays.
  LampRays(const PatchSet& patches, const Tracer& tracer, const Lamps& lamps, bool multiple_importance);

  const Lamps& lamps() const { return lamps_; }
  const LightTree& tree() const { return tree_; }
  const Portals& portals() const { return portals_; }
  const Panes& panes() const { return panes_; }
  const PunctualLights& punctual() const { return punctual_; }

  // One sample towards a lamp of the choices, which are those of the origin or of a patch around it. u:
  // uniform in [0, 1): the lamp and a coordinate on it; the other coordinate. ends: receives the ends of the
  // ray unless null; only where given is above 0.
  LampTerm towards_lamp(const LampRayOrigin& from, const LampChoices& choices, const std::array<float, 2>& u,
                        LampRayEnds* ends) const;
  // A cosine ray, which counts where it meets a lamp.
  LampTerm along(const Ray& ray, const Vec3& normal, const LampChoices& choices, LampRayEnds* ends) const;

 private:
  LampTerm towards_ball(const LampRayOrigin& from, const LampChoices& choices, std::size_t choice,
                        const std::array<double, 2>& u, LampRayEnds* ends) const;
  double given(double cosine, double lamp_density) const;
  std::uint32_t sky_patch(std::uint32_t lamp, const Vec3d& direction) const;
  bool sky_is_visible(const Ray& ray, std::uint32_t portal_side) const;
  void look(const Vec3& from, const Vec3d& to, float min_lift, LampTerm& term) const;
  void look_through_panes(const Ray& ray, float distance, LampTerm& term) const;

  const Tracer& tracer_;
  const Lamps& lamps_;
  bool multiple_importance_;
  LightTree tree_;
  Portals portals_;
  Panes panes_;
  PunctualLights punctual_;
  SkyPatches sky_patches_;
  std::vector<float> lift_;  // [triangle], m
};

}  // namespace luxel
