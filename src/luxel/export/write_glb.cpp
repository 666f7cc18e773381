// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/write_glb.h"

#include "luxel/core/output_file.h"
#include "luxel/import/pack_glb.h"

namespace luxel {
namespace {

GltfPacking packing_for(TargetApplication program, MeshCompression compression, double metres_per_unit) {
  const auto profile = profile_of(program);
  GltfPacking packing;
  packing.max_step /= metres_per_unit;
  packing.core_only = !profile.reads_quantised;
  packing.colours_are_srgb = profile.colours_are_srgb;
  if (compression == MeshCompression::meshopt && profile.reads_meshopt)
    packing.compression = GltfCompression::meshopt;
  else if (compression != MeshCompression::plain)
    packing.compression = GltfCompression::quantised;
  return packing;
}

}  // namespace

void write_glb(const std::filesystem::path& path, const GltfWriter& file, TargetApplication program,
               MeshCompression compression, double metres_per_unit) {
  const auto source = path.string();
  write_file(path,
             packed_glb(file.bytes(source), source, packing_for(program, compression, metres_per_unit)));
}

}  // namespace luxel
