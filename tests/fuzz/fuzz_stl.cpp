// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/load_stl.h"

#include "fuzz/answered.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return luxel::answered(data, size, [](std::string_view bytes) {
    luxel::expect_sound(luxel::load_stl(bytes, "nowhere/room.stl", {}, {}));
  });
}
