// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/seen_measure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "luxel/core/none.h"
#include "luxel/core/student.h"
#include "luxel/solve/pool_units.h"
#include "luxel/solve/tuning.h"
#include "luxel/trace/place_views.h"
#include "luxel/trace/seen_error.h"

namespace luxel {

namespace {

using namespace tuning::seen;

double squared(double x) { return x * x; }

// Squared errors of one receiver with each replicate left out in turn, scaled to those of all replicates.
class LeaveOneOut {
 public:
  LeaveOneOut(Replicates direct, Replicates gathered) : direct_(direct), gathered_(gathered) {}

  // number: receiver * bands + band. squared_error: of all replicates, with the bias. Adds weight times the
  // results.
  void add(std::size_t number, double squared_error, double weight, std::span<float> without) const {
    const auto n = static_cast<double>(direct_.size());
    const auto value = [&](std::size_t r) {
      return static_cast<double>(direct_[r][number] + gathered_[r][number]);
    };
    double mean = 0.0;
    for (std::size_t r = 0; r < direct_.size(); ++r) mean += value(r) / n;
    double sum = 0.0;
    for (std::size_t r = 0; r < direct_.size(); ++r) sum += squared(value(r) - mean);
    const auto squared_bias = squared_error - sum / (n * (n - 1.0));
    for (std::size_t r = 0; r < direct_.size(); ++r) {
      const auto left = std::max(0.0, sum - squared(value(r) - mean) * n / (n - 1.0));
      without[r] += static_cast<float>(weight * (left / (n * (n - 2.0)) + squared_bias));
    }
  }

 private:
  Replicates direct_, gathered_;
};

// The light of single sides by an answer.
class SidesOfAnswer {
 public:
  SidesOfAnswer(const PatchSet& patches, const GatherSides& sides, const Spread& answer, bool black)
      : patches_(patches), sides_(sides), answer_(answer), black_(black) {}

  SeenSide light_of(SideId side) {
    set(here_, side);
    if (patches_.material_of(side.patch()).is_diffuser()) set(far_, side.opposite());
    return light_of_side(patches_, side, here_, far_, black_);
  }

 private:
  void set(SideEstimate& estimate, SideId side) const {
    const auto bands = patches_.band_count();
    const auto receiver = sides_.receiver_of_side[side.index()];
    estimate.irradiance.assign(bands, 0.0f);
    estimate.squared_error.assign(bands, 0.0);
    for (std::size_t b = 0; receiver != none && b < bands; ++b) {
      estimate.irradiance[b] = answer_.mean[receiver * bands + b];
      estimate.squared_error[b] = static_cast<double>(answer_.squared_error[receiver * bands + b]);
    }
  }

