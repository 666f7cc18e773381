// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/core/context.h"
#include "luxel/import/load_scene.h"

namespace luxel {

// load_scene() for glTF 2.0, as GLB or as JSON with files beside it, without the options that need no file
// format.
Scene load_gltf(const std::filesystem::path& path, const LoadOptions& options, const Context& context);

// The same for a file in memory; path gives its name and where its other files lie.
Scene load_gltf(std::string bytes, const std::filesystem::path& path, const LoadOptions& options,
                const Context& context);

}  // namespace luxel
