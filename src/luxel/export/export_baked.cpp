// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/export_mesh.h"
#include "luxel/solution/solution_file.h"

namespace luxel {

void export_glb(const std::filesystem::path& path, const Baked& baked, const ExportOptions& options) {
  const auto light = make_smooth_light(baked.patches, baked.solution, {.lights_hidden = true});
  export_glb(path, baked.patches, baked.solution, light, Vec3(0.0f, 1.0f, 0.0f), options);
}

}  // namespace luxel
