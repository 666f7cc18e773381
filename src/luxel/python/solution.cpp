// SPDX-License-Identifier: Apache-2.0
// Solutions: their arrays, and means over surfaces.
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "luxel/patch/focus.h"
#include "luxel/python/arrays.h"
#include "luxel/python/handles.h"
#include "luxel/render/solution_light.h"
#include "luxel/render/surface_measure.h"

namespace py = pybind11;

namespace luxel {
namespace {

using Handle = std::shared_ptr<SolutionHandle>;

// [patch][band] of one side; None where there are no such values.
py::object side_values(py::handle self, const SideValues& values, bool back) {
  const auto& of_side = values.of(back);
  if (of_side.empty()) return py::none();
  return table_of(of_side, self.cast<Handle>()->baked.patches.band_count(), self);
}

// [material][band], as Luxel has them together.
py::array by_material(const PatchSet& patches, std::vector<float> BandMaterial::*values) {
  std::vector<float> all;
  for (const auto& material : patches.materials)
    all.insert(all.end(), (material.*values).begin(), (material.*values).end());
  return taken(std::move(all), {static_cast<py::ssize_t>(patches.materials.size()),
                                static_cast<py::ssize_t>(patches.band_count())});
}

std::vector<std::string> names_of(const PatchSet& patches) {
  std::vector<std::string> names;
  for (const auto& material : patches.materials) names.push_back(material.name);
  return names;
}

py::dict facts_of(const SolutionHandle& handle) {
  const auto& s = handle.baked.solution;
  py::dict facts;
  facts["method"] = s.provenance.method;
  facts["seed"] = s.provenance.seed;
  facts["rays"] = s.provenance.rays;
  facts["stop"] = std::string(name(s.stop));
  facts["error"] = s.seen_error;
  facts["predicted_error"] = s.predicted_error;
  facts["error_95th"] = s.error_95th;
  facts["mesh_error"] = s.mesh_error;
  facts["unshot_fraction"] = s.unshot_fraction;
  facts["degrees_of_freedom"] = s.error_degrees_of_freedom;
  facts["version"] = s.provenance.program_version;
  facts["command_line"] = s.provenance.command_line;
  facts["fingerprint"] = s.provenance.scene_fingerprint;
  py::dict options;
  for (const auto& [key, value] : s.provenance.options) options[py::str(key)] = value;
  facts["options"] = options;
  return facts;
}

Handle read(const std::string& path, const CallOptions& call) {
  auto reporter = call.reporter();
  return reporter.run([&] {
    auto run = read_stored_run(path);
    return std::make_shared<SolutionHandle>(
        SolutionHandle{path, std::move(run.baked), std::move(run.samples)});
  });
}

void save(const SolutionHandle& handle, const std::string& path, const CallOptions& call) {
  auto reporter = call.reporter();
  reporter.run(
      [&] { write_solution(path, handle.baked.patches, handle.baked.solution, handle.samples.get()); });
}

// [replicate][patch][side], lx.
py::object replicates(const SolutionHandle& handle, const CallOptions& call) {
  if (!handle.samples) return py::none();
  auto reporter = call.reporter();
  auto rows = reporter.run(
      [&] { return replicate_illuminance(handle.baked.patches, *handle.samples, Context(call.threads)); });
  if (rows.empty()) return py::none();
  std::vector<float> all;
  for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
  return taken(std::move(all), {static_cast<py::ssize_t>(rows.size()),
                                static_cast<py::ssize_t>(handle.baked.patches.size()), 2});
}

py::tuple as_tuple(const MeasuredNumber& n) { return py::make_tuple(n.value, n.low, n.high); }

// One dictionary per set of patches. side: "auto", "front", "back".
py::list measure(const SolutionHandle& handle, const std::vector<std::vector<std::uint32_t>>& among,
                 const std::string& side, const CallOptions& call) {
  const auto& patches = handle.baked.patches;
  const auto which = side == "front"  ? SurfaceSide::front
                     : side == "back" ? SurfaceSide::back
                                      : SurfaceSide::automatic;
  auto reporter = call.reporter();
  std::string errors;
  const auto measures = reporter.run([&] {
    std::vector<std::vector<float>> rows;
    if (handle.samples) rows = replicate_illuminance(patches, *handle.samples, Context(call.threads));
    const SurfaceMeter meter(patches, handle.baked.solution, std::move(rows));
    errors = name(meter.errors_of_means());
    std::vector<SurfaceMeasure> result;
    for (const auto& selected : among) result.push_back(meter.measure(selected, which));
    return result;
  });
  py::list list;
  for (const auto& m : measures) {
    py::dict d;
    d["side"] = m.back ? "back" : "front";
    d["patches"] = m.patches;
    d["area"] = m.area;
    d["unlit"] = m.unlit;
    d["mean"] = as_tuple(m.mean);
    d["min"] = as_tuple(m.min);
    d["max"] = as_tuple(m.max);
    d["min_over_mean"] = as_tuple(m.min_over_mean);
    d["min_over_max"] = as_tuple(m.min_over_max);
    d["darkest"] = m.darkest;
    d["brightest"] = m.brightest;
    d["errors"] = errors;
    list.append(d);
  }
  return list;
}

// The patches of materials, or of objects and groups of the scene, that a pattern matches.
std::vector<std::uint32_t> patches_called(const SolutionHandle& handle, const std::string& pattern,
                                          const SceneHandle* scene) {
  const auto& patches = handle.baked.patches;
  if (scene != nullptr && fingerprint(scene->scene) != patches.scene_fingerprint)
    throw MismatchError(
        fmt::format("{}: it is not the scene that {} was solved from", scene->scene.source, handle.name),
        scene->scene.source);
  std::vector<std::uint32_t> selected;
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (is_called(scene ? &scene->scene : nullptr, patches, p, pattern))
      selected.push_back(static_cast<std::uint32_t>(p));
  return selected;
}

}  // namespace

void define_solution(py::module_& module) {
  py::class_<SolutionHandle, Handle> solution(module, "Solution");
  const auto view = [&solution](const char* name, auto make) {
    solution.def_property_readonly(
        name, [make](py::object self) -> py::object { return make(self.cast<Handle>()->baked, self); });
  };
  using Object = py::object;
  view("irradiance", [](auto& b, Object o) { return side_values(o, b.solution.irradiance, false); });
  view("irradiance_back", [](auto& b, Object o) { return side_values(o, b.solution.irradiance, true); });
  view("radiosity", [](auto& b, Object o) { return side_values(o, b.solution.radiosity, false); });
  view("radiosity_back", [](auto& b, Object o) { return side_values(o, b.solution.radiosity, true); });
  view("irradiance_error",
       [](auto& b, Object o) { return side_values(o, b.solution.standard_error, false); });
  view("irradiance_error_back",
       [](auto& b, Object o) { return side_values(o, b.solution.standard_error, true); });
  view("areas", [](auto& b, Object o) { return view_of(b.patches.area, o); });
  view("normals", [](auto& b, Object o) { return rows_of<float>(b.patches.normal, o); });
  view("vertices", [](auto& b, Object o) { return rows_of<float>(b.patches.vertices, o); });
  view("corners", [](auto& b, Object o) { return rows_of<std::uint32_t>(b.patches.corners, o); });
  view("triangles", [](auto& b, Object o) { return view_of(b.patches.triangle, o); });
  view("patch_materials",
       [](auto& b, Object o) { return rows_of<std::uint32_t>(b.patches.material, o).attr("reshape")(-1); });
  view("reflectance", [](auto& b, Object) { return by_material(b.patches, &BandMaterial::reflectance); });
  view("emittance", [](auto& b, Object) { return by_material(b.patches, &BandMaterial::emittance); });
  view("origin", [](auto& b, Object) {
    const auto& o = b.patches.origin;
    return py::make_tuple(o.x, o.y, o.z);
  });
  view("materials", [](auto& b, Object) { return py::cast(names_of(b.patches)); });
  view("bands", [](auto& b, Object) { return py::cast(b.patches.bands); });
  view("light_groups", [](auto& b, Object) { return py::cast(b.patches.light_groups); });
  view("lux", [](auto& b, Object) -> Object {
    if (!b.patches.has_colours()) return py::none();
    return taken(lux_of_bands(b.patches));
  });
  solution.def_readwrite("name", &SolutionHandle::name)
      .def_property_readonly("facts", facts_of)
      .def_property_readonly("has_samples",
                             [](const SolutionHandle& self) { return self.samples != nullptr; })
      .def("__len__", [](const SolutionHandle& self) { return self.baked.patches.size(); })
      .def("save", save)
      .def("replicates", replicates)
      .def("measure", measure)
      .def("patches_called", patches_called, py::arg("pattern"), py::arg("scene").none(true));
  module.def("read_solution", read);
}

}  // namespace luxel
