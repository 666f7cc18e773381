// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "luxel/core/context.h"
#include "luxel/import/load_scene.h"

namespace luxel {

// load_scene() for STL, text or binary, without the options that need no file format. All is grey: STL has no
// materials.
Scene load_stl(const std::filesystem::path& path, const LoadOptions& options, const Context& context);

// The same for a file in memory; path gives its name.
Scene load_stl(std::string_view bytes, const std::filesystem::path& path, const LoadOptions& options,
               const Context& context);

}  // namespace luxel
