// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/patch/patch_set.h"
#include "luxel/solution/hdf5_reader.h"
#include "luxel/solution/hdf5_writer.h"

namespace luxel {

// The panes of glass that absorb light, and the transmittance of each material: the group Luxel/panes, which
// exists only where there are any. Reading refuses numbers out of range as damaged.
void add_panes(Hdf5Writer& file, const PatchSet& patches);
void read_panes(const Hdf5Reader& file, PatchSet& patches);

}  // namespace luxel
