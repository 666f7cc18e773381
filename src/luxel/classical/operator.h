// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "luxel/core/context.h"

namespace luxel {

// Transport operator: computes the irradiance of every element from the radiosities of all, irradiance = F
// radiosity, with F_ij the form factor from i to j. The iterations (solve) depend on nothing else of F.
class TransportOperator {
 public:
  virtual ~TransportOperator() = default;

  // Elements: patch sides, in an order of the operator's own.
  virtual std::size_t size() const = 0;
  virtual std::size_t bands() const = 0;

  // Rows come in blocks: block k is [row_begins()[k], row_begins()[k + 1]); the last entry is size().
  virtual std::span<const std::uint32_t> row_begins() const = 0;

  // Rows [begin, end) of irradiance = F radiosity; other rows stay as they are. radiosity, irradiance:
  // [element][band], W/m², two arrays. begin and end: of row_begins(). The same bits on any number of
  // threads.
  virtual void apply(std::span<const float> radiosity, std::span<float> irradiance, std::size_t begin,
                     std::size_t end, const Context& context) const = 0;
};

}  // namespace luxel
