// SPDX-License-Identifier: Apache-2.0
#include "luxel/transport/sampled_operator.h"

#include <cmath>

#include "luxel/transport/row_sums.h"

namespace luxel {
namespace {

constexpr std::size_t grain = 1 << 14;             // numbers per chunk
constexpr std::size_t cached_elements = 1u << 16;  // whose radiosities stay near the processor: 1 MiB
constexpr std::uint64_t batch_rays = std::uint64_t{1}
                                     << 22;  // that are held at a time where hits are streamed

}  // namespace

SampledOperator::SampledOperator(const PatchSet& patches, const HitStore& hits,
                                 const SampledOperatorOptions& options, const Workers& workers)
    : patches_(patches), hits_(hits), options_(options) {
  find_densities();
  do {
    if (!hits_.is_streamed()) find_arrivals(workers);
    find_row_sums(workers);
  } while (find_one_way_sides());
  find_row_factors(workers);
}

SampledOperator::~SampledOperator() = default;

std::uint64_t SampledOperator::bytes() const {
  std::uint64_t sum = 0;
  for (const auto& a : arrivals_) sum += a.bytes();
  return sum;
}

void SampledOperator::find_densities() {
  const auto slots = sides().size();
  density_.resize(slots);
  inverse_area_.resize(slots);
  sent_density_.assign(elements(), 0.0f);
  for (std::size_t s = 0; s < slots; ++s) {
    const auto patch = sides().side[s] / 2;
    inverse_area_[s] = 1.0 / static_cast<double>(patches_.area[patch]);
    density_[s] = static_cast<float>(hits_.rays_per_slot()[s] * inverse_area_[s]);
    const bool is_one_way = !options_.one_way.empty() && options_.one_way[s] > 0;
    if (options_.both_ways && !is_one_way) sent_density_[s] = density_[s];
  }
}

template <typename ForEachRound>
Arrivals SampledOperator::arrivals_of(std::size_t first, std::size_t end, ForEachRound for_each_round) const {
  const auto slots = sides().size();
  const auto for_each_pair = [&](auto body) {
    for (auto block = first; block < end; ++block)
      for_each_round(block, [&](std::span<const std::uint32_t> senders, const std::uint32_t* hit,
                                std::uint32_t per_slot) {
        for (const auto sender : senders)
          for (std::uint32_t i = 0; i < per_slot; ++i, ++hit)
            if (sent_density_[sender] > 0.0f && sent_density_[*hit] > 0.0f) body(sender, *hit);
      });
  };
  if (!hits_.shares().ranks()) return Arrivals::sorted(slots, for_each_pair);
  RayPairs own;
  for_each_pair([&](std::uint32_t sender, std::uint32_t receiver) {
    own.push_back(sender);
    own.push_back(receiver);
  });
  const auto pairs = exchanged_pairs(own, hits_.shares(), sides());
  return Arrivals::sorted(slots, [&](auto body) {
    for (std::size_t i = 0; i < pairs.size(); i += 2) body(pairs[i], pairs[i + 1]);
  });
}

void SampledOperator::find_arrivals(const Workers& workers) {
  arrivals_.resize(hits_.replicates());
  const auto find = [&](std::size_t r) {
    arrivals_[r] = arrivals_of(0, hits_.blocks(), [&](std::size_t block, auto body) {
      hits_.for_each_round(static_cast<std::uint32_t>(r), block, body);
    });
  };
  if (hits_.shares().ranks())  // which meet, in order
    for (std::size_t r = 0; r < arrivals_.size(); ++r) find(r);
  else
    workers.for_chunks(arrivals_.size(), 1, [&](std::size_t r, std::size_t, int) { find(r); });
}

// ---- Loops ----

template <std::size_t known_width, typename Kernel, typename MakeRows>
void SampledOperator::for_rows(std::uint32_t first, std::uint32_t end, std::size_t width,
                               const Workers& workers, const Kernel& kernel,
                               const MakeRows& make_rows) const {
  if (hits_.is_streamed())
    for_streamed_rows<known_width>(first, end, width, workers, kernel, make_rows);
  else
    for_stored_rows<known_width>(first, end, width, workers, kernel, make_rows);
}

template <std::size_t known_width, typename Kernel, typename MakeRows>
void SampledOperator::for_stored_rows(std::uint32_t first, std::uint32_t end, std::size_t width,
                                      const Workers& workers, const Kernel& kernel,
                                      const MakeRows& make_rows) const {
  const auto begins = hits_.block_begins();
  workers.for_chunks(hits_.blocks(), 1, [&](std::size_t block, std::size_t, int) {
    const auto slot0 = begins[block];
    const auto slot1 = begins[block + 1];
    if (!hits_.is_mine(slot0)) return;
    auto rows = make_rows(slot0, slot1);
    std::vector<double> own((slot1 - slot0) * width), arriving(own.size());
    for (auto r = first; r < end; ++r) {
      std::fill(own.begin(), own.end(), 0.0);
      std::fill(arriving.begin(), arriving.end(), 0.0);
      hits_.for_each_round(
          r, block,
          [&](std::span<const std::uint32_t> slots, const std::uint32_t* hit, std::uint32_t per_slot) {
            add_own_rays<known_width>(kernel, width, slots, hit, per_slot, slot0, own.data());
          });
      add_arrivals<known_width>(kernel, width, arrivals_[r], slot0, slot1, arriving.data());
      rows.add(r, own.data(), arriving.data());
    }
    rows.finish();
  });
}

// Traces some blocks at a time, and adds each ray at its both ends: in the order of blocks, as above.
template <std::size_t known_width, typename Kernel, typename MakeRows>
void SampledOperator::for_streamed_rows(std::uint32_t first, std::uint32_t end, std::size_t width,
                                        const Workers& workers, const Kernel& kernel,
                                        const MakeRows& make_rows) const {
  const auto begins = hits_.block_begins();
  const auto blocks = hits_.blocks();
  const std::size_t replicates = end - first;
  std::vector<std::vector<double>> own(replicates, std::vector<double>(sides().size() * width, 0.0));
  auto arriving = own;
  for (std::size_t from = 0; from < blocks;) {
    auto to = from;
    for (std::uint64_t rays = 0; to < blocks && rays < batch_rays; ++to)
      for (auto s = begins[to]; s < begins[to + 1]; ++s) rays += replicates * hits_.rays_per_slot()[s];
    // 1. The rays, and what they bring to their senders.
    std::vector<BlockRays> batch((to - from) * replicates);
    workers.for_chunks(batch.size(), 1, [&](std::size_t i, std::size_t, int) {
      const auto block = from + i / replicates;
      const auto k = i % replicates;
      batch[i].trace(hits_, first + static_cast<std::uint32_t>(k), block);
      batch[i].for_each_round(
          [&](std::span<const std::uint32_t> slots, const std::uint32_t* hit, std::uint32_t per_slot) {
            add_own_rays<known_width>(kernel, width, slots, hit, per_slot, begins[block],
                                      &own[k][begins[block] * width]);
          });
    });
    // 2. What they bring to those that they meet.
    std::vector<Arrivals> arrivals(replicates);
    const auto find = [&](std::size_t k) {
      arrivals[k] = arrivals_of(from, to, [&](std::size_t block, auto body) {
        batch[(block - from) * replicates + k].for_each_round(body);
      });
    };
    if (hits_.shares().ranks())
      for (std::size_t k = 0; k < replicates; ++k) find(k);
    else
      workers.for_chunks(replicates, 1, [&](std::size_t k, std::size_t, int) { find(k); });
    workers.for_chunks(blocks * replicates, 1, [&](std::size_t i, std::size_t, int) {
      const auto block = i / replicates;
      const auto k = i % replicates;
      if (hits_.is_mine(begins[block]))
        add_arrivals<known_width>(kernel, width, arrivals[k], begins[block], begins[block + 1],
                                  &arriving[k][begins[block] * width]);
    });
    from = to;
  }
  workers.for_chunks(blocks, 1, [&](std::size_t block, std::size_t, int) {
    if (!hits_.is_mine(begins[block])) return;
    auto rows = make_rows(begins[block], begins[block + 1]);
    const auto at = begins[block] * width;
    for (std::size_t k = 0; k < replicates; ++k)
      rows.add(first + static_cast<std::uint32_t>(k), &own[k][at], &arriving[k][at]);
    rows.finish();
  });
}

// ---- Sums of radiosity ----

SampledOperator::RayWeights SampledOperator::weights() const {
  RayWeights weight;
  for (std::size_t s = 0; s < density_.size(); ++s) {
    weight.trusted.push_back(options_.own_trust * density_[s]);
    weight.mutual.push_back(sent_density_[s] > 0.0f ? 1.0f : 0.0f);
  }
  return weight;
}

namespace {

// Density and three radiosities of an element in one place of memory.
struct PackedKernel {
  const std::array<float, 4>* element;
  const float* trusted;  // k d, [slot]
  const float* mutual;   // [slot]: 1, or 0 where rays count one way
  bool fetches;

