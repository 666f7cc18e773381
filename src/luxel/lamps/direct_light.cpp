// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/direct_light.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include "luxel/core/address.h"
#include "luxel/core/discrete_distribution.h"
#include "luxel/core/none.h"
#include "luxel/core/sobol.h"
#include "luxel/core/trig.h"
#include "luxel/lamps/lamp_choices.h"
#include "luxel/lamps/lamp_sample.h"
#include "luxel/patch/side.h"
#include "luxel/trace/gather_sides.h"
#include "luxel/trace/patch_emitter.h"
#include "luxel/trace/point_sight.h"

namespace luxel {

// Where the rays of a side begin.
struct DirectLight::Side {
  SideId id;
  PatchEmitter emitter;
  float lift;  // m
};

namespace {

// Weight of the visibility over all lamps in that of one lamp, in samples. With 1, errors are 1 to 4 %
// smaller, but the replicates depend on each other so much that their spread is 10 % too small. With very
// large values, errors are a quarter larger where there are a dozen lamps.
constexpr double prior_samples = 3.0;

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

// Sums of unshadowed and of visible samples.
struct Tally {
  double all = 0.0;
  double seen = 0.0;

  Tally& operator+=(const Tally& other) {
    all += other.all;
    seen += other.seen;
    return *this;
  }
  Tally operator-(const Tally& other) const { return {all - other.all, seen - other.seen}; }
};

// The estimate of one replicate for each lamp with a closed form, at unit radiance: its own visible samples,
// corrected by the visibility that other replicates found (a control variate). own, whole: [lamp], sums of
// this replicate and of all replicates that may contribute.
void correct(const LampChoices& choices, const Lamps& lamps, std::span<const Tally> own,
             std::span<const Tally> others, double per_sample, std::span<double> value) {
  Tally together;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const auto weight = lamps.triangles()[choices.lamps()[i].lamp].weight;
    together += {weight * others[i].all, weight * others[i].seen};
  }
  const auto visibility = together.all > 0.0 ? together.seen / together.all : 0.0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const auto irradiance = choices.lamps()[i].irradiance;
    const auto prior = prior_samples * irradiance / choices.probability(i);
    const auto all = others[i].all + prior;
    const auto beta = all > 0.0 ? (others[i].seen + prior * visibility) / all : visibility;
    value[i] = beta * irradiance + (own[i].seen - beta * own[i].all) * per_sample;
  }
}

struct Workspace {
  LampChoices choices;
  std::vector<Tally> tally;          // [replicate][lamp chosen individually]
  std::vector<double> sum;           // [replicate][group][band]
  std::vector<Tally> whole, others;  // [lamp chosen individually]
  std::vector<double> value;
};

// Branches pay off only where there are enough samples to resolve them.
std::size_t branches_for(std::uint32_t samples) {
  return std::min<std::size_t>(LampChoices::few_lamps, 16 + samples);
}

// sum: of one replicate, [group][band].
void add_radiance(double* sum, double value, const Lamps& lamps, std::uint32_t lamp) {
  const auto radiance = lamps.radiance(lamp);
  auto* out = sum + lamps.group(lamp) * radiance.size();
  for (std::size_t b = 0; b < radiance.size(); ++b) out[b] += value * static_cast<double>(radiance[b]);
}

}  // namespace

DirectLight::DirectLight(const PatchSet& patches, const Tracer& tracer, const Lamps& lamps,
                         const DirectOptions& options)
    : patches_(patches), tracer_(tracer), lamps_(lamps), options_(options), tree_(lamps), portals_(patches) {
  for (const auto& lamp : lamps.triangles()) lift_.push_back(origin_lift(lamp.corner));
  for (const auto& light : patches.point_lights)
    point_weight_.push_back(std::accumulate(light.intensity.begin(), light.intensity.end(), 0.0));
}

