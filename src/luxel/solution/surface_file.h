// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/patch/patch_set.h"
#include "luxel/solution/hdf5_reader.h"
#include "luxel/solution/hdf5_writer.h"

namespace luxel {

// Textures, their placement on the patches, and the patches' ratios to their materials: the group
// Luxel/surface, which exists only where the patches have any of these.
void add_surface(Hdf5Writer& file, const PatchSet& patches);
// Into patches whose mesh, bands and materials have been read.
void read_surface(const Hdf5Reader& file, PatchSet& patches);

// Describes what is wrong with the surfaces; empty if they are valid.
std::string fault_in_surface(const PatchSet& patches);

}  // namespace luxel
