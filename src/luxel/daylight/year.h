// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/daylight/coefficients.h"
#include "luxel/sky/weather.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// Sky and sun of one record of a weather file, by Perez's model.
struct DaylightHour {
  std::size_t record = 0;  // of Weather::hours
  double time = 0.0;       // h of local standard time at the middle of the record
  double duration = 1.0;   // h
  SunPosition sun;
  double sky_illuminance = 0.0;  // of the ground by the sky, lx
  double sun_illuminance = 0.0;  // of a plane that faces the sun, lx; 0 where it is below the horizon
};

// What the sun's rays meet.
struct SunSurroundings {
  const PatchSet& patches;  // for their panes of glass
  const Tracer& tracer;
};

// The light of a year at points, hour by hour (Tregenza and Waters 1983, Reinhart and Walkenhorst 2001). The
// sky of an hour has the luminances of Perez's model in the patches of the coefficients. The sun is apart:
// its light straight to a point is traced to its true place, a disc of 0.53 degrees; what surfaces reflect of
// it comes by the coefficients of the four patches around it, which is as coarse as these are.
class DaylightYear {
 public:
  // Keeps references to the coefficients. Traces one ray per point and hour with sun, and polls the monitor;
  // after its stop is_stopped(). albedo: of the ground.
  DaylightYear(const DaylightCoefficients& coefficients, const Weather& weather,
               std::span<const ProbePoint> points, const SunSurroundings& around, double albedo,
               const Context& context);

  bool is_stopped() const { return is_stopped_; }
  // Hours with light, in the order of the file.
  const std::vector<DaylightHour>& hours() const { return hours_; }
  std::size_t points() const { return coefficients_.points; }
  // lx, straight from the sun: [hour * points + point].
  const std::vector<float>& direct_sun() const { return direct_sun_; }
  // lx, by sky and sun, [hour * points + point]: the mean over the replicates but `left_out`; over all with
  // left_out = replicates(). Cost: 0.3 ns per hour, point and patch of the sky.
  std::vector<float> illuminance(std::uint32_t left_out) const;
  // The same without what comes straight from the sun.
  std::vector<float> diffuse(std::uint32_t left_out) const;
  std::uint32_t replicates() const { return coefficients_.replicates; }

 private:
  void trace_sun(std::span<const ProbePoint> points, const SunSurroundings& around, const Context& context);

  const DaylightCoefficients& coefficients_;
  Context context_;  // reports nothing
  std::vector<DaylightHour> hours_;
  // cd/m²: [hour * sky patches + sky patch], of the sky, and what the sun adds for reflected light.
  std::vector<float> sky_, sun_;
  std::vector<float> direct_sun_;
  bool is_stopped_ = false;
};

// Standard errors of the illuminance of all replicates, `all`, by the jackknife: lx, [hour * points + point].
// Cost: replicates times that of DaylightYear::illuminance().
std::vector<float> illuminance_errors(const DaylightYear& year, const std::vector<float>& all);

}  // namespace luxel
