// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/gather_sides.h"

namespace luxel {

// Scattering of the light that arrives at rows: R_i = rho_i H_i + tau_i H_j, with j the row of the other side
// of the patch. A view; rows: [row * columns + column], columns bands or other quantities that are
// transported in the same way.
struct Scattering {
  std::span<const float> reflectance;    // rho
  std::span<const float> transmittance;  // tau; empty where nothing transmits light diffusely
  std::span<const std::uint32_t> far;    // [row]: j; the row itself where tau is 0

  Scattering(std::span<const float> rho, std::span<const float> tau, std::span<const std::uint32_t> far_row)
      : reflectance(rho), transmittance(tau), far(far_row) {}
  // Surfaces that only reflect.
  Scattering(std::span<const float> rho) : reflectance(rho) {}
  Scattering(const std::vector<float>& rho) : reflectance(rho) {}

  bool transmits() const { return !transmittance.empty(); }

  // Light that element i = row * columns + column scatters. irradiance(i): irradiance of that element.
  template <std::invocable<std::size_t> Irradiance>
  float sent_on(const Irradiance& irradiance, std::size_t i, std::size_t columns) const {
    const auto reflected = reflectance[i] * irradiance(i);
    return transmits() ? reflected + transmitted(irradiance, i, columns) : reflected;
  }
  float sent_on(std::span<const float> irradiance, std::size_t i, std::size_t columns) const {
    return sent_on([irradiance](std::size_t at) { return irradiance[at]; }, i, columns);
  }
  template <std::invocable<std::size_t> Irradiance>
  float transmitted(const Irradiance& irradiance, std::size_t i, std::size_t columns) const {
    assert(i < transmittance.size());
    return transmittance[i] * irradiance(far[i / columns] * columns + i % columns);
  }
};

// The numbers of a Scattering.
struct ScatteringTable {
  std::vector<float> reflectance, transmittance;
  std::vector<std::uint32_t> far;

  operator Scattering() const { return {reflectance, transmittance, far}; }
  Scattering view() const { return *this; }
};

// Returns the scattering of all receivers, one column per band. A diffuser only reflects where its other side
// is no receiver, since no light reaches it.
ScatteringTable scattering_of(const PatchSet& patches, const GatherSides& sides, const Context& context);

// Returns the rows twice, one set after the other.
ScatteringTable repeated_twice(const Scattering& scattering);

}  // namespace luxel
