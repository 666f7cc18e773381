// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/import/load_scene.h"

namespace luxel {

// Whether one of the options makes a material of this name, which lets light pass in the file, a pane.
bool is_glass_of(const std::vector<GlassOption>& options, const std::string& name);

// Makes materials panes of glass, and notes which. Throws InputError where an option applies to no material,
// or to one that emits light.
void apply_glass(const std::vector<GlassOption>& options, Scene& scene, const Context& context);

}  // namespace luxel
