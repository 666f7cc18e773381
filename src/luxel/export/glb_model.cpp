// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/glb_model.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/export/utf8.h"
#include "luxel/export/y_up.h"

namespace luxel {
namespace {

// A GLB states its length in 32 bits; a mebibyte is left for the JSON.
void check_size(const std::filesystem::path& path, const tinygltf::Model& model) {
  constexpr std::size_t limit = (std::size_t{1} << 32) - (std::size_t{1} << 20);
  const auto bytes = model.buffers.empty() ? 0 : model.buffers[0].data.size();
  if (bytes > limit)
    throw InputError(path.string(), fmt::format("the mesh needs {} bytes but a GLB file holds 4 GiB: "
                                                "cut the scene into larger patches",
                                                bytes));
}

}  // namespace

void add_vertices(tinygltf::Model& model, tinygltf::Primitive& primitive, const std::vector<Vec3>& positions,
                  const std::vector<Rgba16>& colours) {
  Bounds box;
  for (const auto& p : positions) box.add(p);
  const auto position = add_array(model, positions, vector_of_floats);
  model.accessors[position].minValues = {box.low.x, box.low.y, box.low.z};
  model.accessors[position].maxValues = {box.high.x, box.high.y, box.high.z};
  primitive.attributes["POSITION"] = position;
  const auto colour = add_array(model, colours, rgba_of_shorts);
  model.accessors[colour].normalized = true;
  primitive.attributes["COLOR_0"] = colour;
}

int add_indices(tinygltf::Model& model, const std::vector<std::array<std::uint32_t, 3>>& triangles,
                std::size_t vertices) {
  const auto fits_short = vertices <= 65535;  // index 65535 is reserved: primitive restart
  const auto add = [&]<typename Index>(const GlbElement& element) {
    std::vector<Index> indices;
    indices.reserve(3 * triangles.size());
    for (const auto& t : triangles)
      for (const auto i : t) indices.push_back(static_cast<Index>(i));
    return add_array(model, indices, element);
  };
  return fits_short ? add.template operator()<std::uint16_t>(short_index)
                    : add.template operator()<std::uint32_t>(long_index);
}

tinygltf::Material unlit_material(const std::string& name) {
  tinygltf::Material material;
  material.name = valid_utf8(name);
  material.alphaMode = "OPAQUE";
  material.doubleSided = false;
  material.pbrMetallicRoughness.metallicFactor = 0.0;
  material.pbrMetallicRoughness.roughnessFactor = 0.9;
  material.extensions["KHR_materials_unlit"] = tinygltf::Value(tinygltf::Value::Object{});
  return material;
}

void add_root(tinygltf::Model& model, tinygltf::Node root, const Vec3& up, const Vec3d& origin) {
  root.rotation = turn_to_y_up(up);
  if (origin != Vec3d(0.0)) {
    const auto at = turned(root.rotation, origin);
    root.translation = {at.x, at.y, at.z};
  }
  const auto number = static_cast<int>(model.nodes.size());
  model.nodes.push_back(std::move(root));
  tinygltf::Scene scene;
  scene.nodes.push_back(number);
  model.scenes.push_back(std::move(scene));
  model.defaultScene = 0;
}

void write_glb(const std::filesystem::path& path, tinygltf::Model& model) {
  check_size(path, model);
  std::ostringstream stream;
  tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, stream, false, true);
  write_file(path, stream.view());
}

}  // namespace luxel
