// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/measure_surfaces.h"

#include <cmath>

#include "luxel/core/student.h"

namespace luxel {
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
                              Replicates gathered, const Workers& workers) {
  const auto bands = patches.band_count();
  const auto kinds = 2 * patches.materials.size();
  std::vector<std::size_t> kind(sides.size());  // [receiver]: 2 * material, + 1 for its back
  std::vector<double> area(kinds, 0.0);
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const auto patch = sides.side[s] / 2;
    kind[s] = 2 * static_cast<std::size_t>(patches.material[patch]) + sides.side[s] % 2;
    area[kind[s]] += static_cast<double>(patches.area[patch]);
  }
  // W, [replicate][kind * bands + band]; the last kind is all of them.
  std::vector<std::vector<double>> power(direct.size());
  workers.for_chunks(direct.size(), 1, [&](std::size_t r, std::size_t, int) {
    power[r].assign((kinds + 1) * bands, 0.0);
    for (std::size_t s = 0; s < sides.size(); ++s) {
      const auto of_receiver = static_cast<double>(patches.area[sides.side[s] / 2]);
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
