// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/apply_glass.h"

#include <algorithm>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/import/name_list.h"
#include "luxel/scene/name_pattern.h"

namespace luxel {
namespace {

std::vector<std::string> names_of(const Scene& scene) {
  std::vector<std::string> names;
  for (const auto& material : scene.materials) names.push_back(material.name);
  return names;
}

void make_pane(Material& material, const Vec3& transmittance, const Scene& scene) {
  if (material.is_lamp())
    throw InputError(scene.source,
                     fmt::format("glass: the material '{}' emits light, so it is no pane", material.name));
  material.opaque = false;
  material.transmittance = transmittance;
}

// Returns whether there is such a material.
bool apply(const GlassOption& option, Scene& scene) {
  bool any = false;
  for (auto& material : scene.materials) {
    const bool applies =
        option.materials.empty() ? !material.opaque : matches(option.materials, material.name);
    if (!applies) continue;
    make_pane(material, option.transmittance, scene);
    any = true;
  }
  return any;
}

}  // namespace

bool is_glass_of(const std::vector<GlassOption>& options, const std::string& name) {
  return std::any_of(options.begin(), options.end(), [&](const GlassOption& option) {
    return option.materials.empty() || matches(option.materials, name);
  });
}

void apply_glass(const std::vector<GlassOption>& options, Scene& scene, const Context& context) {
  if (options.empty()) return;
  for (const auto& option : options) {
    if (apply(option, scene)) continue;
    if (option.materials.empty())
      throw InputError(
          scene.source,
          fmt::format("glass: no material lets light pass, so there are no panes; name the material "
                      "that is glass; there are {}",
                      name_list(names_of(scene))));
    throw InputError(scene.source, fmt::format("glass: no material matches '{}'; there are {}",
                                               option.materials, name_list(names_of(scene))));
  }
  std::vector<std::string> panes;
  for (const auto& material : scene.materials)
    if (!material.opaque && is_glass_of(options, material.name)) panes.push_back(material.name);
  context.note(fmt::format("{}: panes of glass, with the transmittance asked for: {}", scene.source,
                           name_list(panes)));
}

}  // namespace luxel
