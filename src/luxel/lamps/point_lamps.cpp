// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/point_lamps.h"

#include <cassert>

#include "luxel/lamps/polygon_irradiance.h"
#include "luxel/trace/point_sight.h"

namespace luxel {

PointLamps::PointLamps(const PatchSet& patches, const Tracer& tracer, const LampRays& rays,
                       const LampRayOrigin& origin, std::uint32_t replicates)
    : patches_(patches),
      tracer_(tracer),
      rays_(rays),
      origin_(origin),
      replicates_(replicates),
      punctual_(patches.band_count(), 0.0) {
  const auto& lamps = rays.lamps();
  const auto& at = origin.position;
  choices_.make(lamps, rays.tree(), {at, at, at}, origin.normal,
                {.most = LampChoices::few_lamps, .closed_form = true});
  for (const auto& lamp : choices_.lamps())
    unshadowed_.push_back(unit_irradiance(lamps.triangles()[lamp.lamp], Vec3d(at), Vec3d(origin.normal)));
  tally_.assign(replicates * unshadowed_.size(), {});
  if (rays.panes().is_tinted()) seen_of_band_.assign(tally_.size() * lamps.bands(), 0.0);
  branches_.assign(replicates * lamps.groups() * lamps.bands(), 0.0);
  trace_punctual();
  const auto& punctual = rays.punctual();
  opening_choices_.make(patches.point_lights, punctual.weights, punctual.with_opening,
                        {Vec3d(at), 0.0, Vec3d(origin.normal)});
  for (std::uint32_t i = 0; i < patches.point_lights.size(); ++i)
    if (const auto& light = patches.point_lights[i].light; is_extended(light) && !has_opening(light))
      discs_.push_back(i);
  openings_.assign(replicates * punctual_.size(), 0.0);
}

void PointLamps::trace_punctual() {
  for (const auto& lamp : patches_.point_lights) {
    if (is_extended(lamp.light)) continue;
    const auto sight = sight_of(lamp.light, Vec3d(origin_.position), Vec3d(origin_.normal));
    if (!(sight.irradiance > 0.0)) continue;
    ++rays_traced_;
    const Ray ray{origin_.position, Vec3(sight.direction)};
    if (tracer_.occluded(ray, sight.distance)) continue;
    const auto through = rays_.panes().along(ray, sight.distance);
    for (std::size_t b = 0; b < punctual_.size(); ++b)
      punctual_[b] += sight.irradiance * in_band(through, b) * static_cast<double>(lamp.intensity[b]);
  }
}

void PointLamps::sample_discs(std::uint32_t replicate, const std::array<float, 3>& v) {
  const auto bands = punctual_.size();
  for (const auto sun : discs_) {
    const auto& lamp = patches_.point_lights[sun];
    const auto sight = sight_of(lamp.light, Vec3d(origin_.position), Vec3d(origin_.normal),
                                {static_cast<double>(v[1]), static_cast<double>(v[2])});
    if (!(sight.irradiance > 0.0)) continue;
    ++rays_traced_;
    const Ray ray{origin_.position, Vec3(sight.direction)};
    if (tracer_.occluded(ray, sight.distance)) continue;
    const auto through = rays_.panes().along(ray, sight.distance);
    for (std::size_t b = 0; b < bands; ++b)
      openings_[replicate * bands + b] +=
          sight.irradiance * in_band(through, b) * static_cast<double>(lamp.intensity[b]);
  }
}

void PointLamps::sample_opening(std::uint32_t replicate, const std::array<float, 3>& v) {
  const auto sample =
      opening_choices_.sample(Vec3d(origin_.position), Vec3d(origin_.normal), static_cast<double>(v[0]),
                              {static_cast<double>(v[1]), static_cast<double>(v[2])});
  if (!(sample.given > 0.0)) return;
  ++rays_traced_;
  const Ray ray{origin_.position, Vec3(sample.sight.direction)};
  if (tracer_.occluded(ray, sample.sight.distance)) return;
  const auto through = rays_.panes().along(ray, sample.sight.distance);
  const auto& intensity = patches_.point_lights[sample.light].intensity;
  for (std::size_t b = 0; b < intensity.size(); ++b)
    openings_[replicate * intensity.size() + b] +=
        sample.given * in_band(through, b) * static_cast<double>(intensity[b]);
}

void PointLamps::sample(std::uint32_t replicate, const std::array<float, 2>& u,
                        const std::array<float, 3>& v) {
  sample_discs(replicate, v);
  if (!opening_choices_.empty()) sample_opening(replicate, v);
  if (choices_.empty()) return;
  const auto term = rays_.towards_lamp(origin_, choices_, u, nullptr);
  rays_traced_ += term.rays;
  const auto& lamps = rays_.lamps();
  auto* branches = &branches_[replicate * lamps.groups() * lamps.bands()];
  if (term.choice < unshadowed_.size())
    add_to_tally(term, replicate * unshadowed_.size() + term.choice, tally_, seen_of_band_);
  else if (term.seen > 0.0)
    add_sample(branches, term, 1.0, lamps);
  if (term.seen > 0.0) add_sky_difference(branches, term, 1.0, lamps);
}

void PointLamps::add_to(std::span<double> irradiance, std::uint32_t samples) {
  const auto& lamps = rays_.lamps();
  const auto bands = punctual_.size();
  assert(samples > 0 && irradiance.size() == replicates_ * bands);
  const auto per_sample = 1.0 / static_cast<double>(samples);
  estimate_ = branches_;
  for (auto& e : estimate_) e *= per_sample;
  estimates_.add({choices_, lamps, unshadowed_, tally_, seen_of_band_, replicates_, per_sample}, true,
                 estimate_);
  for (std::size_t r = 0; r < replicates_; ++r) {
    for (std::size_t i = 0; i < lamps.groups() * bands; ++i)
      irradiance[r * bands + i % bands] += estimate_[r * lamps.groups() * bands + i];
    for (std::size_t b = 0; b < bands; ++b)
      irradiance[r * bands + b] += punctual_[b] + openings_[r * bands + b] * per_sample;
  }
}

}  // namespace luxel
