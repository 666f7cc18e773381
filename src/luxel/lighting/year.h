// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/lighting/coefficients.h"
#include "luxel/lighting/sun_light.h"
#include "luxel/lighting/window_groups.h"
#include "luxel/lighting/year_skies.h"

namespace luxel {

// The coefficients of all windows, and those without the windows of each group. A group without coefficients,
// the only one then, is all windows and openings.
struct YearCoefficients {
  const DaylightCoefficients& open;
  const WindowLight& windows;
};

// The light of a year at points, hour by hour (Tregenza and Waters 1983, Reinhart and Walkenhorst 2001). The
// sky of an hour has the luminances of Perez's model in the patches of the coefficients. The sun is apart:
// its light straight to a point is traced to its true place, a disc of 0.53 degrees; what surfaces reflect of
// it comes by the coefficients of the four patches around it, which is as coarse as these are.
class DaylightYear {
 public:
  // Keeps references to the coefficients and the skies, whose patches are the same. Traces SunLight::rays
  // per point and hour with sun, and polls the monitor; after its stop is_stopped().
  DaylightYear(const YearCoefficients& coefficients, const YearSkies& skies,
               std::span<const ProbePoint> points, const SunSurroundings& around, const Context& context);

  bool is_stopped() const { return sun_light_.is_stopped(); }
  // Hours with light.
  const std::vector<DaylightHour>& hours() const { return skies_.hours; }
  std::size_t points() const { return coefficients_.points; }
  // lx, straight from the sun: [hour * points + point].
  const std::vector<float>& direct_sun() const { return sun_light_.all(); }
  // lx, direct sunlight in the mean over the replicates but `left_out`.
  std::vector<float> direct_sun(std::uint32_t left_out) const {
    return sun_light_.without(sun_light_.all(), replicates(), left_out);
  }
  // lx, by sky and sun, [hour * points + point]: the mean over the replicates but `left_out`; over all with
  // left_out = replicates(). Cost: that of PackedColumns::times().
  std::vector<float> illuminance(std::uint32_t left_out) const;
  // The same without direct light of the sun.
  std::vector<float> diffuse(std::uint32_t left_out) const;
  std::uint32_t replicates() const { return coefficients_.replicates; }

  const std::vector<WindowGroup>& groups() const { return windows_.groups; }
  bool has_groups() const { return !windows_.without.empty(); }  // else the only one is all light
  double light_taken_twice() const { return windows_.twice; }    // see WindowLight
  // lx, by sky and sun through the windows of a group: [hour * points + point]. all: illuminance(left_out).
  std::vector<float> through(std::size_t group, std::vector<float> all, std::uint32_t left_out) const;
  // lx, direct sunlight through the windows of a group: [hour * points + point].
  const std::vector<float>& direct_sun_through(std::size_t group) const { return sun_light_.through(group); }

 private:
  std::vector<float> diffuse_by(const DaylightCoefficients& coefficients, std::uint32_t left_out) const;

  const DaylightCoefficients& coefficients_;
  const WindowLight& windows_;
  Context context_;  // reports nothing
  const YearSkies& skies_;
  struct SunPatch {
    std::size_t patch = 0;
    float luminance = 0.0f;  // cd/m²
  };
  std::vector<std::vector<SunPatch>> sun_;  // [hour], what the sun adds to the sky for reflected light
  SunLight sun_light_;
};

// Standard errors of the illuminance of all replicates, `all`, by the jackknife: lx, [hour * points + point].
// Cost: replicates times that of DaylightYear::illuminance().
std::vector<float> illuminance_errors(const DaylightYear& year, const std::vector<float>& all);

}  // namespace luxel
