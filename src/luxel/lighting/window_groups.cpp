// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/window_groups.h"

#include <algorithm>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/import/name_list.h"
#include "luxel/patch/make_panes.h"
#include "luxel/scene/name_pattern.h"
#include "luxel/scene/triangle_names.h"

namespace luxel {
namespace {

constexpr float nearly_all = 0.99999f;  // of what a pane lets through, so that it counts as one

// Material, object and group of a triangle of glass.
std::vector<std::string> names_of(const Scene& scene, std::size_t triangle) {
  auto names = object_and_group(scene, triangle);
  names.push_back(scene.materials[static_cast<std::size_t>(scene.triangle_material[triangle])].name);
  return names;
}

bool fits(const WindowGroup& group, const std::vector<std::string>& names) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return !name.empty() && matches(group.name, name); });
}

// The error that no window has the name of a group. known: the names of glass, which follow `introduction`.
std::string no_window(const WindowGroup& group, const std::set<std::string>& known,
                      const std::string& introduction) {
  if (known.empty())
    return fmt::format("blinds: no window is called '{}': there is no glass; name the material that is glass",
                       group.name);
  return fmt::format("blinds: no window is called '{}', or it belongs to a group before; {} {}", group.name,
                     introduction, name_list(std::vector(known.begin(), known.end())));
}

[[noreturn]] void refuse(const WindowGroup& group, const Scene& scene) {
  std::set<std::string> names;
  for (const auto& glass : find_glass(scene))
    for (const auto& name : names_of(scene, glass.triangle))
      if (!name.empty()) names.insert(name);
  const InputError error(scene.source, no_window(group, names, "the names of glass are"));
  if (names.empty()) throw with_hints(error, {{Setting::glass, "NAME=TAU"}});
  throw error;
}

// names: of each pane. A pane belongs to the first group whose name fits one of its own.
std::vector<std::vector<std::uint32_t>> grouped(std::span<const WindowGroup> groups,
                                                const std::vector<std::vector<std::string>>& names) {
  std::vector<std::vector<std::uint32_t>> panes(groups.size());
  for (std::uint32_t i = 0; i < names.size(); ++i) {
    const auto group =
        std::find_if(groups.begin(), groups.end(), [&](const WindowGroup& g) { return fits(g, names[i]); });
    if (group != groups.end()) panes[static_cast<std::size_t>(group - groups.begin())].push_back(i);
  }
  return panes;
}

double luminance_under(const std::vector<float>& sky, std::size_t bands, std::size_t sky_patch) {
  return std::accumulate(sky.begin() + static_cast<std::ptrdiff_t>(sky_patch * bands),
                         sky.begin() + static_cast<std::ptrdiff_t>((sky_patch + 1) * bands), 0.0);
}

// In the mean over points and replicates, under the sky of the patches.
double mean_light(const DaylightCoefficients& coefficients, const PatchSet& patches) {
  double sum = 0.0;
  for (std::size_t path = 0; path < daylight_paths; ++path)
    for (std::size_t m = 0; m < coefficients.points; ++m)
      for (std::uint32_t r = 0; r < coefficients.replicates; ++r) {
        const auto row = coefficients.row(static_cast<DaylightPath>(path), m, r);
        for (std::size_t p = 0; p < row.size(); ++p)
          sum += static_cast<double>(row[p]) * luminance_under(patches.sky, patches.band_count(), p);
      }
  return sum / static_cast<double>(std::max<std::size_t>(1, coefficients.points * coefficients.replicates));
}

}  // namespace

WindowLight all_windows(double transmittance) { return {{{"all windows", transmittance}}, {}, {}, 0.0}; }

void make_panes_of_groups(std::span<const WindowGroup> groups, Scene& scene) {
  for (const auto& group : groups) {
    bool any = false;
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
      auto& material = scene.materials[static_cast<std::size_t>(scene.triangle_material[t])];
      if (material.opaque || !fits(group, names_of(scene, t))) continue;
      any = true;
      material.transmittance = glm::min(material.transmittance, Vec3(nearly_all));
    }
    if (!any) refuse(group, scene);
  }
}

std::vector<std::vector<std::uint32_t>> panes_of_groups(const Scene& scene, const PatchSet& patches,
                                                        std::span<const WindowGroup> groups) {
  const auto triangles = pane_triangles(scene);
  if (triangles.size() != patches.panes.size()) throw MismatchError("the panes are not those of the scene");
  std::vector<std::vector<std::string>> names;
  for (const auto triangle : triangles) names.push_back(names_of(scene, triangle));
  auto panes = grouped(groups, names);
  for (std::size_t g = 0; g < groups.size(); ++g)
    if (panes[g].empty()) refuse(groups[g], scene);
  return panes;
}

std::vector<std::vector<std::uint32_t>> panes_of_groups(const PatchSet& patches,
                                                        std::span<const WindowGroup> groups) {
  std::vector<std::vector<std::string>> names;
  std::set<std::string> known;
  for (const auto& pane : patches.panes) {
    names.push_back({patches.materials[static_cast<std::size_t>(pane.material)].name});
    known.insert(names.back()[0]);
  }
  auto panes = grouped(groups, names);
  for (std::size_t g = 0; g < groups.size(); ++g)
    if (panes[g].empty())
      throw InputError(no_window(groups[g], known, "a stored run knows glass by its material, which is"));
  return panes;
}

PatchSet with_dark_panes(const PatchSet& patches, std::span<const std::uint32_t> panes) {
  auto dark = patches;
  const auto id = static_cast<MaterialId>(dark.materials.size());
  auto& material = dark.materials.emplace_back();
  material.name = "closed blinds";
  material.reflectance.assign(dark.band_count(), 0.0f);
  material.emittance.assign(dark.band_count(), 0.0f);
  material.transmittance.assign(dark.band_count(), 0.0f);
  for (const auto pane : panes) dark.panes[pane].material = id;
  return dark;
}

WindowLight find_window_light(const WindowRun& of, const Tracer& tracer, std::vector<WindowGroup> groups,
                              std::span<const std::vector<std::uint32_t>> panes,
                              const CoefficientOptions& options, const Context& context) {
  WindowLight light;
  light.groups = std::move(groups);
  const auto with_dark = [&](const PatchSet& patches) {
    return find_coefficients({patches, of.run.state, of.run.options, true}, tracer, of.points, options,
                             context);
  };
  std::vector<std::uint32_t> all;
  auto left = mean_light(of.open, of.run.patches);
  const auto whole = left;
  for (const auto& of_group : panes) {
    light.dark.push_back(with_dark_panes(of.run.patches, of_group));
    light.without.push_back(with_dark(light.dark.back()));
    if (light.without.back().points == 0) return {};
    left -= whole - mean_light(light.without.back(), of.run.patches);
    all.insert(all.end(), of_group.begin(), of_group.end());
  }
  if (panes.size() > 1) {
    const auto dark = with_dark(with_dark_panes(of.run.patches, all));
    if (dark.points == 0) return {};
    light.twice = (mean_light(dark, of.run.patches) - left) / std::max(whole, 1e-30);
  }
  return light;
}

}  // namespace luxel
