// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "luxel/classical/method_options.h"
#include "luxel/classical/row_operator.h"
#include "luxel/core/context.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Transport by local lines: each side traces `lines` random cosine lines, and the factor to another side is
// the share of them that meet it (listing 1 of the founding course paper). Unbiased, factor by factor. Rows
// are stored as pairs of receiver and share: 8 bytes each, at most `lines` per receiver. Cost: one nearest
// hit per line, once.
class LinesOperator final : public RowOperator {
 public:
  // Keeps a reference to patches. Returns nothing if the monitor stops the work.
  static std::optional<LinesOperator> make(const PatchSet& patches, const Tracer& tracer,
                                           const LinesOptions& options, const Context& context = {});

  void for_rows(std::size_t begin, std::size_t end, const RowBody& body) const override;
  std::uint32_t lines() const { return lines_; }

 private:
  LinesOperator(const PatchSet& patches, std::uint32_t lines, const Context& context)
      : RowOperator(patches, context), lines_(lines), rows_(size()) {}

  std::uint32_t lines_;
  std::vector<std::vector<Factor>> rows_;  // [receiver]
};

}  // namespace luxel
