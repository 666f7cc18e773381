// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/resumed_options.h"

#include <algorithm>

#include <fmt/format.h>

#include "luxel/runs/quality.h"

namespace luxel {

void restore_options(const std::vector<std::pair<std::string, std::string>>& changes,
                     const std::string& command, OptionSet& options, Provenance& provenance) {
  options.restore(provenance.options);
  options.restore(changes);
  const auto is_changed = [&](const char* name) {
    return std::any_of(changes.begin(), changes.end(), [&](const auto& c) { return c.first == name; });
  };
  // A new bound ends the run where it says, as in a bake.
  if (std::any_of(bounds_of_run.begin(), bounds_of_run.end(), is_changed) && !is_changed("cheap-rays"))
    options.set_default("cheap-rays", "none");
  auto used = options.used_values(RunSettings::heading);
  if (used == provenance.options) return;
  provenance.options = std::move(used);
  provenance.command_line += fmt::format("; {}", command);
}

}  // namespace luxel
