// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace luxel {

// Bytes of main memory that programs could still take; 0 where the system does not tell.
std::uint64_t free_memory();

// Bytes of main memory that this process holds now; 0 where the system does not tell.
std::uint64_t resident_memory();

// Gives what was freed back to the system at once, so that it does not count as held: C libraries keep freed
// memory for later. Does nothing where the library has no such call.
void return_freed_memory();

}  // namespace luxel