  void fetch(std::uint32_t e) const {
    if (fetches) __builtin_prefetch(element + e);
  }
  void operator()(std::uint32_t slot, std::uint32_t e, double* sum) const {
    const auto& x = element[e];
    const auto q = 1.0f / (trusted[slot] + mutual[slot] * x[0]);
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

  void fetch(std::uint32_t) const {}
  void operator()(std::uint32_t slot, std::uint32_t e, double* sum) const {
    const auto q = 1.0f / (trusted[slot] + mutual[slot] * sent_density[e]);
    const auto width = known_columns ? known_columns : columns;
    const auto* R = radiosity + width * e;
    for (std::size_t c = 0; c < width; ++c) sum[c] += static_cast<double>(q * R[c]);
  }
};

}  // namespace

template <typename MakeRows>
void SampledOperator::sum_rows(std::uint32_t first, std::uint32_t end, std::size_t columns,
                               std::span<const float> radiosity, const Workers& workers,
                               const MakeRows& make_rows) const {
  const auto weight = weights();
  const auto add_columns = [&]<std::size_t known>() {
    const ColumnsKernel<known> kernel{radiosity.data(), sent_density_.data(), weight.trusted.data(),
                                      weight.mutual.data(), columns};
    for_rows<known>(first, end, columns, workers, kernel, make_rows);
  };
  if (columns == 12) return add_columns.template operator()<12>();
  if (columns != 3) return add_columns.template operator()<0>();
  std::vector<std::array<float, 4>> packed(elements());
  workers.for_chunks(packed.size(), grain, [&](std::size_t from, std::size_t to, int) {
    for (auto e = from; e < to; ++e)
      packed[e] = {sent_density_[e], radiosity[3 * e], radiosity[3 * e + 1], radiosity[3 * e + 2]};
  });
  const PackedKernel kernel{packed.data(), weight.trusted.data(), weight.mutual.data(),
                            packed.size() > cached_elements};
  for_rows<3>(first, end, 3, workers, kernel, make_rows);
}

namespace {

// Mean over replicates of the weighted rows of one block.
class MeanRows {
 public:
  MeanRows(std::uint32_t slot0, std::uint32_t slot1, std::size_t columns, double trust, std::uint32_t count,
           const std::vector<std::vector<float>>& factor, const std::vector<double>& inverse_area,
           std::span<float> out)
      : slot0_(slot0),
        slot1_(slot1),
        columns_(columns),
        trust_(trust),
        count_(count),
        factor_(factor),
        inverse_area_(inverse_area),
        out_(out),
        sum_((slot1 - slot0) * columns, 0.0) {}

