// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace luxel {

class GltfFile;

// A glTF file's JSON without compression, and the bytes of the buffers that it has of its own.
struct DecompressedGltf {
  std::string text;
  std::map<std::size_t, std::string> buffers;
};

// Decodes meshes in KHR_draco_mesh_compression and arrays in EXT_meshopt_compression: the same file with
// plain bufferViews, in a buffer behind its own. Returns nothing where the file uses neither. Throws
// InputError with the JSON path where the data is damaged or would be larger than 4 GiB.
std::optional<DecompressedGltf> decompress_gltf(GltfFile& file);

}  // namespace luxel
