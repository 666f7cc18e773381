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

#include "luxel/python/arrays.h"
#include "luxel/python/handles.h"
#include "luxel/runs/daylight_study.h"
#include "luxel/scene/up_axis.h"

namespace py = pybind11;

namespace luxel {
namespace {

using Floats = py::array_t<double, py::array::c_style | py::array::forcecast>;

struct DaylightRequest : DaylightQuestion {
  std::string weather_file;  // empty: factors alone
  double max_edge = 0.0;
  std::vector<std::pair<std::string, double>> groups;  // of windows, by name
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
               const DaylightRequest& request, const CallOptions& call) {
  auto reporter = call.reporter();
  Handle answer;
  const bool is_whole = reporter.run([&] {
    const Context context(call.threads);
    RunRecord record(0.0);
    DaylightQuestion question = request;
    if (!request.weather_file.empty()) {
      question.weather = load_weather(request.weather_file);
      warn_of(question.weather->oddities, reporter);
    }
    question.up = Vec3d(up_of_scene(input.scene));
    question.solve.seed = question.coefficients.seed;
    if (request.max_edge > 0.0) question.solve.patches.max_edge = static_cast<float>(request.max_edge);
    for (const auto& [name, tau] : request.groups) question.blinds.push_back({name, tau});
    answer = study_daylight(input.scene, input.scene.source, std::move(question),
                            [&](const PatchSet& patches) { return points_of(patches, positions, normals); },
                            {context, reporter, record});
    return answer != nullptr;
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
      const auto& record = a.question.weather->hours[hour.record];
      const std::chrono::year_month_day day{std::chrono::year(a.question.weather->has_leap_day ? 2024 : 2023),
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
  const auto& f = handle->factors.front();
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
  py::class_<DaylightRequest>(module, "DaylightOptions")
      .def(py::init<>())
      .def_readwrite("weather", &DaylightRequest::weather_file)
      .def_readwrite("north", &DaylightRequest::north)
      .def_readwrite("albedo", &DaylightRequest::albedo)
      .def_readwrite("max_edge", &DaylightRequest::max_edge)
      .def_property(
          "error", [](const DaylightRequest& q) { return q.solve.error; },
          [](DaylightRequest& q, double error) { q.solve.error = error; })
      .def_readwrite("subdivision", &DaylightRequest::subdivision)
      .def_property(
          "rays", [](const DaylightRequest& q) { return q.coefficients.rays; },
          [](DaylightRequest& q, std::uint32_t rays) { q.coefficients.rays = rays; })
      .def_property(
          "seed", [](const DaylightRequest& q) { return q.coefficients.seed; },
          [](DaylightRequest& q, std::uint64_t seed) { q.coefficients.seed = seed; })
      .def("set_occupied",
           [](DaylightRequest& q, double from, double to) {
             q.metrics.from = from;
             q.metrics.to = to;
           })
      .def_property(
          "blind_transmittance", [](const DaylightRequest& q) { return q.transmittance; },
          [](DaylightRequest& q, double value) { q.transmittance = value; })
      .def_readwrite("blinds", &DaylightRequest::groups);
  py::class_<DaylightAnswer, Handle>(module, "Daylight")
      .def_property_readonly("minutes", minutes_of)
      .def_property_readonly("sun", sun_of_hours)
      .def_property_readonly(
          "place",
          [](const DaylightAnswer& a) { return a.question.weather ? a.question.weather->place : ""; })
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
