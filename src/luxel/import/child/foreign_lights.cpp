// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/child/foreign_lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <assimp/camera.h>
#include <assimp/light.h>
#include <fmt/format.h>

#include "luxel/import/name_list.h"
#include "luxel/scene/luminous_efficacy.h"

namespace luxel {
namespace {

struct Frame {
  aiVector3D position, ahead, up;
};

// A node at a position whose -Z axis points ahead, as glTF has lights and cameras.
Json node_at(const aiString& name, const Frame& frame) {
  auto back = -frame.ahead;
  if (!(back.Length() > 0.0f)) back = aiVector3D(0, 0, 1);
  back.Normalize();
  auto right = frame.up ^ back;
  constexpr float parallel = 1e-3f;
  if (!(right.Length() > parallel))
    right = (std::abs(back.x) < 0.5f ? aiVector3D(1, 0, 0) : aiVector3D(0, 1, 0)) ^ back;
  right.Normalize();
  const auto up = back ^ right;
  const auto& p = frame.position;
  return {{"name", name.C_Str()},
          {"matrix",
           {right.x, right.y, right.z, 0, up.x, up.y, up.z, 0, back.x, back.y, back.z, 0, p.x, p.y, p.z, 1}}};
}

// Half angles in radians. Assimp gives whole angles, guesses the outer one of COLLADA, whose falloff_angle
// it calls the inner one, and adds the inner one of 3DS to the outer one.
Json cone_of(const aiLight& light, ForeignFormat format) {
  double inner = 0.5 * light.mAngleInnerCone, outer = 0.5 * light.mAngleOuterCone;
  if (format == ForeignFormat::collada) outer = inner;
  if (format == ForeignFormat::max_3ds) outer -= inner;
  constexpr double narrowest = 1e-3, widest = std::numbers::pi / 2.0, usual = std::numbers::pi / 4.0;
  if (!std::isfinite(outer) || outer <= 0.0) outer = usual;
  outer = std::clamp(outer, narrowest, widest);
  inner = std::isfinite(inner) ? std::clamp(inner, 0.0, outer) : 0.0;
  return {{"innerConeAngle", inner}, {"outerConeAngle", outer}};
}

double plain(float value) { return value > 0.0f && std::isfinite(value) ? value : 0.0; }

// KHR_lights_punctual.
Json light_of(const aiLight& light, ForeignFormat format) {
  const auto& c = light.mColorDiffuse;
  const double most = std::max({plain(c.r), plain(c.g), plain(c.b)});
  const double scale = most > 0.0 ? 1.0 / most : 0.0;
  const bool is_directional = light.mType == aiLightSource_DIRECTIONAL;
  const double steradians = is_directional ? 1.0 : 4.0 * std::numbers::pi;
  Json made = {{"name", light.mName.C_Str()},
               {"color", {scale * plain(c.r), scale * plain(c.g), scale * plain(c.b)}},
               {"intensity", most / steradians * luminous_efficacy},
               {"type", is_directional ? "directional" : "point"}};
  if (light.mType == aiLightSource_SPOT) {
    made["type"] = "spot";
    made["spot"] = cone_of(light, format);
  }
  return made;
}

Json perspective_of(const aiCamera& camera) {
  constexpr double usual_aspect = 16.0 / 9.0, usual_angle = 0.8, smallest_angle = 0.02;  // radians
  const double aspect = plain(camera.mAspect) > 0.0 ? camera.mAspect : usual_aspect;
  const double across = camera.mHorizontalFOV;  // whole angle; COLLADA without one becomes a small number
  const bool is_usable = across > smallest_angle && across < 3.0;
  const double upright = is_usable ? 2.0 * std::atan(std::tan(0.5 * across) / aspect) : usual_angle;
  return {{"type", "perspective"},
          {"perspective", {{"yfov", upright}, {"znear", 0.01}, {"aspectRatio", aspect}}}};
}

// Returns the nodes of lights or cameras in their order: several of one name belong to the nodes of that name
// in turn. Lights and cameras of 3DS have coordinates of the file, although Assimp names nodes for them too.
class Places {
 public:
  explicit Places(const ForeignFile& file) : root_(*file.scene->mRootNode), format_(file.format) {}
  const aiNode* next(const aiString& name) {
    if (format_ == ForeignFormat::max_3ds) return &root_;
    const auto nodes = nodes_named(root_, name);
    if (nodes.empty()) return &root_;
    auto& used = used_[name.C_Str()];
    const auto* node = nodes[std::min(used, nodes.size() - 1)];
    ++used;
    return node;
  }

