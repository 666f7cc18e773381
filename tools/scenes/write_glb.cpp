// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/export/scene_gltf.h"
#include "luxel/import/gltf_file.h"
#include "luxel/import/gltf_writer.h"
#include "luxel/scene/luminous_efficacy.h"

#include "scenes/to_scene.h"
#include "scenes/write_scene.h"

namespace luxel::scenes {
namespace {

// The rotation of a node that looks along its -Z, so that it looks along `ahead`, its +Y as far up as it can.
Json looking_along(const Vec3d& ahead) {
  const auto back = -glm::normalize(ahead);
  const auto pole = std::abs(back.y) > 0.999 ? Vec3d(0.0, 0.0, 1.0) : Vec3d(0.0, 1.0, 0.0);
  const auto right = glm::normalize(glm::cross(pole, back));
  const auto q = glm::quat_cast(glm::dmat3(right, glm::cross(back, right), back));
  return {q.x, q.y, q.z, q.w};
}

Json numbers(const Vec3d& v) { return {v.x, v.y, v.z}; }

std::size_t add_camera(GltfWriter& file, const View& view) {
  const auto camera = file.append(
      "/cameras", {{"name", view.name},
                   {"type", "perspective"},
                   {"perspective", {{"yfov", glm::radians(view.vertical_fov)}, {"znear", 0.05}}}});
  return file.append("/nodes", {{"name", view.name},
                                {"camera", camera},
                                {"translation", numbers(view.eye)},
                                {"rotation", looking_along(view.target - view.eye)}});
}

std::size_t add_light(GltfWriter& file, const PunctualLight& light) {
  static constexpr const char* kinds[] = {"directional", "point", "spot"};
  file.use_extension("KHR_lights_punctual");
  auto description = Json{{"name", light.name},
                          {"type", kinds[light.kind]},
                          {"color", numbers(light.colour)},
                          {"intensity", light.intensity}};
  if (light.kind == PunctualLight::spot) {
    const auto angle = glm::radians(light.outer_degrees);
    description["spot"] = {{"innerConeAngle", 0.6 * angle}, {"outerConeAngle", angle}};
  }
  const auto number = file.append("/extensions/KHR_lights_punctual/lights", description);
  auto node = Json{{"name", light.name}, {"extensions", {{"KHR_lights_punctual", {{"light", number}}}}}};
  if (light.kind != PunctualLight::sun) node["translation"] = numbers(light.position);
  if (light.kind != PunctualLight::point) node["rotation"] = looking_along(light.direction);
  return file.append("/nodes", node);
}

}  // namespace

std::string glb_bytes(const Scene& scene, const MadeScene& about) {
  auto bare = GltfFile(gltf_of(scene, {0.0f, 1.0f, 0.0f}).bytes, scene.source, {"KHR_materials_specular"});
  auto file = GltfWriter(bare);
  file.put("/asset/generator", "luxel-scenes");
  file.put("/asset/extras/title", about.title);
  for (const auto& view : about.views) file.append("/scenes/0/nodes", add_camera(file, view));
  for (const auto& light : about.lights) file.append("/scenes/0/nodes", add_light(file, light));
  return file.bytes(scene.source);
}

void write_scene(const std::filesystem::path& path, const MadeScene& made) {
  const auto ending = path.extension();
  if (ending != ".obj" && ending != ".glb")
    throw InputError(path.string(),
                     fmt::format("expected a name that ends in .obj or .glb, found '{}'", ending.string()));
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
  const auto scene = to_scene(made, path.stem().string());
  if (ending == ".glb") {
    write_file(path, glb_bytes(scene, made));
    return;
  }
  auto mtl = path;
  mtl.replace_extension(".mtl");
  write_file(mtl, mtl_text(scene));
  write_file(path, obj_text(scene, made, mtl.filename().string()));
}

}  // namespace luxel::scenes
