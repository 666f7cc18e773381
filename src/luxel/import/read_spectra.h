// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "luxel/scene/spectrum.h"

namespace luxel {

// One quantity that a file of spectra gives, of one material or of the sky.
struct MeasuredSpectrum {
  enum class Quantity {
    reflectance,  // 0 to 1
    radiance,     // W/(m² sr nm), of the front
    sky           // W/(m² sr nm), of what lies around the scene
  };
  std::string material;  // empty for the sky
  Quantity quantity = Quantity::reflectance;
  Spectrum spectrum;     // a radiance has two samples or more, a reflectance one
  std::size_t line = 0;  // of its first row
};

// Reads a CSV file of spectra, see docs/spectra.md: the line "material,quantity,wavelength_nm,value", then a
// row a sample, in any order; empty lines and lines that begin with # are left out. Spectra come in the order
// of their first rows. Throws InputError with file and line for whatever is not as it should be.
std::vector<MeasuredSpectrum> read_spectra(const std::filesystem::path& path);

}  // namespace luxel
