// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/patch/patch_set.h"
#include "luxel/solution/hdf5_reader.h"
#include "luxel/solution/hdf5_writer.h"
#include "luxel/solution/sample_state.h"

namespace luxel {

// The group Luxel/samples of a solution file; see docs/solution-file.md. Not compressed: a checkpoint is
// written often. Reading throws FormatError where the arrays do not fit together; values are checked when a
// solve resumes from them.
void add_samples(Hdf5Writer& file, const SampleState& state);
SampleState read_samples(const Hdf5Reader& file, const PatchSet& patches);

}  // namespace luxel
