// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "luxel/import/load_scene.h"

namespace luxel {

// Applies the options to a scene whose surfaces are read, from a file or from arrays: repairs, materials,
// sky, luminaires, spectra. path: of the scene; luminaires that its materials name are looked for beside it.
// scale and max_reflectance are for readers and not used here. Throws InputError.
void finish_scene(const std::filesystem::path& path, const LoadOptions& options, Scene& scene,
                  const Context& context);

}  // namespace luxel
