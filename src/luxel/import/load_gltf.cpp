// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/load_gltf.h"

#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/import/gltf_array.h"
#include "luxel/import/gltf_lamps.h"
#include "luxel/import/gltf_luminaires.h"
#include "luxel/import/gltf_materials.h"
#include "luxel/import/gltf_mesh.h"
#include "luxel/import/gltf_parts.h"
#include "luxel/import/name_list.h"
#include "luxel/import/place_positions.h"

namespace luxel {
namespace {

class GltfLoader {
 public:
  GltfLoader(GltfFile& file, const LoadOptions& options, const Context& context)
      : file_(file),
        options_(options),
        context_(context),
        nodes_(placed_nodes(file)),
        drawn_(drawn_parts(file, nodes_)) {}

  Scene load();

 private:
  void check_counts() const;
  bool add_triangles(Scene& scene, GltfMaterials& materials);
  void say_warnings() const;

  GltfFile& file_;
  const LoadOptions& options_;
  const Context& context_;
  std::vector<PlacedNode> nodes_;
  GltfParts drawn_;
};

// Few bytes can declare very large scenes: by instances, and by accessors without a buffer view, which are
// zero.
void GltfLoader::check_counts() const {
  constexpr std::size_t max_corners = 300'000'000;  // some 30 bytes each
  std::size_t corners = 0, zeros = 0;
  for (const auto& part : drawn_.parts) {
    const GltfArray positions(file_, part.primitive["attributes"]["POSITION"], 3, 3);
    auto count = positions.size();
    bool is_zero = !positions.accessor()["bufferView"];
    if (const auto index = part.primitive["indices"]) {
      const GltfArray indices(file_, index, 1, 1);
      count = indices.size();
      is_zero = is_zero || !indices.accessor()["bufferView"];
    }
    corners += count;
    zeros += is_zero ? count : 0;
    if (zeros > GltfArray::max_zeros)
      part.primitive.refuse(fmt::format(
          "arrays without a bufferView have more than {} elements in all instances, the most that are taken",
          GltfArray::max_zeros));
    if (corners > max_corners)
      part.primitive.refuse(
          fmt::format("expected at most {} corners of triangles in all instances, found more", max_corners));
  }
}

// Returns false where the monitor stops the work.
bool GltfLoader::add_triangles(Scene& scene, GltfMaterials& materials) {
  check_counts();
  const auto& parts = drawn_.parts;
  // The required sets of texture coordinates are known only after all materials.
  std::vector<MaterialId> material_of;
  for (const auto& part : parts) {
    material_of.push_back(materials.of(part.primitive));
    const auto done = 0.5 * static_cast<double>(material_of.size()) / static_cast<double>(parts.size());
    if (context_.report({.stage = "load", .done = done}) == Next::stop) return false;
  }
  GltfMesh mesh(file_, scene, options_.scale, materials.texture_coordinates());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto done = 0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(parts.size());
    if (context_.report({.stage = "load", .done = done}) == Next::stop) return false;
    mesh.add(parts[i].primitive, parts[i].placed.world, parts[i].object, material_of[i]);
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
    if (count > 0) context_.warn(fmt::format("{}: {} {}", file_.source(), counted(count, noun), what));
  };
  say(drawn_.without_triangles, "primitive", "of points or lines, or without positions, passed over");
  say(drawn_.skinned, "node", "with a skin taken as modelled, not as its joints bend it");
  say(drawn_.morphed, "primitive", "with morph targets taken without them");
}

Scene GltfLoader::load() {
  Scene scene;
  scene.source = file_.source();
  scene.up = Vec3(0.0f, 1.0f, 0.0f);
  GltfMaterials materials(file_, options_);
  if (!add_triangles(scene, materials)) return {};
  materials.give(scene);
  PhotometryStore photometry(context_);
  add_gltf_luminaires(file_, nodes_, options_.scale, photometry, scene);
  add_lamps(file_, nodes_, options_.scale, scene);
  add_cameras(file_, nodes_, options_.scale, scene, context_);
  materials.say_warnings(context_);
  say_warnings();
  scene.files = file_.files();
  scene.allows_outside = options_.allow_outside;
  return scene;
}

}  // namespace

Scene load_gltf(const std::filesystem::path& path, const LoadOptions& options, const Context& context) {
  return load_gltf(read_file(path), path, options, context);
}

Scene load_gltf(std::string bytes, const std::filesystem::path& path, const LoadOptions& options,
                const Context& context) {
  if (context.report({.stage = "load", .done = 0.0}) == Next::stop) return {};
  GltfFile file(std::move(bytes), path, known_extensions(), options.allow_outside);
  return GltfLoader(file, options, context).load();
}

}  // namespace luxel
