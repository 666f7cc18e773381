// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/lighting/metrics.h"
#include "luxel/lighting/year.h"

namespace luxel {

struct YearFilePoints {
  std::vector<Vec3d> position;  // m, in the coordinates of the scene's file
  std::vector<Vec3d> normal;
  std::size_t columns = 0;  // of a grid; 0: none
};

// Writes the hours of a year at points as HDF5, which h5py and pandas read: illuminance, its standard error
// and the part straight from the sun, [hour, point], lx; the month, day and time of each hour, the sun and
// the illuminances outside; points and their metrics. Throws DeviceError where the file cannot be written.
// Cost: replicates + 1 times that of DaylightYear::illuminance().
void write_year(const std::filesystem::path& path, const DaylightYear& year, const Weather& weather,
                const YearFilePoints& points, const YearReport& report);

}  // namespace luxel
