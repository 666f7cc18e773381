// SPDX-License-Identifier: Apache-2.0
// The options of commands, as data: names, units, help and defaults, declared where the commands have them.
#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <pybind11/pybind11.h>

#include "luxel/python/handles.h"
#include "luxel/runs/bake_settings.h"
#include "luxel/runs/relight_changes.h"
#include "luxel/runs/view_factor_settings.h"

namespace py = pybind11;

namespace luxel {
namespace {

py::list entries_of(const OptionSet& set) {
  py::list result;
  for (const auto& entry : set.entries()) {
    const auto& d = entry.declaration;
    py::dict option;
    option["name"] = d.name;
    option["heading"] = entry.heading;
    option["unit"] = d.unit;
    option["help"] = d.help;
    option["default"] = entry.default_value;
    option["is_flag"] = d.is_flag;
    option["many"] = d.many;
    option["only_with"] = py::make_tuple(entry.choice, entry.word);
    result.append(option);
  }
  return result;
}

py::list options_of(const std::string& command) {
  OptionSet set(command, "");
  BakeSettings bake;
  if (command == "bake") {
    bake.declare(set);
    return entries_of(set);
  }
  if (command == "resume") {
    bake.light.declare_bounds(set);
    bake.light.declare_memory(set);
    bake.keep.declare_every(set);
    return entries_of(set);
  }
  if (command == "write") {
    declare_write(bake, set);
    return entries_of(set);
  }
  if (command == "scene") {
    bake.scene.declare_scene(set);
    bake.scene.declare_sky(set);
    bake.scene.declare_luminaires(set);
    bake.scene.declare_spectra(set);
    bake.look.declare_up(set);
    return entries_of(set);
  }
  RelightChanges changes;
  if (command == "relight") {
    changes.declare(set);
    return entries_of(set);
  }
  ViewFactorSettings factors;
  if (command == "viewfactors") {
    SceneSettings scene;
    scene.declare(set);
    factors.declare(set);
    factors.declare_memory(set);
    return entries_of(set);
  }
  throw std::invalid_argument(fmt::format("no options of '{}'", command));
}

}  // namespace

void define_options(py::module_& module) {
  module.def("options_of", options_of, "Options of a command as dictionaries.");
  py::class_<CallOptions>(module, "Call")
      .def(py::init([](int threads, py::object progress, py::object log) {
             return CallOptions{threads, std::move(progress), std::move(log)};
           }),
           py::arg("threads"), py::arg("progress"), py::arg("log"));
}

}  // namespace luxel
