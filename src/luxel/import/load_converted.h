// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/context.h"
#include "luxel/import/load_scene.h"

namespace luxel {

// Returns whether the file is FBX, COLLADA or 3DS, by its ending.
bool is_converted(const std::filesystem::path& path);

// load_scene() for these, without the options that need no file format: the program luxel-import, a process
// of its own under limits of time and memory, converts the file to a GLB, and load_gltf() reads that.
Scene load_converted(const std::filesystem::path& path, const LoadOptions& options, const Context& context);

}  // namespace luxel
