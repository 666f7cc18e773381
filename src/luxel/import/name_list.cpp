// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/name_list.h"

#include <fmt/format.h>

namespace luxel {

std::string name_list(std::span<const std::string> names) {
  constexpr std::size_t most = 6;
  std::string list;
  for (std::size_t i = 0; i < names.size() && i < most; ++i)
    list += fmt::format("{}'{}'", i > 0 ? ", " : "", names[i]);
  if (names.size() > most) list += fmt::format(" and {} more", names.size() - most);
  return list;
}

std::string counted(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace luxel
