// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "luxel/render/automatic_camera.h"

namespace luxel {
namespace {

// Within 6 degrees of an axis: level, or shining straight down.
constexpr double close_to_axis = 0.995;

struct Vote {
  double y = 0.0;
  double z = 0.0;

  void add(double along_y, double along_z, double weight) {
    if (along_y > close_to_axis) y += weight;
    if (along_z > close_to_axis) z += weight;
  }
  // How far y leads, -1 to 1; 0 where nobody voted.
  double lead() const { return y + z > 0.0 ? (y - z) / (y + z) : 0.0; }
};

double power_of(const BandMaterial& material, double area) {
  double sum = 0.0;
  for (const auto emittance : material.emittance) sum += static_cast<double>(emittance);
  return sum * area;
}

}  // namespace

Vec3 automatic_up(const PatchSet& patches) {
  Vote lamps;
  Vote level;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const auto area = static_cast<double>(patches.area[i]);
    const Vec3d n(patches.normal[i]);
    level.add(std::abs(n.y), std::abs(n.z), area);
    lamps.add(-n.y, -n.z, power_of(patches.material_of(i), area));
  }
  const auto lead = std::abs(lamps.lead()) > std::abs(level.lead()) ? lamps.lead() : level.lead();
  return lead < 0.0 ? Vec3(0.0f, 0.0f, 1.0f) : Vec3(0.0f, 1.0f, 0.0f);
}

}  // namespace luxel
