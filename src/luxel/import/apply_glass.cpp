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
  material.diffuse_transmittance = Vec3(0.0f);
}

void make_diffuser(Material& material, const Vec3& transmittance) {
  material.opaque = true;
  material.two_sided = true;
  material.transmittance = Vec3(1.0f);
  material.diffuse_transmittance = transmittance;
}

// Returns whether any material matches. asked: [material], set for each that matches.
bool apply(const GlassOption& option, Scene& scene, std::vector<bool>& asked) {
  bool any = false;
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    auto& material = scene.materials[m];
    const bool applies =
        option.materials.empty() ? !material.opaque : matches(option.materials, material.name);
    if (!applies) continue;
    if (option.is_diffuse)
      make_diffuser(material, option.transmittance);
    else
      make_pane(material, option.transmittance, scene);
    any = asked[m] = true;
  }
  return any;
}

}  // namespace

bool limit_albedo(Material& material, float max_reflectance) {
  if (!material.is_diffuser()) return false;
  material.diffuse_transmittance = glm::min(material.diffuse_transmittance, Vec3(max_reflectance));
  const auto& tau = material.diffuse_transmittance;
  const auto left = std::max(0.0f, max_reflectance - std::max({tau.r, tau.g, tau.b}));
  material.textures.max_reflectance = std::min(material.textures.max_reflectance, left);
  const auto limited = glm::min(material.reflectance, Vec3(max_reflectance) - tau);
  if (limited == material.reflectance) return false;
  material.reflectance = limited;
  return true;
}

bool is_glass_of(const std::vector<GlassOption>& options, const std::string& name) {
  return std::any_of(options.begin(), options.end(), [&](const GlassOption& option) {
    return option.materials.empty() || matches(option.materials, name);
  });
}

void warn_of_limited_albedo(const std::string& source, const std::vector<std::string>& names,
                            float max_reflectance, const Context& context) {
  if (names.empty()) return;
  context.warn(fmt::format(
      "{}: the reflectance of {} was lowered, as no surface reflects and transmits more than {} of the light "
      "together",
      source, name_list(names), max_reflectance));
}

void apply_glass(const LoadOptions& load, Scene& scene, const Context& context) {
  const auto& options = load.glass;
  if (options.empty()) return;
  std::vector<bool> asked(scene.materials.size(), false);
  for (const auto& option : options) {
    if (apply(option, scene, asked)) continue;
    if (option.materials.empty())
      throw InputError(
          scene.source,
          fmt::format("glass: no material lets light pass, so there are no panes; name the material "
                      "that is glass; there are {}",
                      name_list(names_of(scene))));
    throw InputError(scene.source, fmt::format("glass: no material matches '{}'; there are {}",
                                               option.materials, name_list(names_of(scene))));
  }
  std::vector<std::string> panes, diffusers, too_bright;
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    auto& material = scene.materials[m];
    if (limit_albedo(material, load.max_reflectance)) too_bright.push_back(material.name);
    if (asked[m]) (material.is_diffuser() ? diffusers : panes).push_back(material.name);
  }
  const auto note = [&](const char* what, const std::vector<std::string>& names) {
    if (!names.empty())
      context.note(
          fmt::format("{}: {}, with the transmittance asked for: {}", scene.source, what, name_list(names)));
  };
  note("panes of glass", panes);
  note("diffusers, which transmit light evenly in all directions", diffusers);
  warn_of_limited_albedo(scene.source, too_bright, load.max_reflectance, context);
}

}  // namespace luxel
