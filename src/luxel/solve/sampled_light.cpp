// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/sampled_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "luxel/classical/stochastic_jacobi.h"
#include "luxel/core/student.h"
#include "luxel/solution/error_95th.h"
#include "luxel/solve/tuning.h"
#include "luxel/surface/preserve_hue.h"

namespace luxel {

namespace {

using namespace tuning::answer;

}  // namespace

SampledLight::SampledLight(const PatchSet& patches, const PatchTree& tree, const GatherSides& sides,
                           bool smooths, const Context& context)
    : patches_(patches),
      sides_(sides),
      units_(neighbour_begins(sides, hue_positions)),
      scattering_(scattering_of(patches, sides, context)) {
  for (const auto side : sides.side) area_.push_back(patches.area[side.patch()]);
  if (smooths && sides.size() >= min_smoothed_receivers) smoothing_.emplace(patches, tree, sides);
}

SampledLight::Answer SampledLight::answer(std::span<std::vector<float>> direct,
                                          std::span<std::vector<float>> gathered,
                                          std::span<const float> not_found, const Enough& enough,
                                          const Context& context, const Observer& observe) const {
  const auto bands = patches_.band_count();
  if (observe) observe(false);
  // Smoothing is applied only where it is needed: the patches' own rays make no assumption.
  auto own = spread_of_sum(direct, gathered, {not_found, bands, area_}, context);
  if (!smoothing_ || enough(own)) {
    preserve_hue(own.mean, bands, area_, units_);
    return {std::move(own), {}};
  }
  const auto mine = spread_partition(SharedWork(context), area_.size());
  std::vector<float> bias(area_.size() * bands, 0.0f);
  smoothing_->smooth(direct, gathered, bias, context, mine);
  if (observe) observe(true);
  constexpr std::size_t families = 2;  // of replicates: each half has its own mean
  auto not_shown = bias;
  std::transform(bias.begin(), bias.end(), not_found.begin(), not_shown.begin(), std::plus<>());
  auto spread = spread_of_sum(direct, gathered, {not_shown, bands, area_, families}, context);
  mine.all_gather(std::span(bias), bands);
  preserve_hue(spread.mean, bands, area_, units_);
  return {std::move(spread), std::move(bias)};
}

SampledLight::Answer SampledLight::answer_of_part(Replicates direct, Replicates gathered,
                                                  const Context& context) const {
  const auto bands = patches_.band_count();
  const std::vector<float> no_bias(area_.size() * bands, 0.0f);
  auto spread = spread_of_sum(direct, gathered, {no_bias, bands, area_}, context);
  preserve_hue(spread.mean, bands, area_, units_);
  return {std::move(spread), {}};
}

void SampledLight::write(const Answer& answer, Solution& solution, const Context& context) const {
  const auto bands = patches_.band_count();
  const auto numbers = patches_.size() * bands;
  auto& s = solution;
  const bool shared = !answer.bias.empty();
  const std::array arrays = {&s.irradiance.front,     &s.irradiance.back,      &s.radiosity.front,
                             &s.radiosity.back,       &s.standard_error.front, &s.standard_error.back,
                             &s.smoothing_bias.front, &s.smoothing_bias.back};
  context.for_chunks(arrays.size(), 1, [&](std::size_t i, std::size_t, int) {
    arrays[i]->assign(shared || i < arrays.size() - 2 ? numbers : 0, 0.0f);
  });
  context.for_chunks(patches_.size(), grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto p = begin; p < end; ++p)
      for (std::size_t b = 0; b < bands; ++b) s.radiosity.front[p * bands + b] = patches_.emittance(p, b);
  });
  const auto scattering = this->scattering();
  const auto irradiance = [&](std::size_t i) { return std::max(0.0f, answer.mean[i]); };
  context.for_chunks(area_.size(), grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto receiver = begin; receiver < end; ++receiver) {
      const auto side = sides_.side[receiver];
      const bool back = side.is_back();
      for (std::size_t b = 0; b < bands; ++b) {
        const auto i = receiver * bands + b;
        const auto at = side.patch() * bands + b;
        s.irradiance.of(back)[at] = irradiance(i);
        s.radiosity.of(back)[at] += scattering.sent_on(irradiance, i, bands);
        s.standard_error.of(back)[at] = answer.standard_error[i];
        if (shared) s.smoothing_bias.of(back)[at] = std::sqrt(std::max(0.0f, answer.bias[i]));
      }
    }
  });
  s.bands = patches_.bands;
  s.error_95th = error_95th_of(s);
  s.predicted_error = error_of(answer);
  s.predicted_bias = answer.total_squared_light > 0.0
                         ? std::sqrt(answer.total_squared_bias / answer.total_squared_light)
                         : 0.0;
  s.error_degrees_of_freedom = answer.degrees_of_freedom;
}

