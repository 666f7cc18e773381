// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "luxel/classical/operator.h"
#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solve/hit_store.h"
#include "luxel/solve/row_sums.h"

namespace luxel {

struct SampledOperatorOptions {
  bool both_ways = true;  // else each ray counts for its sender alone
  // Weight of a side's own rays, which are stratified, over that of the rays that arrive.
  float own_trust = 3.0f;
  // Sides whose rays count one way, see one_way_sides(): [receiver], or empty. Read while the operator is
  // made.
  std::span<const std::uint8_t> one_way = {};
};

// Transport F by rays that count at both their ends. A ray from side i that meets side j is a sample of F_ij,
// and by reciprocity (A_i F_ij = A_j F_ji) one of F_ji. With d = n / A the density of a side's n rays and k
// the weight of its own, one replicate estimates what arrives at i by the balance heuristic (Veach and Guibas
// 1995):
//
//     Y_i = 1 / A_i ( k sum over own rays of R_j / (k d_i + d_j) + sum over arriving rays of R_j / (k d_i +
//     d_j) )
//
// which is unbiased for any counts. Sinks and one_way_sides() have d_j = 0: rays to and from them count one
// way. So do sides, or 64 neighbours, whose row sums are off 1 by more than chance allows. Row sums S_i (Y of
// radiosity 1) are noisy about 1; they are the control variate of the other replicates, left out one at a
// time:
//
//     h_r = Y_r + (1 - S_r) sum over q != r of Y_q / sum over q != r of S_q
//
// Its mean over the replicates has rows that sum to 1, so that B = E + rho F B converges for every rho < 1.
//
// The replicates are in two halves. A ray that goes out and comes back would show a bright side itself; so
// light that one half gathered is sent on by the other, see CrossedHalves.
//
// Immutable, safe for any number of threads. References the patches and the hits, which must not change.
// Memory: 4 bytes per stored ray, and 12 bytes per receiver and replicate. Cost of an apply: two look-ups per
// ray; where hits are streamed, tracing them.
class SampledOperator {
 public:
  SampledOperator(const PatchSet& patches, const HitStore& hits, const SampledOperatorOptions& options,
                  const Context& context);
  ~SampledOperator();

  const HitStore& hits() const { return hits_; }
  const GatherSides& sides() const { return hits_.sides(); }
  std::size_t elements() const { return hits_.elements(); }

  // Replicates [half_begin(h), half_begin(h + 1)) are half h.
  std::uint32_t half_begin(std::size_t half) const {
    return half == 0 ? 0 : half == 1 ? std::max(1u, hits_.replicates() / 2) : hits_.replicates();
  }
  std::size_t half_of(std::uint32_t replicate) const { return replicate < half_begin(1) ? 0 : 1; }

  // irradiance = F radiosity, F the mean of one half of the replicates. radiosity: [element * columns +
  // column], irradiance: [receiver * columns + column]. Collective: all processes call it together.
  void apply(std::size_t half, std::size_t columns, std::span<const float> radiosity,
             std::span<float> irradiance, const Context& context) const;

  // Computes h_r for each replicate r of that half: [replicate - half_begin(half)][receiver * bands + band].
  // With several processes, each has its own rows alone: HitStore::all_gather_receivers().
  std::vector<std::vector<float>> replicate_rows(std::size_t half, std::span<const float> radiosity,
                                                 const Context& context) const;

  // Factor of all rays of that replicate in row `receiver`, relative to apply(): own rays to sinks have 1 /
  // n, with n rays of the receiver, times this.
  double row_factor(std::uint32_t replicate, std::size_t receiver) const {
    return static_cast<double>(row_factor_[replicate][receiver]);
  }
  // Sum of row `receiver` in one replicate.
  double row_sum(std::uint32_t replicate, std::size_t receiver) const {
    return static_cast<double>(row_sum_[replicate][receiver]);
  }

  // Computes the benefit of a further ray of each receiver: minus the derivative of J = sum of importance *
  // variance of irradiance by the number of the receiver's rays, n = d A, with d its rays per area. J is the
  // sum over receivers of n * worth. The benefit has two parts: the receiver's own row, and the rows of those
  // that its rays meet. Both are noisy, and follow what rays happened to meet: to be averaged over
  // neighbours.
  //
  //     worth_m = sum over j of F_mj [ I_m (R_j - c_m)^2 / A_m^2 + I_j (R_m - c_j)^2 / A_j^2 ]
  //               / (d_m + d_j)^2
  //
  // importance: I, [receiver]. radiosity: R, [element * bands + band]. level: c, the irradiance of rows if
  // all surfaces around them were alike, [receiver * bands + band]. Costs one apply. All processes get the
  // result.
  struct RayWorth {
    std::vector<float> own, given;  // [receiver]
  };
  RayWorth ray_worth(std::span<const double> importance, std::span<const float> radiosity,
                     std::span<const float> level, const Context& context) const;

