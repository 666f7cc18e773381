// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace luxel {

// Returns whether a file is glTF, by its extension: .glb or .gltf, in lower or upper case. The reader and the
// round trip of glTF both use it, so that they agree.
bool is_gltf(const std::filesystem::path& path);

}  // namespace luxel
