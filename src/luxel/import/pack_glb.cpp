// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/pack_glb.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/none.h"
#include "luxel/import/array_store.h"
#include "luxel/import/drop_unused.h"
#include "luxel/import/glb_container.h"
#include "luxel/import/gltf_array.h"
#include "luxel/import/gltf_file.h"
#include "luxel/import/gltf_parts.h"
#include "luxel/import/meshopt_encode.h"
#include "luxel/import/packed_column.h"
#include "luxel/import/position_grid.h"

namespace luxel {
namespace {

constexpr std::size_t triangle_list = 4;  // glTF's mode
constexpr int f32 = 5126;

// Returns whether all arrays of a primitive can be read and belong together.
bool is_readable(GltfFile& file, const JsonValue& primitive) {
  try {
    const auto attributes = primitive["attributes"];
    const GltfArray positions(file, attributes["POSITION"], 3, 3);
    for (const auto& name : attributes.keys())
      if (GltfArray(file, attributes[name], 1, 4).size() != positions.size()) return false;
    if (primitive["mode"].whole(triangle_list) == triangle_list)
      triangle_corners(file, primitive, positions.size());
    else if (const auto index = primitive["indices"])
      if (!GltfArray(file, index, 1, 1).is_unsigned()) return false;
    return positions.size() > 0;
  } catch (const InputError&) {
    return false;  // another program may read it
  }
}

bool may_be_packed(GltfFile& file, const JsonValue& primitive) {
  return primitive["targets"].size() == 0 && !primitive["attributes"]["JOINTS_0"] &&
         is_readable(file, primitive);
}

class GlbPacker {
 public:
  GlbPacker(GltfFile& file, const GltfPacking& packing)
      : file_(file), packing_(packing), root_(SortedJson::parse(file.text())), store_(root_) {}

  // Returns false where there is nothing to pack; the file may have changed then.
  bool run();
  std::string bytes(const std::string& source) { return glb_container(root_, binary_, source); }

 private:
  std::vector<bool> packable_meshes();
  void find_grids(const std::vector<bool>& is_packable);
  void pack(const JsonValue& primitive, SortedJson& changed, const PositionGrid* grid);
  const MeshOrder* order_of(const JsonValue& primitive, std::size_t vertices);
  std::size_t column(const std::string& name, const JsonValue& index, const JsonValue& indices,
                     const MeshOrder* order, const PositionGrid* grid);
  std::size_t indices(const JsonValue& primitive, const MeshOrder* order, std::size_t vertices);
  void place_meshes();
  void require(const char* extension);

  GltfFile& file_;
  const GltfPacking& packing_;
  SortedJson root_;
  std::string binary_;
  ArrayStore store_;
  std::vector<std::optional<PositionGrid>> grids_;  // [mesh]
  bool is_quantised_ = false;                       // beyond glTF without extensions
  // Arrays that several primitives share stay shared. By accessors; none: not reordered.
  std::map<std::pair<std::size_t, std::size_t>, MeshOrder> orders_;
  std::map<std::tuple<std::size_t, std::size_t, std::string, std::array<double, 4>>, std::size_t> columns_;
  std::map<std::tuple<std::size_t, std::size_t, bool, bool>, std::size_t> indices_;
};

// [mesh]
std::vector<bool> GlbPacker::packable_meshes() {
  const auto meshes = file_.root()["meshes"], nodes = file_.root()["nodes"];
  std::vector<bool> is_packable(meshes.size());
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const auto primitives = meshes[m]["primitives"];
    is_packable[m] = true;
    for (std::size_t p = 0; is_packable[m] && p < primitives.size(); ++p)
      is_packable[m] = may_be_packed(file_, primitives[p]);
  }
  for (std::size_t n = 0; n < nodes.size(); ++n)
    if (nodes[n]["skin"] || nodes[n]["weights"])
      if (const auto mesh = nodes[n]["mesh"].whole(none); mesh < meshes.size()) is_packable[mesh] = false;
  return is_packable;
}

void GlbPacker::find_grids(const std::vector<bool>& is_packable) {
  const auto meshes = file_.root()["meshes"];
  grids_.resize(meshes.size());
  if (packing_.core_only) return;
  auto may_have = is_packable;
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const auto primitives = meshes[m]["primitives"];
    for (std::size_t p = 0; may_have[m] && p < primitives.size(); ++p)
      may_have[m] =
          file_.object(primitives[p]["attributes"]["POSITION"], "accessors")["componentType"].whole() == f32;
  }
  grids_ = position_grids(file_, may_have, packing_);
}

// Null where the order stays.
const MeshOrder* GlbPacker::order_of(const JsonValue& primitive, std::size_t vertices) {
  const auto index = primitive["indices"];
  if (packing_.compression != GltfCompression::meshopt || !index ||
      primitive["mode"].whole(triangle_list) != triangle_list)
    return nullptr;
  const auto [found, is_new] = orders_.try_emplace({index.whole(), vertices});
  if (is_new) found->second = meshopt_order(triangle_corners(file_, primitive, vertices), vertices);
  return found->second.triangles.empty() ? nullptr : &found->second;
}

