// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/daylight_factor.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/lighting/replicate_figure.h"
#include "luxel/photometry/sky_integrals.h"
#include "luxel/photometry/sky_model.h"
#include "luxel/photometry/weather_figures.h"

namespace luxel {
namespace {

constexpr double target_part = 0.5, minimum_part = 0.95;  // of the points

double sum_of(std::span<const float> row, const std::vector<double>& luminance) {
  double sum = 0.0;
  for (std::size_t p = 0; p < row.size(); ++p) sum += static_cast<double>(row[p]) * luminance[p];
  return sum;
}

void add_figures(DaylightFactors& f) {
  const auto points = f.value.size();
  const auto count = static_cast<double>(f.replicates.size());
  f.standard_error.assign(points, 0.0f);
  for (std::size_t m = 0; m < points; ++m) {
    double sum = 0.0;
    for (const auto& replicate : f.replicates)
      sum += std::pow(static_cast<double>(replicate[m]) - static_cast<double>(f.value[m]), 2.0);
    f.standard_error[m] = static_cast<float>(std::sqrt(sum / (count * (count - 1.0))));
  }
  GridSamples samples;
  samples.value.assign(f.value.begin(), f.value.end());
  samples.sampling_error.assign(points, 0.0);
  for (const auto& replicate : f.replicates)
    samples.replicates.emplace_back(replicate.begin(), replicate.end());
  samples.solution_freedom = count - 1.0;
  const GridFigures figures(samples);
  f.mean = figures.mean();
  f.min = figures.min();
  f.min_over_mean = figures.min_over_mean();
  f.median = jackknifed(f.replicates, median_of);
}

FactorProvision::Verdict verdict_of(const Figure& part, double needed) {
  using V = FactorProvision::Verdict;
  return part.low >= needed ? V::met : part.high < needed ? V::not_met : V::cannot_tell;
}

}  // namespace

double fraction_reached(std::span<const float> values, double limit) {
  const auto reached =
      std::count_if(values.begin(), values.end(), [&](float v) { return static_cast<double>(v) >= limit; });
  return values.empty() ? 0.0 : static_cast<double>(reached) / static_cast<double>(values.size());
}

double median_of(std::span<const float> values) {
  if (values.empty()) return 0.0;
  std::vector<float> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const auto middle = sorted.size() / 2;
  return sorted.size() % 2 == 1
             ? static_cast<double>(sorted[middle])
             : 0.5 * (static_cast<double>(sorted[middle - 1]) + static_cast<double>(sorted[middle]));
}

DaylightFactors daylight_factors(const DaylightCoefficients& coefficients, int cie_type, double albedo) {
  const auto model = SkyModel::cie(cie_type);
  if (model.follows_sun())
    throw InputError(fmt::format(
        "expected an overcast sky for daylight factors, CIE type 1, 3, 5 or 16, found {}", cie_type));
  const auto luminance = sky_patch_luminances(model, coefficients.sky, 1.0, albedo);
  const auto count = static_cast<float>(coefficients.replicates);
  DaylightFactors f;
  f.cie_type = cie_type;
  f.albedo = albedo;
  f.replicates.assign(coefficients.replicates, std::vector<float>(coefficients.points, 0.0f));
  f.value.assign(coefficients.points, 0.0f);
  for (auto& part : f.components) part.assign(coefficients.points, 0.0f);
  for (std::size_t m = 0; m < coefficients.points; ++m)
    for (std::uint32_t r = 0; r < coefficients.replicates; ++r)
      for (std::size_t path = 0; path < daylight_paths; ++path) {
        const auto part =
            static_cast<float>(sum_of(coefficients.row(static_cast<DaylightPath>(path), m, r), luminance));
        f.replicates[r][m] += part;
        f.components[path][m] += part / count;
        f.value[m] += part / count;
      }
  if (coefficients.points > 0 && coefficients.replicates > 1) add_figures(f);
  return f;
}

std::vector<FactorProvision> factor_provision(const DaylightFactors& factors, double diffuse) {
  std::vector<FactorProvision> provision;
  for (const auto& row : daylight_targets) {
    FactorProvision p;
    p.level = row.level;
    p.target_factor = row.target / diffuse;
    p.minimum_factor = row.minimum / diffuse;
    const auto part = [&](double limit) {
      return jackknifed(factors.replicates,
                        [limit](std::span<const float> values) { return fraction_reached(values, limit); });
    };
    p.on_target = part(p.target_factor);
    p.on_minimum = part(p.minimum_factor);
    const auto target = verdict_of(p.on_target, target_part),
               minimum = verdict_of(p.on_minimum, minimum_part);
    using V = FactorProvision::Verdict;
    p.verdict = target == V::not_met || minimum == V::not_met ? V::not_met
                : target == V::met && minimum == V::met       ? V::met
                                                              : V::cannot_tell;
    provision.push_back(p);
  }
  return provision;
}

}  // namespace luxel
