// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace luxel {

// The irradiance of one side of all patches of a material, in the mean over their area.
struct SurfaceMean {
  std::size_t material = 0;  // index into PatchSet::materials
  std::string name;          // of the material
  bool is_back = false;
  double area = 0.0;  // m², of the sides that light reaches
  // [band], W/m². The standard error is that of the mean, which does not follow from those of the sides,
  // because their errors are correlated; widened by student_widening(), so that 1.96 of it hold the truth on
  // these patches 95 times in 100.
  std::vector<double> irradiance, standard_error;
};

// The power that all sides receive, a path once at each surface that it meets.
struct ReceivedPower {
  std::vector<double> power, standard_error;  // [band], W; likewise
};

struct SurfaceMeans {
  std::vector<SurfaceMean> surfaces;  // by material, front before back; those that light reaches
  ReceivedPower received;
};

}  // namespace luxel
