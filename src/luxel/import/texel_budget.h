// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "luxel/image/raster.h"

namespace luxel {

// Limit of all pictures of one scene together: 2^26 texels, and 64 more per byte of their files. Otherwise a
// few kilobytes that are used a thousand times could require gigabytes.
class TexelBudget {
 public:
  // Throws InputError where the budget is exceeded. bytes: of the picture's file.
  void take(const Raster& raster, std::uint64_t bytes);

 private:
  std::uint64_t texels_ = 0, allowed_ = std::uint64_t{1} << 26;
};

}  // namespace luxel