double error_of(const Spread& spread) {
  return spread.total_squared_light > 0.0
             ? std::sqrt(std::max(0.0, spread.total_squared_error) / spread.total_squared_light)
             : 0.0;
}

std::vector<std::vector<float>> sum_of_groups(std::span<const std::vector<float>> light, std::size_t groups,
                                              std::size_t bands, std::span<const float> weight,
                                              const Context& context) {
  if (groups == 1 && weight.empty()) return {light.begin(), light.end()};
  const auto width = groups * bands;
  std::vector<std::vector<float>> sum;
  for (const auto& from : light) {
    const auto receivers = from.size() / width;
    auto& to = sum.emplace_back(receivers * bands);
    context.for_chunks(receivers, grain, [&](std::size_t begin, std::size_t end, int) {
      for (auto s = begin; s < end; ++s)
        for (std::size_t b = 0; b < bands; ++b) {
          float total = 0.0f;
          for (std::size_t g = 0; g < groups; ++g) {
            const auto value = from[s * width + g * bands + b];
            total += weight.empty() ? value : weight[g * bands + b] * value;
          }
          to[s * bands + b] = total;
        }
    });
  }
  return sum;
}

EnergyAccount energy_of(const PatchSet& patches, const SampledOperator& transport,
                        const std::vector<float>& irradiance, const Context& context) {
  const auto& hits = transport.hits();
  const auto& sides = hits.sides();
  const auto bands = patches.band_count();
  const auto materials = patches.materials.size();
  const auto table = scattering_of(patches, sides, context);
  const auto scattering = table.view();
  // Power carried by a ray of the receiver in one replicate, W, [receiver][band].
  std::vector<double> carried(sides.size() * bands);
  std::vector<double> area_per_ray(sides.size());  // m²
  // Per block: absorbed, escaped, lost at each material's back, absorbed in panes, and from the sky, [band].
  const auto in_panes = 2 + materials, from_sky = in_panes + 1, parts = from_sky + 1;
  const auto width = parts * bands;
  std::vector<double> sums(hits.blocks() * width, 0.0);
  const auto begins = hits.block_begins();
  context.for_chunks(hits.blocks(), 1, [&](std::size_t first, std::size_t last, int) {
    for (auto block = first; block < last; ++block) {
      auto* sum = &sums[block * width];
      for (std::size_t s = begins[block]; s < begins[block + 1]; ++s) {
        const auto patch = sides.side[s].patch();
        const double area = patches.area[patch];
        area_per_ray[s] = area / hits.rays_per_receiver()[s];
        for (std::size_t b = 0; b < bands; ++b) {
          const auto i = s * bands + b;
          const double rho = scattering.reflectance[i];
          const double H = irradiance[i];
          const double own =
              !sides.side[s].is_back() ? static_cast<double>(patches.emittance(patch, b)) : 0.0;
          auto sent = own + rho * H;
          auto albedo = rho;
          if (scattering.transmits()) {
            sent += double{scattering.transmitted([&](std::size_t at) { return irradiance[at]; }, i, bands)};
            albedo += double{scattering.transmittance[i]};
          }
          carried[i] = area_per_ray[s] * sent;
          sum[b] += area * (1.0 - albedo) * H;
        }
      }
      for (std::uint32_t r = 0; r < hits.replicates(); ++r) {
        const auto half = transport.half_of(r);
        const auto weight = 0.5 / (transport.half_begin(half + 1) - transport.half_begin(half));
        hits.for_each_hit(r, block, [&](std::uint32_t receiver, std::uint32_t element) {
          if (element < sides.size() || element == hits.dark()) return;
          const auto counts = weight * transport.row_factor(r, receiver);
          const auto power = std::span(carried).subspan(receiver * bands, bands);
          if (!hits.is_escape(element)) {
            const auto sink =
                hits.has_panes() && element == hits.in_panes() ? in_panes : 2 + element - hits.absorbed(0);
            for (std::size_t b = 0; b < bands; ++b) sum[sink * bands + b] += counts * power[b];
            return;
          }
          const auto sky_patch = hits.sky_patch_of(element);
          for (std::size_t b = 0; b < bands; ++b) {
            const auto let_through = hits.tint_of(element, b);
            sum[bands + b] += counts * power[b] * let_through;
            sum[in_panes * bands + b] += counts * power[b] * (1.0 - let_through);
            sum[from_sky * bands + b] +=
                counts * area_per_ray[receiver] * patches.sky_radiosity(sky_patch, b) * let_through;
          }
        });
      }
    }
  });

  hits.partition().all_gather(
      std::span(sums), width, hits.blocks(), [](std::size_t block) { return block; },
      [&](std::size_t block) { return sides.position[begins[block]]; });

  EnergyAccount energy(emitted_power(patches), materials);
  auto& balance = energy.balance;
  for (std::size_t block = 0; block < hits.blocks(); ++block)
    for (std::size_t b = 0; b < bands; ++b) {
      const auto* sum = &sums[block * width];
      balance.from_sky[b] += sum[from_sky * bands + b];
      balance.in_panes[b] += sum[in_panes * bands + b];
      balance.absorbed[b] += sum[b];
      balance.escaped[b] += sum[bands + b];
      for (std::size_t m = 0; m < materials; ++m) {
        balance.lost_at_backs[b] += sum[(2 + m) * bands + b];
        energy.back_loss[m] += sum[(2 + m) * bands + b];
      }
    }
  return energy;
}

