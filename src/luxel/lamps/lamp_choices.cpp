// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/lamp_choices.h"

#include <algorithm>
#include <numeric>

namespace luxel {
namespace {

// Of the choices, spread evenly over all lamps, for those that closed form or bound underrate: it bounds the
// weights.
constexpr double min_fraction = 0.02;

}  // namespace

void LampChoices::make(const Lamps& lamps, const LightTree& tree, const std::array<Vec3, 3>& corners,
                       const Vec3& n, const LampChoiceOptions& options) {
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

  before_.assign(1, 0.0);
  const auto add = [&](double fraction) { before_.push_back(before_.back() + fraction); };
  for (const auto& lamp : lamps_) {
    const auto& triangle = lamps.triangles()[lamp.lamp];
    add(options.importance ? triangle.weight * lamp.irradiance : triangle.area);
  }
  for (const auto& branch : branches_) add(options.importance ? branch.irradiance : branch.area);
  const auto count = static_cast<double>(before_.size() - 1);
  const auto total = before_.back();
  for (std::size_t i = 0; i < before_.size(); ++i) {
    const auto even = static_cast<double>(i) / count;
    before_[i] = total > 0.0 ? (1.0 - min_fraction) * before_[i] / total + min_fraction * even : even;
  }
  if (!empty()) before_.back() = 1.0;
}

std::size_t LampChoices::choose(double& u) const {
  const auto above = std::upper_bound(before_.begin() + 1, before_.end() - 1, u);
  const auto i = static_cast<std::size_t>(above - before_.begin() - 1);
  u = std::clamp((u - before_[i]) / probability(i), 0.0, 0x1.fffffffffffffp-1);
  return i;
}

LampChoices::Lamp LampChoices::choose(const LightTree& tree, const Vec3& x, const Vec3& n, double u) const {
  const auto i = choose(u);
  if (i < lamps_.size()) return {i, {lamps_[i].lamp, probability(i), u}};
  if (branch(i).ball) return {i, {Lamps::no_lamp, probability(i), u}};
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
