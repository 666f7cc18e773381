// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace luxel {

// One line of a script: a verb and its words.
struct ScriptAction {
  std::size_t line = 0;  // in the file, from 1
  std::vector<std::string> words;
};

// A script of actions in a window: docs/viewer.md lists the verbs. Every verb and the number of its words is
// checked when it is read; arguments are checked when it is executed.
struct Script {
  std::string file;  // for messages
  std::vector<ScriptAction> actions;
};

// Throws InputError, FILE:LINE: sentence.
Script parse_script(const std::string& file, std::string_view text);
Script read_script(const std::filesystem::path& file);

}  // namespace luxel
