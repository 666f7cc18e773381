// SPDX-License-Identifier: Apache-2.0
#include "luxel/gltf/drop_unused.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

#include <nlohmann/json.hpp>

namespace luxel {
namespace {

using Json = nlohmann::json;

constexpr std::size_t alignment = 4;

// Extensions that name neither accessors nor views of buffers.
bool is_harmless(const std::string& extension) {
  return extension.starts_with("KHR_materials_") || extension.starts_with("KHR_texture_transform") ||
         extension == "KHR_lights_punctual" || extension == "KHR_mesh_quantization" ||
         extension == "KHR_xmp_json_ld" || extension == "MOZ_lightmap";
}

// Goes to every place that names an accessor, and to every one that names a view.
using Visit = std::function<void(Json&)>;

void each_of(Json& owner, const char* member, const Visit& visit) {
  if (const auto found = owner.find(member); found != owner.end())
    for (auto& each : *found) visit(each);
}

void at_member(Json& owner, const char* member, const Visit& visit) {
  if (const auto found = owner.find(member); found != owner.end()) visit(*found);
}

void visit_accessor_names(Json& root, const Visit& visit) {
  each_of(root, "meshes", [&](Json& mesh) {
    each_of(mesh, "primitives", [&](Json& primitive) {
      at_member(primitive, "indices", visit);
      each_of(primitive, "attributes", visit);
      each_of(primitive, "targets", [&](Json& target) {
        for (auto& attribute : target) visit(attribute);
      });
    });
  });
  each_of(root, "skins", [&](Json& skin) { at_member(skin, "inverseBindMatrices", visit); });
  each_of(root, "animations", [&](Json& animation) {
    each_of(animation, "samplers", [&](Json& sampler) {
      at_member(sampler, "input", visit);
      at_member(sampler, "output", visit);
    });
  });
}

void visit_view_names(Json& root, const Visit& visit) {
  each_of(root, "accessors", [&](Json& accessor) {
    at_member(accessor, "bufferView", visit);
    at_member(accessor, "sparse", [&](Json& sparse) {
      at_member(sparse["indices"], "bufferView", visit);
      at_member(sparse["values"], "bufferView", visit);
    });
  });
  each_of(root, "images", [&](Json& image) { at_member(image, "bufferView", visit); });
}

// Keeps those elements of an array that are named, and renames them.
void keep_named(Json& root, const char* array, const std::function<void(Json&, const Visit&)>& names) {
  const auto all = root.find(array);
  if (all == root.end()) return;
  std::vector<bool> named(all->size(), false);
  names(root, [&](Json& name) { named.at(name.get<std::size_t>()) = true; });
  std::vector<std::size_t> number(named.size());
  auto kept = Json::array();
  for (std::size_t i = 0; i < named.size(); ++i) {
    number[i] = kept.size();
    if (named[i]) kept.push_back(std::move((*all)[i]));
  }
  names(root, [&](Json& name) { name = number[name.get<std::size_t>()]; });
  if (kept.empty())
    root.erase(array);
  else
    root[array] = std::move(kept);
}

void pack_bytes(Json& root, std::string& bytes) {
  std::string packed;
  each_of(root, "bufferViews", [&](Json& view) {
    const auto offset = view.value("byteOffset", std::size_t{0});
    view["byteOffset"] = packed.size();
    packed.append(bytes, offset, view["byteLength"].get<std::size_t>());
    packed.resize((packed.size() + alignment - 1) / alignment * alignment);
  });
  bytes = std::move(packed);
}

}  // namespace

void drop_unused(Json& root, std::string& bytes) {
  if (const auto used = root.find("extensionsUsed"); used != root.end())
    if (!std::all_of(used->begin(), used->end(), [](const Json& name) { return is_harmless(name); })) return;
  keep_named(root, "accessors", visit_accessor_names);
  keep_named(root, "bufferViews", visit_view_names);
  pack_bytes(root, bytes);
}

}  // namespace luxel
