// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "luxel/export/target_application.h"
#include "luxel/import/gltf_writer.h"

namespace luxel {

// Writes the file atomically, its meshes stored by `compression`, as far as the program reads it. Throws
// DeviceError, and InputError where the compression is not available or the file is beyond 4 GiB.
void write_glb(const std::filesystem::path& path, const GltfWriter& file, TargetApplication program,
               MeshCompression compression, double metres_per_unit = 1.0);

}  // namespace luxel