  void add(std::uint32_t replicate, const double* own, const double* arriving) {
    for (auto s = slot0_; s < slot1_; ++s) {
      const auto factor = static_cast<double>(factor_[replicate][s]);
      for (auto i = (s - slot0_) * columns_; i < (s - slot0_ + 1) * columns_; ++i)
        sum_[i] += factor * (trust_ * own[i] + arriving[i]);
    }
  }
  void finish() {
    for (auto s = slot0_; s < slot1_; ++s) {
      const auto scale = inverse_area_[s] / count_;
      for (std::size_t c = 0; c < columns_; ++c)
        out_[s * columns_ + c] = static_cast<float>(scale * sum_[(s - slot0_) * columns_ + c]);
    }
  }

 private:
  std::uint32_t slot0_, slot1_;
  std::size_t columns_;
  double trust_;
  std::uint32_t count_;
  const std::vector<std::vector<float>>& factor_;
  const std::vector<double>& inverse_area_;
  std::span<float> out_;
  std::vector<double> sum_;
};

// The rows of each replicate apart.
class ReplicateRows {
 public:
  ReplicateRows(std::uint32_t slot0, std::uint32_t slot1, std::size_t columns, double trust,
                std::uint32_t first, const std::vector<double>& inverse_area,
                std::span<std::vector<float>> out)
      : slot0_(slot0),
        slot1_(slot1),
        columns_(columns),
        trust_(trust),
        first_(first),
        inverse_area_(inverse_area),
        out_(out) {}

