// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/drop_unused.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace luxel {
namespace {

constexpr std::size_t alignment = 4;

// Extensions that reference neither accessors nor buffer views, and textures only as glTF itself does.
bool is_harmless(const std::string& extension) {
  return extension.starts_with("KHR_materials_") || extension.starts_with("KHR_texture_transform") ||
         extension == "KHR_lights_punctual" || extension == "KHR_mesh_quantization" ||
         extension == "EXT_texture_webp" || extension == "KHR_texture_basisu" ||
         extension == "KHR_xmp_json_ld" || extension == "MOZ_lightmap";
}

// Visits every place that references an accessor, a buffer view, and so on.
using Visit = std::function<void(SortedJson&)>;
using Names = std::function<void(SortedJson&, const Visit&)>;

void each_of(SortedJson& owner, const char* member, const Visit& visit) {
  if (const auto found = owner.find(member); found != owner.end())
    for (auto& each : *found) visit(each);
}

void at_member(SortedJson& owner, const char* member, const Visit& visit) {
  if (const auto found = owner.find(member); found != owner.end()) visit(*found);
}

void visit_accessor_names(SortedJson& root, const Visit& visit) {
  each_of(root, "meshes", [&](SortedJson& mesh) {
    each_of(mesh, "primitives", [&](SortedJson& primitive) {
      at_member(primitive, "indices", visit);
      each_of(primitive, "attributes", visit);
      each_of(primitive, "targets", [&](SortedJson& target) {
        for (auto& attribute : target) visit(attribute);
      });
    });
  });
  each_of(root, "skins", [&](SortedJson& skin) { at_member(skin, "inverseBindMatrices", visit); });
  each_of(root, "animations", [&](SortedJson& animation) {
    each_of(animation, "samplers", [&](SortedJson& sampler) {
      at_member(sampler, "input", visit);
      at_member(sampler, "output", visit);
    });
  });
}

void visit_view_names(SortedJson& root, const Visit& visit) {
  each_of(root, "accessors", [&](SortedJson& accessor) {
    at_member(accessor, "bufferView", visit);
    at_member(accessor, "sparse", [&](SortedJson& sparse) {
      for (const auto* part : {"indices", "values"})
        at_member(sparse, part, [&](SortedJson& names) { at_member(names, "bufferView", visit); });
    });
  });
  each_of(root, "images", [&](SortedJson& image) { at_member(image, "bufferView", visit); });
}

// The members of a material, at any depth, that reference textures: glTF names them all alike.
void visit_texture_names_of(SortedJson& owner, const Visit& visit) {
  if (!owner.is_object()) return;
  for (const auto& [key, member] : owner.items()) {
    if (key == "extras" || !member.is_object()) continue;
    if (key.ends_with("Texture") || key == "MOZ_lightmap") at_member(member, "index", visit);
    visit_texture_names_of(member, visit);
  }
}

void visit_texture_names(SortedJson& root, const Visit& visit) {
  each_of(root, "materials", [&](SortedJson& material) { visit_texture_names_of(material, visit); });
}

void visit_picture_names(SortedJson& root, const Visit& visit) {
  each_of(root, "textures", [&](SortedJson& texture) {
    at_member(texture, "source", visit);
    each_of(texture, "extensions", [&](SortedJson& extension) { at_member(extension, "source", visit); });
  });
}

void visit_sampler_names(SortedJson& root, const Visit& visit) {
  each_of(root, "textures", [&](SortedJson& texture) { at_member(texture, "sampler", visit); });
}

// Errors in parts of a file that are not read are ignored.
bool names_one_of(const SortedJson& name, std::size_t count) {
  return name.is_number_unsigned() && name.get<std::size_t>() < count;
}

std::size_t size_of(const SortedJson& root, const char* array) {
  const auto found = root.find(array);
  return found != root.end() && found->is_array() ? found->size() : 0;
}

// [element]
std::vector<bool> named(SortedJson& root, const char* array, const Names& names) {
  std::vector<bool> is_named(size_of(root, array), false);
  names(root, [&](SortedJson& name) {
    if (names_one_of(name, is_named.size())) is_named[name.get<std::size_t>()] = true;
  });
  return is_named;
}

// Removes those elements of an array that have no reference and may go, and renumbers the others. may_go:
// [element]; those beyond its end stay.
void drop_unnamed(SortedJson& root, const char* array, const Names& names, const std::vector<bool>& may_go) {
  const auto all = root.find(array);
  if (all == root.end() || !all->is_array()) return;
  const auto is_named = named(root, array, names);
  std::vector<std::size_t> number(is_named.size());
  auto kept = SortedJson::array();
  for (std::size_t i = 0; i < is_named.size(); ++i) {
    number[i] = kept.size();
    if (is_named[i] || i >= may_go.size() || !may_go[i]) kept.push_back(std::move((*all)[i]));
  }
  names(root, [&](SortedJson& name) {
    if (names_one_of(name, number.size())) name = number[name.get<std::size_t>()];
  });
  if (kept.empty())
    root.erase(array);
  else
    root[array] = std::move(kept);
}

void pack_bytes(SortedJson& root, std::string& bytes) {
  std::string packed;
  each_of(root, "bufferViews", [&](SortedJson& view) {
    const auto offset = view.value("byteOffset", std::size_t{0});
    view["byteOffset"] = packed.size();
    packed.append(bytes, offset, view["byteLength"].get<std::size_t>());
    packed.resize((packed.size() + alignment - 1) / alignment * alignment);
  });
  bytes = std::move(packed);
}

}  // namespace

std::vector<bool> used_textures(SortedJson& root) { return named(root, "textures", visit_texture_names); }

bool uses_known_extensions(const SortedJson& root) {
  const auto used = root.find("extensionsUsed");
  return used == root.end() ||
         std::all_of(used->begin(), used->end(), [](const SortedJson& name) { return is_harmless(name); });
}

void drop_unused(SortedJson& root, std::string& bytes, const std::vector<bool>& once_used) {
  if (!uses_known_extensions(root)) return;
  const auto pictures = named(root, "images", visit_picture_names);
  const auto samplers = named(root, "samplers", visit_sampler_names);
  drop_unnamed(root, "textures", visit_texture_names, once_used);
  drop_unnamed(root, "images", visit_picture_names, pictures);
  drop_unnamed(root, "samplers", visit_sampler_names, samplers);
  const auto all = [&](const char* array) { return std::vector<bool>(size_of(root, array), true); };
  drop_unnamed(root, "accessors", visit_accessor_names, all("accessors"));
  drop_unnamed(root, "bufferViews", visit_view_names, all("bufferViews"));
  pack_bytes(root, bytes);
}

}  // namespace luxel
