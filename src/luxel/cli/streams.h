// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace luxel {

// Writes results to the standard output. Throws DeviceError where that fails: a full disk, a closed
// stream. A reader that has ended (luxel ... | head) is not an error. On a terminal they are
// printable().
void print_result(std::string_view text);

// Writes text unchanged, for texts without names from files, such as help in colours.
void print_styled(std::string_view text);

// Writes a message to the standard error stream. Errors of the stream are ignored.
void print_note(std::string_view text);

}  // namespace luxel