std::size_t GlbPacker::column(const std::string& name, const JsonValue& index, const JsonValue& order_index,
                              const MeshOrder* order, const PositionGrid* grid) {
  std::array<double, 4> place{};
  if (name == "POSITION" && grid) place = {grid->step, grid->origin.x, grid->origin.y, grid->origin.z};
  // TEXCOORD_0 and TEXCOORD_1 may be one array.
  const auto kind = name.starts_with("TEXCOORD_") ? std::string("TEXCOORD_") : name;
  const auto [found, is_new] =
      columns_.try_emplace({index.whole(), order ? order_index.whole() : none, kind, place}, 0);
  if (is_new) {
    const GltfArray array(file_, index, 1, 4);
    const auto packed =
        packed_column(name, array, grid, order ? order->vertices : std::vector<std::uint32_t>(), packing_);
    is_quantised_ = is_quantised_ || packed.needs_extension;
    found->second = store_.add(kind, packed);
  }
  return found->second;
}

std::size_t GlbPacker::indices(const JsonValue& primitive, const MeshOrder* order, std::size_t vertices) {
  const auto index = primitive["indices"];
  const bool is_list = primitive["mode"].whole(triangle_list) == triangle_list;
  const auto [found, is_new] = indices_.try_emplace({index.whole(), vertices, order != nullptr, is_list}, 0);
  if (!is_new) return found->second;
  std::vector<std::uint32_t> values;
  if (order) {
    for (const auto& triangle : order->triangles)
      values.insert(values.end(), triangle.begin(), triangle.end());
    vertices = order->vertices.size();
  } else {
    const GltfArray array(file_, index, 1, 1);
    for (std::size_t i = 0; i < array.size(); ++i) values.push_back(array.index_at(i));
  }
  return found->second = store_.add_indices(values, vertices, is_list);
}

void GlbPacker::pack(const JsonValue& primitive, SortedJson& changed, const PositionGrid* grid) {
  const auto attributes = primitive["attributes"];
  const auto vertices = GltfArray(file_, attributes["POSITION"], 3, 3).size();
  const auto* order = order_of(primitive, vertices);
  for (const auto& name : attributes.keys())
    changed["attributes"][name] = column(name, attributes[name], primitive["indices"], order, grid);
  if (primitive["indices"]) changed["indices"] = indices(primitive, order, vertices);
}

// The mesh of a node goes to a child, which has the transform of the grid.
void GlbPacker::place_meshes() {
  auto& nodes = root_["nodes"];
  const auto count = nodes.size();
  for (std::size_t n = 0; n < count; ++n) {
    const auto index = nodes[n].find("mesh");
    if (index == nodes[n].end() || !index->is_number_unsigned()) continue;
    const auto mesh = index->get<std::size_t>();
    if (mesh >= grids_.size() || !grids_[mesh] || grids_[mesh]->as_floats) continue;
    const auto& grid = grids_[mesh];
    SortedJson child = {{"mesh", mesh},
                        {"translation", {grid->origin.x, grid->origin.y, grid->origin.z}},
                        {"scale", {grid->step, grid->step, grid->step}}};
    if (nodes[n].contains("name"))
      child["name"] = nodes[n]["name"];
    else if (!root_["meshes"][mesh].contains("name"))
      child["name"] = fmt::format("node {}", n);  // as a reader calls it, see gltf_parts.h
    nodes[n].erase("mesh");
    nodes[n]["children"].push_back(nodes.size());
    nodes.push_back(std::move(child));
  }
}

void GlbPacker::require(const char* extension) {
  for (const auto* list : {"extensionsUsed", "extensionsRequired"}) {
    auto& names = root_[list];
    if (std::find(names.begin(), names.end(), extension) == names.end()) names.push_back(extension);
  }
}

bool GlbPacker::run() {
  if (!uses_known_extensions(root_) || file_.root()["buffers"].size() != 1) return false;
  const auto is_packable = packable_meshes();
  if (std::find(is_packable.begin(), is_packable.end(), true) == is_packable.end()) return false;
  find_grids(is_packable);
  binary_ = file_.buffer(0);
  const auto meshes = file_.root()["meshes"];
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const auto primitives = meshes[m]["primitives"];
    for (std::size_t p = 0; is_packable[m] && p < primitives.size(); ++p)
      pack(primitives[p], root_["meshes"][m]["primitives"][p], grids_[m] ? &*grids_[m] : nullptr);
  }
  if (root_.contains("nodes")) place_meshes();
  if (is_quantised_) require("KHR_mesh_quantization");
  store_.append_views(binary_);
  drop_unused(root_, binary_, {});
  if (packing_.compression == GltfCompression::meshopt) {
    store_.compress_views(binary_);
    require("EXT_meshopt_compression");
  }
  return true;
}

}  // namespace

std::string packed_glb(std::string glb, const std::string& source, const GltfPacking& packing) {
  if (packing.compression == GltfCompression::plain) return glb;
  {
    GltfFile file(glb, source, known_extensions());
    GlbPacker packer(file, packing);
    if (!packer.run()) return glb;
    auto packed = packer.bytes(source);
    if (packed.size() < glb.size()) return packed;
  }
  // For very small meshes the JSON of the extensions takes more bytes than they save.
  if (packing.compression == GltfCompression::quantised) return glb;
  auto uncompressed = packing;
  uncompressed.compression = GltfCompression::quantised;
  return packed_glb(std::move(glb), source, uncompressed);
}

}  // namespace luxel
