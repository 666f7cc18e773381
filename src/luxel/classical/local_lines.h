// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/classical/form_factor_row.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// What the lines from one patch side met: how many of them met which side. Side 2p is the front of patch p,
// 2p + 1 its back.
struct LineCounts {
  struct Entry {
    std::uint32_t side = 0;
    std::uint32_t lines = 0;  // at least 1
  };
  std::vector<Entry> entries;  // sides rising
  std::uint32_t lines = 0;     // shot
  std::uint32_t escaped = 0;   // that met nothing
};

// The form factor that a count stands for, and its standard error: that of a binomial share whose prior is
// Jeffreys's, so that neither a single hit nor a full count claims to be exact.
double line_factor(std::uint32_t lines_met, std::uint32_t lines_shot);
double line_standard_error(std::uint32_t lines_met, std::uint32_t lines_shot);

// One row of form factors by local lines (listing 1 of the founding course paper; Sbert 1997): lines from
// uniformly random points of the side in cosine-distributed directions, counted where they end. Unbiased.
// seed and step: address of the random numbers; rows of the same address repeat, other addresses are
// independent. `counts` is replaced; its memory is used again. Any number of threads may call. Costs one
// nearest hit per line.
void count_local_lines(const PatchSet& patches, const Tracer& tracer, std::size_t side, std::uint32_t lines,
                       std::uint64_t seed, std::uint32_t step, LineCounts& counts);

// The counts as a row; factors are shares of the lines.
FormFactorRow row_of(const LineCounts& counts);

}  // namespace luxel
