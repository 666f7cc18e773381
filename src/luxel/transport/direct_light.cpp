// SPDX-License-Identifier: Apache-2.0
#include "luxel/transport/direct_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "luxel/random/address.h"
#include "luxel/random/sobol.h"
#include "luxel/transport/lamp_sample.h"
#include "luxel/transport/lit_side.h"
#include "luxel/transport/patch_emitter.h"

namespace luxel {
namespace {

constexpr std::uint64_t stream = 0x6c616d70;  // apart from the other users of the seed
// Of the choices, spread evenly over all lamps, for those that closed form or bound underrate: it bounds the
// weights.
constexpr double least_share = 0.02;
// With how many samples the visibility of all lamps enters that of one. With 1 errors are 1 to 4 % smaller,
// but replicates borrow so much from each other that their spread tells 10 % too little; with very many,
// errors are a quarter larger where there are a dozen lamps.
constexpr double prior_samples = 3.0;

// One side of a patch in one round.
struct Side {
  PatchEmitter emitter;
  std::size_t side;
  std::uint32_t position;
  std::uint32_t round;
  std::uint32_t samples;  // a replicate
  float lift;             // m
};

// The random numbers of one replicate of one side.
class Numbers {
 public:
  Numbers(const DirectOptions& options, const Side& side, std::uint32_t replicate)
      : key_(stream_key(mix64(options.seed + stream), side.round,
                        2 * replicate + static_cast<std::uint32_t>(side.side % 2))),
        low_discrepancy_(options.low_discrepancy) {
    if (options.stratified && low_discrepancy_)
      first_ = side.position * side.samples;  // may wrap round: the sequence has 2^32 points
    else
      key_ = stream_key(key_, 0, static_cast<std::uint32_t>(side.side));
    sobol_ = OwenSobol(key_);
  }
  std::array<float, 4> at(std::uint32_t sample) const {
    return low_discrepancy_ ? sobol_.first4(first_ + sample) : uniform4(key_, sample);
  }

 private:
  std::uint64_t key_;
  std::uint32_t first_ = 0;
  bool low_discrepancy_;
  OwenSobol sobol_{0};
};

// Whom a sample may ask: lamps with their closed form, then branches of many lamps.
struct Choices {
  std::vector<SideLamp> lamps;
  std::vector<LampBranch> branches;
  std::vector<double> before{0.0};  // running sum of the probabilities, which end at 1

  double probability(std::size_t i) const { return before[i + 1] - before[i]; }

  // Chooses with u and stretches what is left of it to [0, 1) again: it goes on as the first number of the
  // point, so that the two best dimensions cover all lamps at once.
  std::size_t choose(double& u) const {
    const auto above = std::upper_bound(before.begin() + 1, before.end() - 1, u);
    const auto i = static_cast<std::size_t>(above - before.begin() - 1);
    u = std::clamp((u - before[i]) / probability(i), 0.0, 0x1.fffffffffffffp-1);
    return i;
  }
};

Choices make_choices(const Side& side, const Lamps& lamps, const LightTree& tree,
                     const DirectOptions& options) {
  Choices choices;
  const auto corners = side.emitter.corners();
  std::vector<std::uint32_t> single;
  if (lamps.size() <= DirectLight::branches) {
    single.resize(lamps.size());
    std::iota(single.begin(), single.end(), 0u);
  } else {
    const auto centre = (corners[0] + corners[1] + corners[2]) / 3.0f;
    const auto radius = std::max({glm::distance(corners[0], centre), glm::distance(corners[1], centre),
                                  glm::distance(corners[2], centre)});
    tree.cut(centre, 1.0001f * radius, side.emitter.normal(), DirectLight::branches, choices.branches);
    std::erase_if(choices.branches, [&](const LampBranch& branch) {
      if (branch.single) single.push_back(branch.index);
      return branch.single;
    });
  }
  find_side_lamps(lamps, single, corners, side.emitter.normal(), options.control_variate, choices.lamps);

  const auto count = choices.lamps.size() + choices.branches.size();
  double total = 0.0;
  std::vector<double> share;
  for (const auto& lamp : choices.lamps) {
    const auto& triangle = lamps.triangles()[lamp.lamp];
    share.push_back(options.importance ? triangle.weight * lamp.irradiance : triangle.area);
  }
  for (const auto& branch : choices.branches)
    share.push_back(options.importance ? branch.irradiance : branch.area);
  for (const auto s : share) total += s;
  for (const auto s : share) {
    const auto own = total > 0.0 ? s / total : 1.0 / static_cast<double>(count);
    const auto probability = (1.0 - least_share) * own + least_share / static_cast<double>(count);
    choices.before.push_back(choices.before.back() + probability);
  }
  for (auto& b : choices.before) b /= choices.before.back();
  return choices;
}

// Unshadowed samples and seen ones, summed.
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

// The estimate of one replicate for each lamp with a closed form, at unit radiance: what it saw, corrected by
// what the others say of visibility. own, whole: [lamp], sums of this replicate and of those that may speak.
void correct(const Choices& choices, const Lamps& lamps, std::span<const Tally> own,
             std::span<const Tally> others, double per_sample, std::span<double> value) {
  Tally together;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const auto weight = lamps.triangles()[choices.lamps[i].lamp].weight;
    together += {weight * others[i].all, weight * others[i].seen};
  }
  const auto visibility = together.all > 0.0 ? together.seen / together.all : 0.0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const auto irradiance = choices.lamps[i].irradiance;
    const auto prior = prior_samples * irradiance / choices.probability(i);
    const auto all = others[i].all + prior;
    const auto beta = all > 0.0 ? (others[i].seen + prior * visibility) / all : visibility;
    value[i] = beta * irradiance + (own[i].seen - beta * own[i].all) * per_sample;
  }
}

