// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/make_materials.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "luxel/import/apply_glass.h"
#include "luxel/import/name_list.h"
#include "luxel/import/raster_colours.h"
#include "luxel/import/texture_files.h"
#include "luxel/import/used_textures.h"

namespace luxel {
namespace {

constexpr float half_solid = 0.5f;

// OBJ counts v from the bottom of a picture, Luxel from its top.
TextureUse use_of(const MtlTexture& mtl, std::uint32_t texture) {
  TextureUse use{.texture = texture};
  use.placement = {mtl.scale.x, 0.0f, mtl.offset.x, 0.0f, -mtl.scale.y, 1.0f - mtl.offset.y};
  if (mtl.clamps) use.wrap = {Wrap::clamp, Wrap::clamp};
  return use;
}

class MaterialMaker {
 public:
  MaterialMaker(const MaterialLibrary& library, const LoadOptions& options, const std::string& source)
      : library_(library), options_(options), folder_(source, options.allow_outside) {}

  Material make(const NamedLine& use);
  const TextureFiles& files() const { return files_; }
  void say_warnings(const std::string& source, const Context& context) const;

 private:
  void cut_holes(const MaterialLibrary::Entry& entry, Material& material);
  void reflect(const MaterialLibrary::Entry& entry, Material& material);
  void emit(const MaterialLibrary::Entry& entry, Material& material);
  void let_through(const MtlMaterial& mtl, Material& material);
  void light_mirror(const MtlMaterial& mtl, Material& material);

  const MaterialLibrary& library_;
  const LoadOptions& options_;
  SceneFolder folder_;
  TextureFiles files_ = TextureFiles(folder_);

