// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/solution/hdf5_reader.h"
#include "luxel/solution/hdf5_writer.h"

namespace luxel {

// Places of a scene with an origin, in metres, as every reader of a file should see them: in the coordinates
// of the scene's file. Where the origin is 0 they are float32 [n][3] and the origin does not appear; else
// they are float64 [n][3], with the origin as float64 [3] beside them.

void add_places(Hdf5Writer& file, const std::string& name, std::span<const Vec3> places, const Vec3d& origin);
void add_origin(Hdf5Writer& file, const std::string& name, const Vec3d& origin);

// Returns the coordinates with the origin added; exact to the bit where the origin is 0, else to the rounding
// of the doubles, 1e-16 of the coordinates.
std::vector<Vec3> read_places(const Hdf5Reader& file, const std::string& name, std::size_t rows,
                              const Vec3d& origin);
Vec3d read_origin(const Hdf5Reader& file, const std::string& name);

}  // namespace luxel
