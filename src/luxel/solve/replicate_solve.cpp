// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/replicate_solve.h"

#include <algorithm>

namespace luxel {
namespace {

constexpr int own_bounces = 2;
constexpr std::size_t grain = 16384;  // numbers a chunk

template <typename Body>
void for_all(std::size_t count, const Workers& workers, Body body) {
  workers.for_chunks(count, grain, [&](std::size_t begin, std::size_t end, int) {
    for (auto i = begin; i < end; ++i) body(i);
  });
}

}  // namespace

std::vector<float> mean_of(std::span<const std::vector<float>> replicates, const Workers& workers) {
  std::vector<float> mean(replicates[0].size());
  const auto share = 1.0f / static_cast<float>(replicates.size());
  for_all(mean.size(), workers, [&](std::size_t i) {
    float sum = 0.0f;
    for (const auto& v : replicates) sum += v[i];
    mean[i] = share * sum;
  });
  return mean;
}

std::vector<float> dark_but_for_sky(const SampledOperator& transport, const PatchSet& patches) {
  const auto bands = patches.band_count();
  std::vector<float> radiosity(transport.elements() * bands, 0.0f);
  for (std::size_t b = 0; b < bands; ++b)
    radiosity[transport.escaped() * bands + b] = static_cast<float>(patches.sky_radiosity(b));
  return radiosity;
}

ReplicateLight solve_replicates(const SampledOperator& transport, std::span<const std::vector<float>> direct,
                                std::span<const float> reflectance, std::span<float> radiosity,
                                double tolerance, const Workers& workers, const Monitor& monitor) {
  const auto count = reflectance.size();
  const auto replicates = static_cast<std::uint32_t>(direct.size());
  const auto mean_direct = mean_of(direct, workers);
  std::vector<float> irradiance(count);
  ReplicateLight light;
  light.iteration = gauss_seidel(transport.all_replicates(), mean_direct, reflectance, radiosity, irradiance,
                                 {.tolerance = tolerance}, workers, monitor);
  light.is_stopped = light.iteration.is_stopped;
  if (light.is_stopped) return light;
  light.gathered.assign(replicates, std::vector<float>(count));
  std::vector<float> own(radiosity.size());
  for (std::uint32_t r = 0; r < replicates; ++r) {
    auto& gathered = light.gathered[r];
    std::copy(radiosity.begin(), radiosity.end(), own.begin());
    for (int bounce = 0; bounce < own_bounces; ++bounce) {
      if (bounce > 0)
        for_all(count, workers,
                [&](std::size_t i) { own[i] = reflectance[i] * (direct[r][i] + gathered[i]); });
      transport.replicate(r).apply(own, gathered, 0, transport.sides().size(), workers);
    }
    light.is_stopped = tell(monitor, {"light"}) == Next::stop;
    if (light.is_stopped) return light;
  }
  const auto middle = mean_of(light.gathered, workers);
  for_all(count, workers, [&](std::size_t i) {
    const auto shift = irradiance[i] - mean_direct[i] - middle[i];
    for (auto& g : light.gathered) g[i] += shift;
  });
  return light;
}

}  // namespace luxel
