// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/lit_scene.h"

#include <fmt/format.h>

#include "luxel/lamps/luminaire_check.h"
#include "luxel/session/default_sky.h"
#include "luxel/session/words.h"

namespace luxel {

std::string describe_scene(const std::string& file, const Scene& scene, const PatchSet& patches) {
  const auto triangles = scene.triangles.size();
  return fmt::format("{}: {}, {}, {}{} patches", file, counted_things(triangles, "triangle"),
                     counted_things(scene.materials.size(), "material"),
                     patches.size() > triangles ? "cut into " : "", with_commas(patches.size()));
}

Scene load_lit_scene(const SceneSettings& settings, const std::string& up, const Context& context,
                     Reporter& reporter, Method method) {
  auto scene = load_scene(settings.file, load_options(settings, up), reporter.reporting(context));
  light_up(settings, scene, context, reporter, method);
  return scene;
}

LoadOptions load_options(const SceneSettings& settings, const std::string& up) {
  auto options = settings.load_options();
  if (up == "y") options.up = Vec3(0.0f, 1.0f, 0.0f);
  if (up == "z") options.up = Vec3(0.0f, 0.0f, 1.0f);
  return options;
}

void light_up(const SceneSettings& settings, Scene& scene, const Context& context, Reporter& reporter,
              Method method) {
  for (const auto& group : move_luminaires_free(scene, context)) reporter.say("light", moved_text(group));
  if (!settings.daylight.adds_default_light()) return;
  if (!has_light(scene)) check_contacts(scene, settings.patches, context);
  const auto added = add_default_light(scene, context, default_sky(method));
  if (added.kind != DefaultLightKind::not_needed)
    reporter.say("light", reporter.worded(added.as_text(), added.hints()));
}

}  // namespace luxel
