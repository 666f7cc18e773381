// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/ending_of.h"

namespace luxel {

// No letters but these: the locale has no say in which file it is.
std::string ending_of(const std::filesystem::path& path) {
  auto ending = path.extension().string();
  for (auto& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending;
}

}  // namespace luxel