  void add(std::uint32_t replicate, const double* own, const double* arriving) {
    auto& out = out_[replicate - first_];
    for (auto s = slot0_; s < slot1_; ++s)
      for (std::size_t c = 0; c < columns_; ++c) {
        const auto i = (s - slot0_) * columns_ + c;
        out[s * columns_ + c] = static_cast<float>(inverse_area_[s] * (trust_ * own[i] + arriving[i]));
      }
  }
  void finish() {}

 private:
  std::uint32_t slot0_, slot1_;
  std::size_t columns_;
  double trust_;
  std::uint32_t first_;
  const std::vector<double>& inverse_area_;
  std::span<std::vector<float>> out_;
};

}  // namespace

namespace {

// Row sums, and the sums of squared weights.
struct UnitKernel {
  const float* sent_density;
  const float* trusted;
  const float* mutual;

  void fetch(std::uint32_t) const {}
  void operator()(std::uint32_t slot, std::uint32_t e, double* sum) const {
    const auto q = static_cast<double>(1.0f / (trusted[slot] + mutual[slot] * sent_density[e]));
    sum[0] += q;
    sum[1] += q * q;
  }
};

}  // namespace

void SampledOperator::find_row_sums(const Workers& workers) {
  const auto slots = sides().size();
  row_sum_.assign(hits_.replicates(), std::vector<float>(slots, 1.0f));
  row_sum_variance_.assign(slots, 0.0f);
  if (!options_.both_ways || slots == 0) return;
  const auto weight = weights();
  const UnitKernel kernel{sent_density_.data(), weight.trusted.data(), weight.mutual.data()};
  struct Rows {
    std::uint32_t slot0, slot1;
    SampledOperator& whole;
    void add(std::uint32_t replicate, const double* own, const double* arriving) {
      const double k = whole.options_.own_trust;
      for (auto s = slot0; s < slot1; ++s) {
        const auto i = 2 * (s - slot0);
        const auto per_area = whole.inverse_area_[s];
        whole.row_sum_[replicate][s] = static_cast<float>(per_area * (k * own[i] + arriving[i]));
        whole.row_sum_variance_[s] +=
            static_cast<float>(per_area * per_area * (k * k * own[i + 1] + arriving[i + 1]));
      }
    }
    void finish() {}
  };
  for_rows<2>(0, hits_.replicates(), 2, workers, kernel, [&](std::uint32_t slot0, std::uint32_t slot1) {
    return Rows{slot0, slot1, *this};
  });
}

bool SampledOperator::find_one_way_sides() {
  constexpr std::uint32_t unit_positions = 64;
  constexpr double most_deviations = 5.0;
  constexpr double most_off = 0.02;  // less is not worth it: row sums are made 1 all the same
  if (!options_.both_ways) return false;
  std::vector<float> one_way(sides().size(), 0.0f);
  // Row sums of slots [first, end) together.
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
    if (std::abs(off) > std::max(most_deviations * std::sqrt(variance), most_off * rows))
      std::fill(one_way.begin() + first, one_way.begin() + end, 1.0f);
  };
  const auto begins = neighbour_begins(sides(), unit_positions);
  for (std::size_t u = 0; u + 1 < begins.size(); ++u) {
    if (!hits_.is_mine(begins[u])) continue;
    test(begins[u], begins[u + 1]);
    for (auto s = begins[u]; s < begins[u + 1]; ++s) test(s, s + 1);
  }
  hits_.share_slots(one_way, 1);
  bool is_new = false;
  for (std::size_t s = 0; s < one_way.size(); ++s) {
    is_new |= one_way[s] > 0.0f && sent_density_[s] > 0.0f;
    if (one_way[s] > 0.0f) sent_density_[s] = 0.0f;
  }
  return is_new;
}

void SampledOperator::find_row_factors(const Workers& workers) {
  const auto slots = sides().size();
  row_factor_.assign(hits_.replicates(), std::vector<float>(slots, 1.0f));
  if (!options_.both_ways || slots == 0) return;
  // g_r = 1 + sum over q != r of (1 - S_q) / (sum over p != q of S_p), within each half.
  for (std::size_t half = 0; half < 2; ++half) {
    const auto first = half_begin(half);
    const auto end = half_begin(half + 1);
    if (end - first < 2) continue;
    workers.for_chunks(slots, grain, [&](std::size_t from, std::size_t to, int) {
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

void SampledOperator::apply(std::size_t half, std::size_t columns, std::span<const float> radiosity,
                            std::span<float> irradiance, const Workers& workers) const {
  const auto first = half_begin(half);
  const auto end = half_begin(half + 1);
  sum_rows(first, end, columns, radiosity, workers, [&](std::uint32_t slot0, std::uint32_t slot1) {
    return MeanRows(slot0, slot1, columns, options_.own_trust, end - first, row_factor_, inverse_area_,
                    irradiance);
  });
  hits_.share_slots(irradiance, columns);
}

std::vector<std::vector<float>> SampledOperator::replicate_rows(std::size_t half,
                                                                std::span<const float> radiosity,
                                                                const Workers& workers) const {
  const auto first = half_begin(half);
  const auto end = half_begin(half + 1);
  const auto columns = radiosity.size() / elements();
  std::vector<std::vector<float>> rows(end - first, std::vector<float>(sides().size() * columns));
  sum_rows(first, end, columns, radiosity, workers, [&](std::uint32_t slot0, std::uint32_t slot1) {
    return ReplicateRows(slot0, slot1, columns, options_.own_trust, first, inverse_area_, rows);
  });
  if (end - first < 2 || !options_.both_ways) return rows;
  workers.for_chunks(sides().size(), grain, [&](std::size_t from, std::size_t to, int) {
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

// ---- What a ray is worth ----

namespace {

// sum[0] the part of the slot's own row, sum[1] the part of the other's.
struct WorthKernel {
  const float* density;       // of own rays, [slot]
  const float* sent_density;  // [element]
  const float* importance;    // I / A², [element]
  const float* radiosity;     // [element * bands + band]
  const float* level;         // c, [element * bands + band]
  std::size_t bands;

  void fetch(std::uint32_t e) const { __builtin_prefetch(radiosity + bands * e); }
  void operator()(std::uint32_t slot, std::uint32_t e, double* sum) const {
    double own = 0.0;
    double other = 0.0;
    for (std::size_t b = 0; b < bands; ++b) {
      const auto to_own = static_cast<double>(radiosity[bands * e + b] - level[bands * slot + b]);
      const auto to_other = static_cast<double>(radiosity[bands * slot + b] - level[bands * e + b]);
      own += to_own * to_own;
      other += to_other * to_other;
    }
    const bool is_mutual = sent_density[slot] > 0.0f && sent_density[e] > 0.0f;
    const auto d = static_cast<double>(density[slot] + (is_mutual ? sent_density[e] : 0.0f));
    const auto weight = 1.0 / (d * d * d);
    sum[0] += weight * own * static_cast<double>(importance[slot]);
    if (is_mutual) sum[1] += weight * other * static_cast<double>(importance[e]);
  }
};

}  // namespace

SampledOperator::RayWorth SampledOperator::ray_worth(std::span<const double> importance,
                                                     std::span<const float> radiosity,
                                                     std::span<const float> level,
                                                     const Workers& workers) const {
  const auto slots = sides().size();
  const auto bands = patches_.band_count();
  std::vector<float> per_area2(elements(), 0.0f), levels(elements() * bands, 0.0f);
  for (std::size_t s = 0; s < slots; ++s)
    per_area2[s] = static_cast<float>(importance[s] * inverse_area_[s] * inverse_area_[s]);
  std::copy(level.begin(), level.end(), levels.begin());
  RayWorth worth{std::vector<float>(slots), std::vector<float>(slots)};
  const WorthKernel kernel{density_.data(),  sent_density_.data(), per_area2.data(),
                           radiosity.data(), levels.data(),        bands};
  struct Rows {
    std::uint32_t slot0, slot1;
    const std::vector<double>& inverse_area;
    RayWorth& worth;
    std::vector<double> sum;
    void add(std::uint32_t, const double* own, const double* arriving) {
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += own[i] + arriving[i];
    }
    void finish() {
      for (auto s = slot0; s < slot1; ++s) {
        worth.own[s] = static_cast<float>(inverse_area[s] * sum[2 * (s - slot0)]);
        worth.given[s] = static_cast<float>(inverse_area[s] * sum[2 * (s - slot0) + 1]);
      }
    }
  };
  for_rows<2>(0, hits_.replicates(), 2, workers, kernel, [&](std::uint32_t slot0, std::uint32_t slot1) {
    return Rows{slot0, slot1, inverse_area_, worth, std::vector<double>(2 * (slot1 - slot0), 0.0)};
  });
  for (auto* part : {&worth.own, &worth.given}) hits_.share_slots(*part, 1);
  return worth;
}

// ---- Halves ----

CrossedHalves::CrossedHalves(const SampledOperator& whole, std::size_t bands)
    : whole_(whole),
      bands_(bands),
      row_begins_{0, static_cast<std::uint32_t>(whole.sides().size()),
                  static_cast<std::uint32_t>(2 * whole.sides().size())} {}

std::vector<float> CrossedHalves::seen_by(std::size_t half, std::span<const float> radiosity) const {
  const auto slots = whole_.sides().size() * bands_;
  std::vector<float> seen(whole_.elements() * bands_);
  const auto other = radiosity.subspan(half == 0 ? slots : 0, slots);
  const auto sinks = radiosity.subspan(2 * slots, seen.size() - slots);
  std::copy(sinks.begin(), sinks.end(), std::copy(other.begin(), other.end(), seen.begin()));
  return seen;
}

void CrossedHalves::apply(std::span<const float> radiosity, std::span<float> irradiance, std::size_t begin,
                          std::size_t end, const Workers& workers) const {
  const auto slots = whole_.sides().size();
  for (std::size_t half = 0; half < 2; ++half)
    if (begin <= half * slots && (half + 1) * slots <= end && slots > 0)
      whole_.apply(half, bands_, seen_by(half, radiosity),
                   irradiance.subspan(half * slots * bands_, slots * bands_), workers);
}

}  // namespace luxel
