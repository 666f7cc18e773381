// SPDX-License-Identifier: Apache-2.0
// The extension module luxel._core: plain functions and read-only arrays. The Python files beside it make it
// the interface that people use.
#include <exception>
#include <new>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "luxel/core/hint.h"
#include "luxel/python/handles.h"
#include "luxel/version.h"

namespace py = pybind11;

namespace luxel {
namespace {

// Raises the Python exception of a kind: luxel._errors words it.
void raise(const char* kind, const Error& error) {
  const auto make = py::module_::import("luxel._errors").attr("make");
  const auto raised = make(kind, error.what(), as_pairs(hints_of(error)), error.file, error.line);
  PyErr_SetObject(py::type::handle_of(raised).ptr(), raised.ptr());
}

void translate(std::exception_ptr pointer) {
  try {
    if (pointer) std::rethrow_exception(pointer);
  } catch (const UsageError& error) {
    raise("usage", error);
  } catch (const InputError& error) {
    raise("input", error);
  } catch (const FormatError& error) {
    raise("format", error);
  } catch (const MismatchError& error) {
    raise("mismatch", error);
  } catch (const DeviceError& error) {
    raise("device", error);
  } catch (const Error& error) {
    raise("error", error);
  }
}

}  // namespace
}  // namespace luxel

PYBIND11_MODULE(_core, module) {
  module.attr("version") = LUXEL_VERSION;
  py::register_exception_translator(luxel::translate);
  luxel::define_options(module);
  luxel::define_scene(module);
  luxel::define_solution(module);
  luxel::define_bake(module);
  luxel::define_outputs(module);
  luxel::define_probes(module);
  luxel::define_view_factors(module);
  luxel::define_photometry(module);
  luxel::define_daylight(module);
}
