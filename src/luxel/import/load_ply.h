// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "luxel/core/context.h"
#include "luxel/import/load_scene.h"

namespace luxel {

// load_scene() for PLY, without the options that need no file format. Its colours, of faces or else of
// vertices, become the reflectance; where it names textures, these do.
Scene load_ply(const std::filesystem::path& path, const LoadOptions& options, const Context& context);

// The same for a file in memory; path gives its name and where its textures lie.
Scene load_ply(std::string_view bytes, const std::filesystem::path& path, const LoadOptions& options,
               const Context& context);

}  // namespace luxel
