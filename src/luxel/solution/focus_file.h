// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/patch/patch_set.h"
#include "luxel/solution/hdf5_reader.h"
#include "luxel/solution/hdf5_writer.h"

namespace luxel {

// The cameras of the patches and where their error matters (PatchSet::cameras, focuses_on_cameras, focus), in
// the group "Luxel/focus", and PatchSet::view in "Luxel/view"; nothing where there are none. Readers accept
// files without them.
void add_focus(Hdf5Writer& file, const PatchSet& patches);
void read_focus(const Hdf5Reader& file, PatchSet& patches);

}  // namespace luxel
