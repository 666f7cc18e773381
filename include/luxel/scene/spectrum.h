// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

namespace luxel {

/// Values beyond the first and last sample: a reflectance keeps its last value; of light nobody
/// measured there is none.
enum class Beyond { holds, zero };

/// A quantity by wavelength: samples, and straight lines between them. Empty: not known.
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

  /// Not of an empty one. Cost: a binary search.
  double at(double wavelength, Beyond beyond) const;
  bool any_above_zero() const;

  bool operator==(const Spectrum&) const = default;

 private:
  std::vector<Sample> samples_;
};

}  // namespace luxel
