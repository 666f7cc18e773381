// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/lines_operator.h"

#include "luxel/classical/local_lines.h"
#include "luxel/classical/row_turns.h"

namespace luxel {

std::optional<LinesOperator> LinesOperator::make(const PatchSet& patches, const Tracer& tracer,
                                                 const LinesOptions& options, const Context& context) {
  LinesOperator transport(patches, options.lines, context);
  const bool is_whole =
      for_chunks_in_turns(transport.size(), 4, context, [&](std::size_t begin, std::size_t end) {
        LineCounts counts;
        for (auto receiver = begin; receiver < end; ++receiver) {
          count_local_lines(patches, tracer, transport.sides().side[receiver], {options.lines, options.seed},
                            counts);
          const auto row = row_of(counts);
          transport.rows_[receiver] = transport.factors_of(row);
          transport.book_losses(receiver, row);
        }
      });
  if (!is_whole) return {};
  return transport;
}

void LinesOperator::for_rows(std::size_t begin, std::size_t end, const RowBody& body) const {
  for (auto receiver = begin; receiver < end; ++receiver) body(receiver, rows_[receiver]);
}

}  // namespace luxel
