// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>

#include "luxel/runs/option_set.h"

namespace luxel {

using Commands = std::span<const std::unique_ptr<OptionSet>>;

// Scripts for shells that complete commands, options, the words an option takes, and files by their endings.
// They are made from the declarations alone.
std::string bash_completion(Commands commands);
std::string zsh_completion(Commands commands);
std::string fish_completion(Commands commands);

}  // namespace luxel
