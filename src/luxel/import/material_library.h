// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/import/polygon_mesh.h"
#include "luxel/import/read_mtl.h"

namespace luxel {

// All MTL files of one OBJ file.
struct MaterialLibrary {
  struct Entry {
    MtlMaterial material;
    std::filesystem::path folder;  // of the MTL file; its texture names start there
  };
  std::map<std::string, Entry> entries;  // by material name; the first of a name counts
  std::vector<std::string> files;        // those read, in order
};

// Reads the files that the mtllib statements name, in their order. A missing file is a warning.
MaterialLibrary read_libraries(std::span<const NamedLine> statements, const std::filesystem::path& obj_path,
                               const Context& context);

// The plain file that a name inside an OBJ or MTL file means: below folder as written, with backslashes for
// slashes, or, for the whole paths of another machine, the last part alone beside the file.
std::optional<std::filesystem::path> find_file(const std::filesystem::path& folder, const std::string& name);

}  // namespace luxel
