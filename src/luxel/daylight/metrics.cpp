// SPDX-License-Identifier: Apache-2.0
#include "luxel/daylight/metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "luxel/core/student.h"
#include "luxel/daylight/daylight_factor.h"
#include "luxel/daylight/replicate_figure.h"
#include "luxel/sky/weather_figures.h"

namespace luxel {
namespace {

constexpr double autonomy_lux = 300.0, useful_from = 100.0, useful_to = 3000.0;
constexpr double sun_lux = 1000.0, sun_limit = 250.0, half = 0.5;

// Records that count as occupied.
bool is_occupied(const WeatherHour& record, const MetricOptions& options) {
  const auto middle = record.end - 0.5 * record.duration;
  return middle >= options.from && middle < options.to;
}

enum Metric : std::size_t { da, cda, low, useful, autonomous, high, exposure, metrics };

// All that is counted for one set of illuminances.
struct Counts {
  std::array<std::vector<float>, metrics> of_point;
  double space = 0.0, space_with_blinds = 0.0;  // fractions of the points
  std::array<double, 3> points_target{}, points_minimum{}, hours_target{}, hours_minimum{};
  double mean_300 = 0.0, min_90 = 0.0;  // h
};

class Counter {
 public:
  Counter(const DaylightYear& year, const Weather& weather, const MetricOptions& options)
      : year_(year), options_(options) {
    const auto& hours = year.hours();
    for (std::size_t h = 0; h < weather.hours.size(); ++h)
      if (is_occupied(weather.hours[h], options)) {
        ++occupied_;
        whole_ += weather.hours[h].duration;
      }
    for (const auto& hour : hours) is_occupied_.push_back(is_occupied(weather.hours[hour.record], options));
    find_blinds();
    find_bright_half(weather);
  }

  std::size_t occupied() const { return occupied_; }
  double occupied_hours() const { return whole_; }
  std::size_t hours_with_blinds() const {
    return static_cast<std::size_t>(std::count(has_blinds_.begin(), has_blinds_.end(), true));
  }
  std::size_t bright_hours() const { return bright_.size(); }

  // h of occupied hours with much light straight from the sun, [point].
  std::vector<float> sun_hours() const {
    std::vector<float> sum(year_.points(), 0.0f);
    for (std::size_t h = 0; h < year_.hours().size(); ++h)
      for (std::size_t m = 0; is_occupied_[h] && m < sum.size(); ++m)
        if (static_cast<double>(year_.direct_sun()[h * sum.size() + m]) > sun_lux)
          sum[m] += static_cast<float>(year_.hours()[h].duration);
    return sum;
  }

  Counts count(std::uint32_t left_out) const {
    const auto diffuse = year_.diffuse(left_out);
    const auto points = year_.points();
    Counts counts;
    for (auto& values : counts.of_point) values.assign(points, 0.0f);
    std::vector<float> with_blinds(points, 0.0f);
    std::vector<float> here(points);
    for (std::size_t h = 0; h < year_.hours().size(); ++h) {
      const auto duration = static_cast<float>(year_.hours()[h].duration);
      for (std::size_t m = 0; m < points; ++m) {
        here[m] = diffuse[h * points + m] + year_.direct_sun()[h * points + m];
        counts.of_point[exposure][m] += duration * here[m];
      }
      if (!is_occupied_[h]) continue;
      add_occupied(here, duration, has_blinds_[h] ? options_.blind_transmittance : 1.0, counts, with_blinds);
    }
    finish(counts, with_blinds);
    count_provision(diffuse, counts);
    return counts;
  }

 private:
  void find_blinds() {
    const auto points = year_.points();
    for (std::size_t h = 0; h < year_.hours().size(); ++h) {
      std::size_t bright = 0;
      for (std::size_t m = 0; m < points; ++m)
        if (static_cast<double>(year_.direct_sun()[h * points + m]) > options_.blinds_limit) ++bright;
      has_blinds_.push_back(is_occupied_[h] &&
                            static_cast<double>(bright) > options_.blinds_part * static_cast<double>(points));
    }
  }

  void find_bright_half(const Weather& weather) {
    std::vector<std::size_t> order(year_.hours().size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return year_.hours()[a].sky_illuminance > year_.hours()[b].sky_illuminance;
    });
    order.resize(std::min(order.size(), weather.hours.size() / 2));
    std::sort(order.begin(), order.end());
    bright_ = std::move(order);
  }

