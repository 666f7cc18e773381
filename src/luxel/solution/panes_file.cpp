// SPDX-License-Identifier: Apache-2.0
#include "luxel/solution/panes_file.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace luxel {
namespace {

const std::string group = "Luxel/panes";

}  // namespace

void add_panes(Hdf5Writer& file, const PatchSet& patches) {
  if (patches.panes.empty()) return;
  std::vector<Vec3> corners, axes;
  std::vector<std::uint32_t> material;
  std::vector<float> exponent, transmittance;
  for (const auto& pane : patches.panes) {
    corners.insert(corners.end(), pane.corner.begin(), pane.corner.end());
    axes.push_back(pane.axis);
    material.push_back(static_cast<std::uint32_t>(pane.material));
    exponent.push_back(pane.exponent);
  }
  for (const auto& m : patches.materials) {
    if (m.transmittance.empty())
      transmittance.insert(transmittance.end(), patches.band_count(), 1.0f);
    else
      transmittance.insert(transmittance.end(), m.transmittance.begin(), m.transmittance.end());
  }
  file.add_group(group);
  file.add_array(group + "/corners", vectors(corners), "m");
  file.add_array(group + "/axis", vectors(axes), "1");
  file.add_array(group + "/material", flat_array(std::span<const std::uint32_t>(material)));
  file.add_array(group + "/exponent", flat_array(std::span<const float>(exponent)), "1");
  file.add_array(group + "/transmittance", rows_of(transmittance, patches.band_count()), "1");
}

void read_panes(const Hdf5Reader& file, PatchSet& patches) {
  if (!file.has(group)) return;
  const auto bands = patches.band_count();
  const auto transmittance = file.array<float>(group + "/transmittance", patches.materials.size(), bands);
  for (std::size_t m = 0; m < patches.materials.size(); ++m) {
    const std::span row(&transmittance[m * bands], bands);
    if (!std::all_of(row.begin(), row.end(), [](float t) { return t >= 0.0f && t <= 1.0f; }))
      file.refuse_as_damaged("a transmittance is not a number from 0 to 1");
    if (std::any_of(row.begin(), row.end(), [](float t) { return t < 1.0f; }))
      patches.materials[m].transmittance.assign(row.begin(), row.end());
  }
  const auto n = file.rows(group + "/material");
  const auto material = file.array<std::uint32_t>(group + "/material", n);
  const auto exponent = file.array<float>(group + "/exponent", n);
  const auto axis = file.vectors(group + "/axis", n);
  const auto corners = file.vectors(group + "/corners", 3 * n);
  for (std::size_t i = 0; i < n; ++i) {
    if (material[i] >= patches.materials.size() || patches.materials[material[i]].transmittance.empty())
      file.refuse_as_damaged("a pane has no material with a transmittance");
    const Pane pane{{corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]},
                    axis[i],
                    MaterialId{material[i]},
                    exponent[i]};
    if (!std::all_of(pane.corner.begin(), pane.corner.end(), is_finite))
      file.refuse_as_damaged("a corner of a pane is not finite");
    if (!(std::fabs(glm::length(pane.axis) - 1.0f) < 1e-3f) ||
        !(pane.exponent == 1.0f || pane.exponent == 0.5f))
      file.refuse_as_damaged("the axis of a pane is no unit vector, or its exponent is neither 1 nor 0.5");
    patches.panes.push_back(pane);
  }
}

}  // namespace luxel
