// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <string>
#include <vector>

#include "luxel/core/hint.h"

namespace luxel {

// "--sky 1": the option that changes a setting.
std::string flag_of(const Hint& hint);

// Returns the sentence with the options that may help: "a longer edge is needed (--max-edge)".
std::string with_flags(const std::string& sentence, const std::vector<Hint>& hints);
std::string with_flags(const std::exception& error);

}  // namespace luxel