// Both ends are lifted off their planes by the bound on rounding. The lamp's own triangle therefore stays
// behind the end of the ray, at grazing angles and at short distances too.
bool DirectLight::visible(const Vec3& from, const Vec3d& to, std::uint32_t lamp, float min_lift) const {
  if (const auto& triangle = lamps_.triangles()[lamp]; triangle.is_portal())
    return sky_is_visible(from, to, triangle.portal);
  const auto lift = static_cast<double>(std::max(min_lift, lift_[lamp]));
  const auto way = to + lift * lamps_.triangles()[lamp].normal - Vec3d(from);
  const auto distance = glm::length(way);
  return !(distance > 0.0) || !tracer_.occluded({from, Vec3(way / distance)}, static_cast<float>(distance));
}

// Of several portals on a line only the first counts, so that each line counts once.
bool DirectLight::sky_is_visible(const Vec3& from, const Vec3d& to, std::uint32_t portal_side) const {
  const auto way = to - Vec3d(from);
  const auto distance = glm::length(way);
  if (!(distance > 0.0)) return false;
  const Ray ray{from, Vec3(way / distance)};
  return !tracer_.occluded(ray, std::numeric_limits<float>::infinity()) &&
         portals_.first_crossed(ray) == portal_side;
}

DirectLight::Side DirectLight::start_on(SideId id) const {
  return {id, PatchEmitter(patches_, id), origin_lift(patches_.points(id.patch()))};
}

void DirectLight::choose_lamps(LampChoices& choices, const Side& side, std::uint32_t samples) const {
  choices.make(lamps_, tree_, side.emitter.corners(), side.emitter.normal(),
               {.most = branches_for(samples),
                .importance = options_.importance,
                .closed_form = options_.control_variate && !options_.multiple_importance,
                .balls = !options_.multiple_importance});
}

template <typename Body>
void DirectLight::for_each_term(const Side& side, const LampChoices& choices, const Samples& samples,
                                Ends* ends, Body body) const {
  const auto [position, round, per_replicate] = samples;
  for (std::uint32_t r = 0; r < options_.replicates; ++r) {
    const Numbers numbers(options_, side.id, position, round, per_replicate, r);
    for (std::uint32_t k = 0; k < per_replicate; ++k) {
      const auto u = numbers.at(k);
      const auto from = side.emitter.point(u[2], u[3]);
      body(r, ask_lamp(side, choices, from, u, ends));
      if (options_.multiple_importance) {
        const auto v = numbers.more(k);
        body(r, look_round(side, choices, side.emitter.ray({u[2], u[3], v[0], v[1]}), ends));
      }
    }
  }
}

