// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/core/bounds.h"
#include "luxel/core/context.h"
#include "luxel/form_factors/shaft.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/patch_tree.h"

namespace luxel {

// Finds the patches that reach into a shaft. Read-only after it was made.
class ShaftSearch {
 public:
  // Keeps a reference to patches. 0.3 s and 75 MB per million patches.
  ShaftSearch(const PatchSet& patches, const Context& context);

  // Replaces `found` by those patches, but not more than `most`: beyond that it stops and returns false.
  bool find(const Shaft& shaft, std::size_t most, std::vector<std::uint32_t>& found) const;

 private:
  const PatchSet& patches_;
  PatchTree tree_;
  std::vector<Bounds> boxes_;  // [node]
};

}  // namespace luxel
