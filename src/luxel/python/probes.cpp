// SPDX-License-Identifier: Apache-2.0
// Light at points of free space, and on calculation planes.
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "luxel/lighting/calculation_plane.h"
#include "luxel/python/arrays.h"
#include "luxel/python/handles.h"
#include "luxel/render/probe_sphere.h"
#include "luxel/render/solution_light.h"
#include "luxel/runs/picture_camera.h"

namespace py = pybind11;

namespace luxel {
namespace {

using Floats = py::array_t<double, py::array::c_style | py::array::forcecast>;

// positions, normals: [point][3]; normals are unit.
std::vector<ProbePoint> points_of(const PatchSet& patches, const Floats& positions, const Floats& normals) {
  const auto p = positions.unchecked<2>();
  const auto n = normals.unchecked<2>();
  std::vector<ProbePoint> points;
  for (py::ssize_t i = 0; i < p.shape(0); ++i) {
    const Vec3d at(p(i, 0), p(i, 1), p(i, 2));
    points.push_back({Vec3(at - patches.origin), Vec3(Vec3d(n(i, 0), n(i, 1), n(i, 2)))});
  }
  return points;
}

py::object probe(SolutionHandle& handle, const Floats& positions, const Floats& normals,
                 const ProbeOptions& options, const CallOptions& call) {
  check_has_lux(handle.baked.patches, handle.name);
  const auto points = points_of(handle.baked.patches, positions, normals);
  auto reporter = call.reporter();
  const auto light = reporter.run([&] {
    const Context context(call.threads);
    const auto& tracer = handle.traced(context);
    const SolutionProbe probing(handle.baked.patches, handle.baked.solution, tracer, handle.samples.get(),
                                context);
    return probe_light(probing, points, options, reporter.reporting(context));
  });
  if (light.size() != points.size()) return py::none();
  std::vector<double> illuminance, error, sampling, irradiance;
  std::vector<std::uint8_t> place, reached;
  for (const auto& l : light) {
    illuminance.push_back(l.illuminance);
    error.push_back(l.standard_error());
    sampling.push_back(l.sampling_error);
    irradiance.insert(irradiance.end(), l.irradiance.begin(), l.irradiance.end());
    place.push_back(static_cast<std::uint8_t>(l.place));
    reached.push_back(l.reached ? 1 : 0);
  }
  const auto count = static_cast<py::ssize_t>(points.size());
  py::dict result;
  result["illuminance"] = taken(std::move(illuminance));
  result["illuminance_error"] = taken(std::move(error));
  result["sampling_error"] = taken(std::move(sampling));
  result["irradiance"] =
      taken(std::move(irradiance), {count, static_cast<py::ssize_t>(handle.baked.patches.band_count())});
  result["place"] = taken(std::move(place));
  result["reached"] = taken(std::move(reached));
  return result;
}

py::object spheres(SolutionHandle& handle, const Floats& positions, std::size_t count,
                   const ProbeOptions& options, const CallOptions& call) {
  check_has_lux(handle.baked.patches, handle.name);
  Floats normals({positions.shape(0), py::ssize_t{3}});
  auto n = normals.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < n.shape(0); ++i) n(i, 0) = n(i, 1) = 0.0, n(i, 2) = 1.0;
  const auto points = points_of(handle.baked.patches, positions, normals);
  auto reporter = call.reporter();
  const auto light = reporter.run([&] {
    const Context context(call.threads);
    const SolutionProbe probing(handle.baked.patches, handle.baked.solution, handle.traced(context),
                                handle.samples.get(), context);
    return probe_spheres(probing, points, count, options, reporter.reporting(context));
  });
  if (light.size() != points.size()) return py::none();
  std::vector<double> coefficients, error;
  for (const auto& l : light) {
    coefficients.insert(coefficients.end(), l.coefficients.begin(), l.coefficients.end());
    error.push_back(l.error);
  }
  const auto bands = static_cast<py::ssize_t>(handle.baked.patches.band_count());
  py::dict result;
  result["coefficients"] = taken(std::move(coefficients), {static_cast<py::ssize_t>(points.size()), bands,
                                                           static_cast<py::ssize_t>(count)});
  result["relative_error"] = taken(std::move(error));
  return result;
}

py::tuple as_tuple(const Figure& f) { return py::make_tuple(f.value, f.low, f.high); }

// [row][column] of the cells, NaN where there is no point.
py::array grid_of(const PlaneResult& plane, double (*value)(const ProbedLight&)) {
  const auto& grid = plane.grid;
  std::vector<double> cells(grid.rows * grid.columns, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < plane.light.size(); ++i) cells[grid.cell[i]] = value(plane.light[i]);
  return taken(std::move(cells),
               {static_cast<py::ssize_t>(grid.rows), static_cast<py::ssize_t>(grid.columns)});
}

py::object measure(SolutionHandle& handle, const CalculationArea& area, const SceneHandle* scene,
                   const ProbeOptions& options, const CallOptions& call) {
  check_has_lux(handle.baked.patches, handle.name);
  const auto& baked = handle.baked;
  LookSettings look;
  restore_up(baked.solution.provenance, look);
  auto reporter = call.reporter();
  const auto plane = reporter.run([&] {
    const Context context(call.threads);
    const auto& tracer = handle.traced(context);
    const SolutionProbe probing(baked.patches, baked.solution, tracer, handle.samples.get(), context);
    const AreaScene around{baked.patches, baked.solution, tracer, Vec3d(up_of(look, baked.patches)),
                           scene ? &scene->scene : nullptr};
    return measure_plane(probing, area, around, options, reporter.reporting(context));
  });
  if (!plane) return py::none();
  std::vector<double> positions;
  for (const auto& p : plane->grid.position) positions.insert(positions.end(), {p.x, p.y, p.z});
  py::dict result;
  result["mean"] = as_tuple(plane->mean);
  result["min"] = as_tuple(plane->min);
  result["max"] = as_tuple(plane->max);
  result["uniformity"] = as_tuple(plane->min_over_mean);
  result["diversity"] = as_tuple(plane->min_over_max);
  result["illuminance"] = grid_of(*plane, [](const ProbedLight& l) { return l.illuminance; });
  result["illuminance_error"] = grid_of(*plane, [](const ProbedLight& l) { return l.standard_error(); });
  result["positions"] = taken(std::move(positions), {static_cast<py::ssize_t>(plane->grid.points()), 3});
  result["spacing"] = plane->grid.spacing;
  result["errors"] = name(plane->solution_errors);
  result["points_behind"] = plane->behind;
  return result;
}

// The rectangle of the patches' extents at a height above the file's zero, on the up axis.
std::vector<std::vector<double>> extents_at(const SolutionHandle& handle, double height) {
  LookSettings look;
  restore_up(handle.baked.solution.provenance, look);
  const auto& patches = handle.baked.patches;
  const auto up = up_of(look, patches);
  const std::size_t axis = std::abs(up.y) > 0.5f ? 1 : 2;
  Vec3d low(std::numeric_limits<double>::infinity()), high(-std::numeric_limits<double>::infinity());
  for (const auto& corner : patches.corners)
    for (const auto v : corner) {
      low = glm::min(low, patches.in_file(patches.vertices[v]));
      high = glm::max(high, patches.in_file(patches.vertices[v]));
    }
  const std::size_t other = axis == 1 ? 2 : 1;
  const auto corner = [&](double x, double y) {
    std::vector<double> at(3);
    at[0] = x;
    at[other] = y;
    at[axis] = height;
    return at;
  };
  const auto o = static_cast<glm::length_t>(other);
  return {corner(low.x, low[o]), corner(high.x, low[o]), corner(high.x, high[o]), corner(low.x, high[o])};
}

CalculationArea area_of(const std::string& name, const std::vector<std::vector<double>>& polygon,
                        const std::string& surface, std::optional<double> spacing, double border,
                        double maintenance) {
  CalculationArea area;
  area.name = name;
  for (const auto& p : polygon) area.polygon.emplace_back(p[0], p[1], p[2]);
  area.surface = surface;
  area.spacing = spacing;
  area.border = border;
  area.maintenance.factor = maintenance;
  return area;
}

}  // namespace

void define_probes(py::module_& module) {
  py::class_<ProbeOptions>(module, "ProbeOptions")
      .def(py::init<>())
      .def_readwrite("error", &ProbeOptions::error)
      .def_readwrite("floor", &ProbeOptions::floor)
      .def_readwrite("rays", &ProbeOptions::max_rays)
      .def_readwrite("seed", &ProbeOptions::seed)
      .def_readwrite("direct", &ProbeOptions::direct);
  py::class_<CalculationArea>(module, "Area")
      .def(py::init(&area_of), py::arg("name"), py::arg("polygon"), py::arg("surface"),
           py::arg("spacing").none(true), py::arg("border"), py::arg("maintenance"))
      .def_readwrite("is_direct", &CalculationArea::is_direct);
  module.def("probe", probe);
  module.def("probe_spheres", spheres);
  module.def("measure_plane", measure, py::arg("solution"), py::arg("area"), py::arg("scene").none(true),
             py::arg("options"), py::arg("call"));
  module.def("extents_at", extents_at);
}

}  // namespace luxel
