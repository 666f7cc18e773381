// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "luxel/core/discrete_distribution.h"
#include "luxel/lamps/lamps.h"
#include "luxel/lamps/light_tree.h"
#include "luxel/lamps/lit_side.h"

namespace luxel {

struct LampChoiceOptions {
  std::size_t most = 48;     // lamps and branches that are chosen separately, up to 48
  bool importance = true;    // by what they may give the patch; else by area
  bool closed_form = false;  // lamps that stand alone with their mean over the patch; else roughly
  bool balls = true;         // bulbs of many facets as one choice, sampled by their bounding sphere
};

// The lamps that samples of one side of a patch choose from: the most important lamps individually, the
// others in branches of the tree; all individually where there are few. Rebuilt for each side in the memory
// of the last.
class LampChoices {
 public:
  static constexpr std::size_t few_lamps = 48;

  // corners, n: of the side.
  void make(const Lamps& lamps, const LightTree& tree, const std::array<Vec3, 3>& corners, const Vec3& n,
            const LampChoiceOptions& options);

  bool empty() const { return choices_.size() == 0; }
  // Lamps chosen individually: choices 0, 1, ...; the branches follow.
  const std::vector<SideLamp>& lamps() const { return lamps_; }
  double probability(std::size_t choice) const { return choices_.weight(choice); }

  struct Lamp {
    std::size_t choice = 0;
    LampChoice lamp;  // with the probability of all choices on the way to it
  };
  // Chooses one lamp for the point x of the side. u: uniform in [0, 1); its remainder is reused as the first
  // number of the point on the lamp, so that the two best dimensions cover all lamps at once. For a ball no
  // lamp is chosen (none); the probability is that of the choice.
  Lamp choose(const LightTree& tree, const Vec3& x, const Vec3& n, double u) const;
  // Returns the branch of a choice that is not an individual lamp.
  const LampBranch& branch(std::size_t choice) const { return branches_[choice - lamps_.size()]; }
  // The probability with which choose() gives this lamp at x, and the choice it hangs in. 0: never. Without
  // balls.
  Lamp find(const LightTree& tree, std::uint32_t lamp, const Vec3& x, const Vec3& n) const;

 private:
  std::size_t choose(double& u) const;

  std::vector<SideLamp> lamps_;
  std::vector<LampBranch> branches_;
  std::vector<std::uint32_t> single_;
  DiscreteDistribution choices_;
  bool by_area_ = false;
};

}  // namespace luxel
