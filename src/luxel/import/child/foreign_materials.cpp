// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/child/foreign_materials.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "luxel/import/name_list.h"
#include "luxel/scene/luminous_efficacy.h"

namespace luxel {
namespace {

constexpr float largest_colour = 1e6f;

// Replaces negative values and NaN by 0, and limits large ones.
float plain(float value) { return value > 0.0f ? std::min(value, largest_colour) : 0.0f; }

aiColor3D plain(const aiColor3D& c) { return {plain(c.r), plain(c.g), plain(c.b)}; }

std::string name_of(const aiMaterial& material) {
  aiString name;
  material.Get(AI_MATKEY_NAME, name);
  return name.C_Str();
}

// A texture takes the place of the colour in these formats.
aiColor3D base_colour(const aiMaterial& material, bool is_textured) {
  aiColor3D colour(1.0f, 1.0f, 1.0f);
  if (is_textured) return colour;
  if (material.Get(AI_MATKEY_BASE_COLOR, colour) == AI_SUCCESS) return plain(colour);
  material.Get(AI_MATKEY_COLOR_DIFFUSE, colour);
  return plain(colour);
}

// W/(m² sr). 3DS gives the fraction of its own colour that a surface shows without light.
aiColor3D radiance_of(const aiMaterial& material, const ForeignFile& file, bool is_textured) {
  aiColor3D colour;
  material.Get(AI_MATKEY_COLOR_EMISSIVE, colour);
  colour = plain(colour);
  if (file.format == ForeignFormat::max_3ds && colour.r == colour.g && colour.g == colour.b)
    colour = colour * base_colour(material, false);
  if (!is_textured) return colour;
  const auto most = std::max({colour.r, colour.g, colour.b});
  const auto strength = most > 0.0f ? most : 1.0f;
  return {strength, strength, strength};
}

Json numbers(const aiColor3D& colour) { return {colour.r, colour.g, colour.b}; }

int gltf_wrap(aiTextureMapMode mode) {
  if (mode == aiTextureMapMode_Clamp || mode == aiTextureMapMode_Decal) return 33071;
  return mode == aiTextureMapMode_Mirror ? 33648 : 10497;
}

}  // namespace

std::optional<std::size_t> ForeignMaterials::of(unsigned number) {
  if (number >= file_.scene->mNumMaterials) return std::nullopt;
  const auto [place, is_new] = made_.try_emplace(number);
  if (is_new) place->second = add(*file_.scene->mMaterials[number], number);
  return place->second;
}

unsigned ForeignMaterials::coordinates(unsigned number) const {
  const auto found = coordinates_.find(number);
  return found == coordinates_.end() ? 0 : found->second;
}

// Returns a textureInfo of glTF; null where the material has no such texture.
Json ForeignMaterials::texture(const aiMaterial& material, std::initializer_list<aiTextureType> types,
                               unsigned number) {
  for (const auto type : types) {
    aiString name;
    unsigned set = 0;
    std::array<aiTextureMapMode, 3> wrap = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap,
                                            aiTextureMapMode_Wrap};
    if (material.GetTexture(type, 0, &name, nullptr, &set, nullptr, nullptr, wrap.data()) != AI_SUCCESS)
      continue;
    if (name.length == 0 || set >= AI_MAX_NUMBER_OF_TEXTURECOORDS) continue;
    const auto image = pictures_.image(name);
    if (!image) continue;
    const auto sampler =
        glb_.append("/samplers", {{"wrapS", gltf_wrap(wrap[0])}, {"wrapT", gltf_wrap(wrap[1])}});
    const auto index = glb_.append("/textures", {{"source", *image}, {"sampler", sampler}});
    auto& sets = coordinates_[number];
    sets = std::max(sets, set + 1);
    return {{"index", index}, {"texCoord", set}};
  }
  return nullptr;
}

std::optional<std::size_t> ForeignMaterials::add(const aiMaterial& material, unsigned number) {
  const auto name = name_of(material);
  if (name == AI_DEFAULT_MATERIAL_NAME) return std::nullopt;
  Json made = {{"name", name}, {"doubleSided", true}};
  const auto base = texture(material, {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}, number);
  const auto colour = base_colour(material, !base.is_null());
  float metallic = 0.0f;
  material.Get(AI_MATKEY_METALLIC_FACTOR, metallic);
  auto& pbr = made["pbrMetallicRoughness"];
  pbr = {{"baseColorFactor", {colour.r, colour.g, colour.b, 1.0f}},
         {"metallicFactor", std::min(plain(metallic), 1.0f)}};
  if (!base.is_null()) pbr["baseColorTexture"] = base;

  const auto emission = texture(material, {aiTextureType_EMISSION_COLOR, aiTextureType_EMISSIVE}, number);
  if (!emission.is_null()) made["emissiveTexture"] = emission;
  const auto radiance = radiance_of(material, file_, !emission.is_null());
  if (const auto most = std::max({radiance.r, radiance.g, radiance.b}); most > 0.0f) {
    made["emissiveFactor"] = numbers(radiance * (1.0f / most));
    made["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = most * luminous_efficacy;
    glb_.use_extension("KHR_materials_emissive_strength");
  }
  add_alpha(material, name, made);
  return glb_.append("/materials", made);
}

// An opacity of exactly 0 in COLLADA comes from programs that write the transparency in its place.
void ForeignMaterials::add_alpha(const aiMaterial& material, const std::string& name, Json& made) {
  float opacity = 1.0f;
  material.Get(AI_MATKEY_OPACITY, opacity);
  if (!(opacity >= 0.0f && opacity <= 1.0f)) opacity = 1.0f;
  if (opacity == 0.0f && file_.format == ForeignFormat::collada) {
    invisible_.push_back(name);
    opacity = 1.0f;
  }
  if (opacity < 1.0f) {
    made["alphaMode"] = "BLEND";
    made["pbrMetallicRoughness"]["baseColorFactor"][3] = opacity;
  }
  aiString mask, base;
  if (material.GetTexture(aiTextureType_OPACITY, 0, &mask) != AI_SUCCESS) return;
  material.GetTexture(aiTextureType_DIFFUSE, 0, &base);
  if (mask == base)
    made["alphaMode"] = "MASK";
  else
    with_opacity_picture_.push_back(name);
}

void ForeignMaterials::finish() {
  if (!invisible_.empty())
    file_.messages.push_back(
        fmt::format("warning an opacity of 0 is read as a transparency of 0, and the surfaces are opaque: {}",
                    name_list(invisible_)));
  if (!with_opacity_picture_.empty())
    file_.messages.push_back(fmt::format(
        "warning a picture of the opacity is passed over, as it is not the picture of the colour, for {}",
        name_list(with_opacity_picture_)));
}

}  // namespace luxel
