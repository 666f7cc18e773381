// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/light_groups.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/scene/name_pattern.h"
#include "luxel/scene/triangle_names.h"

namespace luxel {
namespace {

// Names by which a rule can select the triangle's lamp.
std::vector<std::string> names_of(const Scene& scene, const PatchSet& patches, std::size_t patch) {
  auto names = object_and_group(scene, patches.triangle[patch]);
  names.insert(names.begin(), patches.material_of(patch).name);
  return names;
}

std::vector<std::string> lamp_names(const PatchSet& patches) {
  std::vector<std::string> names;
  for (const auto& material : patches.materials)
    if (material.is_lamp()) names.push_back(material.name);
  for (const auto& light : patches.point_lights) names.push_back(light.light.name);
  return names;
}

}  // namespace

void set_light_groups(const Scene& scene, std::span<const LightGroupRule> rules, PatchSet& patches) {
  auto& groups = patches.light_groups;
  groups.clear();
  const auto index_of = [&](const std::string& name) {
    const auto at = std::find(groups.begin(), groups.end(), name) - groups.begin();
    if (at == std::ssize(groups)) groups.push_back(name);
    return static_cast<std::uint32_t>(at);
  };
  std::vector<std::uint8_t> is_used(rules.size(), 0);
  const auto group_name = [&](std::size_t patch) {
    const auto names = names_of(scene, patches, patch);
    for (std::size_t r = 0; r < rules.size(); ++r)
      if (std::any_of(names.begin(), names.end(),
                      [&](const auto& name) { return matches(rules[r].pattern, name); })) {
        is_used[r] = 1;
        return rules[r].name;
      }
    return names.front();
  };

  const auto materials = patches.materials.size();
  std::vector<std::uint8_t> has_group(materials, 0);
  std::map<std::pair<std::size_t, std::uint32_t>, MaterialId> others;  // (material, a further group of it)
  std::uint32_t last_triangle = 0, group = 0;
  bool is_first = true;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto m = static_cast<std::size_t>(patches.material[p]);
    if (!patches.materials[m].is_lamp()) continue;
    if (is_first || patches.triangle[p] != last_triangle) group = index_of(group_name(p));
    is_first = false;
    last_triangle = patches.triangle[p];
    if (!has_group[m]) {
      has_group[m] = 1;
      patches.materials[m].light_group = group;
    }
    if (patches.materials[m].light_group == group) continue;
    const auto [at, is_new] = others.try_emplace({m, group}, MaterialId(patches.materials.size()));
    if (is_new) {
      auto other = patches.materials[m];
      other.light_group = group;
      patches.materials.push_back(std::move(other));
    }
    patches.material[p] = at->second;
  }
  for (auto& light : patches.point_lights) {
    const auto rule = std::find_if(rules.begin(), rules.end(), [&](const LightGroupRule& each) {
      return matches(each.pattern, light.light.name);
    });
    light.light_group = index_of(rule == rules.end() ? light.light.name : rule->name);
    if (rule != rules.end()) is_used[static_cast<std::size_t>(rule - rules.begin())] = 1;
  }
  for (std::size_t r = 0; r < rules.size(); ++r)
    if (!is_used[r])
      throw InputError(fmt::format(
          "light group '{}': no lamp's material, object or group is called '{}'; the materials of "
          "lamps are: {}",
          rules[r].name, rules[r].pattern, fmt::join(lamp_names(patches), ", ")));
  if (patches.has_sky()) index_of(sky_group);
  if (groups.size() > max_light_groups)
    throw with_hints(InputError(fmt::format(
                         "{} light groups, where at most {} can be dimmed separately: put lamps together",
                         groups.size(), max_light_groups)),
                     {{Setting::light_group, "NAME=PATTERN"}});
}

void join_light_groups(PatchSet& patches) {
  patches.light_groups.clear();
  for (auto& material : patches.materials) material.light_group = 0;
  for (auto& light : patches.point_lights) light.light_group = 0;
}

}  // namespace luxel
