// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace luxel {

// The file of a readable font for text on the screen, TrueType: the first of DejaVu Sans, Noto Sans,
// Liberation Sans and Open Sans that the system has. Nothing where none is installed; Dear ImGui's own font
// serves then.
//
// data_folders: as XDG_DATA_DIRS, with colons between them; empty: the usual ones.
std::optional<std::filesystem::path> find_text_font(const std::string& data_folders);
// The same, by XDG_DATA_DIRS of the environment.
std::optional<std::filesystem::path> find_text_font();

}  // namespace luxel
