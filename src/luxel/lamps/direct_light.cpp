// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/direct_light.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

#include "luxel/core/address.h"
#include "luxel/core/sobol.h"
#include "luxel/lamps/lamp_choices.h"
#include "luxel/lamps/lamp_rays.h"
#include "luxel/lamps/lamp_tally.h"
#include "luxel/lamps/punctual_choices.h"
#include "luxel/patch/side.h"
#include "luxel/trace/gather_sides.h"
#include "luxel/trace/patch_emitter.h"

namespace luxel {

// Where the rays of a side begin.
struct DirectLight::Side {
  SideId id;
  PatchEmitter emitter;
  float lift;  // m
};

namespace {

// The random numbers of one replicate of one side.
class Numbers {
 public:
  Numbers(const DirectOptions& options, SideId side, std::uint32_t position, std::uint32_t round,
          std::uint32_t samples, std::uint32_t replicate)
      : key_(stream_key(mix64(options.seed + seed_of(RandomSeed::lamps)), round,
                        2 * replicate + (side.is_back() ? 1u : 0u))),
        low_discrepancy_(options.low_discrepancy) {
    const bool is_shared = options.stratified && low_discrepancy_;
    if (is_shared) first_ = position % sequence_positions * samples;
    key_ = stream_key(key_, 0, is_shared ? position / sequence_positions : side.index());
    sobol_ = OwenSobol(key_);
  }
  std::array<float, 4> at(std::uint32_t sample) const {
    return low_discrepancy_ ? sobol_.first4(first_ + sample) : uniform4(key_, sample);
  }
  // Two more numbers, for the cosine ray.
  std::array<float, 2> more(std::uint32_t sample) const {
    if (low_discrepancy_) return {sobol_.at(first_ + sample, 4), sobol_.at(first_ + sample, 5)};
    const auto u = uniform4(mix64(key_ + 1), sample);
    return {u[0], u[1]};
  }

