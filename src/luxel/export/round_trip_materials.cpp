// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/round_trip_materials.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "luxel/scene/material.h"

namespace luxel {
namespace {

constexpr auto no_material = std::numeric_limits<std::size_t>::max();
constexpr auto no_texture = std::numeric_limits<std::size_t>::max();
constexpr const char* older = "/extensions/KHR_materials_pbrSpecularGlossiness";
constexpr const char* base = "/pbrMetallicRoughness";

Json texture_info(std::size_t texture, std::size_t coordinates) {
  return {{"index", texture}, {"texCoord", coordinates}};
}

}  // namespace

bool RoundTripMaterials::is_textured(const JsonValue& material) {
  return material["pbrMetallicRoughness"]["baseColorTexture"] ||
         material["extensions"]["KHR_materials_pbrSpecularGlossiness"]["diffuseTexture"];
}

// Returns the path of the primitive's material if it has not been changed yet.
std::optional<std::string> RoundTripMaterials::changed_for(const std::string& path, const JsonValue& index,
                                                           std::size_t texture, std::size_t coordinates) {
  const auto of_file = index ? index.whole() : no_material;
  const auto [found, is_new] = made_.try_emplace({of_file, texture, coordinates}, 0);
  if (is_new) {
    if (!index) {
      // the reflectance that the light was solved with; glTF's default would be a mirror
      const auto grey = Material().reflectance;
      found->second = copy_.append(
          "/materials", {{"name", "none"},
                         {"pbrMetallicRoughness",
                          {{"baseColorFactor", {grey.r, grey.g, grey.b, 1}}, {"metallicFactor", 0}}}});
      take_gloss_off(fmt::format("/materials/{}", found->second));
    } else {
      taken_.resize(std::max(taken_.size(), of_file + 1));
      found->second =
          taken_[of_file] ? copy_.append_copy("/materials", fmt::format("/materials/{}", of_file)) : of_file;
      taken_[of_file] = true;
    }
  }
  copy_.put(path + "/material", found->second);
  if (!is_new) return std::nullopt;
  return fmt::format("/materials/{}", found->second);
}

// Converts the base colour of the older extension to today's properties.
void RoundTripMaterials::plain_base(const std::string& material) {
  if (!copy_.has(material + older)) return;
  for (const auto& [from, to] :
       {std::pair("/diffuseTexture", "/baseColorTexture"), std::pair("/diffuseFactor", "/baseColorFactor")})
    if (copy_.has(material + older + from)) copy_.put_copy(material + base + to, material + older + from);
  copy_.put(material + base + "/metallicFactor", 0);
  copy_.erase(material + older);
}

// Removes the gloss of a dielectric; the reflection of a metal consists of gloss.
void RoundTripMaterials::take_gloss_off(const std::string& material) {
  copy_.put(material + "/extensions/KHR_materials_specular", {{"specularFactor", 0}});
  copy_.use_extension("KHR_materials_specular");
}

// Removes extensions that describe how a surface reflects light.
void RoundTripMaterials::take_extensions_off(const std::string& material) {
  for (const auto& extension : copy_.keys(material + "/extensions"))
    if (extension.starts_with("KHR_materials_") || extension == "MOZ_lightmap")
      copy_.erase(material + "/extensions/" + extension);
}

void RoundTripMaterials::colour_base(const std::string& material, int grey, double roughness) {
  plain_base(material);
  const auto factor = material + base + "/baseColorFactor";
  const auto alpha = copy_.number_at(factor + "/3", 1.0);
  copy_.put(factor, {grey, grey, grey, alpha});
  copy_.put(material + base + "/metallicFactor", 0);
  copy_.put(material + base + "/roughnessFactor", roughness);
}

std::optional<std::string> RoundTripMaterials::shadeless(const std::string& path, const JsonValue& index) {
  const auto material = changed_for(path, index, no_texture, 0);
  if (!material) return std::nullopt;
  colour_base(*material, 1, 0.9);  // rough for programs that do not support the extension
  take_extensions_off(*material);  // the others have no meaning beside this one
  copy_.put(*material + "/extensions/KHR_materials_unlit", Json::object());
  copy_.use_extension("KHR_materials_unlit");
  if (const auto suffix = profile_of(program_).material_suffix; !suffix.empty())
    copy_.put(*material + "/name", fmt::format("{}{}", copy_.text_at(*material + "/name", ""), suffix));
  return material;
}

void RoundTripMaterials::one_sided(const std::string& path) {
  copy_.put(fmt::format("/materials/{}/doubleSided", copy_.index_at(path + "/material")), false);
}

void RoundTripMaterials::lightmapped(const std::string& path, const JsonValue& index, std::size_t texture,
                                     std::size_t coordinates, float intensity, const Vec3& emission) {
  const auto material = changed_for(path, index, texture, coordinates);
  if (!material) return;
  plain_base(*material);
  copy_.put(*material + "/extensions/MOZ_lightmap",
            {{"index", texture}, {"texCoord", coordinates}, {"intensity", intensity}});
  copy_.use_extension("MOZ_lightmap");
  if (profile_of(program_).gloss_dims_lightmaps) take_gloss_off(*material);
  const auto most = std::max({emission.r, emission.g, emission.b});
  if (!(most > 0.0f)) return;
  // Factors are at most 1; the strength takes the rest. With a texture the factor, which has the colour,
  // stays.
  const bool textured = copy_.has(*material + "/emissiveTexture");
  const auto colour = textured ? Vec3(1.0f) : emission / most;
  copy_.put(*material + "/emissiveFactor", {colour.r, colour.g, colour.b});
  copy_.put(*material + "/extensions/KHR_materials_emissive_strength", {{"emissiveStrength", most}});
  copy_.use_extension("KHR_materials_emissive_strength");
}

void RoundTripMaterials::shining(const std::string& path, const JsonValue& index, std::size_t texture,
                                 std::size_t coordinates) {
  const auto material = changed_for(path, index, texture, coordinates);
  if (!material) return;
  colour_base(*material, 0, 1.0);
  // They are invisible on black. The base colour's picture may still define holes.
  if (copy_.text_at(*material + "/alphaMode", "OPAQUE") == "OPAQUE")
    copy_.erase(*material + base + "/baseColorTexture");
  for (const auto* picture : {"/normalTexture", "/occlusionTexture"}) copy_.erase(*material + picture);
  copy_.erase(*material + base + "/metallicRoughnessTexture");
  take_extensions_off(*material);
  take_gloss_off(*material);
  copy_.put(*material + "/emissiveFactor", {1, 1, 1});
  copy_.put(*material + "/emissiveTexture", texture_info(texture, coordinates));
}

}  // namespace luxel
