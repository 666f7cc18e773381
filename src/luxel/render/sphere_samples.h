// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "luxel/core/sobol.h"
#include "luxel/lamps/lamp_choices.h"
#include "luxel/lamps/punctual_choices.h"
#include "luxel/render/probe_light.h"
#include "luxel/trace/point_sight.h"

namespace luxel {

// Estimates integrals over the sphere of the radiance that arrives at a point, times weights that depend on
// the direction. Lamps and portals are sampled by shadow rays, each direction by the face of a cube that it
// passes, so that weights are bounded; suns and other punctual lights are exact, luminaires with an opening
// are sampled as lamps are; evenly distributed rays find sky and surfaces. Independent replicates of
// scrambled Sobol points. Cost: up to 13 rays per sample.
class SphereSamples {
 public:
  // Writes the weights of a unit direction, [k]; [k] of all calls are the same functions.
  using Weights = std::function<void(const Vec3d& direction, std::span<double> weights)>;

  // Keeps a reference to the probe. count: of weights. The normal of the point matters only where it lies on
  // a surface: the light is that in front of the surface. key: of the random numbers. has_errors: whether
  // sums for the solution's error are taken.
  SphereSamples(const SolutionProbe& probe, const ProbePoint& point, std::size_t count, Weights weights,
                std::uint64_t key, bool has_errors = false);

  // Takes sample i of replicate r.
  void sample(std::uint32_t r, std::uint32_t i);

  // The integrals, mean of the replicates, [band * count + k], W/m² for weights without a unit. samples:
  // taken per replicate.
  std::vector<double> means(std::uint32_t samples) const;
  // Integral k in lx, [replicate], without the punctual lights.
  std::vector<double> lux_of_replicates(std::size_t k, std::uint32_t samples) const;
  // Integral k in lx of the punctual lights, which has no noise.
  double lux_of_punctual(std::size_t k) const;

  // Sums for SolutionLight::error() of integral k, whose weights must not be negative, and their whole; where
  // they are taken.
  std::span<const double> error_sums(std::size_t k) const;
  double error_whole() const { return static_cast<double>(even_rays_); }
  std::uint64_t rays() const { return rays_; }

 private:
  template <typename Values>
  void add(const Vec3d& direction, const Values& radiance, double solid_angle, std::span<double> sum);
  // Adds a punctual light, if nothing hides it.
  void add_seen(const BandPointLight& lamp, const PointSight& sight, double solid_angle,
                std::span<double> sum);
  void sample_lamps(std::size_t face, const OwenSobol& points, std::uint32_t i, std::span<double> sum);
  void trace_punctual();
  void choose_openings();
  void sample_openings(std::size_t face, const OwenSobol& points, std::uint32_t i, std::span<double> sum);

  const SolutionProbe& probe_;
  LampRayOrigin origin_;
  std::size_t count_;
  Weights weights_of_;
  std::uint64_t key_;
  bool has_errors_;
  std::size_t bands_;
  std::array<LampChoices, 6> choices_;
  std::array<PunctualChoices, 6> openings_;
  std::vector<double> sums_;      // [replicate][band][k], of all samples so far
  std::vector<double> punctual_;  // [band][k]
  std::vector<double> errors_;    // [k][sum]
  std::vector<double> radiosity_;
  std::vector<double> weights_;
  std::uint64_t rays_ = 0, even_rays_ = 0;
};

}  // namespace luxel
