// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "luxel/lighting/window_groups.h"
#include "luxel/photometry/weather.h"

namespace luxel {

// Occupancy and state of the blinds, record by record of a weather file.
struct YearSchedule {
  std::vector<std::uint8_t> occupied;      // [record], 0 or 1; empty: not stated
  std::vector<std::vector<float>> closed;  // [group][record], [0, 1]: part of it; empty: not stated
};

// Reads a CSV file with one row for each record of the weather file, in its order, and a first line with the
// names of the columns: "occupied" with 0 or 1, and the names of groups of windows, or "blinds" for all of
// them, with the closed part of the blinds, 0 to 1. Throws InputError with file and line.
YearSchedule read_schedule(const std::filesystem::path& path, std::size_t records,
                           std::span<const WindowGroup> groups);

}  // namespace luxel
