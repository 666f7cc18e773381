// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/scene_gltf.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

#include <fmt/format.h>

#include "luxel/core/utf8.h"
#include "luxel/export/unlit_mesh.h"
#include "luxel/image/image_file.h"
#include "luxel/import/gltf_writer.h"
#include "luxel/scene/luminous_efficacy.h"

namespace luxel {
namespace {

Json numbers(const Vec3& v) { return {v.x, v.y, v.z}; }

class SceneWriter {
 public:
  explicit SceneWriter(const Scene& scene) : scene_(scene) {}

  SceneGltf write(const Vec3& up) {
    add_root(file_, {{"name", "scene"}}, up, scene_.origin);
    for (const auto& material : scene_.materials) add_material(material);
    add_objects();
    return {file_.bytes(scene_.source), std::move(order_)};
  }

 private:
  // By object and material.
  using Groups = std::map<std::pair<std::uint32_t, std::size_t>, std::vector<std::uint32_t>>;

  void add_material(const Material& material) {
    const auto& textures = material.textures;
    const auto number = file_.append("/materials", Json::object());
    const auto path = fmt::format("/materials/{}", number);
    file_.put(path + "/name", valid_utf8(material.name));
    file_.put(path + "/doubleSided", material.two_sided);
    const bool is_pane = !material.opaque && material.transmittance != Vec3(1.0f);
    auto base = is_pane                ? material.transmittance
                : textures.reflectance ? textures.reflectance_factor
                                       : material.reflectance;
    if (material.is_diffuser())
      base /= 1.0f - add_diffuse_transmission(material.diffuse_transmittance, base, path);
    // A surface that lets all light pass is invisible.
    file_.put(path + "/pbrMetallicRoughness",
              {{"baseColorFactor", {base.r, base.g, base.b, material.opaque || is_pane ? 1 : 0}},
               {"metallicFactor", 0},
               {"roughnessFactor", 1}});
    if (const auto picture = textures.reflectance ? textures.reflectance : textures.cutout;
        picture && !is_pane)
      file_.put(path + "/pbrMetallicRoughness/baseColorTexture", texture_of(*picture));
    if (textures.cutout) {
      file_.put(path + "/alphaMode", "MASK");
      file_.put(path + "/alphaCutoff", textures.cutout_threshold);
    }
    if (!material.opaque && !is_pane) file_.put(path + "/alphaMode", "BLEND");
    if (is_pane) {
      file_.put(path + "/extensions/KHR_materials_transmission", {{"transmissionFactor", 1}});
      file_.use_extension("KHR_materials_transmission");
    }
    // Luxel's surfaces are diffuse; glTF's have a gloss that takes a fraction of the light.
    file_.put(path + "/extensions/KHR_materials_specular", {{"specularFactor", 0}});
    file_.use_extension("KHR_materials_specular");
    add_emission(material, path);
  }

  // Returns the fraction of the diffuse light that leaves the other side. The base colour becomes the albedo.
  float add_diffuse_transmission(const Vec3& tau, const Vec3& reflectance, const std::string& path) {
    const auto largest = [](const Vec3& v) { return std::max({v.r, v.g, v.b}); };
    const auto factor = largest(tau) / (largest(tau) + largest(reflectance));
    file_.put(path + "/extensions/KHR_materials_diffuse_transmission",
              {{"diffuseTransmissionFactor", factor},
               {"diffuseTransmissionColorFactor", numbers(glm::min(tau / factor, Vec3(1.0f)))}});
    file_.use_extension("KHR_materials_diffuse_transmission");
    return std::min(factor, 0.999f);
  }

  void add_emission(const Material& material, const std::string& path) {
    const auto& textures = material.textures;
    const auto nits = static_cast<float>(luminous_efficacy) / pi *
                      (textures.emittance ? textures.emittance_factor : material.emittance);
    const auto most = std::max({nits.r, nits.g, nits.b});
    if (!(most > 0.0f)) return;
    file_.put(path + "/emissiveFactor", numbers(nits / most));
    file_.put(path + "/extensions/KHR_materials_emissive_strength", {{"emissiveStrength", most}});
    file_.use_extension("KHR_materials_emissive_strength");
    if (textures.emittance) file_.put(path + "/emissiveTexture", texture_of(*textures.emittance));
  }

