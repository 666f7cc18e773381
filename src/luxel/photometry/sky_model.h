// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "luxel/core/vector.h"

namespace luxel {

// Directions of this module's models are unit vectors in local axes: x east, y north, z zenith.

inline constexpr int sky_types =
    16;  // of the CIE: 15 of the standard general sky, and the overcast sky of 1955

// Distribution of the luminance of a sky over its directions. A small value without state; safe for any
// number of threads.
//
// Standard general sky: ISO 15469:2004. Perez: R. Perez, R. Seals, J. Michalsky, "All-weather model for sky
// luminance distribution", Solar Energy 50(3), 1993.
class SkyModel {
 public:
  SkyModel() = default;  // uniform
  // A type of the CIE: 1 to 15 are those of the standard general sky; 16 is the traditional overcast sky,
  // L = Lz (1 + 2 sin elevation) / 3. Types 1, 3, 5 and 16 ignore the sun. A sun below the horizon counts as
  // one on the horizon. Throws InputError where there is no such type.
  static SkyModel cie(int type, const Vec3d& sun = Vec3d(0.0, 0.0, 1.0));
  // The formula of Perez with its parameters a, b, c, d, e (perez_sky.h computes them). Where b is above 0
  // the formula has no limit at the horizon: such a b counts as 0. Luminances below 0 are 0. A sun below the
  // horizon counts as one on the horizon.
  static SkyModel perez(const std::array<double, 5>& parameters, const Vec3d& sun);

  // Luminance in a direction: in units of the zenith's for the uniform sky and types of the CIE; for Perez as
  // his formula gives it. 0 below the horizon. Cost: 40 ns.
  double relative_luminance(const Vec3d& direction) const;
  // Returns whether the sun's place changes the luminances.
  bool follows_sun() const { return kind_ == Kind::graded && (c_ != 0.0 || e_ != 0.0); }
  // Direction of the sun in the model: not below the horizon.
  const Vec3d& sun() const { return sun_; }

 private:
  enum class Kind : std::uint8_t { uniform, overcast, graded };

  Kind kind_ = Kind::uniform;
  Vec3d sun_ = Vec3d(0.0, 0.0, 1.0);
  // scale (1 + a exp(b / cos Z)) (constant + c exp(d chi) + e cos² chi); Z from the zenith, chi from the sun.
  double scale_ = 1.0, a_ = 0.0, b_ = 0.0, constant_ = 1.0, c_ = 0.0, d_ = 0.0, e_ = 0.0;
};

}  // namespace luxel