  const PatchSet& patches_;
  const GatherSides& sides_;
  const Spread& answer_;
  bool black_;
  SideEstimate here_, far_;
};

}  // namespace

SeenMeasure::SeenMeasure(const PatchSet& patches, const GatherSides& sides,
                         std::span<const std::uint32_t> units, const Tracer& tracer, const Context& context,
                         Pooling pooling)
    : patches_(patches),
      sides_(sides),
      units_(units.begin(), units.end()),
      pooling_(pooling),
      views_(place_views(patches, tracer, context)) {}

double SeenMeasure::error_of(const Spread& answer) const {
  const auto light = light_of(views_.stating, answer);
  return SeenError(views_.stating, light).percentile_95();
}

SeenLight SeenMeasure::light_of(const Views& views, const Spread& answer) const {
  SeenLight light{std::vector<float>(views.sides.size()), std::vector<float>(views.sides.size()),
                  sky_radiance(patches_)};
  SidesOfAnswer of_answer(patches_, sides_, answer, is_black());
  for (std::size_t i = 0; i < views.sides.size(); ++i) {
    const auto side = of_answer.light_of(views.sides[i]);
    light.radiance[i] = side.radiance;
    light.squared_error[i] = side.squared_error;
  }
  return light;
}

void SeenMeasure::take(const Spread& answer, Replicates direct, Replicates gathered, const Context& context) {
  const auto light = light_of(views_.stating, answer);
  const SeenError seen(views_.stating, light);
  error_ = seen.percentile_95();
  estimate_uncertainty(seen, light, answer, direct, gathered, context);
  take_importance(answer, context);
}

void SeenMeasure::take(const Spread& answer, const Context& context) {
  error_ = error_of(answer);
  uncertainty_ = 0.0;
  take_importance(answer, context);
}

void SeenMeasure::take_importance(const Spread& answer, const Context& context) {
  const auto dealing = light_of(views_.dealing, answer);
  spread_importance(SeenError(views_.dealing, dealing).attention(), answer, context);
}

void SeenMeasure::estimate_uncertainty(const SeenError& seen, const SeenLight& light, const Spread& answer,
                                       Replicates direct, Replicates gathered, const Context& context) {
  const auto bands = patches_.band_count();
  const auto n = direct.size();
  const auto receivers = sides_.size();
  const bool black = is_black();
  // Ordered by receiver, because each process holds the replicates of a range of receivers.
  std::vector<std::uint8_t> is_seen(receivers, 0);
  const auto see = [&](SideId side) {
    if (sides_.receiver_of_side[side.index()] != none) is_seen[sides_.receiver_of_side[side.index()]] = 1;
  };
  for (const auto side : views_.stating.sides) {
    see(side);
    if (is_diffuser(side)) see(side.opposite());
  }
  std::vector<float> without(receivers * n, 0.0f);
  // The same of the light that a receiver's side sends to the other side of a diffuser.
  std::vector<float> without_through(patches_.has_diffusers() ? without.size() : 0, 0.0f);
  const auto mine = spread_partition(SharedWork(context), receivers);
  const LeaveOneOut leave_one_out(direct, gathered);
  context.for_chunks(mine.end() - mine.begin(), mine.grain(), [&](std::size_t from, std::size_t to, int) {
    for (auto s = mine.begin() + from; s < mine.begin() + to; ++s)
      for (std::size_t b = 0; is_seen[s] && b < bands; ++b) {
        const auto rho = black ? 1.0 : static_cast<double>(patches_.reflectance(sides_.side[s].patch(), b));
        leave_one_out.add(s * bands + b, static_cast<double>(answer.squared_error[s * bands + b]),
                          squared(rho / std::numbers::pi) / static_cast<double>(bands),
                          std::span(without).subspan(s * n, n));
        if (!is_diffuser(sides_.side[s])) continue;
        const auto tau = static_cast<double>(patches_.diffuse_transmittance(sides_.side[s].patch(), b));
        leave_one_out.add(s * bands + b, static_cast<double>(answer.squared_error[s * bands + b]),
                          squared(tau / std::numbers::pi) / static_cast<double>(bands),
                          std::span(without_through).subspan(s * n, n));
      }
  });
  mine.all_gather(std::span(without), n);
  if (!without_through.empty()) mine.all_gather(std::span(without_through), n);
  std::vector<double> errors(n);
  context.for_chunks(n, 1, [&](std::size_t r, std::size_t, int) {
    std::vector<float> squared_error(light.squared_error.size(), 0.0f);
    for (std::size_t i = 0; i < squared_error.size(); ++i) {
      const auto receiver = sides_.receiver_of_side[views_.stating.sides[i].index()];
      if (receiver != none) squared_error[i] = without[receiver * n + r];
      if (!is_diffuser(views_.stating.sides[i])) continue;
      const auto far = sides_.receiver_of_side[views_.stating.sides[i].opposite().index()];
      if (far != none) squared_error[i] += without_through[far * n + r];
    }
    errors[r] = seen.percentile_95(squared_error);
  });
  double mean = 0.0;
  for (const auto e : errors) mean += e / static_cast<double>(n);
  double sum = 0.0;
  for (const auto e : errors) sum += squared(e - mean);
  const auto jackknife = std::sqrt(sum * static_cast<double>(n - 1) / static_cast<double>(n));
  uncertainty_ = error_ > 0.0 ? jackknife / error_ : 0.0;
}

double SeenMeasure::area_of(std::size_t receiver) const {
  return static_cast<double>(patches_.area[sides_.side[receiver].patch()]);
}

std::vector<float> SeenMeasure::radiances(const Spread& answer, const Context& context) const {
  const bool black = is_black();
  std::vector<float> result(sides_.size());
  context.for_chunks(result.size(), radiance_grain, [&](std::size_t begin, std::size_t end, int) {
    SidesOfAnswer of_answer(patches_, sides_, answer, black);
    for (auto s = begin; s < end; ++s) result[s] = of_answer.light_of(sides_.side[s]).radiance;
  });
  return result;
}

std::vector<double> SeenMeasure::densities(std::span<const SeenUnit> units) const {
  if (pooling_ == Pooling::unit) {
    std::vector<double> own;
    for (const auto& unit : units) own.push_back(unit.sum / unit.area);
    return own;
  }
  std::size_t fronts = 0;
  while (fronts < units.size() && units_[fronts] < sides_.fronts) ++fronts;
  auto density = pooled_densities(units.first(fronts));
  const auto of_backs = pooled_densities(units.subspan(fronts));
  density.insert(density.end(), of_backs.begin(), of_backs.end());
  return density;
}

std::vector<SeenMeasure::UnitAttention> SeenMeasure::attention_of_units(
    std::span<const Attention> of_seen, std::span<const float> radiance) const {
  std::vector<double> hits(of_seen.size(), 0.0);
  for (const auto code : views_.dealing.seen)
    if (code < Views::sky) hits[code] += 1.0;
  const auto count = units_.size() - 1;
  std::vector<std::uint32_t> unit_of(sides_.size());  // [receiver]
  std::vector<UnitAttention> result(count);
  std::vector<SeenUnit> weights(count);
  std::vector<double> radiance_of_unit(count);
  for (std::size_t u = 0; u < count; ++u) {
    double light = 0.0;
    for (auto s = units_[u]; s < units_[u + 1]; ++s) {
      unit_of[s] = static_cast<std::uint32_t>(u);
      weights[u].area += area_of(s);
      light += area_of(s) * static_cast<double>(radiance[s]);
    }
    radiance_of_unit[u] = light / weights[u].area;
  }
  std::vector<double> adaptations(count, 0.0);  // weight times adaptation
  std::vector<double> found(count, 0.0);        // importance of what was met
  for (std::size_t i = 0; i < of_seen.size(); ++i) {
    const auto receiver = sides_.receiver_of_side[views_.dealing.sides[i].index()];
    if (receiver == none) continue;
    const auto u = unit_of[receiver];
    weights[u].hits += hits[i];
    weights[u].sum += of_seen[i].weight;
    adaptations[u] += of_seen[i].weight * of_seen[i].adaptation;
    found[u] += of_seen[i].importance(static_cast<double>(radiance[receiver]));
  }
  const auto weight = densities(weights);
  auto weighted = weights;
  for (std::size_t u = 0; u < count; ++u) weighted[u].sum = adaptations[u];
  const auto adaptation = densities(weighted);
  for (std::size_t u = 0; u < count; ++u) {
    if (!(weight[u] > 0.0)) continue;
    auto& unit = result[u];
    unit.attention = {weight[u], adaptation[u] / weight[u]};
    unit.importance = unit.attention.importance(radiance_of_unit[u]);
    if (!(weights[u].sum > 0.0)) continue;
    const auto of_met = weight[u] * found[u] / weights[u].sum;
    const auto prior = pooling_ == Pooling::unit ? 0.0 : prior_hits;
    unit.importance = (weights[u].hits * of_met + prior * unit.importance) / (weights[u].hits + prior);
  }
  return result;
}

void SeenMeasure::spread_importance(std::span<const Attention> of_seen, const Spread& answer,
                                    const Context& context) {
  const auto bands = patches_.band_count();
  const auto scale = 1.0 / squared(std::numbers::pi * static_cast<double>(bands));
  const bool black = is_black();
  const auto radiance = radiances(answer, context);
  const auto units = attention_of_units(of_seen, radiance);
  importance_.assign(sides_.size(), 0.0);
  double seen = 0.0;   // sum of importance * variance
  double whole = 0.0;  // sum of area * variance
  for (std::size_t u = 0; u < units.size(); ++u) {
    for (auto s = units_[u]; s < units_[u + 1]; ++s) {
      const auto patch = sides_.side[s].patch();
      double rho2 = 0.0;
      double tau2 = 0.0;
      for (std::size_t b = 0; b < bands; ++b) {
        rho2 += black ? 1.0 : squared(static_cast<double>(patches_.reflectance(patch, b)));
        tau2 += squared(static_cast<double>(patches_.diffuse_transmittance(patch, b)));
      }
      const auto own = units[u].attention.importance(static_cast<double>(radiance[s]));
      const auto of_side = scale * area_of(s) * std::min(own, units[u].importance);
      importance_[s] += rho2 * of_side;
      const auto far = sides_.receiver_of_side[sides_.side[s].opposite().index()];
      if (tau2 > 0.0 && far != none) importance_[far] += tau2 * of_side;
    }
  }
  for (std::size_t s = 0; s < importance_.size(); ++s) {
    double variance = 0.0;
    for (std::size_t b = 0; b < bands; ++b)
      variance += squared(static_cast<double>(answer.standard_error[s * bands + b]));
    seen += importance_[s] * variance;
    whole += area_of(s) * variance;
  }
  const auto by_area = whole > 0.0 ? area_fraction * seen / whole : 0.0;
  for (std::size_t s = 0; s < importance_.size(); ++s)
    importance_[s] = (1.0 - area_fraction) * importance_[s] + by_area * area_of(s);
}

SeenSides seen_sides(const PatchSet& patches, const Tracer& tracer, const SideValues& irradiance,
                     const FrontAndBack<double>& squared_error, const Context& context) {
  const auto sides = all_gather_sides(patches, make_patch_tree(patches, context));
  const auto units = neighbour_begins(sides, sequence_positions);
  // Errors of the mesh differ from side to side, and count where they are seen: none is to count for a side
  // that is hidden next to a bright one.
  SeenMeasure measure(patches, sides, units, tracer, context, SeenMeasure::Pooling::unit);
  if (!measure.has_views()) return {};
  const auto bands = patches.band_count();
  Spread answer;
  for (const auto side : sides.side)
    for (std::size_t b = 0; b < bands; ++b) {
      const auto at = side.patch() * bands + b;
      const auto squared = static_cast<float>(squared_error.of(side)[at]);
      answer.mean.push_back(irradiance.of(side)[at]);
      answer.squared_error.push_back(squared);
      answer.standard_error.push_back(std::sqrt(std::max(0.0f, squared)));
    }
  measure.take(answer, context);
  SeenSides result{measure.error(), std::vector<double>(side_count(patches.size()), 0.0)};
  for (std::size_t receiver = 0; receiver < sides.size(); ++receiver)
    result.importance[sides.side[receiver].index()] = measure.importance()[receiver];
  return result;
}

std::vector<double> seen_densities(const PatchSet& patches, const Tracer& tracer, const Context& context) {
  const auto sets = place_views(patches, tracer, context);
  if (sets.empty()) return {};
  std::vector<double> density(patches.size(), 0.0);  // first the fractions
  for (const auto* views : {&sets.dealing, &sets.stating})
    for (std::size_t v = 0; v < views->size(); ++v) {
      const auto seen = views->seen_by(v);
      const auto of_one =
          0.5 * sets.places * static_cast<double>(views->weight[v]) / static_cast<double>(seen.size());
      for (const auto code : seen)
        if ((code & Views::unfocused) == 0 && code != Views::sky)
          density[views->sides[code].patch()] += of_one;
    }
  const auto tree = make_patch_tree(patches, context);
  for (const auto region : tree.regions) {
    const auto places = std::span(tree.order).subspan(tree.nodes[region].first, tree.nodes[region].count);
    for (std::size_t begin = 0; begin < places.size(); begin += sequence_positions) {
      const auto unit =
          places.subspan(begin, std::min<std::size_t>(sequence_positions, places.size() - begin));
      double fraction = 0.0, area = 0.0;
      for (const auto p : unit) {
        fraction += density[p];
        area += static_cast<double>(patches.area[p]);
      }
      for (const auto p : unit) density[p] = fraction / area;
    }
  }
  return density;
}

namespace {

double error_in(const Views& views, const PatchSet& patches, const Solution& solution) {
  if (views.size() == 0) return 0.0;
  const auto widening =
      solution.error_degrees_of_freedom > 0.0 ? student_widening(solution.error_degrees_of_freedom) : 1.0;
  const bool black = reflects_nothing(patches, views);
  const auto bands = patches.band_count();
  SeenLight light{{}, {}, sky_radiance(patches)};
  SideEstimate here, far;
  const auto set = [&](SideId side, SideEstimate& estimate) {
    estimate = {};
    for (auto i = side.patch() * bands; i < (side.patch() + 1) * bands; ++i) {
      estimate.irradiance.push_back(solution.irradiance.of(side)[i]);
      const auto narrow = static_cast<double>(solution.standard_error.of(side)[i]) / widening;
      estimate.squared_error.push_back(narrow * narrow);
    }
  };
  for (const auto side : views.sides) {
    set(side, here);
    set(side.opposite(), far);
    const auto seen = light_of_side(patches, side, here, far, black);
    light.radiance.push_back(seen.radiance);
    light.squared_error.push_back(seen.squared_error);
  }
  return SeenError(views, light).percentile_95();
}

}  // namespace

double seen_error_of(const PatchSet& patches, const Tracer& tracer, const Solution& solution,
                     const Context& context) {
  if (solution.standard_error.front.empty()) return 0.0;
  return error_in(place_views(patches, tracer, context).stating, patches, solution);
}

double picture_error_of(const PatchSet& patches, const Tracer& tracer, const Solution& solution,
                        const Camera& camera) {
  if (solution.standard_error.front.empty()) return 0.0;
  return error_in(camera_view(patches, tracer, camera), patches, solution);
}

}  // namespace luxel
