// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "luxel/runs/option_set.h"

namespace luxel {

// ", did you mean '--error'?", or nothing where no name is near. before: what stands before a name.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& names, const char* before);

// Checks the words after the name of a command, before they are parsed. Throws UsageError, which names an
// option as typed, where an option is unknown or has no value, or where there are too many words.
void check_words(const OptionSet& command, std::span<const std::string> words);

}  // namespace luxel
