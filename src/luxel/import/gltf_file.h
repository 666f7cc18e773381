// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "luxel/import/json_value.h"
#include "luxel/import/scene_folder.h"

namespace luxel {

// A glTF 2.0 file as stored: its JSON, and the bytes it refers to, inside it, in data URIs or in files beside
// it. Meshes that Draco or meshoptimizer compressed are decoded when it is opened, so that its contents have
// no compressed ones. Files are named relative to its folder; those that SceneFolder does not permit and
// internet addresses are refused.
class GltfFile {
 public:
  // Reads a GLB (recognised by its first bytes) or the JSON of a .gltf. Throws InputError where it is
  // neither, is damaged or shorter than declared, is not glTF 2, or requires an extension that is not in
  // `extensions`.
  GltfFile(const std::filesystem::path& path, const std::vector<std::string_view>& extensions,
           bool allow_outside = false);
  // The same for a file in memory; path gives its name and where its other files lie.
  GltfFile(std::string bytes, const std::filesystem::path& path,
           const std::vector<std::string_view>& extensions, bool allow_outside = false);
  GltfFile(const GltfFile&) = delete;
  GltfFile& operator=(const GltfFile&) = delete;

  const JsonValue& root() const { return root_; }
  const std::string& source() const { return source_; }

  // Returns the element of the root's array that an index refers to: object(primitive["material"],
  // "materials"). Throws where the array has no such element; the index must exist.
  JsonValue object(const JsonValue& index, std::string_view array) const;

  // Returns the bytes of the bufferView with this index; valid until the file is destroyed. Buffers are read
  // on first use. Not thread-safe.
  std::string_view view(const JsonValue& index);

  // Returns the bytes of the bufferView with this number, which must exist.
  std::string_view view(std::size_t number);

  // Returns the bytes of an object with buffer, byteOffset and byteLength; valid as those of view().
  std::string_view range(const JsonValue& of);

  // Returns the bytes of the buffer with this number; valid as those of view().
  std::string_view buffer(std::size_t number);

  // Returns the JSON as stored, except for what was decoded.
  std::string_view text() const { return text_; }

  // Returns the bytes that a URI refers to. Throws InputError where there is no such file that may be read.
  std::string resource(const JsonValue& uri);

  // The files that were read besides this one.
  const std::vector<std::filesystem::path>& files() const { return files_; }

 private:
  std::string_view read_container();
  void check_version(const std::vector<std::string_view>& extensions) const;

  std::string source_;
  std::filesystem::path folder_;
  SceneFolder permitted_;
  std::vector<std::filesystem::path> files_;
  std::string bytes_;        // the whole file
  std::string_view binary_;  // what a GLB has behind it
  std::string_view text_;
  std::string decoded_text_;  // in place of the file's own where it was compressed
  JsonValue root_;
  std::map<std::size_t, std::string> buffers_;  // those read from elsewhere, or decoded
};

}  // namespace luxel