 private:
  const aiNode& root_;
  ForeignFormat format_;
  std::map<std::string, std::size_t> used_;
};

// In a 3DS file with animation, Assimp replaces all directions by this one.
bool is_lost(const aiVector3D& direction, ForeignFormat format) {
  return format == ForeignFormat::max_3ds && direction == aiVector3D(0.0f, 0.0f, 1.0f);
}

void report_lost(ForeignFile& file, const std::vector<std::string>& names) {
  if (!names.empty())
    file.messages.push_back(
        fmt::format("warning spot lights and cameras whose direction cannot be read from a 3DS file with "
                    "animation are passed over: {}",
                    name_list(names)));
}

void add_lights(ForeignFile& file, GltfWriter& glb, AttachedNodes& attached) {
  Places places(file);
  std::vector<std::string> omitted, lost;
  std::size_t count = 0;
  for (unsigned i = 0; i < file.scene->mNumLights; ++i) {
    const auto& light = *file.scene->mLights[i];
    const auto* node = places.next(light.mName);
    if (light.mType != aiLightSource_POINT && light.mType != aiLightSource_SPOT &&
        light.mType != aiLightSource_DIRECTIONAL) {
      omitted.push_back(light.mName.C_Str());
      continue;
    }
    if (light.mType == aiLightSource_SPOT && is_lost(light.mDirection, file.format)) {
      lost.push_back(light.mName.C_Str());
      continue;
    }
    const auto number = glb.append("/extensions/KHR_lights_punctual/lights", light_of(light, file.format));
    glb.use_extension("KHR_lights_punctual");
    auto made = node_at(light.mName, {light.mPosition, light.mDirection, light.mUp});
    made["extensions"]["KHR_lights_punctual"]["light"] = number;
    attached[node].push_back(std::move(made));
    ++count;
  }
  if (count > 0)
    file.messages.push_back(fmt::format(
        "note the intensity of {} has no unit in this format; it is taken as watts", counted(count, "lamp")));
  report_lost(file, lost);
  if (!omitted.empty())
    file.messages.push_back(
        fmt::format("warning area and ambient lights are passed over: {}", name_list(omitted)));
}

void add_cameras(ForeignFile& file, GltfWriter& glb, AttachedNodes& attached) {
  Places places(file);
  std::vector<std::string> lost;
  for (unsigned i = 0; i < file.scene->mNumCameras; ++i) {
    const auto& camera = *file.scene->mCameras[i];
    if (is_lost(camera.mLookAt, file.format)) {
      lost.push_back(camera.mName.C_Str());
      continue;
    }
    const bool is_max = file.format == ForeignFormat::max_3ds;  // whose up Assimp takes for y
    auto made =
        node_at(camera.mName, {camera.mPosition, camera.mLookAt, is_max ? aiVector3D(0, 0, 1) : camera.mUp});
    made["camera"] = glb.append("/cameras", perspective_of(camera));
    attached[places.next(camera.mName)].push_back(std::move(made));
  }
  report_lost(file, lost);
}

}  // namespace

AttachedNodes attached_nodes(ForeignFile& file, GltfWriter& glb) {
  AttachedNodes attached;
  add_lights(file, glb, attached);
  add_cameras(file, glb, attached);
  return attached;
}

}  // namespace luxel
