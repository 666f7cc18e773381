// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/export/target_application.h"
#include "luxel/runs/option_set.h"

namespace luxel {

// Declares --compress. file: what it applies to, as in "a .glb".
void declare_compression(OptionSet& set, MeshCompression& compression, const std::string& file);

// Throws UsageError where this build has no such compression, or the program does not read it.
void check_compression(MeshCompression compression, TargetApplication program = TargetApplication::any);

}  // namespace luxel
