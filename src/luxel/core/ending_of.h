// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace luxel {

// The ending of a file's name with its dot, in small letters: ".glb" of "Room.GLB"; empty where it has none.
std::string ending_of(const std::filesystem::path& path);

}  // namespace luxel
