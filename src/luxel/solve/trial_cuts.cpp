// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/trial_cuts.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "luxel/core/address.h"
#include "luxel/patch/refine_patches.h"
#include "luxel/patch/side.h"
#include "luxel/solve/mesh_estimate.h"
#include "luxel/solve/part_light.h"
#include "luxel/trace/tracer.h"

namespace luxel {
namespace {

constexpr double rays_per_sample = 4.0 * 2.0 * 2.0;         // parts; answers; a shadow ray and a gather ray
constexpr double min_of_part = 16.0, max_of_part = 1024.0;  // rays the first time
constexpr std::uint32_t more_rays = 4;                      // the second time
constexpr double promising = 2.0;  // estimate over its noise from which on a patch is tried a second time
constexpr double sure = 2.0;       // and is cut after that
// Rays per contribution over those of the trial before, at most: a part has a quarter of its whole.
constexpr double growth = 4.0;
// Weight of a patch's own noise, which its four parts do not tell well; the rest is the noise of the mean
// patch for the same light.
constexpr double own_noise = 0.5;
// The light, over the mean, relative to which errors do not count: about that of the seen error.
constexpr double dim_part = 0.05;

// [side of parts]. of_wholes: rays of each part, [patch].
std::vector<std::uint32_t> rays_of_sides(const Cut& cut, std::span<const std::uint32_t> of_wholes) {
  std::vector<std::uint32_t> rays(side_count(cut.parts.size()), 0);
  for (std::size_t p = 0; p < cut.parts.size(); ++p) {
    rays[SideId(p, false).index()] = of_wholes[cut.parent[p]];
    if (cut.parts.material_of(p).two_sided) rays[SideId(p, true).index()] = of_wholes[cut.parent[p]];
  }
  return rays;
}

std::vector<std::uint8_t> has_rays(std::span<const std::uint32_t> rays) {
  std::vector<std::uint8_t> result(rays.size());
  std::transform(rays.begin(), rays.end(), result.begin(), [](std::uint32_t n) { return n > 0 ? 1 : 0; });
  return result;
}

// Calls body(side, irradiance) for each band of each side, with the mean of both answers, W/m².
template <typename Body>
void for_light(const PatchSet& patches, const Answers& answers, Body body) {
  const auto bands = patches.band_count();
  const auto& [a, b] = answers;
  for (std::size_t s = 0; s < side_count(patches.size()); ++s) {
    const auto side = SideId::at(s);
    const auto& first = a.solution.irradiance.of(side);
    const auto& second = b.solution.irradiance.of(side);
    for (auto i = side.patch() * bands; i < (side.patch() + 1) * bands; ++i)
      body(s, 0.5 * std::max(0.0, static_cast<double>(first[i]) + static_cast<double>(second[i])));
  }
}

// [side]: squared error of the mean view per squared difference of irradiance, (m²/W)².
std::vector<double> weights_in_views(const PatchSet& patches, const Answers& answers,
                                     std::span<const double> density) {
  std::vector<double> light(side_count(patches.size()), 0.0);  // the sum of all bands
  for_light(patches, answers, [&](std::size_t s, double e) { light[s] += e; });
  std::vector<double> weights(light.size(), 0.0);
  double seen = 0.0, all = 0.0;
  for (std::size_t s = 0; s < weights.size(); ++s) {
    const auto patch = SideId::at(s).patch();
    if (light[s] > 0.0) weights[s] = density[patch] * static_cast<double>(patches.area[patch]);
    seen += weights[s];
    all += weights[s] * light[s];
  }
  for (std::size_t s = 0; s < weights.size(); ++s) {
    if (weights[s] == 0.0) continue;
    const auto whole = light[s] + dim_part * all / seen;
    weights[s] *= static_cast<double>(patches.band_count()) / (seen * whole * whole);
  }
  return weights;
}

class Trial {
 public:
  Trial(const PatchSet& patches, const Answers& answers, std::vector<double> weights,
        const SampledOptions& how, const Context& context)
      : patches_(patches),
        answers_(answers),
        weights_(std::move(weights)),
        how_(how),
        context_(context),
        light_(patches.size(), 0.0) {
    for_light(patches, answers,
              [&](std::size_t s, double e) { light_[SideId::at(s).patch()] += weights_[s] * e * e; });
  }

  // Rays of each part, [patch], in proportion to its contribution if it had no light at all. All together
  // they are within `allowed`. per_contribution: rays per contribution, at most (0: no limit); receives the
  // number used.
  std::vector<std::uint32_t> rays_for(std::span<const std::uint8_t> is_candidate, double allowed,
                                      double& per_contribution) const {
    const auto is_within = [&](double per) { return cost(is_candidate, per) <= allowed; };
    const auto largest = *std::max_element(light_.begin(), light_.end());
    auto high = largest > 0.0 ? max_of_part * static_cast<double>(light_.size()) / largest : 0.0;
    if (per_contribution > 0.0) high = std::min(high, per_contribution);
    if (!is_within(high)) {
      double low = 0.0;
      constexpr int halvings = 40;
      for (int i = 0; i < halvings && high - low > 0.01 * high; ++i) {
        const auto middle = 0.5 * (low + high);
        (is_within(middle) ? low : high) = middle;
      }
      high = low;
    }
    per_contribution = high;
    std::vector<std::uint32_t> rays(light_.size(), 0);
    for (std::size_t p = 0; p < rays.size(); ++p)
      if (is_candidate[p] != 0) rays[p] = rays_of(p, per_contribution);
    return rays;
  }