  void add_occupied(const std::vector<float>& here, float duration, double blinds, Counts& counts,
                    std::vector<float>& with_blinds) const {
    double sum = 0.0, least = std::numeric_limits<double>::infinity();
    for (std::size_t m = 0; m < here.size(); ++m) {
      const auto lux = static_cast<double>(here[m]);
      auto& of = counts.of_point;
      if (lux >= autonomy_lux) of[da][m] += duration;
      of[cda][m] += duration * static_cast<float>(std::min(1.0, lux / autonomy_lux));
      of[lux < useful_from ? low : lux <= useful_to ? useful : high][m] += duration;
      if (lux >= autonomy_lux && lux <= useful_to) of[autonomous][m] += duration;
      if (blinds * lux >= autonomy_lux) with_blinds[m] += duration;
      sum += lux;
      least = std::min(least, lux);
    }
    if (sum >= 300.0 * static_cast<double>(here.size())) counts.mean_300 += static_cast<double>(duration);
    if (least >= 90.0) counts.min_90 += static_cast<double>(duration);
  }

  void finish(Counts& counts, std::vector<float>& with_blinds) const {
    const auto whole = static_cast<float>(std::max(whole_, 1e-9));
    float lit = 0.0f;
    for (std::size_t h = 0; h < year_.hours().size(); ++h)
      if (is_occupied_[h]) lit += static_cast<float>(year_.hours()[h].duration);
    for (auto& v : counts.of_point[low]) v += std::max(0.0f, whole - lit);  // hours without light
    for (std::size_t k = 0; k < exposure; ++k)
      for (auto& v : counts.of_point[k]) v /= whole;
    for (auto& v : with_blinds) v /= whole;
    counts.space = fraction_reached(counts.of_point[da], half);
    counts.space_with_blinds = fraction_reached(with_blinds, half);
  }

  void count_provision(const std::vector<float>& diffuse, Counts& counts) const {
    const auto points = year_.points();
    const auto n = static_cast<double>(std::max<std::size_t>(1, bright_.size()));
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<float> on_target(points, 0.0f), on_minimum(points, 0.0f);
      double hours_target = 0.0, hours_minimum = 0.0;
      for (const auto h : bright_) {
        std::size_t t = 0, l = 0;
        for (std::size_t m = 0; m < points; ++m) {
          const auto lux = static_cast<double>(diffuse[h * points + m] + year_.direct_sun()[h * points + m]);
          if (lux >= daylight_targets[k].target) on_target[m] += 1.0f, ++t;
          if (lux >= daylight_targets[k].minimum) on_minimum[m] += 1.0f, ++l;
        }
        if (static_cast<double>(t) >= half * static_cast<double>(points)) hours_target += 1.0;
        if (static_cast<double>(l) >= 0.95 * static_cast<double>(points)) hours_minimum += 1.0;
      }
      counts.points_target[k] = fraction_reached(on_target, half * n);
      counts.points_minimum[k] = fraction_reached(on_minimum, half * n);
      counts.hours_target[k] = hours_target / n;
      counts.hours_minimum[k] = hours_minimum / n;
    }
  }

  const DaylightYear& year_;
  MetricOptions options_;
  std::size_t occupied_ = 0;
  double whole_ = 0.0;                          // h
  std::vector<bool> is_occupied_, has_blinds_;  // [hour of the year]
  std::vector<std::size_t> bright_;             // hours of the year
};

double mean_over(const std::vector<float>& values) {
  const auto sum = std::accumulate(values.begin(), values.end(), 0.0);
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

PointMetric point_metric(const Counts& all, const std::vector<Counts>& left_out, Metric metric) {
  PointMetric found{all.of_point[metric], {}, {}, {}};
  std::vector<double> means, medians;
  for (const auto& c : left_out) {
    means.push_back(mean_over(c.of_point[metric]));
    medians.push_back(median_of(c.of_point[metric]));
  }
  found.mean = jackknifed(mean_over(found.value), means);
  found.median = jackknifed(median_of(found.value), medians);
  const auto n = static_cast<double>(left_out.size());
  for (std::size_t m = 0; m < found.value.size(); ++m) {
    double mean = 0.0, sum = 0.0;
    for (const auto& c : left_out) mean += static_cast<double>(c.of_point[metric][m]) / n;
    for (const auto& c : left_out) sum += std::pow(static_cast<double>(c.of_point[metric][m]) - mean, 2.0);
    found.standard_error.push_back(static_cast<float>(std::sqrt((n - 1.0) / n * sum)));
  }
  return found;
}

template <typename Value>
Figure figure(const Counts& all, const std::vector<Counts>& left_out, const Value& value) {
  std::vector<double> others;
  for (const auto& c : left_out) others.push_back(value(c));
  return jackknifed(value(all), others);
}

bool is_sure(const Figure& f, double limit) { return f.low >= limit || f.high < limit; }

}  // namespace

