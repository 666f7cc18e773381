// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/point_lamps.h"

#include <cassert>

#include "luxel/lamps/polygon_irradiance.h"
#include "luxel/trace/point_sight.h"

namespace luxel {

PointLamps::PointLamps(const PatchSet& patches, const Tracer& tracer, const LampRays& rays,
                       const LampRayOrigin& origin, std::uint32_t replicates)
    : rays_(rays), origin_(origin), replicates_(replicates), punctual_(patches.band_count(), 0.0) {
  const auto& lamps = rays.lamps();
  const auto& at = origin.position;
  choices_.make(lamps, rays.tree(), {at, at, at}, origin.normal,
                {.most = LampChoices::few_lamps, .closed_form = true});
  for (const auto& lamp : choices_.lamps())
    unshadowed_.push_back(unit_irradiance(lamps.triangles()[lamp.lamp], Vec3d(at), Vec3d(origin.normal)));
  tally_.assign(replicates * unshadowed_.size(), {});
  branches_.assign(replicates * lamps.groups() * lamps.bands(), 0.0);
  trace_punctual(patches, tracer);
}

void PointLamps::trace_punctual(const PatchSet& patches, const Tracer& tracer) {
  for (const auto& lamp : patches.point_lights) {
    const auto sight = sight_of(lamp.light, Vec3d(origin_.position), Vec3d(origin_.normal));
    if (!(sight.irradiance > 0.0)) continue;
    ++rays_traced_;
    if (tracer.occluded({origin_.position, Vec3(sight.direction)}, sight.distance)) continue;
    for (std::size_t b = 0; b < punctual_.size(); ++b)
      punctual_[b] += sight.irradiance * static_cast<double>(lamp.intensity[b]);
  }
}

void PointLamps::sample(std::uint32_t replicate, const std::array<float, 2>& u) {
  if (choices_.empty()) return;
  const auto term = rays_.towards_lamp(origin_, choices_, u, nullptr);
  rays_traced_ += term.rays;
  const auto& lamps = rays_.lamps();
  if (term.choice < unshadowed_.size())
    tally_[replicate * unshadowed_.size() + term.choice] += {term.given, term.seen ? term.given : 0.0};
  else if (term.seen)
    add_radiance(&branches_[replicate * lamps.groups() * lamps.bands()], term.given, lamps, term.lamp);
}

void PointLamps::add_to(std::span<double> irradiance, std::uint32_t samples) {
  const auto& lamps = rays_.lamps();
  const auto bands = punctual_.size();
  assert(samples > 0 && irradiance.size() == replicates_ * bands);
  const auto per_sample = 1.0 / static_cast<double>(samples);
  estimate_ = branches_;
  for (auto& e : estimate_) e *= per_sample;
  estimates_.add({choices_, lamps, unshadowed_, tally_, replicates_, per_sample}, true, estimate_);
  for (std::size_t r = 0; r < replicates_; ++r) {
    for (std::size_t i = 0; i < lamps.groups() * bands; ++i)
      irradiance[r * bands + i % bands] += estimate_[r * lamps.groups() * bands + i];
    for (std::size_t b = 0; b < bands; ++b) irradiance[r * bands + b] += punctual_[b];
  }
}

}  // namespace luxel
