// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace luxel {

// Parameters of a bufferView by EXT_meshopt_compression.
struct MeshoptView {
  std::size_t count = 0;   // elements
  std::size_t stride = 0;  // bytes per element, decoded
  std::string mode;        // ATTRIBUTES, TRIANGLES or INDICES
  std::string filter;      // NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL
};

// Returns the count * stride decompressed bytes. Throws CompressionError where the data are damaged
// or declare more elements than their bytes can hold, and where Luxel was built without
// meshoptimizer.
std::string decode_meshopt(std::string_view bytes, const MeshoptView& view);

}  // namespace luxel
