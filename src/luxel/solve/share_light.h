// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/parallel/ranks.h"
#include "luxel/parallel/workers.h"
#include "luxel/patch/patch_set.h"
#include "luxel/patch/patch_tree.h"
#include "luxel/solve/polynomial_fit.h"
#include "luxel/transport/gather_sides.h"

namespace luxel {

// Neighbouring patches share their rays: where the light of a node of the tree cannot be told from a linear
// or quadratic function of the place, given the noise, the node's patches take the value of that function,
// fitted by least squares over all of them. Three or six numbers for hundreds of patches have a hundredth of
// the variance.
//
// A fit f is kept where an unbiased estimate of what it gets wrong, |f - E y|², taken from products of
// different replicates (in which independent noise cancels), is at most three times the variance that the
// best of the finer fits below would add in its place (with one time, Mallows 1973; as trees are pruned:
// Breiman and others 1984). So a shadow's edge or a corner keeps its own patches' rays, and a node whose
// numbers carry no noise is never touched. Each half of the replicates is fitted by the choice of the other:
// what chose has no part in the numbers, so their spread, and the estimate of the bias, stay honest.
class LightSharing {
 public:
  // What does not change from round to round: where the slots are. Keeps a reference to the tree. 16 bytes a
  // slot.
  LightSharing(const PatchSet& patches, const PatchTree& tree, const GatherSides& sides,
               const Workers& workers);

  // values: [replicate][slot * bands + band], at least 4 replicates, replaced by the fits, each replicate's
  // from its own numbers. bias: [slot * bands + band], the square of what the fit may get wrong is added to
  // it; its sum weighted by area is an unbiased estimate, so it may be below 0 in places. The same bits on
  // any number of threads. Cost: about 0.3 us a slot for 8 replicates of 3 bands; nothing is kept but marks
  // on nodes. mine: of ranks that call with the same values and share the work, the slots whose numbers
  // this one needs: it gets those, and some beside them.
  void share(std::span<std::vector<float>> values, std::span<float> bias, const Workers& workers,
             const LoopShare& mine) const;

 private:
  const PatchTree& tree_;
  std::size_t bands_;
  std::vector<FitPlace> places_;                          // [slot]
  std::array<std::vector<std::uint32_t>, 2> first_slot_;  // fronts, backs: [place in the order, and the end]
};

// Once.
void share_light(const PatchSet& patches, const PatchTree& tree, const GatherSides& sides,
                 std::span<std::vector<float>> values, std::span<float> bias, const Workers& workers);

}  // namespace luxel
