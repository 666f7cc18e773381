// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "luxel/cli/terminal.h"
#include "luxel/runs/option_set.h"

namespace luxel {

// Options that every command has beside those it declares.
struct CommonOption {
  const char *name, *unit, *help;
  char letter = 0;
};
inline constexpr CommonOption common_options[] = {
    {"config", "FILE", "read options from a text file of 'name = value' lines"},
    {"color", colour_modes, "colours in messages and help; auto: on a terminal, unless NO_COLOR is set"},
    {"print-config", "", "print every option with its value and where it came from, and stop"},
    {"help", "", "list the options that people use first, with examples", 'h'},
    {"help-all", "", "list all options"},
};

struct ExitCode {
  int code;
  const char* meaning;
};
inline constexpr ExitCode exit_codes[] = {
    {0, "fine"}, {1, "failed"}, {2, "misused"}, {3, "stopped before the requested accuracy"}};

// The sentence under the name of the program, in help and manual.
inline constexpr const char* program_summary =
    "global illumination of diffuse scenes by the radiosity method";

// Layout of help: for a terminal or a file.
struct HelpStyle {
  TextPaint paint;
  std::size_t columns = 100;
};

// The help of a command. is_whole: with all options, else with those that people use first.
std::string help_of(const OptionSet& set, bool is_whole, const HelpStyle& style);
// The help of the program: its commands and exit codes.
std::string help_of(std::span<const std::unique_ptr<OptionSet>> commands, const HelpStyle& style);

}  // namespace luxel