namespace {

struct Estimate {
  double mean = 0.0, standard_error = 0.0;
};

// value(r): of replicate r.
template <typename Value>
Estimate estimate_of(std::size_t replicates, Value value) {
  const auto n = static_cast<double>(replicates);
  Estimate estimate;
  for (std::size_t r = 0; r < replicates; ++r) estimate.mean += value(r) / n;
  double sum = 0.0;
  for (std::size_t r = 0; r < replicates; ++r) sum += std::pow(value(r) - estimate.mean, 2.0);
  estimate.standard_error = student_widening(n - 1.0) * std::sqrt(sum / (n * (n - 1.0)));
  return estimate;
}

}  // namespace

SurfaceMeans measure_surfaces(const PatchSet& patches, const GatherSides& sides, Replicates direct,
                              Replicates gathered, const Context& context) {
  const auto bands = patches.band_count();
  const auto kinds = 2 * patches.materials.size();
  std::vector<std::size_t> kind(sides.size());  // [receiver]: 2 * material, + 1 for its back
  std::vector<double> area(kinds, 0.0);
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const auto patch = sides.side[s].patch();
    kind[s] = 2 * static_cast<std::size_t>(patches.material[patch]) + sides.side[s].is_back();
    area[kind[s]] += static_cast<double>(patches.area[patch]);
  }
  // W, [replicate][kind * bands + band]; the last kind is the total.
  std::vector<std::vector<double>> power(direct.size());
  context.for_chunks(direct.size(), 1, [&](std::size_t r, std::size_t, int) {
    power[r].assign((kinds + 1) * bands, 0.0);
    for (std::size_t s = 0; s < sides.size(); ++s) {
      const auto of_receiver = static_cast<double>(patches.area[sides.side[s].patch()]);
      for (std::size_t b = 0; b < bands; ++b) {
        const auto i = s * bands + b;
        power[r][kind[s] * bands + b] +=
            of_receiver * (static_cast<double>(direct[r][i]) + static_cast<double>(gathered[r][i]));
      }
    }
    for (std::size_t i = 0; i < kinds * bands; ++i) power[r][kinds * bands + i % bands] += power[r][i];
  });

  const auto estimate = [&](std::size_t k, std::size_t b) {
    return estimate_of(direct.size(), [&](std::size_t r) { return power[r][k * bands + b]; });
  };
  SurfaceMeans means;
  for (std::size_t k = 0; k < kinds; ++k) {
    if (!(area[k] > 0.0)) continue;
    SurfaceMean mean{k / 2, patches.materials[k / 2].name, k % 2 == 1, area[k], {}, {}};
    for (std::size_t b = 0; b < bands; ++b) {
      const auto of_band = estimate(k, b);
      mean.irradiance.push_back(of_band.mean / area[k]);
      mean.standard_error.push_back(of_band.standard_error / area[k]);
    }
    means.surfaces.push_back(std::move(mean));
  }
  for (std::size_t b = 0; b < bands; ++b) {
    const auto of_band = estimate(kinds, b);
    means.received.power.push_back(of_band.mean);
    means.received.standard_error.push_back(of_band.standard_error);
  }
  return means;
}

}  // namespace luxel
