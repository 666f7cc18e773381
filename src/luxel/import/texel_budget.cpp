// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/texel_budget.h"

#include <fmt/format.h>

#include "luxel/core/error.h"

namespace luxel {

void TexelBudget::take(const Raster& raster, std::uint64_t bytes) {
  constexpr std::uint64_t per_byte = 64;
  allowed_ += per_byte * bytes;
  texels_ += static_cast<std::uint64_t>(raster.width) * static_cast<std::uint64_t>(raster.height);
  if (texels_ > allowed_)
    throw InputError(
        fmt::format("the pictures of the scene hold more than {} texels, the most for files of "
                    "their size; make them smaller",
                    allowed_));
}

}  // namespace luxel
