// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/text_lines.h"

#include <algorithm>

namespace luxel {

std::vector<std::string_view> text_lines(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  std::vector<std::string_view> lines;
  while (!bytes.empty()) {
    const auto end = std::min(bytes.find_first_of("\r\n"), bytes.size());
    lines.push_back(bytes.substr(0, end));
    bytes.remove_prefix(end);
    if (!bytes.empty()) bytes.remove_prefix(bytes.starts_with("\r\n") ? 2 : 1);
  }
  return lines;
}

}  // namespace luxel
