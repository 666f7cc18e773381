// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/focus.h"

#include <algorithm>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/hint.h"
#include "luxel/scene/name_pattern.h"
#include "luxel/scene/triangle_names.h"

namespace luxel {
bool is_called(const Scene* scene, const PatchSet& patches, std::size_t patch, const std::string& pattern) {
  if (matches(pattern, patches.material_of(patch).name)) return true;
  if (scene == nullptr) return false;
  const auto names = object_and_group(*scene, patches.triangle[patch]);
  return std::any_of(names.begin(), names.end(), [&](const auto& name) { return matches(pattern, name); });
}

void set_focus(const Scene& scene, const std::string& focus, PatchSet& patches) {
  patches.focus.clear();
  patches.focuses_on_cameras = focus == focus_on_camera;
  if (focus == focus_on_all) return;
  if (patches.focuses_on_cameras) {
    if (patches.cameras.empty())
      throw with_hints(InputError("the focus is on the camera, but the scene has none: give one"),
                       {{Setting::eye}, {Setting::target}});
    return;
  }
  patches.focus.resize(patches.size());
  for (std::size_t p = 0; p < patches.size(); ++p)
    patches.focus[p] = is_called(&scene, patches, p, focus) ? 1 : 0;
  if (std::none_of(patches.focus.begin(), patches.focus.end(), [](auto f) { return f != 0; }))
    throw with_hints(
        InputError(fmt::format(
            "no material, object or group is called '{}', which the focus is on; expected all, camera "
            "or a name (* and ? stand for any text and any letter)",
            focus)),
        {{Setting::focus, "NAME"}});
}

}  // namespace luxel
