// SPDX-License-Identifier: Apache-2.0
// Daylight factors, and the illuminances of a year.
#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "luxel/daylight/daylight_factor.h"
#include "luxel/daylight/daylight_scene.h"
#include "luxel/daylight/metrics.h"
#include "luxel/daylight/window_groups.h"
#include "luxel/daylight/year.h"
#include "luxel/daylight/year_skies.h"
#include "luxel/import/set_daylight.h"
#include "luxel/python/arrays.h"
#include "luxel/python/handles.h"
#include "luxel/runs/daylight_transport.h"
#include "luxel/scene/up_axis.h"

namespace py = pybind11;

namespace luxel {
namespace {

using Floats = py::array_t<double, py::array::c_style | py::array::forcecast>;

struct DaylightQuestion {
  std::string weather;  // file; empty: factors alone
  double north = 0.0, albedo = 0.2, max_edge = 0.0, error = 0.05;
  int subdivision = 2;  // of the sky's patches
  CoefficientOptions coefficients = {};
  MetricOptions metrics = {};
  double transmittance = WindowGroup{}.transmittance;       // of closed blinds
  std::vector<std::pair<std::string, double>> blinds = {};  // of groups of windows, by name

  std::vector<WindowGroup> groups() const {
    std::vector<WindowGroup> result;
    for (const auto& [name, tau] : blinds) result.push_back({name, tau});
    return result;
  }
};

struct DaylightAnswer {
  std::optional<Weather> weather;
  std::optional<DaylightTransport> transport;
  DaylightCoefficients coefficients;
  DaylightFactors factors;
  YearSkies skies;
  WindowLight windows;
  std::optional<DaylightYear> year;  // refers to all of these
  std::optional<YearReport> report;
};
using Handle = std::shared_ptr<DaylightAnswer>;

std::vector<ProbePoint> points_of(const PatchSet& patches, const Floats& positions, const Floats& normals) {
  const auto p = positions.unchecked<2>();
  const auto n = normals.unchecked<2>();
  std::vector<ProbePoint> points;
  for (py::ssize_t i = 0; i < p.shape(0); ++i)
    points.push_back(
        {Vec3(Vec3d(p(i, 0), p(i, 1), p(i, 2)) - patches.origin), Vec3(Vec3d(n(i, 0), n(i, 1), n(i, 2)))});
  return points;
}

void warn_of(const std::vector<std::string>& sentences, PythonReporter& reporter) {
  for (const auto& sentence : sentences) warn(reporter.log(), sentence);
}

Handle compute(const SceneHandle& input, const Floats& positions, const Floats& normals,
               const DaylightQuestion& question, const CallOptions& call) {
  auto reporter = call.reporter();
  auto answer = std::make_shared<DaylightAnswer>();
  auto& a = *answer;
  const bool is_whole = reporter.run([&] {
    const Context context(call.threads);
    RunRecord record(0.0);
    if (!question.weather.empty()) {
      a.weather = load_weather(question.weather);
      warn_of(a.weather->oddities, reporter);
    }
    auto scene = input.scene;
    const auto up = Vec3d(up_of_scene(scene));
    const SkyPatches sky(question.subdivision, up, north_of(up, question.north));
    if (a.weather) a.skies = skies_of_year(*a.weather, sky, question.albedo, context);
    set_only_sky(sky, a.weather ? mean_sky(a.skies) : overcast_sky(sky, question.albedo), scene);
    const auto groups = question.groups();
    make_panes_of_groups(groups, scene);
    DaylightSolveOptions how{{}, question.error, question.coefficients.seed};
    if (question.max_edge > 0.0) how.patches.max_edge = static_cast<float>(question.max_edge);
    a.transport = solve_daylight(scene, scene.source, how, {}, {context, reporter, record});
    if (!a.transport) return false;
    const auto& t = *a.transport;
    const auto points = points_of(t.patches, positions, normals);
    a.coefficients =
        find_coefficients(t.run(), *t.tracer, points, question.coefficients, reporter.reporting(context));
    if (a.coefficients.points == 0) return false;
    a.factors = daylight_factors(a.coefficients, 16, question.albedo);
    if (!a.weather) return true;
    a.windows = groups.empty() ? all_windows(question.transmittance)
                               : window_light(scene, t, a.coefficients, groups, question.coefficients,
                                              reporter.reporting(context));
    if (a.windows.groups.empty()) return false;
    a.year.emplace(YearCoefficients{a.coefficients, a.windows}, a.skies, a.coefficients.origins,
                   SunSurroundings{t.patches, *t.tracer}, reporter.reporting(context));
    if (a.year->is_stopped()) return false;
    a.report = metrics_of(*a.year, *a.weather, question.metrics);
    return !reporter.is_interrupted();
  });
  return is_whole ? answer : nullptr;
}

py::tuple as_tuple(const Figure& f) { return py::make_tuple(f.value, f.low, f.high); }

// Minutes since 1970 of the middle of each hour, of a calendar without time zone: month and day are those of
// the file, the year is the one that its 29 February allows.
py::array minutes_of(const DaylightAnswer& a) {
  std::vector<std::int64_t> minutes;
  if (a.year)
    for (const auto& hour : a.year->hours()) {
      const auto& record = a.weather->hours[hour.record];
      const std::chrono::year_month_day day{std::chrono::year(a.weather->has_leap_day ? 2024 : 2023),
                                            std::chrono::month(record.month), std::chrono::day(record.day)};
      const auto days = std::chrono::sys_days(day).time_since_epoch().count();
      minutes.push_back(static_cast<std::int64_t>(days) * 1440 +
                        static_cast<std::int64_t>(std::llround(hour.time * 60.0)));
    }
  return taken(std::move(minutes));
}

py::array by_hour(const DaylightAnswer& a, std::vector<float> values) {
  const auto hours = static_cast<py::ssize_t>(a.year ? a.year->hours().size() : 0);
  return taken(std::move(values), {hours, static_cast<py::ssize_t>(a.coefficients.points)});
}

py::array sun_of_hours(const DaylightAnswer& a) {
  std::vector<double> angles;
  if (a.year)
    for (const auto& hour : a.year->hours())
      angles.insert(angles.end(),
                    {hour.sun.elevation, hour.sun.azimuth, hour.sky_illuminance, hour.sun_illuminance});
  return taken(std::move(angles), {static_cast<py::ssize_t>(angles.size() / 4), 4});
}

py::dict metrics_as_dict(const Handle& handle) {
  py::dict result;
  if (!handle->report) return result;
  const auto& m = handle->report->metrics;
  const py::object owner = py::cast(handle);
  const auto add = [&](const char* name, const PointMetric& metric) {
    result[name] = view_of(metric.value, owner);
    result[py::str(std::string(name) + "_error")] = view_of(metric.standard_error, owner);
  };
  add("daylight_autonomy", m.autonomy);
  add("continuous_daylight_autonomy", m.continuous_autonomy);
  add("useful_daylight", m.useful);
  add("below_100", m.below_100);
  add("autonomous", m.autonomous);
  add("above_3000", m.above_3000);
  add("exposure", m.exposure);
  add("sun_hours", m.sun_hours);
  result["sDA"] = as_tuple(m.autonomy_of_space);
  result["sDA_with_blinds"] = as_tuple(m.autonomy_with_blinds);
  result["ASE"] = as_tuple(m.sun_exposure);
  result["occupied_hours"] = m.occupied_hours;
  py::dict blinds;
  for (const auto& group : m.blinds) blinds[py::str(group.name)] = group.closed_hours;
  result["closed_hours"] = blinds;
  return result;
}

py::dict factors_as_dict(const Handle& handle) {
  const auto& f = handle->factors;
  const py::object owner = py::cast(handle);
  py::dict result;
  result["factor"] = view_of(f.value, owner);
  result["factor_error"] = view_of(f.standard_error, owner);
  result["sky"] = view_of(f.components[0], owner);
  result["external"] = view_of(f.components[1], owner);
  result["internal"] = view_of(f.components[2], owner);
  result["mean"] = as_tuple(f.mean);
  result["median"] = as_tuple(f.median);
  result["min"] = as_tuple(f.min);
  result["uniformity"] = as_tuple(f.min_over_mean);
  return result;
}

}  // namespace

void define_daylight(py::module_& module) {
  py::class_<DaylightQuestion>(module, "DaylightOptions")
      .def(py::init<>())
      .def_readwrite("weather", &DaylightQuestion::weather)
      .def_readwrite("north", &DaylightQuestion::north)
      .def_readwrite("albedo", &DaylightQuestion::albedo)
      .def_readwrite("max_edge", &DaylightQuestion::max_edge)
      .def_readwrite("error", &DaylightQuestion::error)
      .def_readwrite("subdivision", &DaylightQuestion::subdivision)
      .def_property(
          "rays", [](const DaylightQuestion& q) { return q.coefficients.rays; },
          [](DaylightQuestion& q, std::uint32_t rays) { q.coefficients.rays = rays; })
      .def_property(
          "seed", [](const DaylightQuestion& q) { return q.coefficients.seed; },
          [](DaylightQuestion& q, std::uint64_t seed) { q.coefficients.seed = seed; })
      .def("set_occupied",
           [](DaylightQuestion& q, double from, double to) {
             q.metrics.from = from;
             q.metrics.to = to;
           })
      .def_property(
          "blind_transmittance", [](const DaylightQuestion& q) { return q.transmittance; },
          [](DaylightQuestion& q, double value) { q.transmittance = value; })
      .def_readwrite("blinds", &DaylightQuestion::blinds);
  py::class_<DaylightAnswer, Handle>(module, "Daylight")
      .def_property_readonly("minutes", minutes_of)
      .def_property_readonly("sun", sun_of_hours)
      .def_property_readonly("place",
                             [](const DaylightAnswer& a) { return a.weather ? a.weather->place : ""; })
      .def_property_readonly("has_year", [](const DaylightAnswer& a) { return a.year.has_value(); })
      .def_property_readonly("knows_openings",
                             [](const DaylightAnswer& a) { return a.coefficients.knows_openings; })
      .def_property_readonly("solve_error", [](const DaylightAnswer& a) { return a.transport->error; })
      .def("factors", [](const Handle& handle) { return factors_as_dict(handle); })
      .def("metrics", metrics_as_dict)
      .def("illuminance",
           [](const DaylightAnswer& a) { return by_hour(a, a.year->illuminance(a.year->replicates())); })
      .def("illuminance_error",
           [](const DaylightAnswer& a) {
             return by_hour(a, illuminance_errors(*a.year, a.year->illuminance(a.year->replicates())));
           })
      .def("direct_sun", [](const DaylightAnswer& a) { return by_hour(a, a.year->direct_sun()); });
  module.def("daylight", compute);
}

}  // namespace luxel
