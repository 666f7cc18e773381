// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "luxel/import/meshopt_view.h"

namespace luxel {

// Returns whether Luxel was built with meshoptimizer. Without it the functions below throw InputError.
bool has_meshopt();

// Triangles and vertices in the order that compresses best and is drawn fastest.
struct MeshOrder {
  std::vector<std::array<std::uint32_t, 3>> triangles;  // of the new vertices
  std::vector<std::uint32_t> vertices;                  // [new vertex]: the old one; unused ones are left out
};
MeshOrder meshopt_order(const std::vector<std::array<std::uint32_t, 3>>& triangles, std::size_t vertices);

// Returns the bytes of which decode_meshopt() makes the given ones; with the filter EXPONENTIAL, floats with
// mantissas of 12 bits, an error of at most 1/4096 of an element's largest component. Other filters are
// refused.
std::string encode_meshopt(std::string_view bytes, const MeshoptView& view);

}  // namespace luxel
