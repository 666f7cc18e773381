// SPDX-License-Identifier: Apache-2.0
// Numbers chosen for SampledOperator, with where they come from.
#pragma once

#include <cstddef>
#include <cstdint>

namespace luxel::sampled_tuning {

constexpr std::size_t grain = 1 << 14;  // numbers per chunk of a loop: some 10 us of work

// Elements whose radiosities stay near the processor without being asked for ahead: 1 MiB of 16 bytes.
constexpr std::size_t cached_elements = 1u << 16;

// Rays held at a time where hits are streamed: 16 MiB of hits, and as much of who sent them.
constexpr std::uint64_t held_rays = std::uint64_t{1} << 22;

// Sides that count one way: neighbours tested together, the deviations of their row sums from 1 (five: one
// false alarm in three million; a false one costs rays, not truth), and the least deviation worth it, since
// the control variate brings row sums to 1 all the same.
constexpr std::uint32_t tested_positions = 64;
constexpr double max_deviations = 5.0;
constexpr double min_deviation = 0.02;

}  // namespace luxel::sampled_tuning