std::vector<ShadowRay> DirectLight::rays_of(SideId side_id, std::uint32_t position, std::uint32_t round,
                                            std::uint32_t per_replicate) const {
  const auto side = start_on(side_id);
  LampChoices choices;
  choose_lamps(choices, side, options_.replicates * per_replicate);
  std::vector<ShadowRay> rays;
  if (choices.empty()) return rays;
  Ends ends;
  for_each_term(side, choices, {position, round, per_replicate}, &ends,
                [&](std::uint32_t r, const Term& term) {
                  if (term.given > 0.0)
                    rays.push_back({r, term.lamp, ends.from, ends.to, term.given, term.seen});
                });
  return rays;
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
  if (choices.empty() && point_weight_.empty()) return 0;

  // 1. Rays. Lamps chosen individually are tallied; the others are added directly.
  const auto known = choices.lamps().size();
  const auto width = lamps_.groups() * lamps_.bands();
  const auto replicates = options_.replicates;
  const auto per_sample = 1.0 / static_cast<double>(per_replicate);
  work.tally.assign(replicates * known, {});
  work.sum.assign(replicates * width, 0.0);
  auto rays = add_point_lights(side, position, round, per_replicate, work.sum);
  if (!choices.empty())
    for_each_term(side, choices, {position, round, per_replicate}, nullptr,
                  [&](std::uint32_t r, const Term& term) {
                    if (term.choice < known)
                      work.tally[r * known + term.choice] += {term.given, term.seen ? term.given : 0.0};
                    else if (term.seen)
                      add_radiance(&work.sum[r * width], term.given * per_sample, lamps_, term.lamp);
                    rays += term.rays;
                  });

  // 2. Each replicate is corrected by the visibility in the other replicates.
  work.whole.assign(known, {});
  for (std::size_t i = 0; i < work.tally.size(); ++i) work.whole[i % known] += work.tally[i];
  work.others = work.whole;
  work.value.resize(known);
  for (std::uint32_t r = 0; r < replicates; ++r) {
    const auto own = std::span(work.tally).subspan(r * known, known);
    for (std::size_t i = 0; i < known; ++i) {
      work.value[i] = own[i].seen * per_sample;
      if (replicates > 1) work.others[i] = work.whole[i] - own[i];
    }
    if (control_variate) correct(choices, lamps_, own, work.others, per_sample, work.value);
    for (std::size_t i = 0; i < known; ++i)
      add_radiance(&work.sum[r * width], work.value[i], lamps_, choices.lamps()[i].lamp);
  }
  std::transform(work.sum.begin(), work.sum.end(), out.begin(),
                 [](double v) { return static_cast<float>(v); });
  return rays;
}

// sum: [replicate][group][band].
std::uint64_t DirectLight::add_point_lights(const Side& side, std::uint32_t position, std::uint32_t round,
                                            std::uint32_t per_replicate, std::span<double> sum) const {
  if (point_weight_.empty()) return 0;
  const auto& lights = patches_.point_lights;
  const auto bands = lamps_.bands(), width = lamps_.groups() * bands;
  const Vec3d normal(side.emitter.normal());
  thread_local std::vector<PointSight> sights;
  thread_local DiscreteDistribution by_irradiance;  // lights in proportion to their unshadowed irradiance
  sights.resize(lights.size());
  std::uint64_t rays = 0;
  for (std::uint32_t r = 0; r < options_.replicates; ++r) {
    const Numbers numbers(options_, side.id, position, round, per_replicate, r);
    for (std::uint32_t k = 0; k < per_replicate; ++k) {
      const auto u = numbers.at(k);
      const auto from = side.emitter.point(u[2], u[3]);
      by_irradiance.clear();
      for (std::size_t i = 0; i < lights.size(); ++i) {
        sights[i] = sight_of(lights[i].light, Vec3d(from), normal);
        by_irradiance.add(point_weight_[i] * sights[i].irradiance);
      }
      const auto whole = by_irradiance.total();
      if (!(whole > 0.0)) continue;
      const auto chosen = by_irradiance.choose(static_cast<double>(u[0]));
      const auto& sight = sights[chosen];
      ++rays;
      if (tracer_.occluded({from, Vec3(sight.direction)}, sight.distance)) continue;
      const auto& light = lights[chosen];
      const auto given = whole / point_weight_[chosen] / per_replicate;
      auto* out = &sum[r * width + (lamps_.groups() > 1 ? light.light_group * bands : 0)];
      for (std::size_t b = 0; b < bands; ++b) out[b] += given * static_cast<double>(light.intensity[b]);
    }
  }
  return rays;
}

