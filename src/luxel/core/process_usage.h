// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace luxel {

// Returns the seconds since the process started, in steps of 10 ms; 0 if the system does not report it.
double process_age();

// Returns the largest main memory that the process has held so far, in bytes.
std::uint64_t peak_memory();

}  // namespace luxel
