// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/daylight_plans.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace luxel {
namespace {

std::vector<double> per_cent(const std::vector<float>& fractions) {
  std::vector<double> values;
  for (const auto f : fractions) values.push_back(100.0 * static_cast<double>(f));
  return values;
}

ColourScale per_cent_scale() {
  return {.low = 0.0, .high = 100.0, .marks = {0.0, 25.0, 50.0, 75.0, 100.0}, .unit = "%"};
}

// The end of a scale from 0 that no value exceeds, at least `low`.
double round_end(const std::vector<double>& values, double low) {
  auto high = low;
  for (const auto v : values) high = std::max(high, v);
  const auto power = std::pow(10.0, std::floor(std::log10(high)));
  for (const double step : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.5})
    if (step * power >= high) return step * power;
  return 10.0 * power;
}

}  // namespace

std::string per_cent_text(const Figure& fraction, int decimals) {
  const auto text = [](double value, int places) {
    return fmt::format("{:.{}f}", 100.0 * std::clamp(value, 0.0, 1.0), places);
  };
  if (!(fraction.low < fraction.high)) return fmt::format("{:.{}f} %", 100.0 * fraction.value, decimals);
  if (text(fraction.low, decimals) == text(fraction.high, decimals)) ++decimals;
  return fmt::format("{:.{}f} % ({} to {})", 100.0 * fraction.value, decimals, text(fraction.low, decimals),
                     text(fraction.high, decimals));
}

MetricPlan plan_of(const DaylightFactors& factors) {
  MetricPlan plan;
  plan.title = fmt::format("Daylight factor, CIE sky type {}", factors.cie_type);
  plan.figures = {"mean " + per_cent_text(factors.mean, 2) + ", median " + per_cent_text(factors.median, 2),
                  "minimum " + per_cent_text(factors.min, 2) +
                      fmt::format(", uniformity {:.2f}", factors.min_over_mean.value)};
  plan.values = per_cent(factors.value);
  plan.scale = {.low = 0.1,
                .high = 20.0,
                .is_logarithmic = true,
                .marks = {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0},
                .unit = "%"};
  plan.lines = {0.5, 1.0, 2.0, 5.0};
  plan.decimals = 1;
  return plan;
}

std::vector<MetricPlan> plans_of(const YearMetrics& year) {
  const auto hours = "of " + scale_number(static_cast<double>(year.occupied_hours)) + " occupied";
  MetricPlan autonomy;
  autonomy.title = "Daylight autonomy, 300 lx or more, " + hours + " hours";
  autonomy.figures = {
      "mean " + per_cent_text(year.autonomy.mean, 1) + ", median " + per_cent_text(year.autonomy.median, 1),
      "sDA300,50% " + per_cent_text(year.autonomy_of_space, 0) + " of the points, with blinds " +
          per_cent_text(year.autonomy_with_blinds, 0)};
  autonomy.values = per_cent(year.autonomy.value);
  autonomy.scale = per_cent_scale();
  autonomy.lines = {50.0};

  MetricPlan useful;
  useful.title = "Useful daylight, 100 to 3,000 lx, " + hours + " hours";
  useful.figures = {
      "mean " + per_cent_text(year.useful.mean, 1) + ", median " + per_cent_text(year.useful.median, 1),
      fmt::format("in the mean above 3,000 lx {:.1f} %, below 100 lx {:.1f} %",
                  100.0 * year.above_3000.mean.value, 100.0 * year.below_100.mean.value)};
  useful.values = per_cent(year.useful.value);
  useful.scale = per_cent_scale();

  MetricPlan sun;
  sun.title = "Direct sun above 1,000 lx, hours " + hours;
  sun.figures = {fmt::format("mean {:.0f} h, median {:.0f} h; blinds open, without reflected light",
                             year.sun_hours.mean.value, year.sun_hours.median.value),
                 "ASE1000,250h " + per_cent_text(year.sun_exposure, 0) + " of the points"};
  for (const auto h : year.sun_hours.value) sun.values.push_back(static_cast<double>(h));
  const auto end = round_end(sun.values, 500.0);
  sun.scale = {.low = 0.0, .high = end, .marks = {0.0, 250.0, 0.5 * end, 0.75 * end, end}, .unit = "h"};
  if (end > 2000.0) sun.scale.marks = {0.0, 0.25 * end, 0.5 * end, 0.75 * end, end};
  if (end < 750.0) sun.scale.marks = {0.0, 125.0, 250.0, 375.0, 500.0};
  sun.lines = {250.0};
  return {autonomy, useful, sun};
}

std::vector<MetricPlan> plans_of_day(const DaylightYear& year, const Weather& weather,
                                     const CalendarDay& day) {
  const auto light = year.illuminance(year.replicates());
  const auto points = year.points();
  std::vector<MetricPlan> plans;
  for (std::size_t h = 0; h < year.hours().size(); ++h) {
    const auto& hour = year.hours()[h];
    const auto& record = weather.hours[hour.record];
    if (record.month != day.month || record.day != day.day) continue;
    MetricPlan plan;
    double sum = 0.0;
    for (std::size_t m = 0; m < points; ++m) {
      plan.values.push_back(static_cast<double>(light[h * points + m]));
      sum += plan.values.back();
    }
    const auto minutes = std::lround(60.0 * hour.time);
    plan.title = fmt::format("{:02}-{:02} {:02}:{:02}, illuminance", record.month, record.day, minutes / 60,
                             minutes % 60);
    plan.figures = {fmt::format("mean {} lx; outside {} lx by the sky",
                                scale_number(std::round(sum / static_cast<double>(points))),
                                scale_number(std::round(hour.sky_illuminance))),
                    fmt::format("sun {:.0f}° high, azimuth {:.0f}°", hour.sun.elevation, hour.sun.azimuth)};
    plan.scale = {.low = 10.0,
                  .high = 100'000.0,
                  .is_logarithmic = true,
                  .marks = {10.0, 100.0, 300.0, 1000.0, 3000.0, 10'000.0, 100'000.0},
                  .unit = "lx"};
    plans.push_back(std::move(plan));
  }
  return plans;
}

}  // namespace luxel
