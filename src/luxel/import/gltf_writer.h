// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "luxel/core/json.h"
#include "luxel/core/vector.h"
#include "luxel/import/gltf_file.h"

namespace luxel {

// Writes a glTF file as one GLB: a new file, or an editable copy of another. A copy preserves all content of
// the original, including unknown parts, and all of its bytes; its buffers, and pictures in files of their
// own, are embedded. Additions are appended. Values in the JSON are named by their paths ("/meshes/3/name"),
// as in errors.
class GltfWriter {
 public:
  // A file without content.
  GltfWriter();
  // A copy. Throws InputError where a buffer is missing or shorter than declared, even for parts that are not
  // read; a missing picture stays missing.
  explicit GltfWriter(GltfFile& file);
  ~GltfWriter();

  bool has(const std::string& path) const;
  std::size_t size(const std::string& path) const;  // of an array or object; 0 where there is none
  std::vector<std::string> keys(const std::string& path) const;  // of an object; none where there is none
  std::size_t index_at(const std::string& path) const;
  double number_at(const std::string& path, double otherwise) const;
  std::string text_at(const std::string& path, const std::string& otherwise) const;

  // Sets the value at a path: put("/materials/0/doubleSided", true). Missing parents are created.
  void put(const std::string& path, const Json& value);
  void put_copy(const std::string& path, const std::string& of);
  void erase(const std::string& path);  // if it is there; of an array those behind it move up
  // Appends a value, or a copy of the value at another place, to an array, which is made if missing; returns
  // its index.
  std::size_t append(const std::string& array, const Json& value);
  std::size_t append_copy(const std::string& array, const std::string& of);
  // Adds the name to extensionsUsed if it is not among them.
  void use_extension(std::string_view name);

  // Append arrays of vertices, without gaps; each returns its accessor. Positions get the bounds that glTF
  // requires. None may be empty.
  std::size_t add_positions(std::span<const Vec3> values);
  std::size_t add_vectors(std::span<const Vec3> values);
  std::size_t add_vectors(std::span<const Vec2> values);
  std::size_t add_colours(std::span<const std::array<std::uint16_t, 4>> values);  // normalised RGBA
  std::size_t add_joints(std::span<const std::array<std::uint16_t, 4>> values);   // as they are
  // components: 1 to 4, of each element.
  std::size_t add_floats(std::span<const float> values, int components);
  std::size_t add_indices(std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t vertices);
  // A PNG or JPEG file; gives its image.
  std::size_t add_picture(std::string_view bytes, std::string_view type, std::string_view name);

  // The file, without arrays that nothing names and textures that no material uses any more. Throws
  // InputError, naming `source`, where it is beyond the 4 GiB of a GLB.
  std::string bytes(const std::string& source) const;

 private:
  struct Document;
  struct Element;
  std::size_t add_view(std::string_view bytes, int target);
  std::size_t add_array(std::string_view bytes, std::size_t count, const Element& element);
  void take_buffers(GltfFile& file);
  void take_pictures(GltfFile& file);

  std::unique_ptr<Document> document_;
  std::string bytes_;
};

}  // namespace luxel
