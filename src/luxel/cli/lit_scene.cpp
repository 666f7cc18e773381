// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/lit_scene.h"

#include <fmt/format.h>

#include "luxel/cli/flags.h"
#include "luxel/render/default_light.h"

namespace luxel {

Scene load_lit_scene(const SceneSettings& settings, const Context& context, Console& console) {
  auto scene = load_scene(settings.file, settings.load, console.reporting(context));
  if (!settings.adds_default_light) return scene;
  const auto added = add_default_light(scene, context);
  if (added.kind != DefaultLightKind::not_needed)
    console.say(fmt::format("{}: {}", settings.file, with_flags(added.as_text(), added.hints())));
  return scene;
}

}  // namespace luxel
