// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

namespace luxel {

// The whole path of a file or folder that exists, with all links followed; nothing where it cannot be
// reached. Where /proc is mounted, folders above the working folder need not be readable.
std::optional<std::filesystem::path> real_path(const std::filesystem::path& path);

// Returns whether the path leads to a regular file, through links or not. Folders, devices and pipes are
// not.
bool is_plain_file(const std::filesystem::path& path);

}  // namespace luxel
