// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/sampled_operator.h"

#include <algorithm>
#include <cassert>

#include "luxel/solve/sampled_operator_rows.h"

namespace luxel {
using namespace tuning::rows;

SampledOperator::SampledOperator(const PatchSet& patches, const HitStore& hits,
                                 const SampledOperatorOptions& options, const Context& context)
    : patches_(patches), hits_(hits), options_(options) {
  find_densities();
  do {
    find_weights();
    if (!hits_.is_streamed()) find_arrivals(context);
    find_row_sums(context);
  } while (find_one_way_sides());
  find_row_factors(context);
}

SampledOperator::~SampledOperator() = default;

void SampledOperator::find_densities() {
  const auto receivers = sides().size();
  density_.resize(receivers);
  inverse_area_.resize(receivers);
  sent_density_.assign(elements(), 0.0f);
  for (std::size_t s = 0; s < receivers; ++s) {
    const auto patch = sides().side[s].patch();
    inverse_area_[s] = 1.0 / static_cast<double>(patches_.area[patch]);
    density_[s] = static_cast<float>(hits_.rays_per_receiver()[s] * inverse_area_[s]);
    const bool is_one_way = !options_.one_way.empty() && options_.one_way[s] > 0;
    if (options_.both_ways && !is_one_way) sent_density_[s] = density_[s];
  }
}

void SampledOperator::find_arrivals(const Context& context) {
  arrivals_.resize(hits_.replicates());
  const auto find = [&](std::size_t r) {
    arrivals_[r] = arrivals_of(0, hits_.blocks(), [&](std::size_t block, auto body) {
      hits_.for_each_round(static_cast<std::uint32_t>(r), block, body);
    });
  };
  if (hits_.partition().is_shared())  // collective: all processes meet here in the same order
    for (std::size_t r = 0; r < arrivals_.size(); ++r) find(r);
  else
    context.for_chunks(arrivals_.size(), 1, [&](std::size_t r, std::size_t, int) { find(r); });
}

// ---- Sums of radiosity ----

void SampledOperator::find_weights() {
  trusted_.resize(density_.size());
  mutual_.resize(density_.size());
  for (std::size_t s = 0; s < density_.size(); ++s) {
    trusted_[s] = options_.own_trust * density_[s];
    mutual_[s] = sent_density_[s] > 0.0f ? 1.0f : 0.0f;
  }
}

namespace {

// Density and three radiosities of an element, stored together for one memory access.
struct PackedKernel {
  const std::array<float, 4>* element;
  const float* trusted;  // k d, [receiver]
  const float* mutual;   // [receiver]: 1, or 0 where rays count one way
  bool fetches;

  void fetch(std::uint32_t e) const {
    if (fetches) __builtin_prefetch(element + e);
  }
  void operator()(std::uint32_t receiver, std::uint32_t e, double* sum) const {
    const auto& x = element[e];
    const auto q = 1.0f / (trusted[receiver] + mutual[receiver] * x[0]);
    for (std::size_t b = 0; b < 3; ++b) sum[b] += static_cast<double>(q * x[b + 1]);
  }
};

template <std::size_t known_columns>
struct ColumnsKernel {
  const float* radiosity;
  const float* sent_density;
  const float* trusted;
  const float* mutual;
  std::size_t columns;
  bool fetches;

  void fetch(std::uint32_t e) const {
    if (!fetches) return;
    __builtin_prefetch(radiosity + (known_columns ? known_columns : columns) * e);
    __builtin_prefetch(sent_density + e);
  }
  void operator()(std::uint32_t receiver, std::uint32_t e, double* sum) const {
    const auto q = 1.0f / (trusted[receiver] + mutual[receiver] * sent_density[e]);
    const auto width = known_columns ? known_columns : columns;
    const auto* R = radiosity + width * e;
    for (std::size_t c = 0; c < width; ++c) sum[c] += static_cast<double>(q * R[c]);
  }
};

}  // namespace

template <typename MakeRows>
void SampledOperator::sum_rows(std::uint32_t first, std::uint32_t end, std::size_t columns,
                               std::span<const float> radiosity, const Context& context,
                               const MakeRows& make_rows) const {
  const auto add_columns = [&]<std::size_t known>() {
    const ColumnsKernel<known> kernel{radiosity.data(), sent_density_.data(),
                                      trusted_.data(),  mutual_.data(),
                                      columns,          elements() > cached_elements};
    for_rows<known>(first, end, columns, context, kernel, make_rows);
  };
  if (columns == 4) return add_columns.template operator()<4>();
  if (columns != 3) return add_columns.template operator()<0>();
  std::vector<std::array<float, 4>> packed(elements());
  context.for_chunks(packed.size(), grain, [&](std::size_t from, std::size_t to, int) {
    for (auto e = from; e < to; ++e)
      packed[e] = {sent_density_[e], radiosity[3 * e], radiosity[3 * e + 1], radiosity[3 * e + 2]};
  });
  const PackedKernel kernel{packed.data(), trusted_.data(), mutual_.data(), packed.size() > cached_elements};
  for_rows<3>(first, end, 3, context, kernel, make_rows);
}

namespace {

// Rows [receiver0, receiver1), and what makes irradiance of their sums.
struct RowBlock {
  std::uint32_t receiver0, receiver1;
  std::size_t columns;
  double trust;
  const std::vector<double>& inverse_area;
};

// Mean over replicates of the weighted rows of one block.
class MeanRows {
 public:
  MeanRows(const RowBlock& block, std::uint32_t count, const std::vector<std::vector<float>>& factor,
           std::span<float> out)
      : receiver0_(block.receiver0),
        receiver1_(block.receiver1),
        columns_(block.columns),
        trust_(block.trust),
        count_(count),
        factor_(factor),
        inverse_area_(block.inverse_area),
        out_(out),
        sum_((receiver1_ - receiver0_) * columns_, 0.0) {}

