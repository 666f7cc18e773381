// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

namespace luxel {

// The standard streams of the process, as the system numbers them.
inline constexpr int standard_output = 1, error_output = 2;

// Call first. The number of a closed standard stream is reused by the next file that is opened, so that
// messages would end up in a mesh; it is therefore occupied by a descriptor that refuses writes. A reader
// that exits (luxel ... | head) or a limit on file sizes becomes an error of the write and does not end the
// process.
void secure_streams();

// Returns whether a stream is a terminal.
bool is_terminal_device(int stream);

// Returns the columns of a terminal; 0 where the stream is not a terminal or has no size.
std::size_t terminal_columns(int stream);

// Discards from now on what the process and its libraries write to the standard output, and returns a stream
// to where it went; -1 on failure.
int take_standard_output();

// Writes all bytes to a stream. Returns false on failure.
bool write_all(int stream, std::string_view bytes);

}  // namespace luxel
