// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace luxel {

// The folder of a scene's file, and the files that this file names: buffers, materials, pictures, luminaires.
// A scene may be untrusted: files that it names are read only where they lie in the folder or below, with all
// links followed, unless the user allows more (LoadOptions::allow_outside).
class SceneFolder {
 public:
  explicit SceneFolder(const std::filesystem::path& scene_file, bool allow_outside = false);

  bool permits(const std::filesystem::path& file) const;
  bool allows_outside() const { return allow_outside_; }

  struct Found {
    std::optional<std::filesystem::path> file = {};  // that may be read
    bool is_outside = false;                         // there is one, but it may not be read
  };
  // The plain file that a name inside an OBJ, MTL or PLY file means: below `folder` as written, with
  // backslashes for slashes, or, for the whole paths of another machine, the last part alone beside the file.
  Found find(const std::filesystem::path& folder, const std::string& name) const;

 private:
  std::filesystem::path folder_;  // its real place
  bool allow_outside_;
};

// Throws the InputError of a file outside the folder. place: where it is named, "room.obj:1"; what: "the file
// 'x.bin'".
[[noreturn]] void refuse_outside(const std::string& place, const std::string& what);

// Files that were read for a scene, each once, in their order.
void add_file(std::vector<std::filesystem::path>& files, const std::filesystem::path& file);

}  // namespace luxel
