// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/form_factors/view_factors.h"

namespace luxel {

// Exchange areas G_ij = A_i F_ij = A_j F_ji, m², with both halves of the symmetric table listed, identical to
// the bit.
struct ExchangeAreas {
  std::vector<std::uint64_t> row_begin;  // [element + 1]
  std::vector<std::uint32_t> column;
  std::vector<double> value;          // m²
  std::vector<float> standard_error;  // measured, of the factor: value / area of the row
  // m⁴, for the weights, see enforce_laws(). balance_rows() marks areas that it holds at 0 by a negative
  // sign.
  std::vector<float> variance;
  struct SinkColumn {
    std::vector<double> value;     // [element], m²
    std::vector<double> variance;  // [element], m⁴
  };
  std::array<SinkColumn, ViewFactors::sinks> sink;
  std::vector<double> weight;  // [element], rays / m²; 0 where factors were not counted

  std::size_t size() const { return weight.size(); }
};

// Combines the two estimates of each exchange area. Returns nothing where the monitor stops the work. Memory:
// 20 bytes per listed exchange area.
std::optional<ExchangeAreas> join_directions(const ViewFactors& factors, const Context& context);

// Sets the weights' variances: the measured ones mixed with those of counts, half and half, so that none is 0
// by chance.
void smooth_variances(ExchangeAreas& areas, const ViewFactors& factors, const Context& context);

}  // namespace luxel
