// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "luxel/core/error.h"
#include "luxel/scene/scene.h"

namespace luxel {

// For any bytes a reader returns sound data or throws an error for the user that names the file, whose path
// has "nowhere/" in it. Anything else ends the program, which libFuzzer reports.
template <typename Error = InputError, typename Load>
int answered(const std::uint8_t* data, std::size_t size, Load load) {
  try {
    load(std::string_view(reinterpret_cast<const char*>(data), size));
  } catch (const Error& error) {
    if (std::string_view(error.what()).find("nowhere/") == std::string_view::npos) std::abort();
  }
  return 0;
}

// For what was read: false ends the program.
inline void expect(bool is_sound) {
  if (!is_sound) std::abort();
}

// A scene that was read must be sound: an error of check_scene() is a defect of the reader.
inline void expect_sound(const Scene& scene) {
  try {
    check_scene(scene);
  } catch (const InputError&) {
    std::abort();
  }
}

}  // namespace luxel
