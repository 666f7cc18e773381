// SPDX-License-Identifier: Apache-2.0
#include "luxel/solution/merge_solutions.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/core/student.h"
#include "luxel/patch/side.h"
#include "luxel/solution/error_95th.h"
#include "luxel/solution/solution_layout.h"

namespace luxel {
namespace {

std::vector<RandomStream> streams_of(const Solution& solution) {
  const auto& p = solution.provenance;
  return p.merged.empty() ? std::vector{RandomStream{p.seed, p.rays}} : p.merged;
}

bool same_materials(const PatchSet& a, const PatchSet& b) {
  return std::equal(a.materials.begin(), a.materials.end(), b.materials.begin(), b.materials.end(),
                    [](const BandMaterial& m, const BandMaterial& n) {
                      return m.two_sided == n.two_sided && m.reflectance == n.reflectance &&
                             m.emittance == n.emittance && m.transmittance == n.transmittance &&
                             m.diffuse_transmittance == n.diffuse_transmittance;
                    });
}

void check(const std::vector<NamedSolution>& all) {
  if (all.size() < 2) throw InputError("to merge takes two solutions at least");
  const auto& first = all.front();
  for (const auto& each : all) {
    const auto& [patches, solution] = each.baked;
    const auto refuse = [&](const std::string& what) { throw InputError(each.name, what); };
    if (solution.provenance.method != "sampled" || solution.standard_error.front.empty() ||
        !(solution.error_degrees_of_freedom > 0.0))
      throw with_hints(
          InputError(each.name,
                     "it has no standard errors from independent replicates, so it cannot be merged: "
                     "expected a solution of the sampled method"),
          {{Setting::method, "sampled"}});
    if (patches.scene_fingerprint != first.baked.patches.scene_fingerprint ||
        patches.sky != first.baked.patches.sky || patches.sky_patches != first.baked.patches.sky_patches ||
        !same_materials(patches, first.baked.patches))
      refuse(fmt::format("it is of another scene than {}", first.name));
    if (patches.bands != first.baked.patches.bands || patches.vertices != first.baked.patches.vertices ||
        patches.corners != first.baked.patches.corners || patches.material != first.baked.patches.material)
      refuse(fmt::format("it is of the scene of {}, but of other patches: bake both with the same options",
                         first.name));
  }
}

// Sorts by seed, so that the order of the arguments does not matter; refuses a repeated seed.
void sort_by_seed(std::vector<NamedSolution>& all) {
  const auto seed = [](const NamedSolution& s) { return streams_of(s.baked.solution).front().seed; };
  std::sort(all.begin(), all.end(), [&](const auto& a, const auto& b) {
    return std::pair(seed(a), a.name) < std::pair(seed(b), b.name);
  });
  std::vector<std::pair<std::uint64_t, const std::string*>> seeds;
  for (const auto& each : all)
    for (const auto& stream : streams_of(each.baked.solution)) seeds.emplace_back(stream.seed, &each.name);
  std::sort(seeds.begin(), seeds.end(), [](const auto& a, const auto& b) {
    return std::pair(a.first, *a.second) < std::pair(b.first, *b.second);
  });
  for (std::size_t i = 1; i < seeds.size(); ++i)
    if (seeds[i].first == seeds[i - 1].first)
      throw with_hints(InputError(*seeds[i].second,
                                  fmt::format("it is made with seed {}, as is {}: they are not independent, "
                                              "give each run a seed of its own",
                                              seeds[i].first, *seeds[i - 1].second)),
                       {{Setting::seed}});
}

// The data of each run that contribute to the mean.
struct Fraction {
  const Solution* solution;
  double weight;
  double widening;
};

std::vector<float> mean(const std::vector<Fraction>& fractions, SideValues Solution::*values, bool back) {
  std::vector<float> result((fractions.front().solution->*values).of(back).size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    double sum = 0.0;
    for (const auto& s : fractions) sum += s.weight * static_cast<double>((s.solution->*values).of(back)[i]);
    result[i] = static_cast<float>(sum);
  }
  return result;
}

struct Errors {
  std::vector<float> standard_error, bias;
};

// Variances add up with squared weights, biases with weights.
Errors errors(const std::vector<Fraction>& fractions, bool back, double widening) {
  const auto count = fractions.front().solution->standard_error.of(back).size();
  const bool any_bias = std::any_of(fractions.begin(), fractions.end(), [&](const Fraction& s) {
    return !s.solution->smoothing_bias.of(back).empty();
  });
  Errors result{std::vector<float>(count), std::vector<float>(any_bias ? count : 0)};
  for (std::size_t i = 0; i < count; ++i) {
    double variance = 0.0;
    double all_bias = 0.0;
    for (const auto& s : fractions) {
      const auto narrow = static_cast<double>(s.solution->standard_error.of(back)[i]) / s.widening;
      const auto& biases = s.solution->smoothing_bias.of(back);
      const auto own = biases.empty() ? 0.0 : static_cast<double>(biases[i]);
      variance += s.weight * s.weight * std::max(0.0, narrow * narrow - own * own);
      all_bias += s.weight * own;
    }
    result.standard_error[i] = static_cast<float>(widening * std::sqrt(variance + all_bias * all_bias));
    if (any_bias) result.bias[i] = static_cast<float>(all_bias);
  }
  return result;
}

// Preserves the options that all runs have in common and drops the others; sums rays and joins command lines.
Provenance provenance_of(const std::vector<NamedSolution>& all) {
  auto result = all.front().baked.solution.provenance;
  result.merged.clear();
  result.rays = 0;
  result.command_line.clear();
  for (const auto& each : all) {
    const auto& p = each.baked.solution.provenance;
    for (const auto& stream : streams_of(each.baked.solution)) result.merged.push_back(stream);
    std::erase_if(result.options, [&](const auto& option) {
      return std::find(p.options.begin(), p.options.end(), option) == p.options.end();
    });
    result.rays += p.rays;
    result.command_line += p.command_line + "; ";
  }
  result.command_line += "luxel merge";
  std::sort(result.merged.begin(), result.merged.end(),
            [](const auto& a, const auto& b) { return a.seed < b.seed; });
  result.seed = result.merged.front().seed;
  return result;
}

}  // namespace

Baked merge_solutions(std::vector<NamedSolution> all) {
  check(all);
  sort_by_seed(all);
  double rays = 0.0;
  for (const auto& each : all) rays += static_cast<double>(each.baked.solution.provenance.rays);
  std::vector<Fraction> fractions;
  double inverse_degrees_of_freedom = 0.0;
  double variance = 0.0;
  double bias = 0.0;
  Solution merged;
  for (const auto& each : all) {
    const auto& s = each.baked.solution;
    const auto weight = static_cast<double>(s.provenance.rays) / rays;
    fractions.push_back({&s, weight, student_widening(s.error_degrees_of_freedom)});
    // Variances are inversely proportional to rays, so each fraction of the whole variance is the fraction of
    // the rays.
    inverse_degrees_of_freedom += weight * weight / s.error_degrees_of_freedom;
    variance +=
        weight * weight * (s.predicted_error * s.predicted_error - s.predicted_bias * s.predicted_bias);
    bias += weight * s.predicted_bias;
    merged.unshot_fraction = std::max(merged.unshot_fraction, s.unshot_fraction);
    merged.mesh_error = std::max(merged.mesh_error, s.mesh_error);
  }
  merged.bands = all.front().baked.solution.bands;
  merged.error_degrees_of_freedom = 1.0 / inverse_degrees_of_freedom;
  const auto widening = student_widening(merged.error_degrees_of_freedom);
  for (const bool back : {false, true}) {
    merged.irradiance.of(back) = mean(fractions, &Solution::irradiance, back);
    merged.radiosity.of(back) = mean(fractions, &Solution::radiosity, back);
    auto found = errors(fractions, back, widening);
    merged.standard_error.of(back) = std::move(found.standard_error);
    merged.smoothing_bias.of(back) = std::move(found.bias);
  }
  merged.predicted_bias = bias;
  merged.predicted_error = std::sqrt(std::max(0.0, variance) + bias * bias);
  merged.error_95th = error_95th_of(merged);
  merged.stop = all.front().baked.solution.stop;
  merged.provenance = provenance_of(all);
  return {std::move(all.front().baked.patches), std::move(merged)};
}

}  // namespace luxel
