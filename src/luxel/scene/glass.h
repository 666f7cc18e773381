// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace luxel {

// Refractive index of window glass.
inline constexpr double glass_index = 1.52;

// Transmittance of glass at normal incidence if it absorbs nothing: 0.9183.
double clear_slab_transmittance();

// Transmittance of unpolarised light by a pane, [0, 1], for the cosine of the angle of incidence, in [0, 1].
// at_normal, [0, 1]: that at normal incidence.
//
// A plane slab of index 1.52 with all reflections between its two faces (Fresnel's equations, both
// polarisations): T = (1 - r)^2 a / (1 - r^2 a^2). The absorption, a = a0^(1 / cosine within the glass), is
// such that T at normal incidence is the given value. Above that of a slab without absorption, as with
// anti-reflection coatings, T is that of the clear slab to the power that gives the value: 1 is no glass.
double pane_transmittance(double at_normal, double cosine);

// Transmittance at normal incidence of a pane whose transmissivity (Radiance's material "glass":
// transmittance of the glass itself at normal incidence, without the reflections) is this, [0, 1].
double transmittance_of_transmissivity(double transmissivity);

}  // namespace luxel
