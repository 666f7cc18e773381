// SPDX-License-Identifier: Apache-2.0
// Row sums of a sampled operator, the control variate that they are, and the sides that they give away.
#include <algorithm>
#include <cmath>

#include "luxel/solve/sampled_operator_rows.h"

namespace luxel {

using namespace sampled_tuning;

namespace {

// Row sums, and the sums of squared weights.
struct UnitKernel {
  const float* sent_density;
  const float* trusted;
  const float* mutual;

  void fetch(std::uint32_t) const {}
  void operator()(std::uint32_t receiver, std::uint32_t e, double* sum) const {
    const auto q = static_cast<double>(1.0f / (trusted[receiver] + mutual[receiver] * sent_density[e]));
    sum[0] += q;
    sum[1] += q * q;
  }
};

}  // namespace

void SampledOperator::find_row_sums(const Workers& workers) {
  const auto receivers = sides().size();
  row_sum_.assign(hits_.replicates(), std::vector<float>(receivers, 1.0f));
  row_sum_variance_.assign(receivers, 0.0f);
  if (!options_.both_ways || receivers == 0) return;
  const UnitKernel kernel{sent_density_.data(), trusted_.data(), mutual_.data()};
  struct Rows {
    std::uint32_t receiver0, receiver1;
    SampledOperator& whole;
    void add(std::uint32_t replicate, const double* own, const double* arriving) {
      const double k = whole.options_.own_trust;
      for (auto s = receiver0; s < receiver1; ++s) {
        const auto i = 2 * (s - receiver0);
        const auto per_area = whole.inverse_area_[s];
        whole.row_sum_[replicate][s] = static_cast<float>(per_area * (k * own[i] + arriving[i]));
        whole.row_sum_variance_[s] +=
            static_cast<float>(per_area * per_area * (k * k * own[i + 1] + arriving[i + 1]));
      }
    }
    void finish() {}
  };
  for_rows<2>(0, hits_.replicates(), 2, workers, kernel,
              [&](std::uint32_t receiver0, std::uint32_t receiver1) {
                return Rows{receiver0, receiver1, *this};
              });
}

bool SampledOperator::find_one_way_sides() {
  if (!options_.both_ways) return false;
  std::vector<float> one_way(sides().size(), 0.0f);
  // Row sums of receivers [first, end) together.
  const auto test = [&](std::uint32_t first, std::uint32_t end) {
    double off = 0.0;
    double variance = 0.0;
    double rows = 0.0;
    for (auto s = first; s < end; ++s) {
      if (!(sent_density_[s] > 0.0f)) continue;
      for (std::uint32_t r = 0; r < hits_.replicates(); ++r) off += row_sum(r, s) - 1.0;
      variance += static_cast<double>(row_sum_variance_[s]);
      rows += hits_.replicates();
    }
    if (std::abs(off) > std::max(max_deviations * std::sqrt(variance), min_deviation * rows))
      std::fill(one_way.begin() + first, one_way.begin() + end, 1.0f);
  };
  const auto begins = neighbour_begins(sides(), tested_positions);
  for (std::size_t u = 0; u + 1 < begins.size(); ++u) {
    if (!hits_.is_mine(begins[u])) continue;
    test(begins[u], begins[u + 1]);
    for (auto s = begins[u]; s < begins[u + 1]; ++s) test(s, s + 1);
  }
  hits_.all_gather_receivers(one_way, 1);
  bool is_new = false;
  for (std::size_t s = 0; s < one_way.size(); ++s) {
    is_new |= one_way[s] > 0.0f && sent_density_[s] > 0.0f;
    if (one_way[s] > 0.0f) sent_density_[s] = 0.0f;
  }
  return is_new;
}

void SampledOperator::find_row_factors(const Workers& workers) {
  const auto receivers = sides().size();
  row_factor_.assign(hits_.replicates(), std::vector<float>(receivers, 1.0f));
  if (!options_.both_ways || receivers == 0) return;
  // g_r = 1 + sum over q != r of (1 - S_q) / (sum over p != q of S_p), within each half.
  for (std::size_t half = 0; half < 2; ++half) {
    const auto first = half_begin(half);
    const auto end = half_begin(half + 1);
    if (end - first < 2) continue;
    workers.for_chunks(receivers, grain, [&](std::size_t from, std::size_t to, int) {
      std::vector<double> part(end - first);
      for (auto s = from; s < to; ++s) {
        double sum = 0.0;
        for (auto r = first; r < end; ++r) sum += row_sum(r, s);
        double parts = 0.0;
        for (auto r = first; r < end; ++r)
          parts += part[r - first] = (1.0 - row_sum(r, s)) / (sum - row_sum(r, s));
        for (auto r = first; r < end; ++r)
          row_factor_[r][s] = static_cast<float>(1.0 + parts - part[r - first]);
      }
    });
  }
}

}  // namespace luxel
