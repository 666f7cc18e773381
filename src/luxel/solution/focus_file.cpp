// SPDX-License-Identifier: Apache-2.0
#include "luxel/solution/focus_file.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "luxel/solution/places_file.h"

namespace luxel {
namespace {

const std::string group = "Luxel/focus";

bool is_camera(const Camera& c) {
  const auto is_finite = [](const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  };
  return is_finite(c.eye) && is_finite(c.target) && is_finite(c.up) && c.vertical_fov > 0.0f &&
         c.vertical_fov < 180.0f;
}

}  // namespace

void add_focus(Hdf5Writer& file, const PatchSet& patches) {
  if (patches.cameras.empty() && patches.focus.empty()) return;
  file.add_group(group);
  file.add_number(group, "on_cameras", patches.focuses_on_cameras ? 1u : 0u);
  if (!patches.cameras.empty()) {
    std::vector<Vec3> eye, target, up;
    std::vector<float> fov;
    for (const auto& camera : patches.cameras) {
      eye.push_back(camera.eye);
      target.push_back(camera.target);
      up.push_back(camera.up);
      fov.push_back(camera.vertical_fov);
    }
    add_places(file, group + "/eye", eye, patches.origin);
    add_places(file, group + "/target", target, patches.origin);
    file.add_array(group + "/up", vectors(up), "1");
    file.add_array(group + "/vertical_fov", flat_array(std::span<const float>(fov)), "degree");
  }
  if (!patches.focus.empty())
    file.add_array(group + "/patch", flat_array(std::span<const std::uint8_t>(patches.focus)));
}

void read_focus(const Hdf5Reader& file, PatchSet& patches) {
  if (!file.has(group)) return;
  patches.focuses_on_cameras = file.number<std::uint32_t>(group, "on_cameras") != 0;
  if (file.has(group + "/eye")) {
    const auto n = file.rows(group + "/eye");
    const auto eye = read_places(file, group + "/eye", n, patches.origin);
    const auto target = read_places(file, group + "/target", n, patches.origin);
    const auto up = file.vectors(group + "/up", n);
    const auto fov = file.array<float>(group + "/vertical_fov", n);
    for (std::size_t i = 0; i < n; ++i) patches.cameras.push_back({eye[i], target[i], up[i], fov[i]});
    if (!std::all_of(patches.cameras.begin(), patches.cameras.end(), is_camera))
      file.refuse_as_damaged("a camera of it cannot be");
  }
  if (file.has(group + "/patch")) patches.focus = file.array<std::uint8_t>(group + "/patch", patches.size());
}

}  // namespace luxel
