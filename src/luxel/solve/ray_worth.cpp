// SPDX-License-Identifier: Apache-2.0
// What a further ray is worth to a sampled operator.
#include "luxel/solve/sampled_operator_rows.h"

namespace luxel {
namespace {

// sum[0] the part of the receiver's own row, sum[1] the part of the other's.
struct WorthKernel {
  const float* density;       // of own rays, [receiver]
  const float* sent_density;  // [element]
  const float* importance;    // I / A², [element]
  const float* radiosity;     // [element * bands + band]
  const float* level;         // c, [element * bands + band]
  std::size_t bands;

  void fetch(std::uint32_t e) const { __builtin_prefetch(radiosity + bands * e); }
  void operator()(std::uint32_t receiver, std::uint32_t e, double* sum) const {
    double own = 0.0;
    double other = 0.0;
    for (std::size_t b = 0; b < bands; ++b) {
      const auto to_own = static_cast<double>(radiosity[bands * e + b] - level[bands * receiver + b]);
      const auto to_other = static_cast<double>(radiosity[bands * receiver + b] - level[bands * e + b]);
      own += to_own * to_own;
      other += to_other * to_other;
    }
    const bool is_mutual = sent_density[receiver] > 0.0f && sent_density[e] > 0.0f;
    const auto d = static_cast<double>(density[receiver] + (is_mutual ? sent_density[e] : 0.0f));
    const auto weight = 1.0 / (d * d * d);
    sum[0] += weight * own * static_cast<double>(importance[receiver]);
    if (is_mutual) sum[1] += weight * other * static_cast<double>(importance[e]);
  }
};

}  // namespace

SampledOperator::RayWorth SampledOperator::ray_worth(std::span<const double> importance,
                                                     std::span<const float> radiosity,
                                                     std::span<const float> level,
                                                     const Workers& workers) const {
  const auto receivers = sides().size();
  const auto bands = patches_.band_count();
  std::vector<float> per_area2(elements(), 0.0f), levels(elements() * bands, 0.0f);
  for (std::size_t s = 0; s < receivers; ++s)
    per_area2[s] = static_cast<float>(importance[s] * inverse_area_[s] * inverse_area_[s]);
  std::copy(level.begin(), level.end(), levels.begin());
  RayWorth worth{std::vector<float>(receivers), std::vector<float>(receivers)};
  const WorthKernel kernel{density_.data(),  sent_density_.data(), per_area2.data(),
                           radiosity.data(), levels.data(),        bands};
  struct Rows {
    std::uint32_t receiver0, receiver1;
    const std::vector<double>& inverse_area;
    RayWorth& worth;
    std::vector<double> sum;
    void add(std::uint32_t, const double* own, const double* arriving) {
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += own[i] + arriving[i];
    }
    void finish() {
      for (auto s = receiver0; s < receiver1; ++s) {
        worth.own[s] = static_cast<float>(inverse_area[s] * sum[2 * (s - receiver0)]);
        worth.given[s] = static_cast<float>(inverse_area[s] * sum[2 * (s - receiver0) + 1]);
      }
    }
  };
  for_rows<2>(0, hits_.replicates(), 2, workers, kernel,
              [&](std::uint32_t receiver0, std::uint32_t receiver1) {
                return Rows{receiver0, receiver1, inverse_area_, worth,
                            std::vector<double>(2 * (receiver1 - receiver0), 0.0)};
              });
  for (auto* part : {&worth.own, &worth.given}) hits_.all_gather_receivers(*part, 1);
  return worth;
}

}  // namespace luxel