  void add(std::uint32_t replicate, const double* own, const double* arriving) {
    for (auto s = receiver0_; s < receiver1_; ++s) {
      const auto factor = static_cast<double>(factor_[replicate][s]);
      for (auto i = (s - receiver0_) * columns_; i < (s - receiver0_ + 1) * columns_; ++i)
        sum_[i] += factor * (trust_ * own[i] + arriving[i]);
    }
  }
  void finish() {
    for (auto s = receiver0_; s < receiver1_; ++s) {
      const auto scale = inverse_area_[s] / count_;
      for (std::size_t c = 0; c < columns_; ++c)
        out_[s * columns_ + c] = static_cast<float>(scale * sum_[(s - receiver0_) * columns_ + c]);
    }
  }

 private:
  std::uint32_t receiver0_, receiver1_;
  std::size_t columns_;
  double trust_;
  std::uint32_t count_;
  const std::vector<std::vector<float>>& factor_;
  const std::vector<double>& inverse_area_;
  std::span<float> out_;
  std::vector<double> sum_;
};

// The rows of each replicate separately.
class ReplicateRows {
 public:
  ReplicateRows(const RowBlock& block, std::uint32_t first, std::span<std::vector<float>> out)
      : receiver0_(block.receiver0),
        receiver1_(block.receiver1),
        columns_(block.columns),
        trust_(block.trust),
        first_(first),
        inverse_area_(block.inverse_area),
        out_(out) {}

  void add(std::uint32_t replicate, const double* own, const double* arriving) {
    auto& out = out_[replicate - first_];
    for (auto s = receiver0_; s < receiver1_; ++s)
      for (std::size_t c = 0; c < columns_; ++c) {
        const auto i = (s - receiver0_) * columns_ + c;
        out[s * columns_ + c] = static_cast<float>(inverse_area_[s] * (trust_ * own[i] + arriving[i]));
      }
  }
  void finish() {}

 private:
  std::uint32_t receiver0_, receiver1_;
  std::size_t columns_;
  double trust_;
  std::uint32_t first_;
  const std::vector<double>& inverse_area_;
  std::span<std::vector<float>> out_;
};

}  // namespace

void SampledOperator::apply(std::size_t half, std::size_t columns, std::span<const float> radiosity,
                            std::span<float> irradiance, const Context& context) const {
  assert(half < 2);
  assert(radiosity.size() == elements() * columns && irradiance.size() == sides().size() * columns);
  const auto first = half_begin(half);
  const auto end = half_begin(half + 1);
  sum_rows(first, end, columns, radiosity, context, [&](std::uint32_t receiver0, std::uint32_t receiver1) {
    return MeanRows({receiver0, receiver1, columns, options_.own_trust, inverse_area_}, end - first,
                    row_factor_, irradiance);
  });
  hits_.all_gather_receivers(irradiance, columns);
}

std::vector<std::vector<float>> SampledOperator::replicate_rows(std::size_t half,
                                                                std::span<const float> radiosity,
                                                                const Context& context) const {
  assert(half < 2 && radiosity.size() % elements() == 0);
  const auto first = half_begin(half);
  const auto end = half_begin(half + 1);
  const auto columns = radiosity.size() / elements();
  std::vector<std::vector<float>> rows(end - first, std::vector<float>(sides().size() * columns));
  sum_rows(first, end, columns, radiosity, context, [&](std::uint32_t receiver0, std::uint32_t receiver1) {
    return ReplicateRows({receiver0, receiver1, columns, options_.own_trust, inverse_area_}, first, rows);
  });
  if (end - first < 2 || !options_.both_ways) return rows;
  context.for_chunks(sides().size(), grain, [&](std::size_t from, std::size_t to, int) {
    std::vector<double> row(rows.size());
    for (auto s = from; s < to; ++s) {
      double row_sums = 0.0;
      for (auto r = first; r < end; ++r) row_sums += row_sum(r, s);
      for (auto i = s * columns; i < (s + 1) * columns; ++i) {
        double sum = 0.0;
        for (std::size_t k = 0; k < rows.size(); ++k) sum += row[k] = static_cast<double>(rows[k][i]);
        for (std::size_t k = 0; k < rows.size(); ++k) {
          const auto S = row_sum(first + static_cast<std::uint32_t>(k), s);
          rows[k][i] = static_cast<float>(row[k] + (1.0 - S) * (sum - row[k]) / (row_sums - S));
        }
      }
    }
  });
  return rows;
}

}  // namespace luxel
