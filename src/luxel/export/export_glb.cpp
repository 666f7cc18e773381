// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>
#include <sstream>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include "luxel/export/export_mesh.h"
#include "luxel/export/lit_mesh.h"
#include "luxel/export/utf8.h"
#include "luxel/file/output_file.h"
#include "luxel/math/bounds.h"
#include "luxel/report/error.h"

namespace luxel {
namespace {

static_assert(std::endian::native == std::endian::little, "a GLB's numbers are little-endian, as ours are");

using Rgba16 = std::array<std::uint16_t, 4>;

// The columns of one part as glTF wants them.
struct Columns {
  std::vector<Vec3> position;
  std::vector<Vec3> normal;
  std::vector<Rgba16> colour;
  Bounds bounds;
};

Rgba16 quantise(const Vec3& colour) {
  const auto channel = [](float c) {
    return static_cast<std::uint16_t>(std::lround(std::clamp(c, 0.0f, 1.0f) * 65535.0f));
  };
  return {channel(colour.r), channel(colour.g), channel(colour.b), 65535};
}

Columns columns_of(const LitMesh& mesh, const LitPart& part) {
  Columns columns;
  for (std::size_t i = 0; i < part.smooth.size(); ++i) {
    const auto v = mesh.vertex(part, i);
    columns.position.push_back(v.position);
    columns.normal.push_back(v.normal);
    columns.colour.push_back(quantise(v.colour));
    columns.bounds.add(v.position);
  }
  return columns;
}

struct ElementKind {
  int component, type, target;
};
constexpr ElementKind vector_of_floats = {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3,
                                          TINYGLTF_TARGET_ARRAY_BUFFER};
constexpr ElementKind rgba_of_shorts = {TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_VEC4,
                                        TINYGLTF_TARGET_ARRAY_BUFFER};
constexpr ElementKind short_index = {TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR,
                                     TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER};
constexpr ElementKind long_index = {TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR,
                                    TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER};

// Appends an array to the one buffer, in a view of its own; returns its accessor.
template <typename T>
int add_array(tinygltf::Model& model, const std::vector<T>& values, const ElementKind& kind) {
  auto& bytes = model.buffers[0].data;
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = bytes.size();
  view.byteLength = values.size() * sizeof(T);
  view.target = kind.target;
  bytes.resize((bytes.size() + view.byteLength + 3) / 4 * 4);  // every array begins at a multiple of four
  std::memcpy(bytes.data() + view.byteOffset, values.data(), view.byteLength);
  model.bufferViews.push_back(view);

  tinygltf::Accessor accessor;
  accessor.bufferView = static_cast<int>(model.bufferViews.size() - 1);
  accessor.componentType = kind.component;
  accessor.type = kind.type;
  accessor.count = values.size();
  model.accessors.push_back(accessor);
  return static_cast<int>(model.accessors.size() - 1);
}

int add_indices(tinygltf::Model& model, const LitPart& part) {
  const auto fits_short = part.smooth.size() <= 65535;  // index 65535 is reserved: primitive restart
  const auto add = [&]<typename Index>(const ElementKind& kind) {
    std::vector<Index> indices;
    indices.reserve(3 * part.triangles.size());
    for (const auto& t : part.triangles)
      for (const auto i : t) indices.push_back(static_cast<Index>(i));
    const auto accessor = add_array(model, indices, kind);
    model.accessors[accessor].count = indices.size();
    return accessor;
  };
  return fits_short ? add.template operator()<std::uint16_t>(short_index)
                    : add.template operator()<std::uint32_t>(long_index);
}

tinygltf::Primitive add_primitive(tinygltf::Model& model, const LitMesh& mesh, const LitPart& part) {
  const auto columns = columns_of(mesh, part);
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;

  const auto position = add_array(model, columns.position, vector_of_floats);
  const auto &low = columns.bounds.low, &high = columns.bounds.high;
  model.accessors[position].minValues = {low.x, low.y, low.z};
  model.accessors[position].maxValues = {high.x, high.y, high.z};
  primitive.attributes["POSITION"] = position;
  primitive.attributes["NORMAL"] = add_array(model, columns.normal, vector_of_floats);
  const auto colour = add_array(model, columns.colour, rgba_of_shorts);
  model.accessors[colour].normalized = true;
  primitive.attributes["COLOR_0"] = colour;
  primitive.indices = add_indices(model, part);
  return primitive;
}

// The light is in the colours already, so nothing may be lit again. Rough and not metallic is what the
// extension asks for, for programs that do not know it.
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

void add_mesh(tinygltf::Model& model, const PatchSet& patches, const LitMesh& mesh) {
  tinygltf::Mesh lit;
  lit.name = "lit surfaces";
  auto last_material = std::numeric_limits<std::size_t>::max();
  for (const auto& part : mesh.parts()) {
    if (part.material != last_material)
      model.materials.push_back(unlit_material(patches.materials[part.material].name));
    last_material = part.material;
    lit.primitives.push_back(add_primitive(model, mesh, part));
    lit.primitives.back().material = static_cast<int>(model.materials.size() - 1);
  }
  model.meshes.push_back(std::move(lit));
}

// The quaternion (x, y, z, w) of the shortest turn from up to +Y: up x y for the axis and 1 + up.y for the
// angle, as half angles would have it. Empty where there is nothing to turn.
std::vector<double> turn_to_y_up(const Vec3& up) {
  const auto length = glm::length(Vec3d(up));
  if (!(length > 0.0) || !std::isfinite(length))
    throw InputError(fmt::format("the direction upwards must be a vector of some length, but it is {} {} {}",
                                 up.x, up.y, up.z));
  const auto u = Vec3d(up) / length;
  if (u.y >= 1.0) return {};
  const auto axis = glm::cross(u, Vec3d(0.0, 1.0, 0.0));
  const auto w = 1.0 + u.y;
  const auto norm = std::sqrt(glm::dot(axis, axis) + w * w);
  if (norm < 1e-6) return {1.0, 0.0, 0.0, 0.0};  // upside down: half a turn about any level axis
  return {axis.x / norm, axis.y / norm, axis.z / norm, w / norm};
}

void add_root(tinygltf::Model& model, const Vec3& up) {
  tinygltf::Node root;
  root.name = "scene";
  root.mesh = 0;
  root.rotation = turn_to_y_up(up);
  model.nodes.push_back(std::move(root));
  tinygltf::Scene scene;
  scene.nodes.push_back(0);
  model.scenes.push_back(std::move(scene));
  model.defaultScene = 0;
}

tinygltf::Value provenance_of(const Solution& solution) {
  const auto& from = solution.provenance;
  return tinygltf::Value(tinygltf::Value::Object{
      {"method", tinygltf::Value(valid_utf8(from.method))},
      {"rays", tinygltf::Value(static_cast<double>(from.rays))},
      {"seed", tinygltf::Value(fmt::format("{}", from.seed))},
      {"unshot_share", tinygltf::Value(solution.unshot_share)},
      {"predicted_error", tinygltf::Value(solution.predicted_error)},
      {"scene_fingerprint", tinygltf::Value(fmt::format("{:016x}", from.scene_fingerprint))},
  });
}

// A GLB states its length in 32 bits; a mebibyte is left for the JSON.
void check_size(const std::filesystem::path& path, const tinygltf::Model& model) {
  constexpr std::size_t limit = (std::size_t{1} << 32) - (std::size_t{1} << 20);
  const auto bytes = model.buffers[0].data.size();
  if (bytes > limit)
    throw InputError(path.string(), fmt::format("the lit mesh needs {} bytes but a GLB file holds 4 GiB: "
                                                "cut the scene into larger patches",
                                                bytes));
}

}  // namespace

void export_glb(const std::filesystem::path& path, const PatchSet& patches, const Solution& solution,
                const SmoothLight& light, const Vec3& up, const ExportOptions& options) {
  const LitMesh mesh(patches, solution, light, options.tone);
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = valid_utf8("Luxel " + solution.provenance.program_version);
  model.asset.extras = provenance_of(solution);
  if (!mesh.parts().empty()) {  // glTF knows no empty mesh
    model.extensionsUsed = {"KHR_materials_unlit"};
    model.buffers.emplace_back();
    add_mesh(model, patches, mesh);
    add_root(model, up);
    check_size(path, model);
  }
  std::ostringstream stream;
  tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, stream, false, true);
  write_file(path, stream.view());
}

}  // namespace luxel
