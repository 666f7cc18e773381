// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>

#include "luxel/core/student.h"
#include "luxel/lighting/daylight_factor.h"
#include "luxel/lighting/replicate_figure.h"
#include "luxel/photometry/weather_figures.h"

namespace luxel {
namespace {

constexpr double autonomy_lux = 300.0, useful_from = 100.0, useful_to = 3000.0;
constexpr double sun_lux = 1000.0, sun_limit = 250.0, half = 0.5;

// Records that count as occupied.
bool is_occupied(const Weather& weather, std::size_t record, const MetricOptions& options) {
  if (!options.schedule.occupied.empty()) return options.schedule.occupied[record] != 0;
  const auto middle = weather.hours[record].end - 0.5 * weather.hours[record].duration;
  return middle >= options.from && middle < options.to;
}

enum Metric : std::size_t { da, cda, low, useful, autonomous, high, exposure, sunlit, metrics };

// All that is counted for one set of illuminances.
struct Counts {
  std::array<std::vector<float>, metrics> of_point;
  double space = 0.0, space_with_blinds = 0.0, exposed = 0.0;  // fractions of the points
  std::array<double, 3> points_target{}, points_minimum{}, hours_target{}, hours_minimum{};
  double mean_300 = 0.0, min_90 = 0.0;  // h
  double lighting = 0.0;                // kWh
};

class Counter {
 public:
  Counter(const DaylightYear& year, const Weather& weather, const MetricOptions& options)
      : year_(year), options_(options) {
    const auto& hours = year.hours();
    for (std::size_t h = 0; h < weather.hours.size(); ++h)
      if (is_occupied(weather, h, options)) {
        ++occupied_;
        whole_ += weather.hours[h].duration;
      }
    dark_ = whole_;
    for (const auto& hour : hours) {
      is_occupied_.push_back(is_occupied(weather, hour.record, options));
      if (is_occupied_.back()) dark_ -= hour.duration;
    }
    dark_ = std::max(0.0, dark_);
    blinds_.emplace(year, is_occupied_, options.blinds, options.schedule);
    find_bright_half(weather);
  }

  std::size_t occupied() const { return occupied_; }
  double occupied_hours() const { return whole_; }
  std::size_t hours_with_blinds() const {
    std::size_t count = 0;
    for (std::size_t h = 0; h < is_occupied_.size(); ++h) {
      bool any = false;
      for (std::size_t g = 0; g < year_.groups().size(); ++g) any = any || blinds_->closed(g)[h] > 0.0f;
      if (any && is_occupied_[h]) ++count;
    }
    return count;
  }
  std::vector<BlindsFigures> blinds() const {
    std::vector<BlindsFigures> groups;
    std::vector<float> light;
    if (year_.has_groups()) light = year_.illuminance(year_.replicates());
    const auto whole = sum_over_year(light);
    for (std::size_t g = 0; g < year_.groups().size(); ++g) {
      BlindsFigures figures{year_.groups()[g].name, year_.groups()[g].transmittance, 0.0, 1.0};
      for (std::size_t h = 0; h < is_occupied_.size(); ++h)
        if (is_occupied_[h])
          figures.closed_hours += static_cast<double>(blinds_->closed(g)[h]) * year_.hours()[h].duration;
      if (year_.has_groups())
        figures.part_of_light =
            sum_over_year(year_.through(g, light, year_.replicates())) / std::max(whole, 1e-30);
      groups.push_back(figures);
    }
    return groups;
  }
  std::size_t bright_hours() const { return bright_.size(); }

  Counts count(std::uint32_t left_out) const {
    const auto light = year_.illuminance(left_out);
    auto with_blinds = light;
    blinds_->apply(with_blinds, left_out);
    const auto points = year_.points();
    Counts counts;
    for (auto& values : counts.of_point) values.assign(points, 0.0f);
    const auto sunlight = year_.direct_sun(left_out);
    std::vector<float> autonomy_with_blinds(points, 0.0f);
    for (std::size_t h = 0; h < year_.hours().size(); ++h) {
      const auto duration = static_cast<float>(year_.hours()[h].duration);
      const auto here = std::span(light).subspan(h * points, points);
      for (std::size_t m = 0; m < points; ++m) counts.of_point[exposure][m] += duration * here[m];
      if (!is_occupied_[h]) continue;
      add_occupied(here, duration, counts);
      for (std::size_t m = 0; m < points; ++m)
        if (static_cast<double>(sunlight[h * points + m]) > sun_lux) counts.of_point[sunlit][m] += duration;
      const auto screened = std::span(with_blinds).subspan(h * points, points);
      for (std::size_t m = 0; m < points; ++m)
        if (static_cast<double>(screened[m]) >= autonomy_lux) autonomy_with_blinds[m] += duration;
      counts.lighting += lighting_energy(screened, static_cast<double>(duration));
    }
    counts.lighting += undimmed_power() * dark_;
    finish(counts, autonomy_with_blinds);
    count_provision(light, counts);
    return counts;
  }

