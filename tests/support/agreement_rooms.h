// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/patch/patch_set.h"

namespace luxel::truth {

// Small scenes on which every method must give the same light: open and closed, with things in the way, with
// one lamp and with many, dark and bright, with sheets that are lit on both sides. 60 to 250 patches each.
struct AgreementRoom {
  const char* name;
  PatchSet (*make)();
};
const std::vector<AgreementRoom>& agreement_rooms();

}  // namespace luxel::truth
