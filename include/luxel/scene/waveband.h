// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "luxel/scene/spectrum.h"

namespace luxel {

/// One of the wavelengths that light is solved at, and how much of the spectrum it stands for.
struct Waveband {
  double wavelength = 0.0;  ///< nm
  double width = 0.0;       ///< nm, above 0: what the trapezoid rule gives the wavelength

  bool operator==(const Waveband&) const = default;
};

/// wavelengths: nm, ascending, at least two. Widths are half the way to the neighbours, on both sides.
std::vector<Waveband> make_wavebands(const std::vector<double>& wavelengths);

/// The mean of a spectrum around waveband i, weighed by the hat that is 1 at its wavelength and 0 at its
/// neighbours': exact for what runs linearly between samples. The hats of all bands add up to 1, so that the
/// means times the widths add up to the spectrum's whole.
double mean_around(const std::vector<Waveband>& wavebands, std::size_t i, const Spectrum& spectrum,
                   Beyond beyond);

}  // namespace luxel