  double undimmed_energy() const { return undimmed_power() * whole_; }  // kWh

 private:
  double undimmed_power() const { return 1e-3 * options_.lighting.power; }  // kW

  // kWh.
  double lighting_energy(std::span<const float> lux, double duration) const {
    const auto mean = std::accumulate(lux.begin(), lux.end(), 0.0) / static_cast<double>(lux.size());
    return undimmed_power() * duration * std::clamp(1.0 - mean / options_.lighting.level, 0.0, 1.0);
  }

  // lx h, over all points.
  double sum_over_year(const std::vector<float>& light) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < light.size(); ++i)
      sum += year_.hours()[i / year_.points()].duration * static_cast<double>(light[i]);
    return sum;
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

  static void add_occupied(std::span<const float> here, float duration, Counts& counts) {
    double sum = 0.0, least = std::numeric_limits<double>::infinity();
    for (std::size_t m = 0; m < here.size(); ++m) {
      const auto lux = static_cast<double>(here[m]);
      auto& of = counts.of_point;
      if (lux >= autonomy_lux) of[da][m] += duration;
      of[cda][m] += duration * static_cast<float>(std::min(1.0, lux / autonomy_lux));
      of[lux < useful_from ? low : lux <= useful_to ? useful : high][m] += duration;
      if (lux >= autonomy_lux && lux <= useful_to) of[autonomous][m] += duration;
      sum += lux;
      least = std::min(least, lux);
    }
    if (sum >= 300.0 * static_cast<double>(here.size())) counts.mean_300 += static_cast<double>(duration);
    if (least >= 90.0) counts.min_90 += static_cast<double>(duration);
  }

  void finish(Counts& counts, std::vector<float>& with_blinds) const {
    const auto whole = static_cast<float>(std::max(whole_, 1e-9));
    for (auto& v : counts.of_point[low]) v += static_cast<float>(dark_);
    for (std::size_t k = 0; k < exposure; ++k)
      for (auto& v : counts.of_point[k]) v /= whole;
    for (auto& v : with_blinds) v /= whole;
    counts.space = fraction_reached(counts.of_point[da], half);
    counts.space_with_blinds = fraction_reached(with_blinds, half);
    counts.exposed = fraction_reached(counts.of_point[sunlit], sun_limit);
  }

  void count_provision(const std::vector<float>& light, Counts& counts) const {
    const auto points = year_.points();
    const auto n = static_cast<double>(std::max<std::size_t>(1, bright_.size()));
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<float> on_target(points, 0.0f), on_minimum(points, 0.0f);
      double hours_target = 0.0, hours_minimum = 0.0;
      for (const auto h : bright_) {
        std::size_t t = 0, l = 0;
        for (std::size_t m = 0; m < points; ++m) {
          const auto lux = static_cast<double>(light[h * points + m]);
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
  double whole_ = 0.0, dark_ = 0.0;  // h: occupied, those without light
  std::vector<bool> is_occupied_;    // [hour of the year]
  std::vector<std::size_t> bright_;  // hours of the year
  std::optional<Blinds> blinds_;
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

// The fraction of points whose interval holds a limit.
double too_near(const PointMetric& metric, double limit, double widening) {
  std::size_t near = 0;
  for (std::size_t p = 0; p < metric.value.size(); ++p)
    if (std::abs(static_cast<double>(metric.value[p]) - limit) <
        1.96 * widening * static_cast<double>(metric.standard_error[p]))
      ++near;
  return static_cast<double>(near) / static_cast<double>(std::max<std::size_t>(1, metric.value.size()));
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
  m.sun_hours = point_metric(all, left_out, sunlit);
  m.autonomy_of_space = figure(all, left_out, [](const Counts& c) { return c.space; });
  m.autonomy_with_blinds = figure(all, left_out, [](const Counts& c) { return c.space_with_blinds; });
  m.sun_exposure = figure(all, left_out, [](const Counts& c) { return c.exposed; });
  m.hours_with_blinds = counter.hours_with_blinds();
  m.blinds = counter.blinds();
  m.lighting_energy = figure(all, left_out, [](const Counts& c) { return c.lighting; });
  const auto undimmed = counter.undimmed_energy();
  m.lighting_saved = figure(all, left_out, [=](const Counts& c) { return undimmed - c.lighting; });
  const auto widening = student_widening(static_cast<double>(year.replicates()) - 1.0);
  m.too_near_to_tell = too_near(m.autonomy, half, widening);
  m.sun_too_near_to_tell = too_near(m.sun_hours, sun_limit, widening);

  report.light_taken_twice = year.light_taken_twice();
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
