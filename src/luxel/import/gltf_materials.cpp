// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/gltf_materials.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "luxel/import/apply_glass.h"
#include "luxel/import/make_materials.h"
#include "luxel/import/name_list.h"
#include "luxel/import/raster_colours.h"
#include "luxel/import/used_textures.h"
#include "luxel/scene/luminous_efficacy.h"

namespace luxel {
namespace {

// Alpha is the fraction of the light that a surface blocks; from one half on it counts as solid.
constexpr double half_solid = 0.5;
constexpr float half_metal = 0.5f;

// The places where a material may name a picture that matters to diffuse light.
std::array<JsonValue, 3> pictures_of(const JsonValue& json) {
  const auto metallic = json["pbrMetallicRoughness"];
  const auto specular = json["extensions"]["KHR_materials_pbrSpecularGlossiness"];
  const bool is_specular = specular && !metallic;
  return {is_specular ? specular["diffuseTexture"] : metallic["baseColorTexture"],
          metallic["metallicRoughnessTexture"], json["emissiveTexture"]};
}

// Returns the n of the picture's TEXCOORD_n.
std::size_t coordinates_of(const JsonValue& info) {
  return info["extensions"]["KHR_texture_transform"]["texCoord"].whole(info["texCoord"].whole(0));
}

bool has_coordinates(const JsonValue& attributes, std::size_t number) {
  return static_cast<bool>(attributes[fmt::format("TEXCOORD_{}", number)]);
}

Vec3 colour_of(const JsonValue& factor, const std::vector<double>& numbers) {
  constexpr double most = 1e30;
  Vec3 colour;
  for (int band = 0; band < 3; ++band) {
    const auto number = numbers[static_cast<std::size_t>(band)];
    if (!(number >= 0.0 && number <= most))
      factor.refuse(fmt::format("expected colours of 0 to {:g}, found {}", most, number));
    colour[band] = static_cast<float>(number);
  }
  return colour;
}

// In W/(m² sr) per band, from cd/m².
Vec3 radiance_of(const JsonValue& json) {
  constexpr double most = 1e30;
  const auto factor = json["emissiveFactor"];
  const auto strength = json["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"];
  const auto times = strength.number(1.0);
  if (!(times >= 0.0 && times <= most))
    strength.refuse(fmt::format("expected a strength of 0 to {:g}, found {}", most, times));
  auto nits = factor.numbers({0.0, 0.0, 0.0});
  for (auto& nit : nits) nit *= times;
  return colour_of(factor, nits) / static_cast<float>(luminous_efficacy);
}

}  // namespace

struct GltfMaterials::Surface {
  std::string name;
  Vec3 base = Vec3(1.0f);
  double alpha = 1.0;
  float metal = 0.0f;      // [0, 1]
  bool is_mirror = false;  // of specular and glossiness: dark but for its reflections, which base has
  double cutoff = 0.0;     // alpha below it is a hole
  bool is_blended = false;
  double passes = 0.0;  // fraction of the light that is transmitted
  // Fraction of the diffuse light that leaves the other side, and the colour of that light.
  float scatters = 0.0f;
  Vec3 scattered = Vec3(1.0f);
  bool is_unlit = false, two_sided = false;
  Vec3 emittance = Vec3(0.0f);  // W/m²
  TextureInput base_picture, metal_picture, emission_picture;
};

GltfMaterials::GltfMaterials(GltfFile& file, const LoadOptions& options)
    : file_(file), options_(options), textures_(file) {}

MaterialId GltfMaterials::of(const JsonValue& primitive) {
  const auto index = primitive["material"];
  if (!index) {
    if (!default_) {
      Material material;
      material.name = "default";
      material.reflectance = Vec3(std::min(default_reflectance, options_.max_reflectance));
      default_ = add(std::move(material));
    }
    return *default_;
  }
  const auto json = file_.object(index, "materials");
  const auto attributes = primitive["attributes"];
  std::vector<bool> lacks;
  for (const auto& info : pictures_of(json))
    lacks.push_back(info && !has_coordinates(attributes, coordinates_of(info)));
  const auto key = std::pair(index.whole(), std::move(lacks));
  if (const auto found = made_.find(key); found != made_.end()) return found->second;
  auto surface = read(json, attributes);
  if (surface.name.empty()) surface.name = fmt::format("material {}", key.first);
  if (std::find(key.second.begin(), key.second.end(), true) != key.second.end())
    without_coordinates_.push_back(surface.name);
  return made_[key] = add(make(surface));
}

MaterialId GltfMaterials::add(Material material) {
  materials_.push_back(std::move(material));
  return MaterialId{static_cast<std::uint32_t>(materials_.size() - 1)};
}

GltfMaterials::Surface GltfMaterials::read(const JsonValue& json, const JsonValue& attributes) {
  Surface surface;
  surface.name = json["name"].text("");
  const auto metallic = json["pbrMetallicRoughness"];
  const auto specular = json["extensions"]["KHR_materials_pbrSpecularGlossiness"];
  const bool is_specular = specular && !metallic;
  const auto factor = is_specular ? specular["diffuseFactor"] : metallic["baseColorFactor"];
  const auto base = factor.numbers({1.0, 1.0, 1.0, 1.0});
  surface.base = colour_of(factor, base);
  surface.alpha = base[3];
  surface.is_unlit = static_cast<bool>(json["extensions"]["KHR_materials_unlit"]);
  if (!is_specular && !surface.is_unlit)  // unlit: the base colour and nothing else
    surface.metal = static_cast<float>(std::clamp(metallic["metallicFactor"].number(1.0), 0.0, 1.0));
  if (is_specular && !surface.is_unlit) light_mirror(specular, surface);
  surface.emittance = pi * radiance_of(json);
  const auto [base_info, metal_info, emission_info] = pictures_of(json);
  surface.base_picture = texture_input(base_info, attributes);
  surface.metal_picture = texture_input(metal_info, attributes);
  surface.emission_picture = texture_input(emission_info, attributes);

  const auto mode = json["alphaMode"].text("OPAQUE");
  if (mode != "OPAQUE" && mode != "MASK" && mode != "BLEND")
    json["alphaMode"].refuse(fmt::format("expected OPAQUE, MASK or BLEND, found '{}'", mode.substr(0, 40)));
  surface.is_blended = mode == "BLEND";
  if (mode == "MASK") surface.cutoff = json["alphaCutoff"].number(0.5);
  if (mode == "BLEND") surface.cutoff = half_solid;
  surface.passes = json["extensions"]["KHR_materials_transmission"]["transmissionFactor"].number(0.0);
  surface.two_sided = json["doubleSided"].truth(false);
  read_diffuse_transmission(json["extensions"]["KHR_materials_diffuse_transmission"], surface);
  return surface;
}

// The means of its textures are taken.
void GltfMaterials::read_diffuse_transmission(const JsonValue& json, Surface& surface) {
  if (!json || surface.is_unlit) return;
  const auto factor = json["diffuseTransmissionFactor"].number(0.0);
  if (!(factor >= 0.0 && factor <= 1.0))
    json["diffuseTransmissionFactor"].refuse(fmt::format("expected a factor of 0 to 1, found {}", factor));
  const auto colour = json["diffuseTransmissionColorFactor"];
  surface.scatters = static_cast<float>(factor);
  surface.scattered = glm::min(colour_of(colour, colour.numbers({1.0, 1.0, 1.0})), Vec3(1.0f));
  const auto raster_of = [&](const char* name) -> const Raster* {
    const auto info = json[name];
    const auto texture = info ? textures_.picture(info).texture : std::nullopt;
    return texture ? &textures_.raster(*texture) : nullptr;
  };
  if (const auto* raster = raster_of("diffuseTransmissionTexture")) surface.scatters *= mean_alpha(*raster);
  if (const auto* raster = raster_of("diffuseTransmissionColorTexture"))
    surface.scattered *= mean_colour(*raster);
}

// A mirror or metal of KHR_materials_pbrSpecularGlossiness has a dark diffuse colour and a bright specular
// one.
void GltfMaterials::light_mirror(const JsonValue& specular, Surface& surface) {
  constexpr float dark = 0.2f, bright = 0.3f;
  const auto largest = [](const Vec3& v) { return std::max({v.r, v.g, v.b}); };
  if (specular["diffuseTexture"] || specular["specularGlossinessTexture"]) return;
  const auto factor = specular["specularFactor"];
  const auto colour = colour_of(factor, factor.numbers({1.0, 1.0, 1.0}));
  if (!(largest(surface.base) < dark && largest(colour) >= bright)) return;
  surface.base += colour;
  surface.is_mirror = true;
}

GltfMaterials::TextureInput GltfMaterials::texture_input(const JsonValue& info, const JsonValue& attributes) {
  if (!info) return {};
  auto picture = textures_.picture(info);
  TextureInput texture_input{.is_given = true, .texture = picture.texture};
  if (!picture.texture || !has_coordinates(attributes, coordinates_of(info))) return texture_input;
  picture.use.uv_set = set_of(coordinates_of(info));
  texture_input.use = picture.use;
  return texture_input;
}

std::uint32_t GltfMaterials::set_of(std::size_t coordinates) {
  auto& known = texture_coordinates_;
  const auto found = std::find(known.begin(), known.end(), coordinates);
  const auto set = static_cast<std::uint32_t>(found - known.begin());
  if (found == known.end()) known.push_back(coordinates);
  return set;
}

Material GltfMaterials::make(const Surface& surface) {
  Material material;
  material.name = surface.name;
  material.two_sided = surface.two_sided;
  material.textures.max_reflectance = options_.max_reflectance;
  if (surface.is_unlit) unlit_.push_back(surface.name);
  emit(surface, material);
  let_through(surface, material);
  reflect(surface, material);
  cap(material);
  if (material.is_diffuser() && !is_glass_of(options_.glass, surface.name)) {
    diffusers_.push_back(surface.name);
    if (limit_albedo(material, options_.max_reflectance)) too_bright_diffusers_.push_back(surface.name);
  }
  return material;
}

void GltfMaterials::emit(const Surface& surface, Material& material) const {
  const auto& picture = surface.emission_picture;
  material.emittance = surface.emittance;
  if (!picture.is_given || surface.emittance == Vec3(0.0f)) return;
  material.emittance *= picture.texture ? mean_colour(textures_.raster(*picture.texture)) : Vec3(0.0f);
  material.textures.emittance = picture.use;
  material.textures.emittance_factor = surface.emittance;
}

// Alpha becomes a binary hole mask: a hole where the picture's alpha times the factor's is below the cutoff.
void GltfMaterials::let_through(const Surface& surface, Material& material) {
  const auto& picture = surface.base_picture;
  bool has_hole = surface.alpha < surface.cutoff;
  if (picture.texture && surface.cutoff > 0.0 && !has_hole) {
    const auto& raster = textures_.raster(*picture.texture);
    const auto threshold = static_cast<float>(surface.cutoff / surface.alpha);
    if (picture.use && min_alpha(raster) < threshold) {
      material.textures.cutout = picture.use;
      material.textures.cutout_threshold = threshold;
    }
    has_hole = !picture.use && mean_alpha(raster) < threshold;
  }
  if (surface.is_blended && (material.textures.cutout || surface.alpha < 1.0))
    blended_.push_back(surface.name);
  material.opaque = material.is_lamp() || !(has_hole || surface.passes > half_solid);
  if (material.opaque) return;
  if (!has_hole) material.transmittance = transmittance_of(surface);
  if (is_glass_of(options_.glass, surface.name)) return;  // reported by apply_glass()
  (material.transmittance == Vec3(1.0f) ? transparent_ : panes_).push_back(surface.name);
}

// The base colour tints what is transmitted (KHR_materials_transmission). A factor of 1 and white, which is
// what programs write for glass, is no glass at all.
Vec3 GltfMaterials::transmittance_of(const Surface& surface) {
  const auto& picture = surface.base_picture;
  auto colour = surface.base;
  if (picture.texture) colour *= mean_colour(textures_.raster(*picture.texture));
  const auto transmittance = glm::clamp(static_cast<float>(surface.passes) * colour, 0.0f, 1.0f);
  return transmittance == Vec3(0.0f) ? Vec3(1.0f) : transmittance;
}

void GltfMaterials::reflect(const Surface& surface, Material& material) {
  auto base = surface.base_picture;
  auto colour = surface.base * diffuse_fraction(surface, base, material);
  if (material.opaque && surface.scatters > 0.0f) {  // metals transmit nothing
    material.diffuse_transmittance = surface.scatters * (1.0f - surface.metal) * surface.scattered;
    if (material.is_diffuser()) material.two_sided = true;
    colour *= 1.0f - surface.scatters * (1.0f - surface.metal);
  }
  material.reflectance = colour;
  if (base.is_given) {
    material.reflectance *=
        base.texture ? mean_colour(textures_.raster(*base.texture)) : Vec3(default_reflectance);
    material.textures.reflectance = base.use;
    material.textures.reflectance_factor = colour;
  }
  if (surface.is_mirror || material.textures.max_reflectance < options_.max_reflectance)
    material.reflectance = glm::min(material.reflectance, Vec3(max_metal_reflectance));
}

// Returns the fraction of the base colour that is diffuse reflectance. A metal reflects light of its base
// colour, but no diffuse light: where there is more metal than not, the whole base colour stands for it, up
// to a limit; elsewhere the fraction is 1 - metallic. Where a picture gives metallic per texel, the base
// colour picture is replaced by one of stand-ins if their placements agree; otherwise the mean is used.
float GltfMaterials::diffuse_fraction(const Surface& surface, TextureInput& base, Material& material) {
  if (surface.is_mirror) metals_.push_back(surface.name);
  const auto& picture = surface.metal_picture;
  if (surface.metal == 0.0f || (picture.is_given && !picture.texture)) return 1.0f;
  auto metallic = surface.metal;
  if (picture.texture) {
    const auto metal = metal_range(textures_.raster(*picture.texture));
    auto same_use = base.use;
    if (same_use && picture.use) same_use->texture = picture.use->texture;
    if (metal.least < metal.most && picture.use && (!base.is_given || same_use == picture.use)) {
      base.use = picture.use;
      base.texture = textures_.with_metal(base.texture, *picture.texture, surface.metal);
      base.use->texture = *base.texture;
      base.is_given = true;
      if (surface.metal * metal.most > half_metal) metals_.push_back(surface.name);
      return 1.0f;
    }
    metallic = surface.metal * metal.mean;
  }
  if (metallic <= half_metal) return 1.0f - metallic;
  metals_.push_back(surface.name);
  material.textures.max_reflectance = std::min(options_.max_reflectance, max_metal_reflectance);
  return 1.0f;
}

void GltfMaterials::cap(Material& material) {
  const auto capped = glm::min(material.reflectance, Vec3(options_.max_reflectance));
  if (capped == material.reflectance) return;
  too_bright_.push_back(material.name);
  material.stated_reflectance = material.reflectance;
  material.reflectance = capped;
}

void GltfMaterials::give(Scene& scene) {
  scene.materials = std::move(materials_);
  scene.textures = textures_.textures();
  keep_used_textures(scene);
}

void GltfMaterials::say_warnings(const Context& context) const {
  const auto say = [&](const std::string& before, const std::vector<std::string>& names,
                       const std::string& behind) {
    if (!names.empty())
      context.warn(fmt::format("{}: {} {}{}", file_.source(), before, name_list(names), behind));
  };
  if (default_)
    context.warn(fmt::format("{}: a grey of {} is taken for what has no material", file_.source(),
                             default_reflectance));
  say("the reflectance of", too_bright_,
      fmt::format(" was lowered to {}, as no surface reflects all light", options_.max_reflectance));
  if (!transparent_.empty())
    context.warn(
        fmt::format("{}: light passes freely through what is more transparent than not, which is left "
                    "out: {}",
                    file_.source(), name_list(transparent_)),
        {{Setting::glass, "NAME=0.8"}});
  if (!panes_.empty())
    context.note(
        fmt::format("{}: panes of glass, with the transmittance of KHR_materials_transmission times the "
                    "base colour: {}",
                    file_.source(), name_list(panes_)));
  if (!diffusers_.empty())
    context.note(
        fmt::format("{}: diffusers, with the transmittance of KHR_materials_diffuse_transmission: {}",
                    file_.source(), name_list(diffusers_)));
  warn_of_limited_albedo(file_.source(), too_bright_diffusers_, options_.max_reflectance, context);
  say("surfaces are solid or not there: alpha (BLEND) is taken as a hole where it is below 0.5, for",
      blended_, "");
  if (!metals_.empty())
    context.note(
        fmt::format("{}: stand-ins, since metals and mirrors are not modelled: their colour, at most {}, is "
                    "taken as diffuse "
                    "for {}",
                    file_.source(), max_metal_reflectance, name_list(metals_)));
  say("what is drawn without light elsewhere (KHR_materials_unlit) is a diffuse surface of its colour here:",
      unlit_, "");
  say("there are no texture coordinates for some surfaces of", without_coordinates_,
      "; the mean of the picture is taken");
  textures_.say_warnings(context);
}

}  // namespace luxel
