// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/import/load_scene.h"

namespace luxel {

// load_scene() for glTF 2.0, as GLB or as JSON with files beside it, without the options that need no file
// format.
Scene load_gltf(const std::filesystem::path& path, const LoadOptions& options, const LogSink& log,
                const Monitor& monitor);

// The same of a file in memory; path says what it is called and where its other files lie.
Scene load_gltf(std::string bytes, const std::filesystem::path& path, const LoadOptions& options,
                const LogSink& log, const Monitor& monitor);

}  // namespace luxel
