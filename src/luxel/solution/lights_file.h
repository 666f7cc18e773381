// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/patch/patch_set.h"
#include "luxel/solution/hdf5_reader.h"
#include "luxel/solution/hdf5_writer.h"

namespace luxel {

// Punctual lights and luminaires: the group Luxel/point_lights, and Luxel/photometry with the distributions
// of the luminaires, each once. The groups are absent where there are none.
void add_point_lights(Hdf5Writer& file, const PatchSet& patches);
// Into patches whose bands have been read.
void read_point_lights(const Hdf5Reader& file, PatchSet& patches);

}  // namespace luxel
