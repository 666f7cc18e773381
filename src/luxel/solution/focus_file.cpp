// SPDX-License-Identifier: Apache-2.0
#include "luxel/solution/focus_file.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "luxel/solution/places_file.h"

namespace luxel {
namespace {

const std::string group = "Luxel/focus";
const std::string view_group = "Luxel/view";

bool is_camera(const Camera& c) {
  const auto is_finite = [](const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  };
  return is_finite(c.eye) && is_finite(c.target) && is_finite(c.up) && c.vertical_fov > 0.0f &&
         c.vertical_fov < 180.0f && std::isfinite(c.aspect) && c.aspect >= 0.0f;
}

void add_cameras(Hdf5Writer& file, const std::string& path, std::span<const Camera> cameras,
                 const Vec3d& origin) {
  std::vector<Vec3> eye, target, up;
  std::vector<float> fov, aspect;
  for (const auto& camera : cameras) {
    eye.push_back(camera.eye);
    target.push_back(camera.target);
    up.push_back(camera.up);
    fov.push_back(camera.vertical_fov);
    aspect.push_back(camera.aspect);
  }
  add_places(file, path + "/eye", eye, origin);
  add_places(file, path + "/target", target, origin);
  file.add_array(path + "/up", vectors(up), "1");
  file.add_array(path + "/vertical_fov", flat_array(std::span<const float>(fov)), "degree");
  file.add_array(path + "/aspect", flat_array(std::span<const float>(aspect)), "1");
}

std::vector<Camera> read_cameras(const Hdf5Reader& file, const std::string& path, const Vec3d& origin) {
  std::vector<Camera> cameras;
  const auto n = file.rows(path + "/eye");
  const auto eye = read_places(file, path + "/eye", n, origin);
  const auto target = read_places(file, path + "/target", n, origin);
  const auto up = file.vectors(path + "/up", n);
  const auto fov = file.array<float>(path + "/vertical_fov", n);
  // Older files have none.
  const auto aspect =
      file.has(path + "/aspect") ? file.array<float>(path + "/aspect", n) : std::vector<float>(n, 0.0f);
  for (std::size_t i = 0; i < n; ++i) cameras.push_back({eye[i], target[i], up[i], fov[i], aspect[i]});
  if (!std::all_of(cameras.begin(), cameras.end(), is_camera))
    file.refuse_as_damaged(fmt::format("a camera in {} is not valid", path));
  return cameras;
}

}  // namespace

void add_focus(Hdf5Writer& file, const PatchSet& patches) {
  if (patches.view) {
    file.add_group(view_group);
    add_cameras(file, view_group, {&*patches.view, 1}, patches.origin);
  }
  if (patches.cameras.empty() && patches.focus.empty()) return;
  file.add_group(group);
  file.add_number(group, "on_cameras", patches.focuses_on_cameras ? 1u : 0u);
  if (!patches.cameras.empty()) add_cameras(file, group, patches.cameras, patches.origin);
  if (!patches.focus.empty())
    file.add_array(group + "/patch", flat_array(std::span<const std::uint8_t>(patches.focus)));
}

void read_focus(const Hdf5Reader& file, PatchSet& patches) {
  if (file.has(view_group)) {
    const auto cameras = read_cameras(file, view_group, patches.origin);
    if (cameras.size() != 1) file.refuse_as_damaged("it has more than one view, or none");
    patches.view = cameras.front();
  }
  if (!file.has(group)) return;
  patches.focuses_on_cameras = file.number<std::uint32_t>(group, "on_cameras") != 0;
  if (file.has(group + "/eye")) patches.cameras = read_cameras(file, group, patches.origin);
  if (file.has(group + "/patch")) patches.focus = file.array<std::uint8_t>(group + "/patch", patches.size());
}

}  // namespace luxel
