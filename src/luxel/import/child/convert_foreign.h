// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace luxel {

struct ConvertedFile {
  std::string glb;
  std::vector<std::string> messages;  // each "note SENTENCE" or "warning SENTENCE"
};

// Converts an FBX, COLLADA or 3DS file to a GLB: triangles, materials, references to pictures, punctual
// lights and cameras, in metres with +Y up; of 3DS, which states neither, in the coordinates of the file.
// Throws InputError where Assimp refuses the file. A damaged file may also end or block the process.
ConvertedFile convert_foreign(const std::filesystem::path& path);

}  // namespace luxel
