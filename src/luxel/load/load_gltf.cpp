// SPDX-License-Identifier: Apache-2.0
#include "luxel/load/load_gltf.h"

#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "luxel/file/output_file.h"
#include "luxel/load/gltf_lamps.h"
#include "luxel/load/gltf_materials.h"
#include "luxel/load/gltf_mesh.h"
#include "luxel/load/name_list.h"
#include "luxel/load/place_positions.h"
#include "luxel/report/error.h"

namespace luxel {
namespace {

// Those that a file may require: what Luxel reads, and what only changes reflections, which it has none of.
const std::vector<std::string_view>& known_extensions() {
  static const std::vector<std::string_view> known = {"KHR_lights_punctual",
                                                      "KHR_materials_emissive_strength",
                                                      "KHR_materials_unlit",
                                                      "KHR_materials_pbrSpecularGlossiness",
                                                      "KHR_texture_transform",
                                                      "KHR_mesh_quantization",
                                                      "KHR_materials_anisotropy",
                                                      "KHR_materials_clearcoat",
                                                      "KHR_materials_dispersion",
                                                      "KHR_materials_ior",
                                                      "KHR_materials_iridescence",
                                                      "KHR_materials_sheen",
                                                      "KHR_materials_specular",
                                                      "KHR_materials_transmission",
                                                      "KHR_materials_variants",
                                                      "KHR_materials_volume",
                                                      "KHR_xmp_json_ld"};
  return known;
}

// A primitive that draws triangles, where a node puts it.
struct Part {
  const PlacedNode* placed;
  JsonValue primitive;
  std::string object;
};

class GltfLoader {
 public:
  GltfLoader(GltfFile& file, const LoadOptions& options, const LogSink& log, const Monitor& monitor)
      : file_(file), options_(options), log_(log), monitor_(monitor), nodes_(placed_nodes(file)) {}

  Scene load();

 private:
  void find_parts();
  bool add_triangles(Scene& scene, GltfMaterials& materials);
  void say_warnings() const;

  GltfFile& file_;
  const LoadOptions& options_;
  const LogSink& log_;
  const Monitor& monitor_;
  std::vector<PlacedNode> nodes_;
  std::vector<Part> parts_;
  std::size_t without_triangles_ = 0, skinned_ = 0, morphed_ = 0;
};

std::string object_name(const PlacedNode& placed, const JsonValue& mesh) {
  auto name = placed.node["name"].text(mesh["name"].text(""));
  return name.empty() ? fmt::format("node {}", placed.number) : name;
}

void GltfLoader::find_parts() {
  for (const auto& placed : nodes_) {
    if (!placed.node["mesh"]) continue;
    const auto mesh = file_.object(placed.node["mesh"], "meshes");
    const auto primitives = mesh["primitives"];
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      if (GltfMesh::draws_triangles(primitives[i]))
        parts_.push_back({&placed, primitives[i], object_name(placed, mesh)});
      else
        ++without_triangles_;
      if (primitives[i]["targets"].size() > 0) ++morphed_;
    }
    if (placed.node["skin"]) ++skinned_;
  }
}

// False where the monitor says stop.
bool GltfLoader::add_triangles(Scene& scene, GltfMaterials& materials) {
  // Which sets of texture coordinates are wanted shows only when all materials are known.
  std::vector<MaterialId> material_of;
  for (const auto& part : parts_) {
    material_of.push_back(materials.of(part.primitive));
    const auto done = 0.5 * static_cast<double>(material_of.size()) / static_cast<double>(parts_.size());
    if (tell(monitor_, {.stage = "load", .done = done}) == Next::stop) return false;
  }
  GltfMesh mesh(file_, scene, options_.scale, materials.texture_coordinates());
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const auto done = 0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(parts_.size());
    if (tell(monitor_, {.stage = "load", .done = done}) == Next::stop) return false;
    mesh.add(parts_[i].primitive, parts_[i].placed->world, parts_[i].object, material_of[i]);
  }
  mesh.finish();
  if (scene.triangles.empty())
    throw InputError(scene.source, fmt::format("no triangles found in the {} of its scene",
                                               counted(nodes_.size(), "node")));
  Reach reach;
  for (const auto& position : mesh.positions()) reach.add(position);
  place_positions(mesh.positions(), reach, options_.scale, scene);
  return true;
}

void GltfLoader::say_warnings() const {
  const auto say = [&](std::size_t count, const char* noun, const char* what) {
    if (count > 0) warn(log_, fmt::format("{}: {} {}", file_.source(), counted(count, noun), what));
  };
  say(without_triangles_, "primitive", "of points or lines, or without positions, passed over");
  say(skinned_, "node", "with a skin taken as modelled, not as its joints bend it");
  say(morphed_, "primitive", "with morph targets taken without them");
}

Scene GltfLoader::load() {
  Scene scene;
  scene.source = file_.source();
  find_parts();
  GltfMaterials materials(file_, options_);
  if (!add_triangles(scene, materials)) return {};
  materials.give(scene);
  add_lamps(file_, nodes_, options_.scale, scene);
  add_cameras(file_, nodes_, options_.scale, scene, log_);
  materials.say_warnings(log_);
  say_warnings();
  return scene;
}

}  // namespace

Scene load_gltf(const std::filesystem::path& path, const LoadOptions& options, const LogSink& log,
                const Monitor& monitor) {
  return load_gltf(read_file(path), path, options, log, monitor);
}

Scene load_gltf(std::string bytes, const std::filesystem::path& path, const LoadOptions& options,
                const LogSink& log, const Monitor& monitor) {
  if (tell(monitor, {.stage = "load", .done = 0.0}) == Next::stop) return {};
  GltfFile file(std::move(bytes), path, known_extensions());
  return GltfLoader(file, options, log, monitor).load();
}

}  // namespace luxel
