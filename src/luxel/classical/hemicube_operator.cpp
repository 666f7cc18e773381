// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/hemicube_operator.h"

#include "luxel/classical/row_turns.h"

namespace luxel {

std::optional<HemicubeOperator> HemicubeOperator::make(const PatchSet& patches,
                                                       const HemicubeOptions& options, const Workers& workers,
                                                       const Monitor& monitor) {
  HemicubeOperator transport(patches, options, workers);
  const bool is_whole =
      for_chunks_in_turns(transport.size(), 1, workers, monitor, [&](std::size_t begin, std::size_t end) {
        Hemicube hemicube(patches, options);
        FormFactorRow row;
        for (auto slot = begin; slot < end; ++slot) {
          hemicube.row(transport.sides().side[slot], row);
          transport.book_losses(slot, row);
        }
      });
  if (!is_whole) return {};
  return transport;
}

void HemicubeOperator::for_rows(std::size_t begin, std::size_t end, const RowBody& body) const {
  Hemicube hemicube(patches(), options_);
  FormFactorRow row;
  for (auto slot = begin; slot < end; ++slot) {
    hemicube.row(sides().side[slot], row);
    body(slot, factors_of(row));
  }
}

}  // namespace luxel
