// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace luxel {

// Whether a file is glTF, by its ending: .glb or .gltf, in small letters or large. The one place where that
// is told: what is read as glTF is kept as glTF.
bool is_gltf(const std::filesystem::path& path);

}  // namespace luxel
