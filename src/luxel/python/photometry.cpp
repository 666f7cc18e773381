// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/photometry.h"

#include <memory>
#include <string>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "luxel/photometry/figures.h"
#include "luxel/python/arrays.h"
#include "luxel/python/handles.h"

namespace py = pybind11;

namespace luxel {
namespace {

using Handle = std::shared_ptr<Photometry>;
using Floats = py::array_t<double, py::array::c_style | py::array::forcecast>;

py::dict figures_of(const Photometry& photometry) {
  const auto figures = photometric_figures(photometry.intensity);
  const auto plane = [](const PlaneFigures& p) {
    return py::make_tuple(p.maximum, p.beam_angle, p.field_angle);
  };
  py::dict result;
  result["downward_fraction"] = figures.downward_fraction;
  result["x"] = plane(figures.x);
  result["y"] = plane(figures.y);
  return result;
}

py::list lamps_of(const Photometry& photometry) {
  py::list lamps;
  for (const auto& lamp : photometry.lamps) {
    py::dict d;
    d["count"] = lamp.count;
    d["flux"] = lamp.flux;
    d["watts"] = lamp.watts;
    d["name"] = lamp.name;
    d["colour"] = lamp.colour;
    d["colour_rendering"] = lamp.colour_rendering;
    lamps.append(d);
  }
  return lamps;
}

py::array at_angles(const Photometry& photometry, const Floats& vertical, const Floats& horizontal) {
  const auto* v = vertical.data();
  const auto* h = horizontal.data();
  std::vector<double> candela;
  for (py::ssize_t i = 0; i < vertical.size(); ++i)
    candela.push_back(photometry.intensity.at_angles(v[i], h[i]));
  return taken(std::move(candela));
}

}  // namespace

void define_photometry(py::module_& module) {
  py::class_<Photometry, Handle>(module, "Photometry")
      .def_readonly("file", &Photometry::file)
      .def_readonly("format", &Photometry::format)
      .def_readonly("luminaire", &Photometry::luminaire)
      .def_readonly("catalogue", &Photometry::catalogue)
      .def_readonly("maker", &Photometry::maker)
      .def_readonly("absolute", &Photometry::absolute)
      .def_readonly("header_flux", &Photometry::header_flux)
      .def_readonly("warnings", &Photometry::warnings)
      .def_property_readonly("flux", [](const Photometry& p) { return p.intensity.zonal_flux(); })
      .def_property_readonly("max_intensity", [](const Photometry& p) { return p.intensity.maximum(); })
      .def_property_readonly("size",
                             [](const Photometry& p) {
                               const auto& s = p.opening.size;
                               return py::make_tuple(s.x, s.y, s.z);
                             })
      .def_property_readonly("type",
                             [](const Photometry& p) {
                               const auto type = p.intensity.type();
                               return type == GoniometerType::c ? "C" : type == GoniometerType::b ? "B" : "A";
                             })
      .def_property_readonly(
          "vertical",
          [](py::object self) { return view_of(self.cast<Handle>()->intensity.vertical(), self); })
      .def_property_readonly(
          "horizontal",
          [](py::object self) { return view_of(self.cast<Handle>()->intensity.horizontal(), self); })
      .def_property_readonly("intensity",
                             [](py::object self) {
                               const auto& intensity = self.cast<Handle>()->intensity;
                               return table_of(intensity.candela(), intensity.vertical().size(), self);
                             })
      .def("at_angles", at_angles)
      .def("figures", figures_of)
      .def("lamps", lamps_of);
  module.def("load_photometry", [](const std::string& file, std::size_t lamp_set, double rotate) {
    return std::make_shared<Photometry>(load_photometry(file, {.lamp_set = lamp_set, .rotate = rotate}));
  });
}

}  // namespace luxel
