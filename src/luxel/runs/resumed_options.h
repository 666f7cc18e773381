// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "luxel/runs/bake_settings.h"
#include "luxel/solution/solution.h"

namespace luxel {

// Sets the options of a bake to those of the run that a solution came from, then those that are changed.
// options: declared settings. command: resumes the run; the provenance of the solution records it where
// options differ; unchanged options leave the provenance as it was.
void restore_options(const std::vector<std::pair<std::string, std::string>>& changes,
                     const std::string& command, OptionSet& options, Provenance& provenance);

}  // namespace luxel
