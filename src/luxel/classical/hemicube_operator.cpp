// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/hemicube_operator.h"

#include "luxel/classical/row_turns.h"

namespace luxel {

std::optional<HemicubeOperator> HemicubeOperator::make(const PatchSet& patches,
                                                       const HemicubeOptions& options,
                                                       const Context& context) {
  HemicubeOperator transport(patches, options, context);
  const bool is_whole =
      for_chunks_in_turns(transport.size(), 1, context, [&](std::size_t begin, std::size_t end) {
        Hemicube hemicube(patches, options);
        FormFactorRow row;
        for (auto receiver = begin; receiver < end; ++receiver) {
          hemicube.row(transport.sides().side[receiver], row);
          transport.book_losses(receiver, row);
        }
      });
  if (!is_whole) return {};
  return transport;
}

void HemicubeOperator::for_rows(std::size_t begin, std::size_t end, const RowBody& body) const {
  Hemicube hemicube(patches(), options_);
  FormFactorRow row;
  for (auto receiver = begin; receiver < end; ++receiver) {
    hemicube.row(sides().side[receiver], row);
    body(receiver, factors_of(row));
  }
}

}  // namespace luxel
