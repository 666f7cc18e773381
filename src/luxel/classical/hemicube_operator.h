// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "luxel/classical/hemicube.h"
#include "luxel/classical/row_operator.h"
#include "luxel/core/context.h"

namespace luxel {

// Transport by hemicubes: each row is drawn when it is needed, and not stored (Cohen and Greenberg 1985;
// Cohen et al. 1988). Only 8 bytes per receiver and one-sided material are stored, so a scene of any size
// fits; each apply() draws the whole scene once for every receiver requested, which is quadratic.
//
// A row is the form factors of the pixels of a hemicube over the patch: aliased by its resolution, and taken
// at its `points` only. Neither error is estimated.
class HemicubeOperator final : public RowOperator {
 public:
  // Draws every row once to compute the losses. Keeps a reference to patches. Returns nothing if the monitor
  // stops the work. Throws InputError where an option is out of its range.
  static std::optional<HemicubeOperator> make(const PatchSet& patches, const HemicubeOptions& options,
                                              const Context& context = {});

  void for_rows(std::size_t begin, std::size_t end, const RowBody& body) const override;

 private:
  HemicubeOperator(const PatchSet& patches, const HemicubeOptions& options, const Context& context)
      : RowOperator(patches, context), options_(options) {}

  HemicubeOptions options_;
};

}  // namespace luxel
