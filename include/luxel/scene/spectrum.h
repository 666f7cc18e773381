// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace luxel {

/// Values beyond the first and last sample: `holds` continues the last value, for reflectances; `zero` gives
/// 0, for light, which was not measured there.
enum class Beyond { holds, zero };

/// A quantity by wavelength: samples with linear interpolation. Empty: unknown.
class Spectrum {
 public:
  struct Sample {
    double wavelength = 0.0;  ///< nm
    double value = 0.0;

    bool operator==(const Sample&) const = default;
  };

  Spectrum() = default;
  /// Wavelengths ascend.
  explicit Spectrum(std::vector<Sample> samples) : samples_(std::move(samples)) {}
  /// Samples at equal steps, nm.
  Spectrum(double first, double step, const std::vector<double>& values);

  bool empty() const { return samples_.empty(); }
  const std::vector<Sample>& samples() const { return samples_; }
  const Sample& front() const { return samples_.front(); }
  const Sample& back() const { return samples_.back(); }

  /// Returns the value at a wavelength, nm; the spectrum must not be empty. Cost: a binary search.
  double at(double wavelength, Beyond beyond) const;
  bool any_above_zero() const;

  bool operator==(const Spectrum&) const = default;

 private:
  std::vector<Sample> samples_;
};

/// One of the wavelengths at which light is solved, and the width of the spectrum that it represents.
struct Waveband {
  double wavelength = 0.0;  ///< nm
  double width = 0.0;       ///< nm, above 0: what the trapezoid rule gives the wavelength

  bool operator==(const Waveband&) const = default;
};

/// wavelengths: nm, ascending, at least two. Widths are half the way to the neighbours, on both sides.
std::vector<Waveband> make_wavebands(const std::vector<double>& wavelengths);

/// The mean of a spectrum around waveband i, weighed by the hat that is 1 at its wavelength and 0 at its
/// neighbours': exact for spectra that are linear between samples. The hats of all bands add up to 1, so that
/// the means times the widths add up to the integral of the spectrum.
double mean_around(const std::vector<Waveband>& wavebands, std::size_t i, const Spectrum& spectrum,
                   Beyond beyond);

}  // namespace luxel
