// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/load_scene.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/ending_of.h"
#include "luxel/core/error.h"
#include "luxel/import/apply_glass.h"
#include "luxel/import/apply_spectra.h"
#include "luxel/import/is_gltf.h"
#include "luxel/import/load_converted.h"
#include "luxel/import/load_gltf.h"
#include "luxel/import/load_obj.h"
#include "luxel/import/load_ply.h"
#include "luxel/import/load_stl.h"
#include "luxel/import/luminaires.h"
#include "luxel/import/name_list.h"
#include "luxel/import/set_daylight.h"
#include "luxel/scene/name_pattern.h"
#include "luxel/scene/orient_windings.h"
#include "luxel/scene/scale_doubt.h"
#include "luxel/scene/up_axis.h"
#include "luxel/scene/weld_vertices.h"

namespace luxel {
namespace {

bool is_obj(const std::filesystem::path& path) { return ending_of(path) == ".obj"; }
bool is_ply(const std::filesystem::path& path) { return ending_of(path) == ".ply"; }
bool is_stl(const std::filesystem::path& path) { return ending_of(path) == ".stl"; }

constexpr const char* endings = ".obj, .glb, .gltf, .ply, .stl, .fbx, .dae or .3ds";

struct Reader {
  bool (*reads)(const std::filesystem::path&);
  Scene (*load)(const std::filesystem::path&, const LoadOptions&, const Context&);
};
constexpr auto readers = std::to_array<Reader>({{is_obj, load_obj},
                                                {is_gltf, load_gltf},
                                                {is_ply, load_ply},
                                                {is_stl, load_stl},
                                                {is_converted, load_converted}});

void check_options(const LoadOptions& options) {
  if (!(options.scale > 0.0 && std::isfinite(options.scale)))
    throw InputError(fmt::format("expected a scale above 0 metres a unit, found {}", options.scale));
  if (!(options.max_reflectance >= 0.0f && options.max_reflectance < 1.0f))
    throw InputError(fmt::format("expected max_reflectance in [0, 1), found {}", options.max_reflectance));
  if (!(options.weld >= 0.0f && std::isfinite(options.weld)))
    throw InputError(fmt::format("expected a weld distance of 0 or more metres, found {}", options.weld));
  if (options.bands != 0 && (options.bands < min_bands || options.bands > max_bands))
    throw InputError(fmt::format("expected {} to {} bands, or 0 for those of the file, found {}", min_bands,
                                 max_bands, options.bands));
  for (const auto& glass : options.glass)
    if (const auto& t = glass.transmittance; t != glm::clamp(t, 0.0f, 1.0f) || t == Vec3(0.0f))
      throw InputError(
          fmt::format("expected a transmittance in [0, 1] and above 0 in a band, found {}, "
                      "{}, {}",
                      t.r, t.g, t.b));
  for (int band = 0; band < 3; ++band)
    if (!(options.sky[band] >= 0.0f && std::isfinite(options.sky[band])))
      throw InputError(
          fmt::format("expected a sky of 0 or more W/(m² sr) in each band, found {}", options.sky[band]));
}

void check_is_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw InputError(path.string(), "no such file");
  if (std::filesystem::is_directory(status))
    throw InputError(path.string(),
                     fmt::format("it is a folder; name the scene's file inside it ({})", endings));
}

const Reader& reader_of(const std::filesystem::path& path) {
  for (const auto& reader : readers)
    if (reader.reads(path)) return reader;
  const auto ending = ending_of(path);
  throw InputError(path.string(),
                   fmt::format("expected a file that ends in {}, found {}; convert the scene to one of these",
                               endings, ending.empty() ? "no ending" : "'" + ending + "'"));
}

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
    if (selected[i]) scene.materials[i].two_sided = false;
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

Scene load_scene(const std::filesystem::path& path, const LoadOptions& options, const Context& context) {
  check_options(options);
  check_is_file(path);
  auto scene = reader_of(path).load(path, options, context);
  if (scene.triangles.empty()) return scene;  // stopped
  doubt_units(options, scene, context);
  repair(options, scene, context);
  apply_one_sided(options.one_sided, scene);
  apply_glass(options, scene, context);
  apply_flip(options.flip, scene);
  scene.sky = options.sky;
  if (options.daylight) set_daylight(*options.daylight, options.up, scene);
  load_luminaires(path, options, scene, context);
  if (!options.spectra.empty()) apply_spectra(options, scene, context);
  return scene;
}

}  // namespace luxel
