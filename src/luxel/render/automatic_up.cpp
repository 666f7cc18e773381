// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "luxel/render/automatic_camera.h"

namespace luxel {
namespace {

// Cosine: within 6 degrees of an axis counts as level, or as shining straight down.
constexpr double close_to_axis = 0.995;
// Relative lead of level surfaces that decides; below it, furniture may as well lie on its side.
constexpr double clear_lead = 0.1;

struct Vote {
  double y = 0.0;
  double z = 0.0;

  void add(double along_y, double along_z, double weight) {
    if (along_y > close_to_axis) y += weight;
    if (along_z > close_to_axis) z += weight;
  }
  // The lead of y over z, -1 to 1; 0 without votes.
  double lead() const { return y + z > 0.0 ? (y - z) / (y + z) : 0.0; }
};

// Each input triangle is weighted by its length, not its area: treads, boards and table tops are many and
// mostly level, and would be outweighed by two long walls.
Vote level_surfaces(const PatchSet& patches) {
  Vote vote;
  for (std::size_t i = 0; i < patches.size();) {
    const auto triangle = patches.triangle[i];
    const Vec3d n(patches.normal[i]);
    double area = 0.0;
    for (; i < patches.size() && patches.triangle[i] == triangle; ++i)
      area += static_cast<double>(patches.area[i]);
    vote.add(std::abs(n.y), std::abs(n.z), std::sqrt(area));
  }
  return vote;
}

// Votes of lamps, weighted by power.
Vote lamps_downwards(const PatchSet& patches) {
  Vote vote;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    double emittance = 0.0;
    for (std::size_t b = 0; b < patches.band_count(); ++b)
      emittance += static_cast<double>(patches.emittance(i, b));
    const Vec3d n(patches.normal[i]);
    vote.add(-n.y, -n.z, emittance * static_cast<double>(patches.area[i]));
  }
  return vote;
}

}  // namespace

Vec3 automatic_up(const PatchSet& patches) {
  if (patches.up != Vec3(0.0f)) return glm::normalize(patches.up);
  auto lead = level_surfaces(patches).lead();
  if (std::abs(lead) < clear_lead) lead = lamps_downwards(patches).lead();
  return lead < 0.0 ? Vec3(0.0f, 0.0f, 1.0f) : Vec3(0.0f, 1.0f, 0.0f);
}

}  // namespace luxel
