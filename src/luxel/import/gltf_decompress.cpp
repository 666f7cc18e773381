// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/gltf_decompress.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "luxel/core/json.h"
#include "luxel/import/draco_mesh.h"
#include "luxel/import/gltf_file.h"
#include "luxel/import/meshopt_view.h"

namespace luxel {
namespace {

constexpr const char* draco = "KHR_draco_mesh_compression";
constexpr const char* meshopt = "EXT_meshopt_compression";
constexpr std::size_t max_decoded = std::size_t{4} << 30;  // bytes, as a GLB has at most
constexpr int u32 = 5125;

std::size_t components_of(const JsonValue& type) {
  constexpr auto names = std::to_array<std::string_view>({"SCALAR", "VEC2", "VEC3", "VEC4"});
  const auto found = std::find(names.begin(), names.end(), type.text());
  if (found == names.end()) type.refuse("expected SCALAR, VEC2, VEC3 or VEC4");
  return 1 + static_cast<std::size_t>(found - names.begin());
}

// Removes an extension from an object of the file, and the list of extensions where it was the only one.
void erase_extension(SortedJson& owner, const char* name) {
  const auto all = owner.find("extensions");
  if (all == owner.end() || !all->is_object()) return;
  all->erase(name);
  if (all->empty()) owner.erase("extensions");
}

class Decompressor {
 public:
  explicit Decompressor(GltfFile& file) : file_(file), root_(SortedJson::parse(file.text())) {}

  DecompressedGltf run() {
    decode_views();
    decode_meshes();
    empty_fallbacks();
    for (const auto* list : {"extensionsUsed", "extensionsRequired"}) drop_names(list);
    const auto number = file_.root()["buffers"].size();
    root_["buffers"].push_back({{"byteLength", bytes_.size()}});
    buffers_[number] = std::move(bytes_);
    return {json_text(root_), std::move(buffers_)};
  }

 private:
  void decode_views();
  void decode_meshes();
  void decode_primitive(const JsonValue& primitive, SortedJson& changed);
  void empty_fallbacks();
  void drop_names(const char* list);
  SortedJson view_of(const std::string& bytes, const JsonValue& source);
  std::size_t add_accessor(const JsonValue& old, const std::string& bytes, std::size_t count,
                           std::size_t stride);
  // Runs a decoder; its error becomes one that names the place.
  template <typename Decode>
  static auto decoded(const JsonValue& place, const Decode& decode) {
    try {
      return decode();
    } catch (const CompressionError& error) {
      place.refuse(error.what());
    }
  }

