// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/finish_scene.h"

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/import/apply_glass.h"
#include "luxel/import/apply_spectra.h"
#include "luxel/import/is_gltf.h"
#include "luxel/import/luminaires.h"
#include "luxel/import/name_list.h"
#include "luxel/import/set_daylight.h"
#include "luxel/scene/name_pattern.h"
#include "luxel/scene/orient_windings.h"
#include "luxel/scene/retriangulate.h"
#include "luxel/scene/scale_doubt.h"
#include "luxel/scene/up_axis.h"
#include "luxel/scene/weld_vertices.h"

namespace luxel {
namespace {

// For each material, whether any pattern matches it. A pattern without a match is most likely a typing error,
// so it is refused.
std::vector<bool> select(const std::vector<std::string>& patterns, const Scene& scene, const char* option) {
  std::vector<bool> selected(scene.materials.size(), false);
  for (const auto& pattern : patterns) {
    bool any = false;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
      if (!matches(pattern, scene.materials[i].name)) continue;
      selected[i] = any = true;
    }
    if (any) continue;
    std::vector<std::string> names;
    for (const auto& material : scene.materials) names.push_back(material.name);
    throw InputError(scene.source, fmt::format("{}: no material matches '{}'; there are {}", option, pattern,
                                               name_list(names)));
  }
  return selected;
}

void apply_one_sided(const std::vector<std::string>& patterns, Scene& scene) {
  const auto selected = select(patterns, scene, "one_sided");
  for (std::size_t i = 0; i < selected.size(); ++i)
    if (selected[i] && !scene.materials[i].is_diffuser()) scene.materials[i].two_sided = false;
}

void apply_flip(const std::vector<std::string>& patterns, Scene& scene) {
  const auto selected = select(patterns, scene, "flip");
  for (std::size_t i = 0; i < scene.triangles.size(); ++i)
    if (selected[static_cast<std::size_t>(scene.triangle_material[i])]) turn_triangle(scene, i);
}

void repair(const LoadOptions& options, Scene& scene, const Context& context) {
  if (options.weld != 0.0f) context.note(weld_vertices(scene, options.weld).as_text(options.weld));
  if (options.orient) context.note(orient_windings(scene).as_text());
}

void doubt_units(const LoadOptions& options, const Scene& scene, const Context& context) {
  if (const auto doubt = doubt_scale(scene)) {
    const auto scale = fmt::format("{:g}", options.scale * doubt->metres);
    const auto condition =
        options.scale == 1.0 ? fmt::format("if the file counts in {}, ", doubt->unit) : std::string();
    context.warn(
        fmt::format("{}: the scene is {:.3g} m long, too {} for a room; {}a scale of {} makes it {:.3g} "
                    "m long",
                    scene.source, doubt->extent, doubt->is_large ? "large" : "small", condition, scale,
                    doubt->extent * doubt->metres),
        {{Setting::scale, scale}});
  } else if (const auto sentence = doubt_lumens(scene); !sentence.empty()) {
    context.warn(fmt::format("{}: {}", scene.source, sentence));
  }
}

void retriangulate(const std::filesystem::path& path, Scene& scene, const Context& context) {
  const auto made = retriangulate_needles(scene, is_gltf(path) ? JoinedAt::vertices : JoinedAt::places);
  if (made.surfaces > 0)
    context.note(fmt::format("{} flat surfaces of needles are triangulated again: {} triangles instead of {}",
                             made.surfaces, made.after, made.before));
}

void load_luminaires(const std::filesystem::path& path, const LoadOptions& options, Scene& scene,
                     const Context& context) {
  PhotometryStore store(context);
  const auto up = up_of_scene(scene, options.up);
  replace_by_luminaires(path, up, store, scene);
  for (const auto& list : options.luminaires)
    for (const auto& placement : read_luminaires(list, up, store)) add_luminaires(placement, up, scene);
  for (const auto& grid : options.luminaire_grids)
    add_luminaires(place_over(grid, scene, up, store), up, scene);
}

}  // namespace

void finish_scene(const std::filesystem::path& path, const LoadOptions& options, Scene& scene,
                  const Context& context) {
  doubt_units(options, scene, context);
  repair(options, scene, context);
  apply_one_sided(options.one_sided, scene);
  apply_glass(options, scene, context);
  apply_flip(options.flip, scene);
  scene.sky = options.sky;
  if (options.daylight) set_daylight(*options.daylight, options.up, scene);
  load_luminaires(path, options, scene, context);
  if (options.retriangulate) retriangulate(path, scene, context);
  if (!options.spectra.empty()) apply_spectra(options, scene, context);
}

}  // namespace luxel
