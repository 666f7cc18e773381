// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "luxel/patch/patch_set.h"
#include "luxel/scene/scene.h"

namespace luxel {

// Gives the patches the bands that the scene is solved in, its materials and its sky: plain colour, or one
// waveband a wavelength. Light is W/m² in each band: the spectrum there times the band's width, so that bands
// add up to watts. Throws InputError where colours are to become spectra and the wavelengths do not carry
// them.
void set_bands(PatchSet& patches, const Scene& scene);

}  // namespace luxel
