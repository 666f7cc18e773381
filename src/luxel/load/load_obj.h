// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/load/load_scene.h"

namespace luxel {

// load_scene() for OBJ, without the options that need no file format.
Scene load_obj(const std::filesystem::path& path, const LoadOptions& options, const LogSink& log,
               const Monitor& monitor);

}  // namespace luxel