YearReport metrics_of(const DaylightYear& year, const Weather& weather, const MetricOptions& options) {
  const Counter counter(year, weather, options);
  const auto all = counter.count(year.replicates());
  std::vector<Counts> left_out;
  for (std::uint32_t r = 0; r < year.replicates(); ++r) left_out.push_back(counter.count(r));

  YearReport report;
  auto& m = report.metrics;
  m.occupied = counter.occupied();
  m.occupied_hours = static_cast<std::size_t>(std::lround(counter.occupied_hours()));
  m.autonomy = point_metric(all, left_out, da);
  m.continuous_autonomy = point_metric(all, left_out, cda);
  m.below_100 = point_metric(all, left_out, low);
  m.useful = point_metric(all, left_out, useful);
  m.autonomous = point_metric(all, left_out, autonomous);
  m.above_3000 = point_metric(all, left_out, high);
  m.exposure = point_metric(all, left_out, exposure);
  m.sun_hours.value = counter.sun_hours();
  m.sun_hours.standard_error.assign(m.sun_hours.value.size(), 0.0f);
  const auto mean_sun = mean_over(m.sun_hours.value), median_sun = median_of(m.sun_hours.value);
  m.sun_hours.mean = {mean_sun, mean_sun, mean_sun};
  m.sun_hours.median = {median_sun, median_sun, median_sun};
  m.autonomy_of_space = figure(all, left_out, [](const Counts& c) { return c.space; });
  m.autonomy_with_blinds = figure(all, left_out, [](const Counts& c) { return c.space_with_blinds; });
  const auto exposed = fraction_reached(m.sun_hours.value, sun_limit);
  m.sun_exposure = {exposed, exposed, exposed};
  m.hours_with_blinds = counter.hours_with_blinds();
  const auto t = 1.96 * student_widening(static_cast<double>(year.replicates()) - 1.0);
  std::size_t near = 0;
  for (std::size_t p = 0; p < m.autonomy.value.size(); ++p)
    if (std::abs(static_cast<double>(m.autonomy.value[p]) - half) <
        t * static_cast<double>(m.autonomy.standard_error[p]))
      ++near;
  m.too_near_to_tell =
      static_cast<double>(near) / static_cast<double>(std::max<std::size_t>(1, year.points()));

  report.daylight_hours = counter.bright_hours();
  for (std::size_t k = 0; k < 3; ++k) {
    ClimateProvision p;
    p.level = daylight_targets[k].level;
    p.target = daylight_targets[k].target;
    p.minimum = daylight_targets[k].minimum;
    p.points_on_target = figure(all, left_out, [k](const Counts& c) { return c.points_target[k]; });
    p.points_on_minimum = figure(all, left_out, [k](const Counts& c) { return c.points_minimum[k]; });
    p.hours_on_target = figure(all, left_out, [k](const Counts& c) { return c.hours_target[k]; });
    p.hours_on_minimum = figure(all, left_out, [k](const Counts& c) { return c.hours_minimum[k]; });
    p.met_by_points = p.points_on_target.value >= half && p.points_on_minimum.value >= 0.95;
    p.met_by_hours = p.hours_on_target.value >= half && p.hours_on_minimum.value >= half;
    p.sure_by_points = is_sure(p.points_on_target, half) && is_sure(p.points_on_minimum, 0.95);
    p.sure_by_hours = is_sure(p.hours_on_target, half) && is_sure(p.hours_on_minimum, half);
    report.provision.push_back(p);
  }
  report.hours_mean_300 = figure(all, left_out, [](const Counts& c) { return c.mean_300; });
  report.hours_min_90 = figure(all, left_out, [](const Counts& c) { return c.min_90; });
  return report;
}

}  // namespace luxel
