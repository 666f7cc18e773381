// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <optional>
#include <string>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "luxel/core/hint.h"
#include "luxel/form_factors/enforce.h"
#include "luxel/form_factors/exact_view_factors.h"
#include "luxel/form_factors/sample_view_factors.h"
#include "luxel/form_factors/view_factors_file.h"
#include "luxel/patch/make_patches.h"
#include "luxel/python/arrays.h"
#include "luxel/python/handles.h"
#include "luxel/runs/settings.h"
#include "luxel/runs/view_factor_settings.h"
#include "luxel/version.h"

namespace py = pybind11;

namespace luxel {
namespace {

// View factors and the metadata of their file.
struct FactorsHandle {
  ViewFactors factors;
  ViewFactorsNote note;
  SampleFactorsReport sampled;
};
using Handle = std::shared_ptr<FactorsHandle>;

Handle compute(const SceneHandle& input, const GivenOptions& given, const CallOptions& call) {
  SceneSettings scene_settings;
  ViewFactorSettings settings;
  OptionSet set("viewfactors", "");
  scene_settings.declare(set);
  settings.declare(set);
  settings.declare_memory(set);
  set.give(given);
  settings.check();
  scene_settings.file = input.scene.source;
  auto reporter = call.reporter();
  return reporter.run([&]() -> Handle {
    const Context context(call.threads);
    const auto reporting = reporter.reporting(context);
    const auto patches = make_patches(input.scene, settings.patch_options(scene_settings.patches), reporting);
    if (reporter.is_interrupted()) return nullptr;
    const auto elements = make_view_elements(input.scene, patches, settings.kind(), settings.element_sides());
    const Tracer tracer(patches, context);
    auto handle = std::make_shared<FactorsHandle>();
    std::optional<ViewFactors> factors;
    try {
      if (settings.is_exact) {
        ExactFactorsReport report;
        auto how = settings.exact;
        how.min_factor = settings.sampled.min_factor;
        if (settings.force) how.seconds = 0.0;
        factors = exact_view_factors(patches, tracer, elements, how, report, reporting);
      } else {
        factors = sample_view_factors(patches, tracer, elements, settings.sample_options(elements, {}),
                                      handle->sampled, reporting);
      }
    } catch (const InputError& error) {
      throw with_file(input.scene.source, error);
    }
    if (!factors) return nullptr;
    handle->factors = std::move(*factors);
    if (settings.enforce && !reporter.is_interrupted())
      handle->note.enforced = !enforce_laws(handle->factors, reporting).is_stopped;
    handle->note.between = settings.between;
    handle->note.sides = settings.sides;
    auto& provenance = handle->note.provenance;
    provenance.program_version = LUXEL_VERSION;
    provenance.command_line = set.as_command(RunSettings::heading);
    provenance.method = settings.is_exact ? "exact" : "counted";
    provenance.options = set.used_values(RunSettings::heading);
    provenance.seed = settings.sampled.seed;
    provenance.rays = handle->sampled.rays;
    provenance.scene_fingerprint = patches.scene_fingerprint;
    if (elements.kind == Between::patches) {
      handle->note.origin = patches.origin;
      for (const auto p : elements.first_patch) {
        handle->note.triangle.push_back(patches.triangle[p]);
        handle->note.centre.push_back(patches.centroid(p));
      }
    }
    return handle;
  });
}

Handle read(const std::string& path) {
  auto stored = read_view_factors_hdf5(path);
  return std::make_shared<FactorsHandle>(
      FactorsHandle{std::move(stored.factors), std::move(stored.note), {}});
}

void write(const FactorsHandle& handle, const std::string& path) {
  if (path.ends_with(".csv")) return write_view_factors_csv(path, handle.factors);
  if (path.ends_with(".mtx")) return write_view_factors_matrix_market(path, handle.factors, handle.note);
  if (path.ends_with(".h5")) return write_view_factors_hdf5(path, handle.factors, handle.note);
  throw UsageError(path + ": expected one of the extensions .h5 .csv .mtx");
}

}  // namespace

void define_view_factors(py::module_& module) {
  py::class_<FactorsHandle, Handle> factors(module, "ViewFactors");
  const auto view = [&factors](const char* name, auto make) {
    factors.def_property_readonly(
        name, [make](py::object self) -> py::object { return make(*self.cast<Handle>(), self); });
  };
  using Object = py::object;
  view("names", [](auto& h, Object) { return py::cast(h.factors.name); });
  view("areas", [](auto& h, Object o) { return view_of(h.factors.area, o); });
  view("indptr", [](auto& h, Object o) { return view_of(h.factors.row_begin, o); });
  view("indices", [](auto& h, Object o) { return view_of(h.factors.column, o); });
  view("data", [](auto& h, Object o) { return view_of(h.factors.factor, o); });
  view("data_error", [](auto& h, Object o) { return view_of(h.factors.standard_error, o); });
  view("is_known", [](auto& h, Object o) { return view_of(h.factors.is_known, o); });
  for (std::size_t s = 0; s < ViewFactors::sinks; ++s) {
    const std::string name = ViewFactors::sink_name[s];
    view(name.c_str(), [s](auto& h, Object o) { return view_of(h.factors.sink[s].factor, o); });
    view((name + "_error").c_str(),
         [s](auto& h, Object o) { return view_of(h.factors.sink[s].standard_error, o); });
  }
  view("enforced", [](auto& h, Object) { return py::bool_(h.note.enforced); });
  view("between", [](auto& h, Object) { return py::str(h.note.between); });
  view("triangles", [](auto& h, Object o) { return view_of(h.note.triangle, o); });
  view("centres", [](auto& h, Object o) { return rows_of<float>(h.note.centre, o); });
  view("rays", [](auto& h, Object) { return py::int_(h.note.provenance.rays); });
  view("error", [](auto& h, Object) { return py::float_(h.sampled.error); });
  factors.def("__len__", [](const FactorsHandle& h) { return h.factors.size(); }).def("write", write);
  module.def("view_factors", compute);
  module.def("read_view_factors", read);
}

}  // namespace luxel
