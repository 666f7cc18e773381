// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/flags.h"

#include <fmt/format.h>

#include "luxel/runs/setting_options.h"

namespace luxel {

std::string flag_of(const Hint& hint) {
  const auto option = option_of(hint.setting);
  if (option.empty()) return {};
  return hint.value.empty() ? fmt::format("--{}", option) : fmt::format("--{} {}", option, hint.value);
}

std::string with_flags(const std::string& sentence, const std::vector<Hint>& hints) {
  if (hints.empty()) return sentence;
  std::string text;
  for (const auto& hint : hints) text += (text.empty() ? "" : ", ") + flag_of(hint);
  return fmt::format("{} ({})", sentence, text);
}

std::string with_flags(const std::exception& error) { return with_flags(error.what(), hints_of(error)); }

}  // namespace luxel
