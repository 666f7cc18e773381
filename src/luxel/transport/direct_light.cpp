// SPDX-License-Identifier: Apache-2.0
#include "luxel/transport/direct_light.h"

#include <algorithm>
#include <cmath>

#include "luxel/random/address.h"
#include "luxel/random/sobol.h"
#include "luxel/transport/lamp_sample.h"
#include "luxel/transport/lit_side.h"
#include "luxel/transport/patch_emitter.h"

namespace luxel {
namespace {

constexpr std::uint64_t stream = 0x6c616d70;  // apart from the other users of the seed
constexpr double least_share =
    0.02;  // of the choices, spread over lamps that the closed forms may underrate: a bound on the weights
constexpr double prior_samples = 1.0;  // with which the visibility of all lamps enters that of one

}  // namespace

struct DirectLight::Side {
  PatchEmitter emitter;
  std::size_t side = 0;
  std::uint32_t position = 0;
  std::uint32_t round = 0;
  std::uint32_t samples = 0;  // a replicate
  float lift = 0.0f;
};

// The random numbers of one replicate of one side.
class DirectLight::Numbers {
 public:
  Numbers(const DirectOptions& options, const Side& side, std::uint32_t replicate)
      : key_(key(options, side, replicate)),
        sobol_(key_),
        first_(options.stratified ? side.position * side.samples : 0),
        low_discrepancy_(options.low_discrepancy) {}

  std::array<float, 4> at(std::uint32_t sample) const {
    return low_discrepancy_ ? sobol_.first4(first_ + sample) : uniform4(key_, sample);
  }

 private:
  static std::uint64_t key(const DirectOptions& options, const Side& side, std::uint32_t replicate) {
    const auto shared = stream_key(mix64(options.seed + stream), side.round,
                                   2 * replicate + static_cast<std::uint32_t>(side.side % 2));
    return options.stratified && options.low_discrepancy
               ? shared
               : stream_key(shared, 0, static_cast<std::uint32_t>(side.side));
  }

