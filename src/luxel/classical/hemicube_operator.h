// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "luxel/classical/hemicube.h"
#include "luxel/classical/row_operator.h"
#include "luxel/core/progress.h"

namespace luxel {

// Transport by hemicubes: each row is drawn when it is asked for, and forgotten (Cohen and Greenberg 1985;
// Cohen et al. 1988). Nothing but 8 bytes per receiver and one-sided material is kept, so a scene of any size
// fits; each apply() draws the whole scene once for every receiver it is asked for, which is quadratic.
//
// A row is what the pixels of a hemicube over the patch see: aliased by its resolution, and seen from its
// `points` only. Neither error is estimated.
class HemicubeOperator final : public RowOperator {
 public:
  // Draws every row once, to know the losses. Keeps a reference to patches. Nothing if the monitor said stop.
  // Throws InputError where an option is out of its range.
  static std::optional<HemicubeOperator> make(const PatchSet& patches, const HemicubeOptions& options,
                                              const Workers& workers, const Monitor& monitor = {});

  void for_rows(std::size_t begin, std::size_t end, const RowBody& body) const override;

 private:
  HemicubeOperator(const PatchSet& patches, const HemicubeOptions& options, const Workers& workers)
      : RowOperator(patches, workers), options_(options) {}

  HemicubeOptions options_;
};

}  // namespace luxel
