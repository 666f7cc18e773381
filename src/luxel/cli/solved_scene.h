// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "luxel/cli/console.h"
#include "luxel/scene/scene.h"
#include "luxel/solution/solution_file.h"

namespace luxel {

// The scene that a solution was solved from, loaded with the options it was solved with.
struct SolvedScene {
  Scene scene;
  double metres_per_unit = 1.0;
};

// file: of the scene; solution_file: for errors. Nothing after Ctrl-C. Throws MismatchError where it is
// another scene, and what load_scene() throws.
std::optional<SolvedScene> load_solved_scene(const std::string& file, const std::string& solution_file,
                                             const Baked& baked, Console& console);

}  // namespace luxel
