// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/classical/operator.h"
#include "luxel/core/address.h"

namespace luxel::test {

// A transport operator that is a matrix of random numbers, rows of which sum to 0.9, and light for it: a few
// rows shine, all reflect. Two bands.
class RandomMatrix final : public TransportOperator {
 public:
  static constexpr std::size_t band_count = 2;

  explicit RandomMatrix(std::size_t rows) : rows_(rows), factors(rows * rows) {
    for (std::size_t i = 0; i < rows; ++i) {
      double sum = 0.0;
      for (std::size_t j = 0; j < rows; ++j) sum += static_cast<double>(drawn(i, j));
      for (std::size_t j = 0; j < rows; ++j)
        factors[i * rows + j] = static_cast<float>(0.9 * static_cast<double>(drawn(i, j)) / sum);
      area.push_back(0.5f + uniform4({2, 0, static_cast<std::uint32_t>(i), 0})[2]);
    }
    for (std::size_t i = 0; i < rows * band_count; ++i) {
      const auto u = uniform4({2, 0, static_cast<std::uint32_t>(i), 0});
      emittance.push_back(i / band_count < 5 ? u[0] : 0.0f);
      reflectance.push_back(0.3f + 0.6f * u[1]);
    }
    for (std::size_t i = 0; i < rows; i += 8) begins_.push_back(static_cast<std::uint32_t>(i));
    begins_.push_back(static_cast<std::uint32_t>(rows));
  }

  std::size_t size() const override { return rows_; }
  std::size_t bands() const override { return band_count; }
  std::span<const std::uint32_t> row_begins() const override { return begins_; }
  void apply(std::span<const float> radiosity, std::span<float> irradiance, std::size_t begin,
             std::size_t end, const Context&) const override {
    for (auto i = begin; i < end; ++i)
      for (std::size_t b = 0; b < band_count; ++b) {
        double sum = 0.0;
        for (std::size_t j = 0; j < rows_; ++j)
          sum += static_cast<double>(factors[i * rows_ + j]) *
                 static_cast<double>(radiosity[j * band_count + b]);
        irradiance[i * band_count + b] = static_cast<float>(sum);
      }
  }

 private:
  static float drawn(std::size_t i, std::size_t j) {
    return i == j ? 0.0f : uniform4({1, 0, static_cast<std::uint32_t>(i), j})[0];
  }

  std::size_t rows_;
  std::vector<std::uint32_t> begins_;

 public:
  std::vector<float> factors;                 // [row][row]
  std::vector<float> area;                    // [row]
  std::vector<float> emittance, reflectance;  // [row][band]
};

}  // namespace luxel::test
