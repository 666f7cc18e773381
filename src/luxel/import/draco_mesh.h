// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace luxel {

// An error in compressed bytes, or a library that this build lacks; its text does not yet name the file.
struct CompressionError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// An attribute to decode: its id in the Draco data, and what its numbers become.
struct DracoColumn {
  std::size_t id = 0;
  std::size_t component = 0;   // 5120 to 5126, as glTF names types
  std::size_t components = 1;  // per vertex, 1 to 4
};

struct DracoMesh {
  std::size_t vertices = 0;
  std::vector<std::uint32_t> indices;  // three per triangle, below `vertices`
  std::vector<std::string> columns;    // [column]: little-endian numbers, each vertex padded to four bytes
};

// The bytes of one vertex in a column.
std::size_t draco_stride(const DracoColumn& column);

// Decodes a mesh compressed by Draco, bitstream 2.2. Throws CompressionError where the bytes are damaged,
// declare more triangles than their size can hold, or lack an attribute, and where Luxel was built without
// Draco.
DracoMesh decode_draco(std::string_view bytes, std::span<const DracoColumn> columns);

}  // namespace luxel