  // Names of materials, for the warnings.
  std::vector<std::string> unknown_, colorless_, too_bright_, transparent_, glasses_, panes_, mirrors_,
      emitting_twice_;
  std::size_t first_unknown_line_ = 0;
};

Material MaterialMaker::make(const NamedLine& use) {
  Material material;
  material.name = use.name;
  material.reflectance = Vec3(default_reflectance);
  material.textures.max_reflectance = options_.max_reflectance;
  const auto found = library_.entries.find(use.name);
  if (found != library_.entries.end()) {
    cut_holes(found->second, material);
    reflect(found->second, material);
    emit(found->second, material);
    let_through(found->second.material, material);
    if (material.opaque) light_mirror(found->second.material, material);
  } else if (use.line > 0) {
    if (unknown_.empty()) first_unknown_line_ = use.line;
    unknown_.push_back(use.name);
  }
  const auto capped = glm::min(material.reflectance, Vec3(options_.max_reflectance));
  if (capped != material.reflectance) {
    too_bright_.push_back(use.name);
    material.stated_reflectance = material.reflectance;
  }
  material.reflectance = capped;
  return material;
}

void MaterialMaker::let_through(const MtlMaterial& mtl, Material& material) {
  if (material.is_lamp()) return;
  const bool is_clear = mtl.opacity.value_or(1.0f) < half_solid;
  material.opaque = !is_clear && !is_glass(mtl);
  if (material.opaque) return;
  material.transmittance = stated_transmittance(mtl).value_or(Vec3(1.0f));
  const bool absorbs = material.transmittance != Vec3(1.0f);
  if (is_glass_of(options_.glass, mtl.name)) return;  // reported by apply_glass()
  (absorbs ? panes_ : is_clear ? transparent_ : glasses_).push_back(mtl.name);
}

// A surface with specular colour alone would be black here, though it reflects most of the light. Treated as
// diffuse, it preserves the room's energy, if not the reflections.
void MaterialMaker::light_mirror(const MtlMaterial& mtl, Material& material) {
  constexpr float dark = 0.2f, bright = 0.3f;
  const auto largest = [](const Vec3& v) { return std::max({v.r, v.g, v.b}); };
  const auto ks = mtl.ks.value_or(Vec3(0.0f));
  const bool is_black = material.reflectance == Vec3(0.0f) && ks != Vec3(0.0f);
  const bool is_metal = is_polished(mtl) && mtl.map_kd.name.empty() && largest(material.reflectance) < dark &&
                        largest(ks) >= bright;
  if (material.is_lamp() || !(is_black || is_metal)) return;
  material.reflectance = glm::min(material.reflectance + ks, Vec3(max_metal_reflectance));
  material.textures.reflectance = std::nullopt;
  mirrors_.push_back(mtl.name);
}

// A hole is where the opacity, d times the picture, is below one half.
void MaterialMaker::cut_holes(const MaterialLibrary::Entry& entry, Material& material) {
  const auto& mtl = entry.material;
  const auto opacity = mtl.opacity.value_or(1.0f);
  if (mtl.map_d.name.empty() || opacity < half_solid) return;
  const auto picture = files_.find(TextureFiles::Purpose::holes, entry.folder, mtl.map_d.name, mtl.name);
  if (!picture) return;
  material.textures.cutout = use_of(mtl.map_d, files_.mask_of(*picture));
  material.textures.cutout_threshold = half_solid / std::min(opacity, 1.0f);
}

void MaterialMaker::reflect(const MaterialLibrary::Entry& entry, Material& material) {
  const auto& mtl = entry.material;
  if (mtl.map_kd.name.empty()) {
    if (!mtl.kd) colorless_.push_back(mtl.name);
    material.reflectance = mtl.kd.value_or(Vec3(default_reflectance));
    return;
  }
  const auto factor = mtl.kd.value_or(Vec3(1.0f));
  const auto picture =
      files_.find(TextureFiles::Purpose::reflectance, entry.folder, mtl.map_kd.name, mtl.name);
  material.reflectance = factor * Vec3(default_reflectance);
  if (!picture) return;
  material.textures.reflectance = use_of(mtl.map_kd, *picture);
  material.textures.reflectance_factor = factor;
  material.reflectance = factor * mean_colour(files_.raster(*picture));
}

// Uses Ke alone where both are given: exporters write it beside map_Ke in two meanings, as a factor and as 0.
void MaterialMaker::emit(const MaterialLibrary::Entry& entry, Material& material) {
  const auto& mtl = entry.material;
  material.emittance = pi * mtl.ke.value_or(Vec3(0.0f));
  if (mtl.map_ke.name.empty()) return;
  if (mtl.ke) {
    emitting_twice_.push_back(mtl.name);
    return;
  }
  const auto picture = files_.find(TextureFiles::Purpose::emission, entry.folder, mtl.map_ke.name, mtl.name);
  if (!picture) return;
  material.textures.emittance = use_of(mtl.map_ke, *picture);
  material.textures.emittance_factor = Vec3(pi);
  material.emittance = pi * mean_colour(files_.raster(*picture));
}

void MaterialMaker::say_warnings(const std::string& source, const Context& context) const {
  const auto say = [&](const std::string& before, const std::vector<std::string>& names,
                       const std::string& behind) {
    if (!names.empty()) context.warn(fmt::format("{}: {} {}{}", source, before, name_list(names), behind));
  };
  if (!unknown_.empty())
    context.warn(fmt::format(
        "{}:{}: {} {}; a grey of {} is taken", source, first_unknown_line_,
        library_.files.empty() ? "no MTL file describes" : name_list(library_.files) + " does not describe",
        name_list(unknown_), default_reflectance));
  say("neither Kd nor map_Kd is given for", colorless_,
      fmt::format("; a grey of {} is taken", default_reflectance));
  say("the reflectance of", too_bright_,
      fmt::format(" was lowered to {}, as no surface reflects all light", options_.max_reflectance));
  if (!transparent_.empty())
    context.warn(
        fmt::format("{}: light passes freely through what is more transparent than not (d below 0.5), "
                    "which is left out: {}",
                    source, name_list(transparent_)),
        {{Setting::glass, "NAME=0.8"}});
  if (!mirrors_.empty() || !glasses_.empty())
    context.note(fmt::format(
        "{}: stand-ins, since mirrors and glass are not modelled:{}{}", source,
        mirrors_.empty() ? ""
                         : fmt::format(" the specular colour Ks, at most {}, is taken as diffuse for {}",
                                       max_metal_reflectance, name_list(mirrors_)),
        glasses_.empty() ? ""
                         : fmt::format("{} light passes freely through {}, which is left out",
                                       mirrors_.empty() ? "" : ";", name_list(glasses_))));
  if (!panes_.empty())
    context.note(fmt::format("{}: panes of glass, with the transmittance Tf of the file: {}", source,
                             name_list(panes_)));
  say("map_Ke is passed over where Ke is given, as for", emitting_twice_, "");
  files_.say_warnings(source, context);
}

}  // namespace

void make_materials(std::span<const NamedLine> used, const MaterialLibrary& library,
                    const LoadOptions& options, Scene& scene, const Context& context) {
  MaterialMaker maker(library, options, scene.source);
  for (const auto& use : used) scene.materials.push_back(maker.make(use));
  maker.say_warnings(scene.source, context);
  scene.textures = maker.files().textures();
  scene.files.assign(library.files.begin(), library.files.end());
  maker.files().list_files(scene.files);
  scene.allows_outside = options.allow_outside;
  keep_used_textures(scene);
}

}  // namespace luxel