 private:
  void find_densities();
  void find_arrivals(const Context& context);
  void find_row_factors(const Context& context);
  void find_row_sums(const Context& context);
  // Lets sides whose row sums are off 1 count one way. Returns whether there are any new ones.
  bool find_one_way_sides();
  // Arrivals of one replicate, of rays that the blocks [first, end) send.
  template <typename ForEachRound>
  Arrivals arrivals_of(std::size_t first, std::size_t end, ForEachRound for_each_round) const;
  void find_weights();

  // For each receiver of this rank and each of the replicates [first, end): sums over its own rays and over
  // those that arrive. kernel(receiver, element, sum) adds a ray's numbers to sum[0, width). Calls, for each
  // block, rows = make_rows(first receiver, end receiver), rows.add(replicate, own, arriving) in order of
  // replicates, each [receiver - first receiver][width], and rows.finish(). width: known_width, or any where
  // that is 0.
  template <std::size_t known_width, typename Kernel, typename MakeRows>
  void for_rows(std::uint32_t first, std::uint32_t end, std::size_t width, const Context& context,
                const Kernel& kernel, const MakeRows& make_rows) const;
  template <std::size_t known_width, typename Kernel, typename MakeRows>
  void for_stored_rows(std::uint32_t first, std::uint32_t end, std::size_t width, const Context& context,
                       const Kernel& kernel, const MakeRows& make_rows) const;
  template <std::size_t known_width, typename Kernel, typename MakeRows>
  void for_streamed_rows(std::uint32_t first, std::uint32_t end, std::size_t width, const Context& context,
                         const Kernel& kernel, const MakeRows& make_rows) const;
  // Sums of radiosity: kernel and rows of apply() and replicate_rows().
  template <typename MakeRows>
  void sum_rows(std::uint32_t first, std::uint32_t end, std::size_t columns, std::span<const float> radiosity,
                const Context& context, const MakeRows& make_rows) const;

  const PatchSet& patches_;
  const HitStore& hits_;
  SampledOperatorOptions options_;
  // Rays of one replicate per area, 1/m²: [receiver], of the receiver's own rays; [element], of those that
  // may arrive from it: 0 for sinks and sides that count one way.
  std::vector<float> density_, sent_density_;
  std::vector<float> trusted_, mutual_;  // [receiver]: k d; 1, or 0 where rays count one way
  std::vector<double> inverse_area_;     // [receiver], 1/m²
  std::vector<Arrivals> arrivals_;       // [replicate]; none where hits are streamed
  std::vector<std::vector<float>> row_sum_,
      row_factor_;  // [replicate][receiver], of this process's receivers
  // [receiver]: sum over replicates of the variances that row sums would have if all rays were independent.
  std::vector<float> row_sum_variance_;
};

// Both halves as one system: rows [0, n) are what the first half gathers of light that the second gathered,
// rows [n, 2 n) the reverse, n receivers each; then come the sinks. radiosity: [row or sink][band].
class CrossedHalves final : public TransportOperator {
 public:
  // Keeps a reference.
  explicit CrossedHalves(const SampledOperator& whole, std::size_t bands);
  std::size_t size() const override { return 2 * whole_.sides().size(); }
  std::size_t bands() const override { return bands_; }
  std::span<const std::uint32_t> row_begins() const override { return row_begins_; }
  void apply(std::span<const float> radiosity, std::span<float> irradiance, std::size_t begin,
             std::size_t end, const Context& context) const override;

  // The radiosities gathered by half h of the rows: those of the other half and the sinks, [element][band].
  std::vector<float> seen_by(std::size_t half, std::span<const float> radiosity) const;

 private:
  const SampledOperator& whole_;
  std::size_t bands_;
  std::array<std::uint32_t, 3> row_begins_;
};

// One half alone, any number of columns in place of bands.
class HalfOperator final : public TransportOperator {
 public:
  HalfOperator(const SampledOperator& whole, std::size_t half, std::size_t columns)
      : whole_(whole),
        half_(half),
        columns_(columns),
        row_begins_{0, static_cast<std::uint32_t>(whole.sides().size())} {}
  std::size_t size() const override { return whole_.sides().size(); }
  std::size_t bands() const override { return columns_; }
  std::span<const std::uint32_t> row_begins() const override { return row_begins_; }
  void apply(std::span<const float> radiosity, std::span<float> irradiance, std::size_t, std::size_t,
             const Context& context) const override {
    whole_.apply(half_, columns_, radiosity, irradiance, context);
  }

 private:
  const SampledOperator& whole_;
  std::size_t half_, columns_;
  std::array<std::uint32_t, 2> row_begins_;
};

}  // namespace luxel
