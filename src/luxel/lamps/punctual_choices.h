// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "luxel/core/discrete_distribution.h"
#include "luxel/patch/patch_set.h"
#include "luxel/trace/point_sight.h"

namespace luxel {

// One sample of the light of punctual lights and luminaires at a point.
struct PunctualSample {
  std::uint32_t light = 0;  // an index into PatchSet::point_lights
  PointSight sight;         // of the point of its opening that was chosen; irradiance 0: no light
  double given = 0.0;       // W/m² for an intensity of 1 W/sr, were nothing between
};

// Chooses one of the punctual lights and luminaires for each point of a small flat receiver, in proportion to
// the irradiance that each of them gives there without shadows. Where there are many, only the most important
// for the receiver are evaluated at each point, and one of all others, chosen by its importance. Unbiased:
// whatever can light the receiver has an importance above 0. Reuses its memory.
class PunctualChoices {
 public:
  // The receiver: a sphere that holds it, and the unit normal of its side.
  struct Receiver {
    Vec3d centre{0.0};
    double radius = 0.0;  // m
    Vec3d normal{0.0};
  };
  static constexpr std::size_t max_near = 8;  // lights that are evaluated at each point

  // weights: [light], intensity summed over bands, W/sr. lights: those that take part. Keeps references to
  // the lights and the weights. Costs 0.1 us per light where there are more than max_near, else nothing.
  void make(std::span<const BandPointLight> lights, std::span<const double> weights,
            std::span<const std::uint32_t> taking_part, const Receiver& receiver);

  bool empty() const { return near_.empty(); }
  // u: uniform in [0, 1): the choice, and a point of the opening. normal: unit.
  PunctualSample sample(const Vec3d& point, const Vec3d& normal, double u,
                        const std::array<double, 2>& opening);

 private:
  double importance(std::uint32_t light, const Receiver& receiver) const;

  std::span<const BandPointLight> lights_;
  std::span<const double> weights_;
  std::vector<std::uint32_t> near_, far_;
  DiscreteDistribution far_choice_;
  std::vector<PointSight> sights_;  // of the near ones, then of one far one
  DiscreteDistribution choice_;
};

}  // namespace luxel
