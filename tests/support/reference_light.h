// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "luxel/render/path_traced.h"
#include "luxel/solve/sampled.h"
#include "luxel/trace/tracer.h"

namespace luxel::test {

inline Solution solved(const PatchSet& patches, EnergyBalance& energy, SurfaceMeans& means) {
  const Context context(2);
  const Tracer tracer(patches, context);
  Solution light;
  auto report =
      solve_sampled(patches, tracer, light,
                    {.error = 0.01, .error_measure = ErrorMeasure::power, .smoothing = false}, context);
  energy = report.energy;
  means = report.means;
  return light;
}

inline double total(const std::vector<double>& bands) {
  double sum = 0.0;
  for (const auto b : bands) sum += b;
  return sum;
}

// Compares the sampled method with the path-traced reference: means of materials, band by band, within six
// standard errors, and the parts of the energy balance, which it returns.
inline EnergyBalance expect_same_light(const PatchSet& patches, double tolerance = 0.0,
                                       double reference_error = 0.01) {
  const Context context(2);
  const Tracer tracer(patches, context);
  EnergyBalance energy;
  SurfaceMeans means;
  solved(patches, energy, means);
  Solution reference;
  const auto traced = trace_light(
      patches, tracer, reference,
      {.limits = {.error = reference_error}, .bounces_from = BouncesFrom::patches, .seed = 5}, context);
  std::size_t compared = 0;
  for (const auto& mean : means.surfaces)
    for (std::size_t b = 0; b < 3; ++b) {
      double area = 0.0, truth = 0.0, variance = 0.0;
      for (std::size_t p = 0; p < patches.size(); ++p) {
        if (static_cast<std::size_t>(patches.material[p]) != mean.material) continue;
        const double a = patches.area[p];
        const auto i = 3 * p + b;
        area += a;
        truth += a * static_cast<double>(reference.irradiance.of(mean.is_back)[i]);
        variance += std::pow(a * static_cast<double>(reference.standard_error.of(mean.is_back)[i]), 2.0);
      }
      EXPECT_NEAR(mean.irradiance[b], truth / area,
                  6.0 * std::hypot(mean.standard_error[b], std::sqrt(variance) / area) +
                      (2e-3 + tolerance) * truth / area)
          << mean.name << (mean.is_back ? " back" : "") << ", band " << b;
      ++compared;
    }
  EXPECT_GE(compared, 6u);
  const auto whole = total(energy.emitted) + total(energy.from_sky);
  const auto near = [&](const std::vector<double>& a, const std::vector<double>& b, const char* what) {
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(a[i], b[i], (2.0 * reference_error + tolerance) * whole / 3.0) << what << i;
  };
  near(energy.from_sky, traced.from_sky, "from sky");
  near(energy.absorbed, traced.absorbed, "absorbed");
  near(energy.escaped, traced.escaped, "escaped");
  near(energy.in_panes, traced.in_panes, "in panes");
  const auto gone =
      total(energy.absorbed) + total(energy.escaped) + total(energy.lost_at_backs) + total(energy.in_panes);
  EXPECT_NEAR(gone, whole, 0.02 * whole);
  return energy;
}

}  // namespace luxel::test
