// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/ending_of.h"

namespace luxel {

// ASCII letters only: the result does not depend on the locale.
std::string ending_of(const std::filesystem::path& path) {
  auto ending = path.extension().string();
  for (auto& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending;
}

}  // namespace luxel
