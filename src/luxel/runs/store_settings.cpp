// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/store_settings.h"

#include <fmt/format.h>

#include "luxel/runs/quantity.h"
#include "luxel/runs/settings.h"

namespace luxel {

void StoreSettings::declare(OptionSet& set) {
  set.heading("Light by --method sampled");
  set.only_with("method", "sampled");
  set.add_flag("store-transport", transport,
               "store in the .vtkhdf file what 'luxel relight' and 'luxel resume' need");
  set.only_with();
  declare_groups(set);
}

void StoreSettings::declare_groups(OptionSet& set) {
  set.only_with("method", "sampled");
  set.add({.name = "light-group",
           .unit = "NAME=PATTERN",
           .help = "light group of the lamps whose material or object matches (with * and ?); other lamps "
                   "are grouped "
                   "by material",
           .parse =
               [this](const std::string& text) {
                 const auto [name, pattern] =
                     parse_named("light-group", text, "NAME=PATTERN, such as desk=lamp_*");
                 groups.push_back({name, pattern});
               },
           .print =
               [this] {
                 std::string text;
                 for (const auto& rule : groups) text += fmt::format("{}={}\n", rule.name, rule.pattern);
                 if (!text.empty()) text.pop_back();
                 return text;
               },
           .many = true});
  set.only_with();
}

void StoreSettings::declare_run(OptionSet& set) {
  set.heading(RunSettings::heading);
  set.only_with("method", "sampled");
  set.add_output("checkpoint", checkpoint,
                 "solution file (.vtkhdf) that stores the state of the run; the same command, or 'luxel "
                 "resume', continues it");
  declare_every(set);
  set.only_with();
}

void StoreSettings::declare_every(OptionSet& set) {
  set.add({"every", "duration",
           "minimum time between two writes of the checkpoint; 0: write after every doubling",
           [this](const std::string& text) {
             const auto seconds = text == "0" ? std::optional(0.0) : parse_duration(text);
             if (!seconds)
               throw UsageError(
                   fmt::format("--every: expected a time such as 60s or 5min, or 0, not '{}'", text));
             every = *seconds;
           },
           [this] { return every == 0.0 ? std::string("0") : as_duration(every); }});
}

std::pair<std::string, std::string> parse_named(const std::string& option, const std::string& text,
                                                const std::string& expected) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
    throw UsageError(fmt::format("--{}: expected {}, not '{}'", option, expected, text));
  return {text.substr(0, equals), text.substr(equals + 1)};
}

}  // namespace luxel
