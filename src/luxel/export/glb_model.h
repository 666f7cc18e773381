// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include <tiny_gltf.h>

#include "luxel/core/bounds.h"
#include "luxel/export/quantise.h"

namespace luxel {

// What every GLB we write is made of: arrays in one buffer, unlit materials, a root that turns the scene Y
// up. The home of TinyGLTF's header, together with the files that include this one.

static_assert(std::endian::native == std::endian::little, "a GLB's numbers are little-endian, as ours are");

struct GlbElement {
  int component, type, target;
};
inline constexpr GlbElement vector_of_floats = {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3,
                                                TINYGLTF_TARGET_ARRAY_BUFFER};
inline constexpr GlbElement rgba_of_shorts = {TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_VEC4,
                                              TINYGLTF_TARGET_ARRAY_BUFFER};
inline constexpr GlbElement short_index = {TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR,
                                           TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER};
inline constexpr GlbElement long_index = {TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR,
                                          TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER};

// Appends an array to the one buffer, in a view of its own; returns its accessor.
template <typename T>
int add_array(tinygltf::Model& model, const std::vector<T>& values, const GlbElement& element) {
  auto& bytes = model.buffers[0].data;
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = bytes.size();
  view.byteLength = values.size() * sizeof(T);
  view.target = element.target;
  bytes.resize((bytes.size() + view.byteLength + 3) / 4 * 4);  // every array begins at a multiple of four
  std::memcpy(bytes.data() + view.byteOffset, values.data(), view.byteLength);
  model.bufferViews.push_back(view);

  tinygltf::Accessor accessor;
  accessor.bufferView = static_cast<int>(model.bufferViews.size() - 1);
  accessor.componentType = element.component;
  accessor.type = element.type;
  accessor.count = values.size();
  model.accessors.push_back(accessor);
  return static_cast<int>(model.accessors.size() - 1);
}

// POSITION with the box that glTF asks for, and COLOR_0. Neither may be empty.
void add_vertices(tinygltf::Model& model, tinygltf::Primitive& primitive, const std::vector<Vec3>& positions,
                  const std::vector<Rgba16>& colours);

// The accessor of the indices of triangles among so many vertices, short where they fit.
int add_indices(tinygltf::Model& model, const std::vector<std::array<std::uint32_t, 3>>& triangles,
                std::size_t vertices);

// The colours are what is to be seen, so nothing may be lit again. Rough and not metallic is what the
// extension asks for, for programs that do not know it. The model must list KHR_materials_unlit among its
// extensions.
tinygltf::Material unlit_material(const std::string& name);

// Makes the node the one scene's root: it turns `up` to +Y by the shortest way, and puts the scene's zero
// where its origin (m) comes to lie by that. Throws InputError where up has no length.
void add_root(tinygltf::Model& model, tinygltf::Node root, const Vec3& up, const Vec3d& origin);

// Writes the model, whole or not at all. Throws InputError where it is beyond the 4 GiB of a GLB,
// DeviceError.
void write_glb(const std::filesystem::path& path, tinygltf::Model& model);

}  // namespace luxel
