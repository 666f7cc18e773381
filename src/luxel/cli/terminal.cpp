// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/terminal.h"

#include <cstdlib>

#include <fmt/format.h>

#include "luxel/core/standard_streams.h"

namespace luxel {
namespace {

enum class UseOfColour { on_terminals, always, never };
UseOfColour use_of_colour = UseOfColour::on_terminals;  // of the process, set once before the first message

// Codes of ECMA-48, select graphic rendition.
const char* code_of(Style style) {
  switch (style) {
    case Style::label:
      return "1;36";  // bold cyan
    case Style::good:
      return "32";  // green
    case Style::warning:
      return "1;33";  // bold yellow
    case Style::error:
      return "1;31";  // bold red
  }
  return "0";
}

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

}  // namespace

bool is_terminal(int stream) { return is_terminal_device(stream) && variable("TERM") != "dumb"; }

std::size_t columns_of(int stream) {
  constexpr std::size_t usual = 100;
  const auto columns = terminal_columns(stream);
  return columns > 0 ? columns : usual;
}

std::string TextPaint::operator()(Style style, std::string_view text) const {
  if (!is_on_ || text.empty()) return std::string(text);
  return fmt::format("\033[{}m{}\033[0m", code_of(style), text);
}

void set_colour_mode(std::string_view mode) {
  use_of_colour = mode == "always"  ? UseOfColour::always
                  : mode == "never" ? UseOfColour::never
                                    : UseOfColour::on_terminals;
}

TextPaint paint_for(int stream) {
  if (use_of_colour != UseOfColour::on_terminals) return TextPaint(use_of_colour == UseOfColour::always);
  return TextPaint(is_terminal(stream) && variable("NO_COLOR").empty());
}

std::string_view colour_mode_of(int argc, const char* const* argv) {
  constexpr std::string_view option = "--color";
  std::string_view mode = "auto";
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == option && i + 1 < argc) mode = argv[i + 1];
    if (word.starts_with("--color=")) mode = word.substr(option.size() + 1);
  }
  return mode;
}

}  // namespace luxel
