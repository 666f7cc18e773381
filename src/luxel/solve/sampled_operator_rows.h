// SPDX-License-Identifier: Apache-2.0
// The loops over rays that the parts of SampledOperator share; of no use elsewhere.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/solve/row_sums.h"
#include "luxel/solve/sampled_operator.h"
#include "luxel/solve/tuning.h"

namespace luxel {

template <typename ForEachRound>
Arrivals SampledOperator::arrivals_of(std::size_t first, std::size_t end, ForEachRound for_each_round) const {
  const auto receivers = sides().size();
  const auto for_each_pair = [&](auto body) {
    for (auto block = first; block < end; ++block)
      for_each_round(block, [&](std::span<const std::uint32_t> senders, const std::uint32_t* hit,
                                std::uint32_t per_receiver) {
        for (const auto sender : senders)
          for (std::uint32_t i = 0; i < per_receiver; ++i, ++hit)
            if (sent_density_[sender] > 0.0f && sent_density_[*hit] > 0.0f) body(sender, *hit);
      });
  };
  if (!hits_.partition().is_shared()) return Arrivals::sorted(receivers, for_each_pair);
  RayPairs own;
  for_each_pair([&](std::uint32_t sender, std::uint32_t receiver) {
    own.push_back(sender);
    own.push_back(receiver);
  });
  const auto pairs = exchanged_pairs(own, hits_.partition(), sides());
  return Arrivals::sorted(receivers, [&](auto body) {
    for (std::size_t i = 0; i < pairs.size(); i += 2) body(pairs[i], pairs[i + 1]);
  });
}

template <std::size_t known_width, typename Kernel, typename MakeRows>
void SampledOperator::for_rows(std::uint32_t first, std::uint32_t end, std::size_t width,
                               const Context& context, const Kernel& kernel,
                               const MakeRows& make_rows) const {
  if (hits_.is_streamed())
    for_streamed_rows<known_width>(first, end, width, context, kernel, make_rows);
  else
    for_stored_rows<known_width>(first, end, width, context, kernel, make_rows);
}

template <std::size_t known_width, typename Kernel, typename MakeRows>
void SampledOperator::for_stored_rows(std::uint32_t first, std::uint32_t end, std::size_t width,
                                      const Context& context, const Kernel& kernel,
                                      const MakeRows& make_rows) const {
  const auto begins = hits_.block_begins();
  context.for_chunks(hits_.blocks(), 1, [&](std::size_t block, std::size_t, int) {
    const auto receiver0 = begins[block];
    const auto receiver1 = begins[block + 1];
    if (!hits_.is_mine(receiver0)) return;
    auto rows = make_rows(receiver0, receiver1);
    std::vector<double> own((receiver1 - receiver0) * width), arriving(own.size());
    for (auto r = first; r < end; ++r) {
      std::fill(own.begin(), own.end(), 0.0);
      std::fill(arriving.begin(), arriving.end(), 0.0);
      hits_.for_each_round(
          r, block,
          [&](std::span<const std::uint32_t> receivers, const std::uint32_t* hit,
              std::uint32_t per_receiver) {
            add_own_rays<known_width>(kernel, width, {receivers, hit, per_receiver}, receiver0, own.data());
          });
      add_arrivals<known_width>(kernel, width, arrivals_[r], receiver0, receiver1, arriving.data());
      rows.add(r, own.data(), arriving.data());
    }
    rows.finish();
  });
}

// Traces some blocks at a time, and adds each ray at its both ends: in the order of blocks, as above.
template <std::size_t known_width, typename Kernel, typename MakeRows>
void SampledOperator::for_streamed_rows(std::uint32_t first, std::uint32_t end, std::size_t width,
                                        const Context& context, const Kernel& kernel,
                                        const MakeRows& make_rows) const {
  const auto begins = hits_.block_begins();
  const auto blocks = hits_.blocks();
  const std::size_t replicates = end - first;
  std::vector<std::vector<double>> own(replicates, std::vector<double>(sides().size() * width, 0.0));
  auto arriving = own;
  for (std::size_t from = 0; from < blocks;) {
    auto to = from;
    for (std::uint64_t rays = 0; to < blocks && rays < tuning::rows::held_rays; ++to)
      for (auto s = begins[to]; s < begins[to + 1]; ++s) rays += replicates * hits_.rays_per_receiver()[s];
    // 1. The rays, and what they bring to their senders.
    std::vector<BlockRays> batch((to - from) * replicates);
    context.for_chunks(batch.size(), 1, [&](std::size_t i, std::size_t, int) {
      const auto block = from + i / replicates;
      const auto k = i % replicates;
      batch[i].trace(hits_, first + static_cast<std::uint32_t>(k), block);
      batch[i].for_each_round([&](std::span<const std::uint32_t> receivers, const std::uint32_t* hit,
                                  std::uint32_t per_receiver) {
        add_own_rays<known_width>(kernel, width, {receivers, hit, per_receiver}, begins[block],
                                  &own[k][begins[block] * width]);
      });
    });
    // 2. Their contribution to the receivers that they meet.
    std::vector<Arrivals> arrivals(replicates);
    const auto find = [&](std::size_t k) {
      arrivals[k] = arrivals_of(from, to, [&](std::size_t block, auto body) {
        batch[(block - from) * replicates + k].for_each_round(body);
      });
    };
    if (hits_.partition().is_shared())
      for (std::size_t k = 0; k < replicates; ++k) find(k);
    else
      context.for_chunks(replicates, 1, [&](std::size_t k, std::size_t, int) { find(k); });
    context.for_chunks(blocks * replicates, 1, [&](std::size_t i, std::size_t, int) {
      const auto block = i / replicates;
      const auto k = i % replicates;
      if (hits_.is_mine(begins[block]))
        add_arrivals<known_width>(kernel, width, arrivals[k], begins[block], begins[block + 1],
                                  &arriving[k][begins[block] * width]);
    });
    from = to;
  }
  context.for_chunks(blocks, 1, [&](std::size_t block, std::size_t, int) {
    if (!hits_.is_mine(begins[block])) return;
    auto rows = make_rows(begins[block], begins[block + 1]);
    const auto at = begins[block] * width;
    for (std::size_t k = 0; k < replicates; ++k)
      rows.add(first + static_cast<std::uint32_t>(k), &own[k][at], &arriving[k][at]);
    rows.finish();
  });
}

}  // namespace luxel
