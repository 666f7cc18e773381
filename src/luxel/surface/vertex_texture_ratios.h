// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/surface/smooth_light.h"

namespace luxel {

// Returns the texture ratio at vertices: the mean, by area, of the patches that meet there. Empty where no
// patch differs from its material.
class VertexTextureRatios {
 public:
  // Keeps a reference.
  explicit VertexTextureRatios(const PatchSet& patches) : patches_(patches) {}

  // Patches of one vertex are of one material.
  void add(std::size_t vertex, std::size_t patch);
  // Good until the next add().
  TextureRatio at(std::size_t vertex) const;

 private:
  void mix(std::vector<float>& means, const std::vector<float>& ratios, std::size_t vertex, std::size_t patch,
           float weight) const;

  const PatchSet& patches_;
  std::vector<float> area_;                     // [vertex], of all patches so far
  std::vector<float> reflectance_, emittance_;  // [vertex][band]
};

}  // namespace luxel
