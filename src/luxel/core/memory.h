// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace luxel {

// Returns the bytes of main memory that this process can still take, at least 1: the free memory, bounded by
// the limits of the process (its control groups, as containers and Slurm set them, and `ulimit -v`). 0 where
// the system does not report it. root: where /proc and /sys are found.
std::uint64_t free_memory(const std::filesystem::path& root = "/");

// Returns "12 MB of memory, of which 10 are free" where work needs more bytes than free_memory(), else an
// empty text. Asked before the work: allocations beyond the limits of a control group do not fail, the
// process ends.
std::string lack_of_memory(double needed);

// Returns the bytes of main memory that this process holds now; 0 where the system does not report it.
std::uint64_t resident_memory();

// Returns freed memory to the system at once, so that it does not count as used: C libraries keep it for
// later. Does nothing where the library has no such call.
void return_freed_memory();

}  // namespace luxel
