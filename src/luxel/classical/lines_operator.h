// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "luxel/classical/row_operator.h"
#include "luxel/core/progress.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct LinesOptions {
  std::uint32_t lines = 1000;  // from each side
  std::uint64_t seed = 1;      // another seed, other lines
};

// Transport by local lines: from each side go so many random cosine lines, and the factor to another is the
// share of them that meet it (listing 1 of the founding course paper). Unbiased, factor by factor. Rows are
// stored as pairs of receiver and share: 8 bytes each, at most `lines` a receiver. Cost: one nearest hit a
// line, once.
class LinesOperator final : public RowOperator {
 public:
  // Keeps a reference to patches. Nothing if the monitor said stop.
  static std::optional<LinesOperator> make(const PatchSet& patches, const Tracer& tracer,
                                           const LinesOptions& options, const Workers& workers,
                                           const Monitor& monitor = {});

  void for_rows(std::size_t begin, std::size_t end, const RowBody& body) const override;
  std::uint32_t lines() const { return lines_; }

 private:
  LinesOperator(const PatchSet& patches, std::uint32_t lines, const Workers& workers)
      : RowOperator(patches, workers), lines_(lines), rows_(size()) {}

  std::uint32_t lines_;
  std::vector<std::vector<Factor>> rows_;  // [receiver]
};

}  // namespace luxel
