// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/patch/patch_set.h"
#include "luxel/solution/hdf5_reader.h"
#include "luxel/solution/hdf5_writer.h"

namespace luxel {

// The portals that a run's samples belong to: the group Luxel/portals, which exists only where there are any.
// Reading refuses values that are not finite as damaged.
void add_portals(Hdf5Writer& file, const PatchSet& patches);
void read_portals(const Hdf5Reader& file, PatchSet& patches);

}  // namespace luxel
