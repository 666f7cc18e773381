// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/classical/form_factor_row.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// The hits of the lines from one patch side: the number of lines per side that they met. Side 2p is the front
// of patch p, 2p + 1 its back.
struct LineCounts {
  struct Entry {
    SideId side;
    std::uint32_t lines = 0;  // at least 1
  };
  std::vector<Entry> entries;  // sides rising
  std::uint32_t lines = 0;     // shot
  std::uint32_t escaped = 0;   // that met nothing
};

// Form factor estimated from a count, and its standard error: that of a binomial fraction with Jeffreys'
// prior, so that neither a single hit nor a full count appears exact.
double line_factor(std::uint32_t lines_met, std::uint32_t lines_shot);
double line_standard_error(std::uint32_t lines_met, std::uint32_t lines_shot);

struct LineRays {
  std::uint32_t lines = 0;
  // Address of the random numbers: rows of the same address repeat, other addresses are independent.
  std::uint64_t seed = 1;
  std::uint32_t step = 0;
};

// One row of form factors by local lines (listing 1 of the founding course paper; Sbert 1997): lines from
// uniformly random points of the side in cosine-distributed directions, counted where they end. Unbiased.
// `counts` is replaced; its memory is used again. Any number of threads may call. Costs one nearest hit per
// line.
void count_local_lines(const PatchSet& patches, const Tracer& tracer, SideId side, const LineRays& rays,
                       LineCounts& counts);

// The counts as a row; factors are shares of the lines.
FormFactorRow row_of(const LineCounts& counts);

}  // namespace luxel
