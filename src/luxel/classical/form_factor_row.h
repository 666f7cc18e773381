// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/patch/side.h"

namespace luxel {

// The form factors from one side of a patch to all others, those that are not 0. Side 2p is the front of
// patch p, 2p + 1 its back.
struct FormFactorRow {
  struct Entry {
    SideId side;          // that is met, two-sided or not
    float factor = 0.0f;  // (0, 1]
  };
  std::vector<Entry> entries;  // sides rising
  double escaped = 0.0;        // [0, 1]: what meets nothing; with the factors, one
};

}  // namespace luxel
