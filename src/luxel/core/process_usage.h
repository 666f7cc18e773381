// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace luxel {

// Returns the seconds since the process started, in steps of 10 ms; 0 if the system does not report it.
double process_age();

// Processor seconds so far: of all threads of the process, and of the calling thread.
double processor_seconds();
double processor_seconds_of_thread();

// Returns the largest main memory that the process has held so far, in bytes.
std::uint64_t peak_memory();

// From now on the process keeps the memory that it frees, for its next large arrays: the system clears each
// page that it hands out, which took a fifth of a solve's time. Has an effect with glibc alone.
void keep_freed_memory();

}  // namespace luxel
