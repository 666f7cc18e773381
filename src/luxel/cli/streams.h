// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace luxel {

// To be called first. A closed standard stream leaves its number to the next file that is opened, and words
// would end up in a mesh: a closed one is held by a place that refuses them. A reader who leaves (luxel ... |
// head) or a limit on file sizes becomes an error of the write, not the end of hours of work.
void secure_streams();

// Results, on the standard output. Throws DeviceError where they do not arrive: a full disk, a closed stream.
void print_result(std::string_view text);

// Words for a person, on the standard error stream. Where nobody can hear them the work goes on.
void print_note(std::string_view text);

}  // namespace luxel
