// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/import/load_scene.h"

namespace luxel {

// Returns whether one of the options makes a material of this name, which lets light pass in the file, a
// pane.
bool is_glass_of(const std::vector<GlassOption>& options, const std::string& name);

// Makes materials panes of glass or diffusers (LoadOptions::glass), and notes which. Throws InputError where
// an option applies to no material, or makes glass of one that emits light.
void apply_glass(const LoadOptions& load, Scene& scene, const Context& context);

// Lowers the reflectance of a diffuser so that reflectance and diffuse transmittance together are at most
// max_reflectance. Returns whether it did.
bool limit_albedo(Material& material, float max_reflectance);
void warn_of_limited_albedo(const std::string& source, const std::vector<std::string>& names,
                            float max_reflectance, const Context& context);

}  // namespace luxel
