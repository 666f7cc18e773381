// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "luxel/import/child/foreign_file.h"
#include "luxel/import/gltf_writer.h"

namespace luxel {

// The pictures of a file become images of a GLB: embedded ones with their bytes, others as references
// relative to the folder of the file, so that errors name them as the user does.
class ForeignPictures {
 public:
  ForeignPictures(ForeignFile& file, GltfWriter& glb) : file_(file), glb_(glb) {}

  // Returns the image of the name that a material gives; nothing where it is embedded without compression.
  std::optional<std::size_t> image(const aiString& name);

 private:
  std::optional<std::size_t> add(const aiString& name);

  ForeignFile& file_;
  GltfWriter& glb_;
  std::map<std::string, std::optional<std::size_t>> images_;
};

// Returns where a picture is, relative to `folder`. Files from other machines have whole paths, backslashes
// and capitals that differ: the search tries a relative path itself, then its file name in the folder, in
// `textures` and in `STEM.fbm`, where the FBX SDK unpacks, then a whole path. Returns the file name where
// there is none.
std::filesystem::path find_picture(std::string name, const std::filesystem::path& file);

// Returns a path as a relative URI reference.
std::string uri_of(const std::filesystem::path& path);

}  // namespace luxel
