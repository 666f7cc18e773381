// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "luxel/core/context.h"
#include "luxel/import/load_scene.h"

namespace luxel {

// load_scene() for OBJ, without the options that need no file format.
Scene load_obj(const std::filesystem::path& path, const LoadOptions& options, const Context& context);

// The same for a text in memory; path gives its name and where its MTL files lie.
Scene load_obj(std::string_view text, const std::filesystem::path& path, const LoadOptions& options,
               const Context& context);

}  // namespace luxel
