// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/patch/patch_set.h"

namespace luxel {

// The original lamps and colours of patches, to which changes are relative, however often they are
// made.
class OwnLighting {
 public:
  explicit OwnLighting(const PatchSet& patches);

  const std::vector<float>& reflectance() const { return reflectance_; }  // [material * bands + band]

  // Give the same patches, or a copy of them, other lamps or colours, and the fingerprint of a scene so
  // changed. Both throw InputError where there are more or fewer numbers, or one is out of its range. weight:
  // brightness of each light group relative to the original, at least 0, [group * bands + band].
  void set_lamps(const std::vector<float>& weight, PatchSet& patches) const;
  // [material * bands + band], in [0, 1).
  void set_reflectance(const std::vector<float>& reflectance, PatchSet& patches) const;

 private:
  std::vector<std::vector<float>> emittance_;  // [material]
  std::vector<float> reflectance_;
  std::vector<std::vector<float>> intensity_;  // [point light]
  std::vector<float> sky_;
  std::uint64_t fingerprint_;
};

}  // namespace luxel
