// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "luxel/form_factors/element_rays.h"
#include "luxel/form_factors/view_factors.h"

namespace luxel {

// Rows of elements of one side each, as counted: 12 bytes a listed factor.
struct PatchRows {
  std::vector<std::uint32_t> element;  // [row]
  std::vector<std::uint32_t> length;   // [row]: listed factors
  std::vector<std::uint32_t> column;   // rising within a row
  std::vector<std::uint32_t> hits;     // the factor times all rays of the row
  std::vector<float> standard_error;
  std::array<std::vector<double>, ViewFactors::sinks> sink;       // [row]
  std::array<std::vector<float>, ViewFactors::sinks> sink_error;  // [row]
  // Sums of squared standard errors: of the listed factors; and of sinks, in addition.
  double factor_squared_error = 0.0, sink_squared_error = 0.0;
};

// Scratch memory of a thread, reused.
struct PatchRowScratch {
  std::vector<std::uint32_t> met;    // [replicate][receiver][ray]
  std::vector<std::uint32_t> place;  // [number met]: 1 + its place in `numbers`; else 0
  std::vector<std::uint32_t> numbers;
  std::vector<std::uint32_t> counts;  // [place][replicate]
};

// Appends the rows of these receivers, per_receiver rays per replicate. min_factor: factors below are
// dropped.
void append_patch_rows(const ElementRays& rays, std::span<const std::uint32_t> receivers,
                       std::uint32_t per_receiver, double min_factor, PatchRowScratch& scratch,
                       PatchRows& rows);

// Mean and standard error of the fractions of replicates, from their counts out of per_replicate rays each.
struct CountedFraction {
  std::uint32_t hits = 0;
  double fraction = 0.0;
  double standard_error = 0.0;
};
CountedFraction counted_fraction(std::span<const std::uint32_t> counts, std::uint64_t per_replicate);

}  // namespace luxel
