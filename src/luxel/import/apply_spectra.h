// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/core/context.h"
#include "luxel/import/load_scene.h"

namespace luxel {

// Applies the spectra of LoadOptions::spectra to the materials and the sky of a scene, and sets the
// wavelengths to solve at: the visible ones of all spectra in the file, with even steps of max_band_step or
// less put between any that lie farther apart; or LoadOptions::bands at even steps from the first to the
// last. Throws InputError, with file and line, where the file is damaged or does not fit the scene.
void apply_spectra(const LoadOptions& options, Scene& scene, const Context& context);

inline constexpr double max_band_step = 10.0;  // nm

}  // namespace luxel
