// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace luxel {

// Call first. The number of a closed standard stream is reused by the next file that is opened, so that
// messages would end up in a mesh; it is therefore occupied by a descriptor that refuses writes. A reader
// that exits (luxel ... | head) or a limit on file sizes becomes an error of the write and does not end the
// process.
void secure_streams();

// Writes results to the standard output. Throws DeviceError where that fails: a full disk, a closed
// stream. A reader that has ended (luxel ... | head) is not an error. On a terminal they are
// printable().
void print_result(std::string_view text);

// Writes text unchanged, for texts without names from files, such as help in colours.
void print_styled(std::string_view text);

// Writes a message to the standard error stream. Errors of the stream are ignored.
void print_note(std::string_view text);

}  // namespace luxel
