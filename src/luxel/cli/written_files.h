// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "luxel/runs/option_set.h"

namespace luxel {

// Throws UsageError where a file that a command writes is one of these that it reads, under whatever name.
void keep_inputs(const OptionSet& options, const std::vector<std::filesystem::path>& inputs);

// The same for the files that its options and positionals name.
void keep_inputs(const OptionSet& options);

// Removes what killed runs left beside the files that a command writes. Returns a sentence about it; empty
// where there was nothing.
std::string remove_leftovers_of(const OptionSet& options);

}  // namespace luxel
