// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/solved_scene.h"

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/runs/bake_settings.h"
#include "luxel/runs/lit_scene.h"

namespace luxel {

std::optional<SolvedScene> load_solved_scene(const std::string& file, const std::string& solution_file,
                                             const Baked& baked, Console& console) {
  BakeSettings of_bake;
  OptionSet all("bake", "");
  of_bake.declare(all);
  all.restore(baked.solution.provenance.options);
  SolvedScene solved;
  solved.metres_per_unit = of_bake.scene.load.scale;
  of_bake.scene.file = file;
  solved.scene = load_lit_scene(of_bake.scene, of_bake.look.up, {}, console, of_bake.light.method);
  if (interrupted()) return std::nullopt;
  if (fingerprint(solved.scene) != baked.patches.scene_fingerprint)
    throw MismatchError(fmt::format("--scene {}: it is not what {} was solved from", file, solution_file),
                        file);
  return solved;
}

}  // namespace luxel
