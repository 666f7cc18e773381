// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "luxel/runs/option_set.h"

namespace luxel {

// Throws UsageError where a file that a command writes is one of these that it reads, under whatever name.
void keep_inputs(const OptionSet& options, const std::vector<std::filesystem::path>& inputs);

// Checks the files that its options and positionals name.
void keep_inputs(const OptionSet& options);

// Removes files that killed runs left beside the outputs of a command. Returns a sentence about them; empty
// where there were none.
std::string remove_leftovers_of(const OptionSet& options);

}  // namespace luxel