  // The change within the patches that cuts would make, for patches with rays. Nothing if the monitor stops
  // the work. rays_of_parts: [patch].
  std::optional<Contributions> change(std::span<const std::uint32_t> rays_of_parts, std::uint32_t stream) {
    const auto refined = refine_patches(patches_, has_rays(rays_of_parts), context_);
    const Tracer tracer(refined.patches, context_);
    const Cut cut{refined.patches, tracer, refined.parent};
    const auto rays = rays_of_sides(cut, rays_of_parts);
    Answers of_parts;
    for (std::size_t i = 0; i < of_parts.size(); ++i)
      of_parts[i].solution = inherited_light(answers_[i].solution, cut);
    const std::array lights = {&of_parts[0].solution, &of_parts[1].solution};
    auto how = how_;
    how.seed = stream_key(how_.seed, RandomPurpose::refinement, stream);
    const auto on_the_way = [&](const Progress& p) {
      return context_.report({p.stage, p.done, rays_ + p.rays});
    };
    const auto traced = gather_on_parts(cut, rays, how, lights, context_.with_monitor(on_the_way));
    if (!traced) return std::nullopt;
    rays_ += *traced;
    auto result = weighed(
        variation_within_wholes(patches_, answers_, refined.patches, of_parts, refined.parent, context_),
        weights_, patches_.band_count());
    pool_noise(rays_of_parts, result.noise);
    return result;
  }

  std::uint64_t rays() const { return rays_; }

 private:
  std::uint32_t rays_of(std::size_t patch, double per_contribution) const {
    const auto wanted = per_contribution * light_[patch];
    return wanted < min_of_part ? 0u
                                : std::bit_floor(static_cast<std::uint32_t>(std::min(wanted, max_of_part)));
  }

  double cost(std::span<const std::uint8_t> is_candidate, double per_contribution) const {
    double sum = 0.0;
    for (std::size_t p = 0; p < light_.size(); ++p)
      if (is_candidate[p] != 0)
        sum +=
            rays_per_sample * (patches_.material_of(p).two_sided ? 2.0 : 1.0) * rays_of(p, per_contribution);
    return sum;
  }

  void pool_noise(std::span<const std::uint32_t> rays, std::vector<double>& noise) const {
    double all = 0.0, expected = 0.0;
    for (std::size_t p = 0; p < noise.size(); ++p) {
      if (rays[p] == 0) continue;
      all += noise[p];
      expected += light_[p] / rays[p];
    }
    for (std::size_t p = 0; p < noise.size(); ++p)
      if (rays[p] > 0)
        noise[p] = own_noise * noise[p] + (1.0 - own_noise) * all / expected * light_[p] / rays[p];
  }

  const PatchSet& patches_;
  const Answers& answers_;
  std::vector<double> weights_;  // [side]
  const SampledOptions& how_;
  const Context& context_;
  std::vector<double> light_;  // [patch]: contribution to the squared error if it had no light at all
  std::uint64_t rays_ = 0;
};

}  // namespace

TrialCuts::TrialCuts(std::size_t patches, std::vector<double> density)
    : density_(std::move(density)), is_candidate_(patches, 1), squared_(patches, 0.0) {}

std::optional<std::uint64_t> TrialCuts::try_out(const PatchSet& patches, const Answers& answers,
                                                double max_rays, const SampledOptions& how,
                                                const Context& context) {
  Trial trial(
      patches, answers,
      density_.empty() ? weights_in_power(patches, answers) : weights_in_views(patches, answers, density_),
      how, context);
  auto rays = trial.rays_for(is_candidate_, max_rays, rays_per_contribution_);
  rays_per_contribution_ *= growth;
  std::fill(is_candidate_.begin(), is_candidate_.end(), std::uint8_t{0});
  const auto has_none = [](std::span<const std::uint32_t> counts) {
    return std::all_of(counts.begin(), counts.end(), [](std::uint32_t n) { return n == 0; });
  };
  if (has_none(rays)) return 0;
  const auto first = trial.change(rays, 0);
  if (!first) return std::nullopt;
  for (std::size_t p = 0; p < rays.size(); ++p)
    rays[p] = first->squared[p] > promising * first->noise[p] ? more_rays * rays[p] : 0;
  if (has_none(rays)) return trial.rays();
  const auto second = trial.change(rays, 1);
  if (!second) return std::nullopt;
  for (std::size_t p = 0; p < rays.size(); ++p)
    if (rays[p] > 0 && second->squared[p] > sure * second->noise[p]) squared_[p] = second->squared[p];
  return trial.rays();
}

void TrialCuts::note_cut(std::span<const std::uint32_t> parent) {
  std::vector<double> density(density_.empty() ? 0 : parent.size()), squared(parent.size());
  std::vector<std::uint8_t> is_candidate(parent.size());
  for (std::size_t p = 0; p < parent.size(); ++p) {
    const bool was_cut = is_part(parent, p);
    if (!density_.empty()) density[p] = density_[parent[p]];
    squared[p] = was_cut ? 0.0 : squared_[parent[p]];
    is_candidate[p] = was_cut ? 1 : is_candidate_[parent[p]];
  }
  density_ = std::move(density);
  squared_ = std::move(squared);
  is_candidate_ = std::move(is_candidate);
}

}  // namespace luxel
