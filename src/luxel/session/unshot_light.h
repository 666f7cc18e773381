// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/solution/solution.h"

namespace luxel {

// Light that each bounce of an iterative solve adds and the next one will reflect: the difference of two
// successive radiosities.
class UnshotLight {
 public:
  // Before the first bounce the unshot light is the emission of lamps.
  void begin(const PatchSet& patches);
  // For light that does not come in bounces.
  void clear();
  void add_bounce(const Solution& light);

  // W/m², [patch][band]; empty where light does not come in bounces.
  const SideValues& values() const { return unshot_; }

 private:
  bool is_active_ = false;
  SideValues radiosity_;  // after the bounces so far
  SideValues unshot_;
};

}  // namespace luxel
