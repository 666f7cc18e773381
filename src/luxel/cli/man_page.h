// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>

#include "luxel/runs/option_set.h"

namespace luxel {

// The foot of a manual page.
struct ManFooter {
  std::string version;
  std::string date;  // YYYY-MM-DD
};

// Manual pages of section 1 for `man`, in the man(7) macros and ASCII, made from the declarations alone.
// luxel-bake(1): a command with all its options.
std::string man_page(const OptionSet& command, const ManFooter& footer);
// luxel(1): the program with its commands.
std::string man_page(std::span<const std::unique_ptr<OptionSet>> commands, const ManFooter& footer);

}  // namespace luxel
