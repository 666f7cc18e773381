// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/lamp_choices.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "luxel/core/none.h"
#include "luxel/core/unit_vector.h"

namespace luxel {
namespace {

// Fraction of the choices that is spread evenly over all lamps, for those whose closed form or bound is too
// low; it limits the weights.
constexpr double min_fraction = 0.02;

}  // namespace

void LampChoices::make(const Lamps& lamps, const LightTree& tree, const std::array<Vec3, 3>& corners,
                       const Vec3& n, const LampChoiceOptions& options) {
  assert(is_unit(n) && options.most <= few_lamps);
  by_area_ = !options.importance;
  branches_.clear();
  single_.clear();
  if (lamps.size() <= few_lamps) {
    single_.resize(lamps.size());
    std::iota(single_.begin(), single_.end(), 0u);
  } else {
    const auto centre = (corners[0] + corners[1] + corners[2]) / 3.0f;
    const auto radius = std::max({glm::distance(corners[0], centre), glm::distance(corners[1], centre),
                                  glm::distance(corners[2], centre)});
    tree.cut(centre, 1.0001f * radius, n, options.most, options.balls, branches_);
    std::erase_if(branches_, [&](const LampBranch& branch) {
      if (branch.single) single_.push_back(branch.index);
      return branch.single;
    });
  }
  find_side_lamps(lamps, single_, corners, n, options.closed_form, lamps_);

  choices_.clear();
  for (const auto& lamp : lamps_) {
    const auto& triangle = lamps.triangles()[lamp.lamp];
    choices_.add(options.importance ? triangle.weight * lamp.irradiance : triangle.area);
  }
  for (const auto& branch : branches_) choices_.add(options.importance ? branch.irradiance : branch.area);
  choices_.normalise(min_fraction);
}

std::size_t LampChoices::choose(double& u) const {
  const auto i = choices_.at(u);
  u = std::clamp((u - choices_.before(i)) / probability(i), 0.0, 0x1.fffffffffffffp-1);
  return i;
}

LampChoices::Lamp LampChoices::choose(const LightTree& tree, const Vec3& x, const Vec3& n, double u) const {
  assert(u >= 0.0 && u < 1.0);
  const auto i = choose(u);
  if (i < lamps_.size()) return {i, {lamps_[i].lamp, probability(i), u}};
  if (branch(i).ball) return {i, {none, probability(i), u}};
  auto lamp = tree.choose(branches_[i - lamps_.size()], x, n, u, by_area_);
  lamp.probability *= probability(i);
  return {i, lamp};
}

LampChoices::Lamp LampChoices::find(const LightTree& tree, std::uint32_t lamp, const Vec3& x,
                                    const Vec3& n) const {
  for (std::size_t i = 0; i < lamps_.size(); ++i)
    if (lamps_[i].lamp == lamp) return {i, {lamp, probability(i), 0.0}};
  for (std::size_t i = 0; i < branches_.size(); ++i)
    if (tree.holds(branches_[i], lamp)) {
      const auto choice = lamps_.size() + i;
      return {choice,
              {lamp, probability(choice) * tree.probability(branches_[i], lamp, x, n, by_area_), 0.0}};
    }
  return {lamps_.size() + branches_.size(), {lamp, 0.0, 0.0}};
}

}  // namespace luxel
