// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/sampled_operator_rows.h"

#include <algorithm>
#include <cmath>

namespace luxel {

RayPairs exchanged_pairs(const RayPairs& own, const RowPartition& partition, const GatherSides& sides) {
  const auto block_of = [&](std::uint32_t receiver) {
    return 2 * partition.block_of(sides.position[receiver]) + (receiver < sides.fronts ? 0 : 1);
  };
  std::vector<RayPairs> parcels(partition.processes());
  for (std::size_t i = 0; i < own.size(); i += 2) {
    auto& parcel = parcels[partition.owner(sides.position[own[i + 1]])];
    parcel.push_back(own[i]);
    parcel.push_back(own[i + 1]);
  }
  const auto received = partition.all_to_all(parcels);
  // Every parcel is in the order of the senders' blocks; each block has one owner, and its receivers are
  // contiguous.
  RayPairs merged;
  std::size_t size = 0;
  for (const auto& parcel : received) size += parcel.size();
  merged.reserve(size);
  std::vector<std::size_t> next(received.size(), 0);
  while (merged.size() < size) {
    std::size_t first = received.size();
    for (std::size_t r = 0; r < received.size(); ++r)
      if (next[r] < received[r].size() &&
          (first == received.size() || received[r][next[r]] < received[first][next[first]]))
        first = r;
    auto& at = next[first];
    const auto block = block_of(received[first][at]);
    while (at < received[first].size() && block_of(received[first][at]) == block) {
      merged.push_back(received[first][at]);
      merged.push_back(received[first][at + 1]);
      at += 2;
    }
  }
  return merged;
}

using namespace tuning::rows;

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

void SampledOperator::find_row_sums(const Context& context) {
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
  for_rows<2>(0, hits_.replicates(), 2, context, kernel,
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

void SampledOperator::find_row_factors(const Context& context) {
  const auto receivers = sides().size();
  row_factor_.assign(hits_.replicates(), std::vector<float>(receivers, 1.0f));
  if (!options_.both_ways || receivers == 0) return;
  // g_r = 1 + sum over q != r of (1 - S_q) / (sum over p != q of S_p), within each half.
  for (std::size_t half = 0; half < 2; ++half) {
    const auto first = half_begin(half);
    const auto end = half_begin(half + 1);
    if (end - first < 2) continue;
    context.for_chunks(receivers, grain, [&](std::size_t from, std::size_t to, int) {
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

namespace {

// sum[0]: the part of the receiver's own row; sum[1]: the part of the other receiver's.
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
                                                     const Context& context) const {
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
  for_rows<2>(0, hits_.replicates(), 2, context, kernel,
              [&](std::uint32_t receiver0, std::uint32_t receiver1) {
                return Rows{receiver0, receiver1, inverse_area_, worth,
                            std::vector<double>(2 * (receiver1 - receiver0), 0.0)};
              });
  for (auto* part : {&worth.own, &worth.given}) hits_.all_gather_receivers(*part, 1);
  return worth;
}

CrossedHalves::CrossedHalves(const SampledOperator& whole, std::size_t bands)
    : whole_(whole),
      bands_(bands),
      row_begins_{0, static_cast<std::uint32_t>(whole.sides().size()),
                  static_cast<std::uint32_t>(2 * whole.sides().size())} {}

std::vector<float> CrossedHalves::seen_by(std::size_t half, std::span<const float> radiosity) const {
  const auto receivers = whole_.sides().size() * bands_;
  std::vector<float> seen(whole_.elements() * bands_);
  const auto other = radiosity.subspan(half == 0 ? receivers : 0, receivers);
  const auto sinks = radiosity.subspan(2 * receivers, seen.size() - receivers);
  std::copy(sinks.begin(), sinks.end(), std::copy(other.begin(), other.end(), seen.begin()));
  return seen;
}

void CrossedHalves::apply(std::span<const float> radiosity, std::span<float> irradiance, std::size_t begin,
                          std::size_t end, const Context& context) const {
  const auto receivers = whole_.sides().size();
  for (std::size_t half = 0; half < 2; ++half)
    if (begin <= half * receivers && (half + 1) * receivers <= end && receivers > 0)
      whole_.apply(half, bands_, seen_by(half, radiosity),
                   irradiance.subspan(half * receivers * bands_, receivers * bands_), context);
}

}  // namespace luxel