  GltfFile& file_;
  SortedJson root_;
  std::string bytes_;
  std::map<std::size_t, std::string> buffers_;
};

// Appends the bytes and returns a bufferView of them.
SortedJson Decompressor::view_of(const std::string& bytes, const JsonValue& source) {
  if (bytes.size() > max_decoded - bytes_.size())
    source.refuse(fmt::format("the file's arrays would be larger than {} GiB; divide it", max_decoded >> 30));
  SortedJson view = {{"buffer", file_.root()["buffers"].size()},
                     {"byteOffset", bytes_.size()},
                     {"byteLength", bytes.size()}};
  bytes_ += bytes;
  bytes_.resize((bytes_.size() + 3) / 4 * 4);
  return view;
}

void Decompressor::decode_views() {
  const auto views = file_.root()["bufferViews"];
  for (std::size_t i = 0; i < views.size(); ++i) {
    const auto extension = views[i]["extensions"][meshopt];
    if (!extension) continue;
    const MeshoptView view = {extension["count"].whole(), extension["byteStride"].whole(),
                              extension["mode"].text(), extension["filter"].text("NONE")};
    const auto bytes = file_.range(extension);
    auto changed = view_of(decoded(extension, [&] { return decode_meshopt(bytes, view); }), extension);
    if (view.mode == "ATTRIBUTES" && views[i]["byteStride"]) changed["byteStride"] = view.stride;
    if (views[i]["target"]) changed["target"] = views[i]["target"].whole();
    root_["bufferViews"][i] = std::move(changed);
  }
}

void Decompressor::decode_meshes() {
  const auto meshes = file_.root()["meshes"];
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const auto primitives = meshes[m]["primitives"];
    for (std::size_t p = 0; p < primitives.size(); ++p)
      if (primitives[p]["extensions"][draco])
        decode_primitive(primitives[p], root_["meshes"][m]["primitives"][p]);
  }
}

// Accessors may be shared with primitives that have other compressed data, so each primitive gets copies.
void Decompressor::decode_primitive(const JsonValue& primitive, SortedJson& changed) {
  const auto extension = primitive["extensions"][draco];
  erase_extension(changed, draco);
  const auto attributes = primitive["attributes"];
  const auto position = file_.object(attributes["POSITION"], "accessors");
  if (position["bufferView"]) return;  // the file has the uncompressed mesh too
  std::vector<DracoColumn> columns;
  std::vector<std::string> names;
  for (const auto& name : extension["attributes"].keys()) {
    if (!attributes[name]) continue;
    const auto accessor = file_.object(attributes[name], "accessors");
    columns.push_back({extension["attributes"][name].whole(), accessor["componentType"].whole(),
                       components_of(accessor["type"])});
    names.push_back(name);
  }
  const auto bytes = file_.view(extension["bufferView"]);
  const auto mesh = decoded(extension, [&] { return decode_draco(bytes, columns); });
  for (std::size_t c = 0; c < columns.size(); ++c)
    changed["attributes"][names[c]] =
        add_accessor(attributes[names[c]], mesh.columns[c], mesh.vertices, draco_stride(columns[c]));
  const std::string indices(reinterpret_cast<const char*>(mesh.indices.data()), 4 * mesh.indices.size());
  changed["indices"] = add_accessor(primitive["indices"], indices, mesh.indices.size(), 0);
  changed.erase("mode");
}

// stride: 0 of indices.
std::size_t Decompressor::add_accessor(const JsonValue& old, const std::string& bytes, std::size_t count,
                                       std::size_t stride) {
  SortedJson accessor = {{"componentType", u32}, {"type", "SCALAR"}};
  if (stride > 0) {
    file_.object(old, "accessors");
    accessor = root_["accessors"][old.whole()];
    accessor.erase("byteOffset");
  }
  auto view = view_of(bytes, old);
  if (stride > 0) view["byteStride"] = stride;
  auto& views = root_["bufferViews"];
  accessor["bufferView"] = views.size();
  accessor["count"] = count;
  views.push_back(std::move(view));
  root_["accessors"].push_back(std::move(accessor));
  return root_["accessors"].size() - 1;
}

// Fallback buffers, which only programs without the extension read, have no bytes of their own.
void Decompressor::empty_fallbacks() {
  const auto buffers = file_.root()["buffers"];
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    const auto extension = buffers[i]["extensions"][meshopt];
    if (!extension) continue;
    auto& changed = root_["buffers"][i];
    erase_extension(changed, meshopt);
    if (buffers[i]["uri"] || !extension["fallback"].truth(false)) continue;
    changed["byteLength"] = 0;
    buffers_[i] = {};
  }
}

void Decompressor::drop_names(const char* list) {
  const auto found = root_.find(list);
  if (found == root_.end() || !found->is_array()) return;
  auto kept = SortedJson::array();
  for (const auto& name : *found)
    if (name != draco && name != meshopt) kept.push_back(name);
  if (kept.empty())
    root_.erase(list);
  else
    *found = std::move(kept);
}

}  // namespace

std::optional<DecompressedGltf> decompress_gltf(GltfFile& file) {
  const auto text = file.text();
  if (text.find(draco) == text.npos && text.find(meshopt) == text.npos) return std::nullopt;
  return Decompressor(file).run();
}

}  // namespace luxel
