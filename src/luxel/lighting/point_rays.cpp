// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/point_rays.h"

#include <algorithm>
#include <numbers>

#include "luxel/core/address.h"
#include "luxel/core/none.h"
#include "luxel/core/sobol.h"
#include "luxel/core/warp.h"
#include "luxel/lamps/lamp_choices.h"

namespace luxel {
namespace {

// A solution without light, for the choice of the side to which a point on a surface is moved.
Solution dark(const PatchSet& patches) {
  Solution s;
  s.bands = patches.bands;
  for (auto* array : {&s.irradiance.front, &s.irradiance.back, &s.radiosity.front, &s.radiosity.back})
    array->assign(patches.size() * patches.band_count(), 0.0f);
  return s;
}

}  // namespace

PointRays::PointRays(const PatchSet& patches, const Tracer& tracer, const GatherSides& sides,
                     std::uint32_t replicates, const CoefficientOptions& options)
    : patches_(patches),
      tracer_(tracer),
      sides_(sides),
      replicates_(replicates),
      options_(options),
      lamps_(patches),
      lamp_rays_(patches, tracer, lamps_, false),
      dark_(dark(patches)),
      tolerance_(surface_tolerance(patches)) {}

PointHits PointRays::trace(const ProbePoint& point, std::uint32_t index, std::span<float> sky,
                           std::span<float> external) const {
  const auto origin = origin_of(patches_, dark_, tracer_, point, tolerance_).rays;
  const auto& portals = lamp_rays_.portals();
  const auto& panes = lamp_rays_.panes();
  const auto& directions = patches_.sky_patches;
  const auto width = directions.size();
  const auto per_replicate = std::max(1u, options_.rays / replicates_);
  const auto weight = 1.0f / static_cast<float>(per_replicate);
  const auto key = stream_key(options_.seed, RandomPurpose::daylight_points, index);
  const Frame frame(origin.normal);
  LampChoices choices;
  choices.make(lamps_, lamp_rays_.tree(), {origin.position, origin.position, origin.position}, origin.normal,
               {.most = LampChoices::few_lamps});
  const bool has_ground = !directions.is_one() && directions.lower_half() == LowerHalf::one;
  const auto add_sky = [&](std::uint32_t r, std::size_t sky_patch, float value) {
    (has_ground && sky_patch == 0 ? external : sky)[r * width + sky_patch] += value;
  };

  PointHits found;
  found.origin = {origin.position, origin.normal};
  for (std::uint32_t r = 0; r < replicates_; ++r) {
    found.begins.push_back(static_cast<std::uint32_t>(found.hits.size()));
    const OwenSobol cosine(nth_key(key, 2 * r)), towards(nth_key(key, 2 * r + 1));
    for (std::uint32_t i = 0; i < per_replicate; ++i) {
      const Ray ray{origin.position, frame.to_world(cosine_hemisphere(cosine.at(i, 0), cosine.at(i, 1)))};
      const auto hit = tracer_.nearest(ray);
      ++found.rays;
      if (hit) {
        const auto receiver = sides_.receiver_of_side[hit.side().index()];
        if (receiver == none) continue;
        const auto through = static_cast<float>(panes.luminous(panes.along(ray, hit.distance)));
        const bool is_external = !portals.empty() && portals.distance(ray) < hit.distance;
        found.hits.push_back({receiver, weight * through, is_external});
      } else if (portals.first_crossed(ray) == none) {
        const auto through = panes.luminous(panes.along(ray, hit.distance));
        add_sky(r, directions.patch_of(Vec3d(ray.direction)),
                weight * static_cast<float>(through * std::numbers::pi));
      }
      if (choices.empty()) continue;
      const auto term =
          lamp_rays_.towards_lamp(origin, choices, {towards.at(i, 0), towards.at(i, 1)}, nullptr);
      found.rays += term.rays;
      if (term.seen > 0.0) add_sky(r, term.sky_patch, weight * static_cast<float>(term.given * term.seen));
    }
  }
  found.begins.push_back(static_cast<std::uint32_t>(found.hits.size()));
  return found;
}

}  // namespace luxel