  // A texture with its wrapping; its placement is in the coordinates already.
  Json texture_of(const TextureUse& use) {
    const auto key = std::tuple(use.texture, use.wrap[0], use.wrap[1]);
    const auto [found, is_new] = textures_.try_emplace(key, 0);
    if (is_new) {
      const auto [image, is_first] = images_.try_emplace(use.texture, 0);
      const auto& texture = scene_.textures[use.texture];
      if (is_first)
        image->second = file_.add_picture(png_of(*texture.raster), "image/png", valid_utf8(texture.name));
      const auto sampler =
          file_.append("/samplers", {{"wrapS", wrap_code(use.wrap[0])}, {"wrapT", wrap_code(use.wrap[1])}});
      found->second = file_.append("/textures", {{"source", image->second}, {"sampler", sampler}});
    }
    return {{"index", found->second}};
  }

  static int wrap_code(Wrap wrap) {
    return wrap == Wrap::repeat ? 10497 : wrap == Wrap::mirror ? 33648 : 33071;
  }

  void add_objects() {
    const bool has_objects = !scene_.objects.empty() && !scene_.triangle_object.empty();
    const auto& names = has_objects ? scene_.objects : scene_.groups;
    const auto& of_triangle = has_objects ? scene_.triangle_object : scene_.triangle_group;
    Groups groups;
    for (std::uint32_t t = 0; t < scene_.triangles.size(); ++t)
      groups[{of_triangle[t], static_cast<std::size_t>(scene_.triangle_material[t])}].push_back(t);
    std::optional<std::uint32_t> object;
    std::size_t mesh = 0;
    for (const auto& [key, triangles] : groups) {
      if (object != key.first) {
        object = key.first;
        mesh = file_.append("/meshes", {{"primitives", Json::array()}});
        const auto node = file_.append("/nodes", {{"mesh", mesh}});
        file_.put(fmt::format("/nodes/{}/name", node), valid_utf8(names[*object]));
        file_.append("/nodes/0/children", node);
      }
      file_.append(fmt::format("/meshes/{}/primitives", mesh), primitive_of(triangles, key.second));
      order_.insert(order_.end(), triangles.begin(), triangles.end());
    }
  }

  // Vertices of the scene are split where texture coordinates differ.
  Json primitive_of(const std::vector<std::uint32_t>& triangles, std::size_t material) {
    const auto& textures = scene_.materials[material].textures;
    const auto use = textures.reflectance ? textures.reflectance
                     : textures.cutout    ? textures.cutout
                                          : textures.emittance;
    std::map<std::tuple<std::uint32_t, float, float>, std::uint32_t> number_of;
    std::vector<Vec3> positions, tints;
    std::vector<Vec2> places;
    std::vector<std::array<std::uint32_t, 3>> corners;
    for (const auto t : triangles) {
      auto& triangle = corners.emplace_back();
      for (std::size_t c = 0; c < 3; ++c) {
        const auto vertex = scene_.triangles[t][c];
        const auto place = use ? use->place(scene_.uv_sets[use->uv_set][t][c]) : Vec2(0.0f);
        const auto [found, is_new] = number_of.try_emplace(std::tuple(vertex, place.x, place.y),
                                                           static_cast<std::uint32_t>(positions.size()));
        triangle[c] = found->second;
        if (!is_new) continue;
        positions.push_back(scene_.positions[vertex]);
        places.push_back(place);
        if (!scene_.corner_colours.empty()) tints.push_back(scene_.corner_colours[t][c]);
      }
    }
    Json attributes = {{"POSITION", file_.add_positions(positions)}};
    if (use) attributes["TEXCOORD_0"] = file_.add_vectors(std::span<const Vec2>(places));
    if (!tints.empty()) attributes["COLOR_0"] = file_.add_vectors(std::span<const Vec3>(tints));
    return {{"attributes", std::move(attributes)},
            {"indices", file_.add_indices(corners, positions.size())},
            {"material", material}};
  }

  const Scene& scene_;
  GltfWriter file_;
  std::map<std::tuple<std::uint32_t, Wrap, Wrap>, std::size_t> textures_;
  std::map<std::uint32_t, std::size_t> images_;
  std::vector<std::uint32_t> order_;
};

}  // namespace

SceneGltf gltf_of(const Scene& scene, const Vec3& up) { return SceneWriter(scene).write(up); }

}  // namespace luxel
