// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "luxel/import/gltf_array.h"
#include "luxel/import/gltf_packing.h"
#include "luxel/import/position_grid.h"

namespace luxel {

// An attribute of vertices as it is stored: elements of `stride` bytes, a multiple of 4.
struct PackedColumn {
  std::string bytes;
  std::size_t count = 0, stride = 0;
  int component = 0;  // glTF's number of the type
  int components = 0;
  bool is_normalised = false;
  bool needs_extension = false;         // KHR_mesh_quantization
  std::array<double, 3> low{}, high{};  // of positions, as they are stored
};

// Returns the attribute `name` in the smallest type in which it looks the same: positions on the grid, null:
// as they are; unit vectors in 8 bits; texture coordinates within [0, 1] in 16 bits; colours in 16 bits, or
// in 8 where no displayed code changes by more than a half. All else stays as it is. vertices: numbers of
// those that are stored, in their order; empty: all.
PackedColumn packed_column(std::string_view name, const GltfArray& array, const PositionGrid* grid,
                           const std::vector<std::uint32_t>& vertices, const GltfPacking& packing);

}  // namespace luxel