// Sample towards a chosen lamp.
DirectLight::Term DirectLight::ask_lamp(const Side& side, const LampChoices& choices, const Vec3& from,
                                        const std::array<float, 4>& u, Ends* ends) const {
  const auto& normal = side.emitter.normal();
  const auto [choice, chosen] = choices.choose(tree_, from, normal, static_cast<double>(u[0]));
  if (!(chosen.probability > 0.0)) return {};
  if (chosen.lamp == none)
    return ask_ball(side, choices, choice, from, {chosen.rest, static_cast<double>(u[1])}, ends);
  const auto sample =
      sample_lamp(lamps_.triangles()[chosen.lamp], Vec3d(from), chosen.rest, static_cast<double>(u[1]));
  const auto cosine = glm::dot(Vec3d(normal), sample.direction);
  if (!(sample.density > 0.0) || !(cosine > 0.0)) return {};
  const auto to = Vec3d(from) + sample.distance * sample.direction;
  const bool seen = visible(from, to, chosen.lamp, side.lift);
  if (ends != nullptr) *ends = {from, Vec3(to)};
  return {choice, chosen.lamp, given(cosine, sample.density * chosen.probability), seen, 1};
}

// Sample towards the bounding sphere of a bulb, uniform in solid angle; the hit determines the facet.
DirectLight::Term DirectLight::ask_ball(const Side& side, const LampChoices& choices, std::size_t choice,
                                        const Vec3& from, const std::array<double, 2>& u, Ends* ends) const {
  const auto& branch = choices.branch(choice);
  const auto ball = tree_.sphere(branch);
  const auto to = Vec3d(ball.centre) - Vec3d(from);
  const auto sine2 = static_cast<double>(ball.radius) * ball.radius / glm::dot(to, to);
  const auto width = sine2 / (1.0 + std::sqrt(1.0 - sine2));  // 1 - cosine of the cone's half angle
  const auto away = u[0] * width;
  const auto sine = std::sqrt(away * (2.0 - away));
  const auto turn = sin_cos(2.0 * std::numbers::pi * u[1]);
  const Frame frame(Vec3(glm::normalize(to)));
  const auto direction = glm::normalize(
      frame.to_world(Vec3(static_cast<float>(sine * turn.cosine), static_cast<float>(sine * turn.sine),
                          static_cast<float>(1.0 - away))));
  const auto cosine = static_cast<double>(glm::dot(side.emitter.normal(), direction));
  if (!(cosine > 0.0)) return {};
  const auto hit = tracer_.nearest({from, direction});
  const auto lamp = hit && !hit.back ? lamps_.lamp_at(hit.patch, from + hit.distance * direction) : none;
  if (lamp == none || !tree_.holds(branch, lamp)) return {.rays = 1};
  if (ends != nullptr) *ends = {from, from + hit.distance * direction};
  const auto density = choices.probability(choice) / (2.0 * std::numbers::pi * width);
  return {choice, lamp, given(cosine, density), true, 1};
}

// Cosine ray, which may hit a lamp.
DirectLight::Term DirectLight::look_round(const Side& side, const LampChoices& choices, const Ray& ray,
                                          Ends* ends) const {
  const auto hit = tracer_.nearest(ray);
  auto lamp = hit && !hit.back ? lamps_.lamp_at(hit.patch, ray.origin + hit.distance * ray.direction) : none;
  if (!hit && !portals_.empty()) lamp = lamps_.lamp_of_portal(portals_.first_crossed(ray));
  const auto& normal = side.emitter.normal();
  const auto cosine = static_cast<double>(glm::dot(normal, ray.direction));
  if (lamp == none || !(cosine > 0.0)) return {.rays = 1};
  const auto found = choices.find(tree_, lamp, ray.origin, normal);
  const auto density = lamp_density(lamps_.triangles()[lamp], Vec3d(ray.origin), Vec3d(ray.direction));
  const auto length = hit ? hit.distance : portals_.distance(ray);
  if (ends != nullptr) *ends = {ray.origin, ray.origin + length * ray.direction};
  return {found.choice, lamp, given(cosine, density * found.lamp.probability), true, 1};
}

// The balance heuristic (Veach and Guibas 1995) divides both by the sum of the two densities.
double DirectLight::given(double cosine, double lamp_density) const {
  return cosine / (lamp_density + (options_.multiple_importance ? cosine / std::numbers::pi : 0.0));
}

}  // namespace luxel