void add_radiance(std::span<double> out, double value, std::span<const float> radiance) {
  for (std::size_t b = 0; b < out.size(); ++b) out[b] += value * static_cast<double>(radiance[b]);
}

}  // namespace

DirectLight::DirectLight(const PatchSet& patches, const Tracer& tracer, const Lamps& lamps,
                         const DirectOptions& options)
    : patches_(patches), tracer_(tracer), lamps_(lamps), options_(options), tree_(lamps) {
  for (const auto& lamp : lamps.triangles()) lift_.push_back(origin_lift(lamp.corner));
}

// Both ends are lifted off their planes by the bound on rounding, which so keeps the lamp's own triangle
// behind the end however flat the ray comes in, and however near the lamp is.
bool DirectLight::visible(const Vec3& from, const Vec3d& to, std::uint32_t lamp, float least_lift) const {
  const auto lift = static_cast<double>(std::max(least_lift, lift_[lamp]));
  const auto way = to + lift * lamps_.triangles()[lamp].normal - Vec3d(from);
  const auto distance = glm::length(way);
  return !(distance > 0.0) || !tracer_.occluded({from, Vec3(way / distance)}, static_cast<float>(distance));
}

std::uint64_t DirectLight::estimate(std::size_t side_index, std::uint32_t position, std::uint32_t round,
                                    std::uint32_t per_replicate, std::span<float> out) const {
  const Side side{PatchEmitter(patches_, side_index),          side_index, position, round, per_replicate,
                  origin_lift(patches_.points(side_index / 2))};
  std::fill(out.begin(), out.end(), 0.0f);
  const auto choices = make_choices(side, lamps_, tree_, options_);
  if (choices.before.size() == 1) return 0;

  // 1. Shadow rays. Lamps with a closed form are tallied, the others added as they come.
  const auto triangles = lamps_.triangles();
  const auto& normal = side.emitter.normal();
  const auto known = choices.lamps.size();
  const auto bands = lamps_.bands();
  const auto replicates = options_.replicates;
  const auto per_sample = 1.0 / static_cast<double>(per_replicate);
  std::vector<Tally> tally(replicates * known);
  std::vector<double> sum(replicates * bands, 0.0);
  std::uint64_t rays = 0;
  for (std::uint32_t r = 0; r < replicates; ++r) {
    const Numbers numbers(options_, side, r);
    for (std::uint32_t k = 0; k < per_replicate; ++k) {
      const auto u = numbers.at(k);
      const auto from = side.emitter.point(u[2], u[3]);
      auto u1 = static_cast<double>(u[0]);
      const auto i = choices.choose(u1);
      LampChoice choice;
      if (i < known)
        choice = {choices.lamps[i].lamp, 1.0, u1};
      else
        choice = tree_.choose(choices.branches[i - known], from, normal, u1, !options_.importance);
      if (!(choice.probability > 0.0)) continue;
      const auto sample =
          sample_lamp(triangles[choice.lamp], Vec3d(from), choice.rest, static_cast<double>(u[1]));
      const auto cosine = glm::dot(Vec3d(normal), sample.direction);
      if (!(sample.density > 0.0) || !(cosine > 0.0)) continue;
      const auto given = cosine / (sample.density * choices.probability(i) * choice.probability);
      ++rays;
      const bool seen =
          visible(from, Vec3d(from) + sample.distance * sample.direction, choice.lamp, side.lift);
      if (i < known)
        tally[r * known + i] += {given, seen ? given : 0.0};
      else if (seen)
        add_radiance(std::span(sum).subspan(r * bands, bands), given * per_sample,
                     lamps_.radiance(choice.lamp));
    }
  }

  // 2. Each replicate corrected by what the others saw.
  std::vector<Tally> whole(known);
  for (std::size_t i = 0; i < tally.size(); ++i) whole[i % known] += tally[i];
  std::vector<Tally> others = whole;
  std::vector<double> value(known);
  for (std::uint32_t r = 0; r < replicates; ++r) {
    const auto own = std::span(tally).subspan(r * known, known);
    for (std::size_t i = 0; i < known; ++i) {
      value[i] = own[i].seen * per_sample;
      if (replicates > 1) others[i] = whole[i] - own[i];
    }
    if (options_.control_variate) correct(choices, lamps_, own, others, per_sample, value);
    for (std::size_t i = 0; i < known; ++i)
      add_radiance(std::span(sum).subspan(r * bands, bands), value[i],
                   lamps_.radiance(choices.lamps[i].lamp));
  }
  std::transform(sum.begin(), sum.end(), out.begin(), [](double v) { return static_cast<float>(v); });
  return rays;
}

}  // namespace luxel
