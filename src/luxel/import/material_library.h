// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/import/polygon_mesh.h"
#include "luxel/import/read_mtl.h"
#include "luxel/import/scene_folder.h"

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

// Reads the files that the mtllib statements name, in their order. A missing file is a warning; one that the
// folder does not permit is an InputError.
MaterialLibrary read_libraries(std::span<const NamedLine> statements, const std::filesystem::path& obj_path,
                               const SceneFolder& folder, const Context& context);

}  // namespace luxel
