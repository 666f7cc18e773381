// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "luxel/patch/patch_set.h"
#include "luxel/scene/scene.h"

namespace luxel {

/// Lamps whose material, object or group has a name that matches the pattern (* and ? as in name_pattern.h)
/// are dimmed and coloured together, by this name.
struct LightGroupRule {
  std::string name, pattern;
};

inline constexpr std::size_t max_light_groups = 64;
inline constexpr const char* sky_group = "sky";  // the name of the sky's own group

/// Puts every lamp into a light group: that of the first rule that it matches, else one that has the name of
/// its material. The sky is a group of its own, the last. A material whose lamps are in several groups
/// becomes several of one name. Without light there are no groups.
///
/// Throws InputError where a rule matches no lamp, or there are more than max_light_groups: the light of each
/// is stored separately, so memory and the cost of sums grow with their number.
void set_light_groups(const Scene& scene, std::span<const LightGroupRule> rules, PatchSet& patches);

/// Joins all light in one group, for files that do not store the light of groups.
void join_light_groups(PatchSet& patches);

}  // namespace luxel
