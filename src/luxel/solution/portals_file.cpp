// SPDX-License-Identifier: Apache-2.0
#include "luxel/solution/portals_file.h"

#include <span>
#include <string>
#include <vector>

namespace luxel {
namespace {

const std::string group = "Luxel/portals";

}  // namespace

void add_portals(Hdf5Writer& file, const PatchSet& patches) {
  if (patches.portals.empty()) return;
  std::vector<Vec3> corners;
  std::vector<std::uint8_t> both_ways;
  for (const auto& portal : patches.portals) {
    corners.insert(corners.end(), portal.corner.begin(), portal.corner.end());
    both_ways.push_back(portal.both_ways ? 1 : 0);
  }
  file.add_group(group);
  file.add_array(group + "/corners", vectors(corners), "m");
  file.add_array(group + "/both_ways", flat_array(std::span<const std::uint8_t>(both_ways)));
}

void read_portals(const Hdf5Reader& file, PatchSet& patches) {
  if (!file.has(group)) return;
  const auto n = file.rows(group + "/both_ways");
  const auto both_ways = file.array<std::uint8_t>(group + "/both_ways", n);
  const auto corners = file.vectors(group + "/corners", 3 * n);
  for (std::size_t i = 0; i < n; ++i) {
    Portal portal{{corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]}, both_ways[i] != 0};
    for (const auto& corner : portal.corner)
      if (!is_finite(corner)) file.refuse_as_damaged("a corner of a portal is not finite");
    patches.portals.push_back(portal);
  }
}

}  // namespace luxel
