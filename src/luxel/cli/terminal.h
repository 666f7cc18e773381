// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace luxel {

// Returns whether a stream (standard_output, error_output) is a terminal whose cursor can be moved, unlike
// TERM=dumb.
bool is_terminal(int stream);

// Columns of a terminal; 100 where the stream is not a terminal or has no size.
std::size_t columns_of(int stream);

enum class Style { label, good, warning, error };

// Puts colour around words, or leaves them as they are.
class TextPaint {
 public:
  explicit TextPaint(bool is_on = false) : is_on_(is_on) {}
  std::string operator()(Style style, std::string_view text) const;

 private:
  bool is_on_;
};

// auto: colour if the stream is a terminal and NO_COLOR (no-color.org) is unset or empty.
inline constexpr const char* colour_modes = "auto|always|never";

// Sets the mode of all streams, once, before the first message. Any word that is not a mode counts as auto.
void set_colour_mode(std::string_view mode);
TextPaint paint_for(int stream);

// Finds the mode (--color) in the words of a command line before they are parsed, for errors in them.
std::string_view colour_mode_of(int argc, const char* const* argv);

}  // namespace luxel
