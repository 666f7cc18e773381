// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/patch/patch_set.h"
#include "luxel/patch/side.h"
#include "luxel/solution/solution.h"

namespace luxel {

// What each bounce of an iterative solve brings, and the next will send on: the difference of two successive
// radiosities.
class UnshotLight {
 public:
  // Before the first bounce there is what lamps emit.
  void begin(const PatchSet& patches);
  // Where light does not come in bounces.
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
