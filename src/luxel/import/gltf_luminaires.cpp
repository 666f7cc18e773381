// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/gltf_luminaires.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/import/gltf_lamps.h"
#include "luxel/scene/luminous_efficacy.h"

namespace luxel {
namespace {

constexpr const char* extension = "EXT_lights_ies";

class GltfLuminaires {
 public:
  GltfLuminaires(GltfFile& file, double scale, PhotometryStore& store, Scene& scene)
      : file_(file), scale_(scale), store_(store), scene_(scene) {}

  void add_of_extension(const PlacedNode& placed, const JsonValue& use) {
    auto light = placed_light(placed, use);
    light.photometry = profile(use["light"]);
    const auto colour = use["color"].numbers({1.0, 1.0, 1.0});
    const auto multiplier = bounded(use["multiplier"], 1.0, 0.0, 1e6);
    Vec3 factor;
    for (int band = 0; band < 3; ++band) {
      factor[band] = static_cast<float>(colour[static_cast<std::size_t>(band)] * multiplier);
      if (!(factor[band] >= 0.0f && std::isfinite(factor[band])))
        use["color"].refuse("expected numbers of 0 or more");
    }
    light.local_x = gltf_axis(placed, {1.0, 0.0, 0.0});
    light.direction = gltf_axis(placed, {0.0, 0.0, -1.0});
    finish(light, factor);
  }

  void add_of_extras(const PlacedNode& placed, const JsonValue& extras) {
    const auto name = extras["luminaire"];
    auto light = placed_light(placed, name);
    const PhotometryOptions options{
        .lamp_set = static_cast<std::size_t>(bounded(extras["luminaire_lamp_set"], 1.0, 1.0, 1000.0)),
        .rotate = bounded(extras["luminaire_turn"], 0.0, -360.0, 360.0)};
    light.photometry = parsed(name, file_.resource(name), name.text(), options);
    light.name = extras["luminaire_group"].text(std::filesystem::path(name.text()).stem().string());
    light.dimming = static_cast<float>(bounded(extras["luminaire_dimming"], 1.0, 0.0, 1000.0));
    light.maintenance = static_cast<float>(bounded(extras["luminaire_maintenance"], 1.0, 1e-3, 1.0));
    light.local_x = gltf_axis(placed, {1.0, 0.0, 0.0});
    const bool is_punctual = static_cast<bool>(placed.node["extensions"]["KHR_lights_punctual"]["light"]);
    light.direction = gltf_axis(placed, is_punctual ? Vec3d(0.0, 0.0, -1.0) : Vec3d(0.0, -1.0, 0.0));
    finish(light, Vec3(light.dimming * light.maintenance));
  }

 private:
  PointLight placed_light(const PlacedNode& placed, const JsonValue& at) const {
    PointLight light;
    light.kind = PointLightKind::luminaire;
    light.name = placed.node["name"].text("");
    if (light.name.empty()) light.name = fmt::format("node {}", placed.number);
    if (!(std::abs(glm::determinant(glm::dmat3(placed.world))) > 0.0))
      at.refuse("expected a node whose scale is not 0");
    light.position = gltf_place(placed, scale_, scene_);
    return light;
  }

  static double bounded(const JsonValue& value, double fallback, double low, double high) {
    const auto number = value.number(fallback);
    if (!(number >= low && number <= high))
      value.refuse(fmt::format("expected a number from {:g} to {:g}, found {:g}", low, high, number));
    return number;
  }

  std::shared_ptr<const Photometry> profile(const JsonValue& index) {
    const auto lights = file_.root()["extensions"][extension]["lights"];
    const auto number = index.whole();
    if (number >= lights.size())
      index.refuse(fmt::format("it names light profile {}, but the file has {} (numbered from 0)", number,
                               lights.size()));
    auto& known = profiles_[number];
    if (known) return known;
    const auto light = lights[number];
    const auto uri = light["uri"];
    const auto name = light["name"].text(fmt::format("light profile {}", number));
    const auto bytes = uri ? file_.resource(uri) : std::string(file_.view(light["bufferView"]));
    known = parsed(light, bytes, uri && !uri.text().starts_with("data:") ? uri.text() : name, {});
    return known;
  }

  // Errors name what asks for the file, too.
  std::shared_ptr<const Photometry> parsed(const JsonValue& at, const std::string& bytes,
                                           const std::string& name, const PhotometryOptions& options) const {
    try {
      return store_.parse(bytes, name, options);
    } catch (const InputError& error) {
      at.refuse(error.what());
    }
  }

  // The third axis follows, so that a mirrored node does not mirror the luminaire.
  void finish(PointLight& light, const Vec3& factor) {
    const auto x = Vec3d(light.local_x), aim = Vec3d(light.direction);
    light.local_x = Vec3(glm::normalize(x - glm::dot(x, aim) * aim));
    light.local_y = Vec3(glm::cross(-aim, Vec3d(light.local_x)));
    light.intensity = factor * static_cast<float>(light.photometry->intensity.maximum() / luminous_efficacy);
    scene_.point_lights.push_back(std::move(light));
  }

  GltfFile& file_;
  double scale_;
  PhotometryStore& store_;
  Scene& scene_;
  std::map<std::size_t, std::shared_ptr<const Photometry>> profiles_;
};

}  // namespace

// Extras may hold anything; those of other programs are ignored.
bool has_luminaire(const JsonValue& node) {
  const auto extras = node["extras"];
  return extras.is_object() && extras["luminaire"].is_text();
}

void add_gltf_luminaires(GltfFile& file, std::span<const PlacedNode> nodes, double scale,
                         PhotometryStore& store, Scene& scene) {
  GltfLuminaires luminaires(file, scale, store, scene);
  for (const auto& placed : nodes) {
    if (const auto use = placed.node["extensions"][extension]) luminaires.add_of_extension(placed, use);
    if (has_luminaire(placed.node)) luminaires.add_of_extras(placed, placed.node["extras"]);
  }
}

}  // namespace luxel