  std::uint64_t key_;
  OwenSobol sobol_;
  std::uint32_t first_;
  bool low_discrepancy_;
};

DirectLight::DirectLight(const PatchSet& patches, const Tracer& tracer, const Lamps& lamps,
                         const DirectOptions& options)
    : patches_(patches), tracer_(tracer), lamps_(lamps), options_(options), tree_(lamps), area_before_{0.0} {
  for (const auto& lamp : lamps.triangles()) {
    area_before_.push_back(area_before_.back() + lamp.area);
    lift_.push_back(origin_lift(lamp.corner));
  }
}

std::uint64_t DirectLight::estimate(std::size_t side, std::uint32_t position, std::uint32_t round,
                                    std::uint32_t per_replicate, std::span<float> out) const {
  std::vector<double> sum(out.size(), 0.0);
  const Side at{PatchEmitter(patches_, side),          side, position, round, per_replicate,
                origin_lift(patches_.points(side / 2))};
  const auto rays = lamps_.size() <= few_lamps ? estimate_few(at, sum) : estimate_many(at, sum);
  std::transform(sum.begin(), sum.end(), out.begin(), [](double v) { return static_cast<float>(v); });
  return rays;
}

// Both ends are lifted off their planes by the bound on rounding, which so keeps the lamp's own triangle
// behind the end however flat the ray comes in, and however near the lamp is.
bool DirectLight::visible(const Side& side, std::uint32_t lamp, const Vec3& from, const Vec3d& to) const {
  const auto lift = static_cast<double>(std::max(side.lift, lift_[lamp]));
  const auto way = to + lift * lamps_.triangles()[lamp].normal - Vec3d(from);
  const auto distance = glm::length(way);
  return !(distance > 0.0) || !tracer_.occluded({from, Vec3(way / distance)}, static_cast<float>(distance));
}

namespace {

// Which of few lamps: the first number chooses and, stretched, goes on as the first of the point. So two
// dimensions, the best ones, cover all lamps at once.
struct Stretch {
  std::size_t index = 0;
  double rest = 0.0;
};
Stretch stretch(const std::vector<double>& before, double u) {
  const auto at = u * before.back();
  const auto above = std::upper_bound(before.begin() + 1, before.end() - 1, at);
  const auto index = static_cast<std::size_t>(above - before.begin() - 1);
  const auto rest = (at - before[index]) / (before[index + 1] - before[index]);
  return {index, std::clamp(rest, 0.0, 0x1.fffffffffffffp-1)};
}

// Unshadowed samples and seen ones, summed.
struct Tally {
  double all = 0.0;
  double seen = 0.0;
};

}  // namespace

std::uint64_t DirectLight::estimate_few(const Side& side, std::span<double> out) const {
  const auto triangles = lamps_.triangles();
  std::vector<SideLamp> found;
  find_side_lamps(lamps_, side.emitter.corners(), side.emitter.normal(), options_.control_variate, found);
  if (found.empty()) return 0;
  const auto count = found.size();

  // 1. How often each is asked.
  double total = 0.0;
  for (const auto& lamp : found) total += triangles[lamp.lamp].weight * lamp.irradiance;
  std::vector<double> before{0.0};
  for (const auto& lamp : found) {
    const auto& triangle = triangles[lamp.lamp];
    const auto share = total > 0.0 ? triangle.weight * lamp.irradiance / total : 0.0;
    const auto probability =
        options_.importance ? share + least_share / static_cast<double>(count) : triangle.area;
    before.push_back(before.back() + probability);
  }

  // 2. Shadow rays.
  const auto replicates = options_.replicates;
  std::vector<Tally> tally(replicates * count);
  std::uint64_t rays = 0;
  const auto n = Vec3d(side.emitter.normal());
  for (std::uint32_t r = 0; r < replicates; ++r) {
    const Numbers numbers(options_, side, r);
    for (std::uint32_t k = 0; k < side.samples; ++k) {
      const auto u = numbers.at(k);
      const auto choice = stretch(before, static_cast<double>(u[0]));
      const auto lamp = found[choice.index].lamp;
      const auto from = side.emitter.point(u[2], u[3]);
      const auto sample = sample_lamp(triangles[lamp], Vec3d(from), choice.rest, static_cast<double>(u[1]));
      const auto cosine = glm::dot(n, sample.direction);
      if (!(sample.density > 0.0) || !(cosine > 0.0)) continue;
      const auto probability = (before[choice.index + 1] - before[choice.index]) / before.back();
      const auto given = cosine / (sample.density * probability);
      auto& t = tally[r * count + choice.index];
      t.all += given;
      ++rays;
      if (visible(side, lamp, from, Vec3d(from) + sample.distance * sample.direction)) t.seen += given;
    }
  }

  // 3. What all replicates saw, of each lamp and of all.
  std::vector<Tally> of_lamp(count);
  for (std::size_t i = 0; i < replicates * count; ++i) {
    of_lamp[i % count].all += tally[i].all;
    of_lamp[i % count].seen += tally[i].seen;
  }
  const auto per_sample = 1.0 / static_cast<double>(side.samples);
  for (std::uint32_t r = 0; r < replicates; ++r) {
    const auto* own = &tally[r * count];
    const auto without_own = [&](std::size_t i) {
      return replicates > 1 ? Tally{of_lamp[i].all - own[i].all, of_lamp[i].seen - own[i].seen} : of_lamp[i];
    };
    Tally whole;
    for (std::size_t i = 0; i < count; ++i) {
      const auto other = without_own(i);
      whole.all += triangles[found[i].lamp].weight * other.all;
      whole.seen += triangles[found[i].lamp].weight * other.seen;
    }
    const auto visibility = whole.all > 0.0 ? whole.seen / whole.all : 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      auto value = own[i].seen * per_sample;
      if (options_.control_variate) {
        const auto other = without_own(i);
        const auto probability = (before[i + 1] - before[i]) / before.back();
        const auto prior = prior_samples * found[i].irradiance / probability;
        const auto all = other.all + prior;
        const auto beta = all > 0.0 ? (other.seen + prior * visibility) / all : visibility;
        value = beta * found[i].irradiance + (own[i].seen - beta * own[i].all) * per_sample;
      }
      const auto radiance = lamps_.radiance(found[i].lamp);
      for (std::size_t b = 0; b < radiance.size(); ++b)
        out[r * radiance.size() + b] += value * static_cast<double>(radiance[b]);
    }
  }
  return rays;
}

std::uint64_t DirectLight::estimate_many(const Side& side, std::span<double> out) const {
  const auto triangles = lamps_.triangles();
  const auto bands = lamps_.bands();
  const auto n = Vec3d(side.emitter.normal());
  std::uint64_t rays = 0;
  for (std::uint32_t r = 0; r < options_.replicates; ++r) {
    const Numbers numbers(options_, side, r);
    for (std::uint32_t k = 0; k < side.samples; ++k) {
      const auto u = numbers.at(k);
      const auto from = side.emitter.point(u[2], u[3]);
      LampChoice choice;
      if (options_.importance) {
        choice = tree_.choose(from, side.emitter.normal(), static_cast<double>(u[0]));
      } else {
        const auto [index, rest] = stretch(area_before_, static_cast<double>(u[0]));
        choice = {static_cast<std::uint32_t>(index), triangles[index].area / area_before_.back(), rest};
      }
      if (!(choice.probability > 0.0)) continue;
      const auto sample =
          sample_lamp(triangles[choice.lamp], Vec3d(from), choice.rest, static_cast<double>(u[1]));
      const auto cosine = glm::dot(n, sample.direction);
      if (!(sample.density > 0.0) || !(cosine > 0.0)) continue;
      ++rays;
      if (!visible(side, choice.lamp, from, Vec3d(from) + sample.distance * sample.direction)) continue;
      const auto given = cosine / (sample.density * choice.probability * static_cast<double>(side.samples));
      const auto radiance = lamps_.radiance(choice.lamp);
      for (std::size_t b = 0; b < bands; ++b) out[r * bands + b] += given * static_cast<double>(radiance[b]);
    }
  }
  return rays;
}

}  // namespace luxel
