// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/resumed_options.h"

#include <fmt/format.h>

namespace luxel {

void restore_options(const std::vector<std::pair<std::string, std::string>>& changes,
                     const std::string& command, OptionSet& options, Provenance& provenance) {
  options.restore(provenance.options);
  options.restore(changes);
  auto used = options.used_values(RunSettings::heading);
  if (used == provenance.options) return;
  provenance.options = std::move(used);
  provenance.command_line += fmt::format("; {}", command);
}

}  // namespace luxel