 private:
  std::uint64_t key_;
  std::uint32_t first_ = 0;
  bool low_discrepancy_;
  OwenSobol sobol_{0};
};

struct Workspace {
  LampChoices choices;
  std::vector<LampTally> tally;      // [replicate][lamp chosen individually]
  std::vector<double> seen_of_band;  // the same of each band, [...][band]; empty without tinted panes
  std::vector<double> sum;           // [replicate][group][band]
  std::vector<double> irradiance;    // [lamp chosen individually]
  LampEstimates estimates;
};

PunctualChoices::Receiver receiver_of(const PatchEmitter& side) {
  const auto& corners = side.corners();
  const auto centre = (Vec3d(corners[0]) + Vec3d(corners[1]) + Vec3d(corners[2])) / 3.0;
  double radius = 0.0;
  for (const auto& corner : corners) radius = std::max(radius, glm::length(Vec3d(corner) - centre));
  return {centre, radius, Vec3d(side.normal())};
}

// Branches pay off only where there are enough samples to resolve them.
std::size_t branches_for(std::uint32_t samples) {
  return std::min<std::size_t>(LampChoices::few_lamps, 16 + samples);
}

}  // namespace

DirectLight::DirectLight(const PatchSet& patches, const Tracer& tracer, const Lamps& lamps,
                         const DirectOptions& options)
    : patches_(patches),
      tracer_(tracer),
      lamps_(lamps),
      options_(options),
      rays_(patches, tracer, lamps, options.multiple_importance) {}

DirectLight::Side DirectLight::start_on(SideId id) const {
  return {id, PatchEmitter(patches_, id), origin_lift(patches_.points(id.patch()))};
}

void DirectLight::choose_lamps(LampChoices& choices, const Side& side, std::uint32_t samples) const {
  choices.make(lamps_, rays_.tree(), side.emitter.corners(), side.emitter.normal(),
               {.most = branches_for(samples),
                .importance = options_.importance,
                .closed_form = options_.control_variate && !options_.multiple_importance,
                .balls = !options_.multiple_importance});
}

template <typename Body>
void DirectLight::for_each_term(const Side& side, const LampChoices& choices, const Samples& samples,
                                LampRayEnds* ends, Body body) const {
  const auto [position, round, per_replicate] = samples;
  for (std::uint32_t r = 0; r < options_.replicates; ++r) {
    const Numbers numbers(options_, side.id, position, round, per_replicate, r);
    for (std::uint32_t k = 0; k < per_replicate; ++k) {
      const auto u = numbers.at(k);
      const auto from = side.emitter.point(u[2], u[3]);
      body(r, rays_.towards_lamp({from, side.emitter.normal(), side.lift}, choices, {u[0], u[1]}, ends));
      if (options_.multiple_importance) {
        const auto v = numbers.more(k);
        body(r,
             rays_.along(side.emitter.ray({u[2], u[3], v[0], v[1]}), side.emitter.normal(), choices, ends));
      }
    }
  }
}

template <typename Body>
void DirectLight::for_each_term(SideId side_id, const Samples& samples, LampRayEnds* ends, Body body) const {
  const auto side = start_on(side_id);
  LampChoices choices;
  choose_lamps(choices, side, options_.replicates * samples.per_replicate);
  if (!choices.empty()) for_each_term(side, choices, samples, ends, body);
}

std::vector<ShadowRay> DirectLight::rays_of(SideId side_id, std::uint32_t position, std::uint32_t round,
                                            std::uint32_t per_replicate) const {
  std::vector<ShadowRay> rays;
  LampRayEnds ends;
  for_each_term(side_id, {position, round, per_replicate}, &ends, [&](std::uint32_t r, const LampTerm& term) {
    if (term.given > 0.0) rays.push_back({r, term.lamp, ends.from, ends.to, term.given, term.seen > 0.0});
  });
  return rays;
}

std::vector<SkySample> DirectLight::sky_samples(SideId side_id, std::uint32_t position, std::uint32_t round,
                                                std::uint32_t per_replicate) const {
  std::vector<SkySample> samples;
  for_each_term(side_id, {position, round, per_replicate}, nullptr,
                [&](std::uint32_t r, const LampTerm& term) {
                  if (term.given * term.seen > 0.0 && lamps_.triangles()[term.lamp].is_portal())
                    samples.push_back({r, term.sky_patch, term.given * term.seen});
                });
  return samples;
}

std::uint64_t DirectLight::estimate(SideId side_id, std::uint32_t position, std::uint32_t round,
                                    std::uint32_t per_replicate, std::span<float> out) const {
  assert(per_replicate > 0);
  assert(out.size() == options_.replicates * lamps_.groups() * lamps_.bands());
  thread_local Workspace work;  // reused, so that it stops allocating once it is large enough
  std::fill(out.begin(), out.end(), 0.0f);
  const auto side = start_on(side_id);
  const bool control_variate = options_.control_variate && !options_.multiple_importance;
  auto& choices = work.choices;
  choose_lamps(choices, side, options_.replicates * per_replicate);
  if (choices.empty() && patches_.point_lights.empty()) return 0;

  // 1. Rays. Lamps chosen individually are tallied; the others are added directly.
  const auto known = choices.lamps().size();
  const auto width = lamps_.groups() * lamps_.bands();
  const auto replicates = options_.replicates;
  const auto per_sample = 1.0 / static_cast<double>(per_replicate);
  work.tally.assign(replicates * known, {});
  work.seen_of_band.assign(rays_.panes().is_tinted() ? replicates * known * lamps_.bands() : 0, 0.0);
  work.sum.assign(replicates * width, 0.0);
  auto rays = add_point_lights(side, {position, round, per_replicate}, work.sum);
  if (!choices.empty())
    for_each_term(side, choices, {position, round, per_replicate}, nullptr,
                  [&](std::uint32_t r, const LampTerm& term) {
                    rays += term.rays;
                    if (term.choice < known)
                      add_to_tally(term, r * known + term.choice, work.tally, work.seen_of_band);
                    else if (term.seen > 0.0)
                      add_sample(&work.sum[r * width], term, per_sample, lamps_);
                    if (term.seen > 0.0) add_sky_difference(&work.sum[r * width], term, per_sample, lamps_);
                  });

  // 2. Each replicate is corrected by the visibility in the other replicates.
  work.irradiance.clear();
  for (const auto& lamp : choices.lamps()) work.irradiance.push_back(lamp.irradiance);
  work.estimates.add(
      {choices, lamps_, work.irradiance, work.tally, work.seen_of_band, replicates, per_sample},
      control_variate, work.sum);
  std::transform(work.sum.begin(), work.sum.end(), out.begin(),
                 [](double v) { return static_cast<float>(v); });
  return rays;
}

// sum: [replicate][group][band].
std::uint64_t DirectLight::add_point_lights(const Side& side, const Samples& samples,
                                            std::span<double> sum) const {
  const auto& lights = patches_.point_lights;
  if (lights.empty()) return 0;
  const auto per_replicate = samples.per_replicate;
  const auto& punctual = rays_.punctual();
  const auto bands = lamps_.bands(), width = lamps_.groups() * bands;
  const Vec3d normal(side.emitter.normal());
  thread_local PunctualChoices choices;
  choices.make(lights, punctual.weights, punctual.chosen, receiver_of(side.emitter));
  if (choices.empty() && punctual.suns.empty()) return 0;
  std::uint64_t rays = 0;
  const auto add = [&](std::uint32_t r, const Vec3& from, std::uint32_t index, const PointSight& sight,
                       double given) {
    if (!(given > 0.0)) return;
    ++rays;
    const Ray ray{from, Vec3(sight.direction)};
    if (tracer_.occluded(ray, sight.distance)) return;
    const auto through = rays_.panes().along(ray, sight.distance);
    const auto& light = lights[index];
    auto* out = &sum[r * width + (lamps_.groups() > 1 ? light.light_group * bands : 0)];
    for (std::size_t b = 0; b < bands; ++b)
      out[b] += given / per_replicate * in_band(through, b) * static_cast<double>(light.intensity[b]);
  };
  for (std::uint32_t r = 0; r < options_.replicates; ++r) {
    const Numbers numbers(options_, side.id, samples.position, samples.round, per_replicate, r);
    for (std::uint32_t k = 0; k < per_replicate; ++k) {
      const auto u = numbers.at(k);
      const auto from = side.emitter.point(u[2], u[3]);
      std::array<double, 2> opening{};
      if (punctual.has_extended) {
        const auto v = numbers.more(k);
        opening = {static_cast<double>(v[0]), static_cast<double>(v[1])};
      }
      for (const auto sun : punctual.suns) {
        const auto sight = sight_of(lights[sun].light, Vec3d(from), normal, opening);
        add(r, from, sun, sight, sight.irradiance);
      }
      if (choices.empty()) continue;
      const auto sample = choices.sample(Vec3d(from), normal, static_cast<double>(u[0]), opening);
      add(r, from, sample.light, sample.sight, sample.given);
    }
  }
  return rays;
}

}  // namespace luxel
