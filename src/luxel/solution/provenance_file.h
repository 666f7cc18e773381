// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/solution/hdf5_reader.h"
#include "luxel/solution/hdf5_writer.h"
#include "luxel/solution/solution.h"

namespace luxel {

// Origin of a file's numbers, as a group of its own, such as "Luxel/provenance". docs/solution-file.md has
// its entries. Reading refuses a group that lacks one of them.
void add_provenance(Hdf5Writer& file, const std::string& group, const Provenance& provenance);
Provenance read_provenance(const Hdf5Reader& file, const std::string& group);

}  // namespace luxel
