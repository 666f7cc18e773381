// SPDX-License-Identifier: Apache-2.0
#include "luxel/load/make_materials.h"

#include <fmt/format.h>

#include "luxel/load/name_list.h"
#include "luxel/load/texture_means.h"

namespace luxel {
namespace {

class MaterialMaker {
 public:
  MaterialMaker(const MaterialLibrary& library, const LoadOptions& options)
      : library_(library), options_(options) {}

  Material make(const NamedLine& use);
  void say_warnings(const std::string& source, const LogSink& log) const;

 private:
  Vec3 reflectance(const MaterialLibrary::Entry& entry);
  Vec3 radiance(const MaterialLibrary::Entry& entry);
  void light_mirror(const MtlMaterial& mtl, Material& material);

  const MaterialLibrary& library_;
  const LoadOptions& options_;
  TextureMeans reflecting_, emitting_;

  // Names of materials, for the warnings.
  std::vector<std::string> unknown_, colorless_, too_bright_, transparent_, mirrors_, emitting_twice_;
  std::size_t first_unknown_line_ = 0;
};

Material MaterialMaker::make(const NamedLine& use) {
  Material material;
  material.name = use.name;
  material.reflectance = Vec3(default_reflectance);
  const auto found = library_.entries.find(use.name);
  if (found != library_.entries.end()) {
    material.reflectance = reflectance(found->second);
    material.emittance = pi * radiance(found->second);
    material.opaque = material.is_lamp() || found->second.material.opacity.value_or(1.0f) >= 0.5f;
    if (!material.opaque) transparent_.push_back(use.name);
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

// A surface of specular colour alone would be black here, though it sends on most of the light that meets it.
// Taken as diffuse it keeps the room's energy right, if not the reflections.
void MaterialMaker::light_mirror(const MtlMaterial& mtl, Material& material) {
  const bool is_black = material.reflectance == Vec3(0.0f) && !material.is_lamp();
  if (!is_black || mtl.ks.value_or(Vec3(0.0f)) == Vec3(0.0f)) return;
  material.reflectance = *mtl.ks;
  mirrors_.push_back(mtl.name);
}

Vec3 MaterialMaker::reflectance(const MaterialLibrary::Entry& entry) {
  const auto& mtl = entry.material;
  if (mtl.map_kd.empty()) {
    if (!mtl.kd) colorless_.push_back(mtl.name);
    return mtl.kd.value_or(Vec3(default_reflectance));
  }
  const auto mean = reflecting_.mean(entry.folder, mtl.map_kd, mtl.name);
  return mtl.kd.value_or(Vec3(1.0f)) * mean.value_or(Vec3(default_reflectance));
}

// Ke alone where both are given: exporters write it beside map_Ke in two meanings, as a factor and as 0.
Vec3 MaterialMaker::radiance(const MaterialLibrary::Entry& entry) {
  const auto& mtl = entry.material;
  if (mtl.map_ke.empty()) return mtl.ke.value_or(Vec3(0.0f));
  if (mtl.ke) {
    emitting_twice_.push_back(mtl.name);
    return *mtl.ke;
  }
  return emitting_.mean(entry.folder, mtl.map_ke, mtl.name).value_or(Vec3(0.0f));
}

void MaterialMaker::say_warnings(const std::string& source, const LogSink& log) const {
  const auto say = [&](const std::string& before, const std::vector<std::string>& names,
                       const std::string& behind) {
    if (!names.empty()) warn(log, fmt::format("{}: {} {}{}", source, before, name_list(names), behind));
  };
  if (!unknown_.empty())
    warn(log, fmt::format("{}:{}: {} {}; a grey of {} is taken", source, first_unknown_line_,
                          library_.files.empty() ? "no MTL file describes"
                                                 : name_list(library_.files) + " does not describe",
                          name_list(unknown_), default_reflectance));
  say("neither Kd nor map_Kd is given for", colorless_,
      fmt::format("; a grey of {} is taken", default_reflectance));
  say("the reflectance of", too_bright_,
      fmt::format(" was lowered to {}, as no surface reflects all light", options_.max_reflectance));
  say("light passes freely through what is more transparent than not (d below 0.5), which is left out:",
      transparent_, "");
  say("mirrors are not modelled: the specular colour Ks is taken as diffuse for", mirrors_, "");
  say("map_Ke is passed over where Ke is given, as for", emitting_twice_, "");
  reflecting_.say_warnings(source, fmt::format("{} is taken for the mean", default_reflectance), log);
  emitting_.say_warnings(source, "0 is taken for the mean, so that nothing is emitted", log);
}

}  // namespace

std::vector<Material> make_materials(std::span<const NamedLine> used, const MaterialLibrary& library,
                                     const std::string& source, const LoadOptions& options,
                                     const LogSink& log) {
  MaterialMaker maker(library, options);
  std::vector<Material> materials;
  for (const auto& use : used) materials.push_back(maker.make(use));
  maker.say_warnings(source, log);
  return materials;
}

}  // namespace luxel
