// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/lit_scene.h"

#include <fmt/format.h>

#include "luxel/cli/flags.h"
#include "luxel/lamps/luminaire_check.h"
#include "luxel/render/default_light.h"
#include "luxel/session/words.h"

namespace luxel {

std::string describe_scene(const std::string& file, const Scene& scene, const PatchSet& patches) {
  const auto triangles = scene.triangles.size();
  return fmt::format("{}: {}, {}, {}{} patches", file, counted_things(triangles, "triangle"),
                     counted_things(scene.materials.size(), "material"),
                     patches.size() > triangles ? "cut into " : "", with_commas(patches.size()));
}

Scene load_lit_scene(const SceneSettings& settings, const std::string& up, const Context& context,
                     Console& console) {
  auto options = settings.load_options();
  if (up == "y") options.up = Vec3(0.0f, 1.0f, 0.0f);
  if (up == "z") options.up = Vec3(0.0f, 0.0f, 1.0f);
  auto scene = load_scene(settings.file, options, console.reporting(context));
  for (const auto& group : move_luminaires_free(scene, context)) console.say("light", moved_text(group));
  if (!settings.daylight.adds_default_light()) return scene;
  const auto added = add_default_light(scene, context);
  if (added.kind != DefaultLightKind::not_needed)
    console.say("light", with_flags(added.as_text(), added.hints()));
  return scene;
}

}  // namespace luxel
