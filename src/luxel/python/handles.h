// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

#include "luxel/core/context.h"
#include "luxel/python/python_reporter.h"
#include "luxel/runs/bake_settings.h"
#include "luxel/runs/option_set.h"
#include "luxel/scene/scene.h"
#include "luxel/solution/solution_file.h"
#include "luxel/solve/relight.h"
#include "luxel/trace/tracer.h"

namespace luxel {

using GivenOptions = std::vector<std::pair<std::string, std::string>>;  // name and text

// Threads and functions of the Python program that take part in a call.
struct CallOptions {
  int threads = 0;
  pybind11::object progress, log;

  Context context() const { return Context(threads); }
  PythonReporter reporter() const { return {progress, log}; }
};

// A scene with the options that it was made with.
struct SceneHandle {
  Scene scene;
  GivenOptions given;
};

// A solution with its samples and tracer.
struct SolutionHandle {
  std::string name;  // for messages: the file
  Baked baked;
  std::shared_ptr<const SampleState> samples = nullptr;
  std::shared_ptr<const Tracer> tracer = nullptr;  // made when it is first needed

  const Tracer& traced(const Context& context) {
    if (!tracer) tracer = std::make_shared<Tracer>(baked.patches, context);
    return *tracer;
  }
};

// A solution whose lamps and colours are changed again and again.
struct RelighterHandle {
  std::shared_ptr<SolutionHandle> solution;
  std::unique_ptr<Relighter> relighter;
  bool is_changed = false;
};

// Declares the options of pictures, meshes and pages.
inline void declare_write(BakeSettings& settings, OptionSet& set) {
  settings.look.declare(set);
  settings.look.declare_title(set);
  settings.mesh.declare(set);
  settings.picture.declare(set);
  settings.picture.declare_gather(set);
  settings.picture.declare_quantity(set);
}

// Each of these defines a part of the module.
void define_options(pybind11::module_& module);
void define_scene(pybind11::module_& module);
void define_bake(pybind11::module_& module);
void define_solution(pybind11::module_& module);
void define_outputs(pybind11::module_& module);
void define_probes(pybind11::module_& module);
void define_view_factors(pybind11::module_& module);
void define_photometry(pybind11::module_& module);
void define_daylight(pybind11::module_& module);

}  // namespace luxel
