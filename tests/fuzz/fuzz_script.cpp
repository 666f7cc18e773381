// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/script.h"

#include "fuzz/answered.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return luxel::answered(data, size, [](std::string_view bytes) {
    for (const auto& action : luxel::parse_script("nowhere/script.txt", bytes).actions)
      luxel::expect(!action.words.empty() && action.line > 0);
  });
}
