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

// F of all rays: the mean of the replicates. For one caller at a time.
class Pooled final : public TransportOperator {
 public:
  Pooled(const SampledOperator& sampled, std::uint32_t replicates)
      : sampled_(sampled),
        replicates_(replicates),
        first_(sampled.replicate(0)),
        one_(sampled.sides().size() * first_.bands()) {}
  std::size_t size() const override { return first_.size(); }
  std::size_t bands() const override { return first_.bands(); }
  std::span<const std::uint32_t> row_begins() const override { return first_.row_begins(); }
  void apply(std::span<const float> radiosity, std::span<float> irradiance, std::size_t begin,
             std::size_t end, const Workers& workers) const override {
    first_.apply(radiosity, irradiance, begin, end, workers);
    const auto low = begin * bands();
    for (std::uint32_t r = 1; r < replicates_; ++r) {
      sampled_.replicate(r).apply(radiosity, one_, begin, end, workers);
      const auto share = 1.0f / static_cast<float>(r + 1);
      for_all(end * bands() - low, workers,
              [&](std::size_t i) { irradiance[low + i] += share * (one_[low + i] - irradiance[low + i]); });
    }
  }

 private:
  const SampledOperator& sampled_;
  std::uint32_t replicates_;
  SampledOperator::Replicate first_;
  mutable std::vector<float> one_;  // what one replicate brings
};

std::vector<float> mean_of(std::span<const std::vector<float>> values, const Workers& workers) {
  std::vector<float> mean(values[0].size());
  const auto share = 1.0f / static_cast<float>(values.size());
  for_all(mean.size(), workers, [&](std::size_t i) {
    float sum = 0.0f;
    for (const auto& v : values) sum += v[i];
    mean[i] = share * sum;
  });
  return mean;
}

}  // namespace

ReplicateLight solve_replicates(const SampledOperator& transport, std::span<const std::vector<float>> direct,
                                std::span<const float> reflectance, std::span<float> radiosity,
                                double tolerance, const Workers& workers) {
  const auto count = reflectance.size();
  const auto replicates = static_cast<std::uint32_t>(direct.size());
  const auto mean_direct = mean_of(direct, workers);
  std::vector<float> irradiance(count);
  ReplicateLight light;
  light.iteration = gauss_seidel(Pooled(transport, replicates), mean_direct, reflectance, radiosity,
                                 irradiance, {.tolerance = tolerance}, workers);
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
  }
  const auto middle = mean_of(light.gathered, workers);
  for_all(count, workers, [&](std::size_t i) {
    const auto shift = irradiance[i] - mean_direct[i] - middle[i];
    for (auto& g : light.gathered) g[i] += shift;
  });
  return light;
}

}  // namespace luxel
