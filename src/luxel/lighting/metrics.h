// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "luxel/lighting/blinds.h"
#include "luxel/lighting/grid_figures.h"

namespace luxel {

// Electric light that is dimmed by photosensors, so that daylight and lamps together hold a level in the mean
// over the points. Its power follows its light; switched off where daylight alone holds the level.
struct DimmedLighting {
  double power = 0.0;    // W, of all lamps undimmed; 0: none
  double level = 500.0;  // lx
};

struct MetricOptions {
  double from = 8.0, to = 18.0;  // occupied hours, of local standard time, every day: middles in [from, to)
  YearSchedule schedule;         // replaces them where it states them; and the rule of the blinds
  BlindsRule blinds;
  DimmedLighting lighting;
};

// A metric of a point: its value, and the error of the mean over replicates by the jackknife, not widened.
struct PointMetric {
  std::vector<float> value, standard_error;  // [point]
  Figure mean, median;                       // over the points
};

// A group of windows.
struct BlindsFigures {
  std::string name;
  double transmittance = 0.0;  // of closed blinds
  double closed_hours = 0.0;   // h of the occupied ones; half closed counts as half
  double part_of_light = 0.0;  // of all light over the year, in the mean over the points, blinds open
};

struct YearMetrics {
  std::size_t occupied = 0;        // records that count
  std::size_t occupied_hours = 0;  // h, rounded; hours without light among them
  // Fractions of the occupied hours: daylight autonomy (illuminance from 300 lx on), continuous daylight
  // autonomy, useful daylight illuminance below 100, from 100 to 3,000 with limits, from 300 to 3,000 and
  // above.
  PointMetric autonomy, continuous_autonomy, below_100, useful, autonomous, above_3000;
  PointMetric exposure;   // lx h, of all hours of the year
  PointMetric sun_hours;  // h of the occupied ones with more than 1,000 lx straight from the sun
  // Fractions of the points: sDA300,50% without blinds and with blinds that are operated every hour;
  // ASE1000,250 with 250 hours or more. Where illuminance is near a limit, points are too near to tell.
  Figure autonomy_of_space, autonomy_with_blinds, sun_exposure;
  double too_near_to_tell = 0.0;      // points whose interval of daylight autonomy holds 50 %
  double sun_too_near_to_tell = 0.0;  // points whose interval of the hours of sun holds 250
  std::size_t hours_with_blinds = 0;  // occupied records in which the blinds of any group are closed
  std::vector<BlindsFigures> blinds;  // [group]
  // kWh, of occupied hours, with operated blinds: of lamps that are dimmed, and what dimming saves.
  Figure lighting_energy, lighting_saved;
};

// A row of EN 17037 on the climate of the weather file: the half of its hours with most diffuse light. Read
// in two ways: points that have the illuminance in half of these hours, and their fraction; or hours in which
// the fraction of the points has it, and their fraction.
struct ClimateProvision {
  const char* level = "";                              // "minimum", "medium", "high"
  double target = 0.0, minimum = 0.0;                  // lx
  Figure points_on_target, points_on_minimum;          // fractions of the points; needed: 0.5 and 0.95
  Figure hours_on_target, hours_on_minimum;            // fractions of the hours; needed: 0.5
  bool met_by_points = false, met_by_hours = false;    // by the values
  bool sure_by_points = false, sure_by_hours = false;  // the intervals do not contain the limits
};

struct YearReport {
  YearMetrics metrics;
  std::vector<ClimateProvision> provision;
  std::size_t daylight_hours = 0;  // of the half
  // BREEAM-style figures: hours with 300 lx in the mean over points, and with 90 lx at the darkest one.
  Figure hours_mean_300, hours_min_90;
  double light_taken_twice = 0.0;  // see WindowLight
};

// The metrics of a year at its points, each with an interval from the replicates. Cost: replicates + 1 times
// that of DaylightYear::illuminance().
YearReport metrics_of(const DaylightYear& year, const Weather& weather, const MetricOptions& options);

}  // namespace luxel
