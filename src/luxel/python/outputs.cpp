// SPDX-License-Identifier: Apache-2.0
// Pictures, lightmaps and files of a solution.
#include "luxel/runs/outputs.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "luxel/core/error.h"
#include "luxel/image/tone.h"
#include "luxel/python/arrays.h"
#include "luxel/python/handles.h"
#include "luxel/render/final_gather.h"
#include "luxel/render/make_lightmap.h"
#include "luxel/runs/bake_settings.h"

namespace py = pybind11;

namespace luxel {
namespace {

// The options of what is written.
struct WriteOptions {
  BakeSettings settings;
  OptionSet set{"write", ""};

  WriteOptions(const SolutionHandle& handle, const GivenOptions& given) {
    declare_write(settings, set);
    set.give(given);
    settings.mesh.check();
    settings.picture.check();
    restore_up(handle.baked.solution.provenance, settings.look);
  }
};

py::array pixels_of(std::vector<Image> images) {
  const auto height = images.front().height, width = images.front().width;
  std::vector<float> all;
  for (const auto& image : images)
    for (const auto& p : image.pixels) all.insert(all.end(), {p.r, p.g, p.b});
  std::vector<py::ssize_t> shape = {static_cast<py::ssize_t>(images.size()), height, width, 3};
  if (images.size() == 1) shape.erase(shape.begin());
  return taken(std::move(all), std::move(shape));
}

// radiance: [row][column][channel], W/(m² sr); else what a display shows, 0 to 255.
py::object drawn(SolutionHandle& handle, const GivenOptions& given, bool is_radiance,
                 const CallOptions& call) {
  WriteOptions options(handle, given);
  auto reporter = call.reporter();
  auto picture = reporter.run([&] {
    const Context context(call.threads);
    const auto& [look, how] = std::tie(options.settings.look, options.settings.picture);
    const auto& patches = handle.baked.patches;
    const auto& tracer = handle.traced(context);
    const auto camera = camera_of(how, look, handle.baked, tracer, context);
    const auto reporting = reporter.reporting(context);
    if (how.gather > 0)
      return with_sky(gather_picture(patches, handle.baked.solution, tracer, camera,
                                     {.width = how.render.width,
                                      .height = how.render.height,
                                      .rays = how.gather,
                                      .seed = how.render.seed},
                                     reporting),
                      patches, tracer, camera, how.render, reporting);
    const auto light = make_smooth_light(patches, handle.baked.solution, look.smooth, context);
    return render_picture(patches, light, tracer, camera, how.render, reporting);
  });
  if (reporter.is_interrupted()) return py::none();
  if (is_radiance) return pixels_of({std::move(picture.radiance)});
  const auto shown = tone_map(picture.radiance, options.settings.look.tone, picture.edges, picture.sky);
  std::vector<std::uint8_t> codes;
  for (const auto& p : shown.pixels)
    codes.insert(codes.end(), {srgb_code(p.r), srgb_code(p.g), srgb_code(p.b)});
  return taken(std::move(codes), {shown.height, shown.width, 3});
}

// Returns whether the file was written.
bool write(SolutionHandle& handle, const std::string& path, const SceneHandle* scene, double scale,
           const GivenOptions& given, const CallOptions& call) {
  WriteOptions options(handle, given);
  auto& settings = options.settings;
  settings.run.outputs = {path};
  check_before_work(settings.run, settings.picture, all_kinds);
  settings.mesh.check_outputs(settings.run.outputs);
  if (scene && fingerprint(scene->scene) != handle.baked.patches.scene_fingerprint)
    throw MismatchError(
        scene->scene.source + ": it is not the scene that " + handle.name + " was solved from",
        scene->scene.source);
  auto reporter = call.reporter();
  return reporter.run([&] {
    const Context context(call.threads);
    RunRecord record(0.0);
    const MeshWish mesh{&settings.mesh, scene ? &scene->scene : nullptr, scale};
    const auto written = write_outputs(handle.baked, &handle.traced(context),
                                       {settings.run, settings.look, settings.picture, mesh},
                                       {context, reporter, record}, {handle.samples.get(), handle.samples});
    return !written.files.empty();
  });
}

py::object lightmap(SolutionHandle& handle, const LightmapOptions& options, const CallOptions& call) {
  auto reporter = call.reporter();
  LightmapReport report;
  auto map = reporter.run([&] {
    const Context context(call.threads);
    const auto* tracer = options.texels.error > 0.0 ? &handle.traced(context) : nullptr;
    return make_lightmap({handle.baked.patches, handle.baked.solution, tracer}, options, &report,
                         reporter.reporting(context));
  });
  if (map.pages.empty()) return py::none();
  std::vector<Image> irradiance, error;
  std::vector<std::uint8_t> kinds;
  for (auto& page : map.pages) {
    irradiance.push_back(std::move(page.irradiance));
    error.push_back(std::move(page.standard_error));
    for (const auto texel : page.texels) kinds.push_back(static_cast<std::uint8_t>(texel));
  }
  const auto pages = static_cast<py::ssize_t>(map.pages.size());
  const auto size = static_cast<py::ssize_t>(map.atlas.page_size);
  const std::vector<py::ssize_t> shape = {pages, size, size, 3};
  std::vector<float> uv;
  std::vector<std::int32_t> page_of;
  for (std::size_t side = 0; side < map.atlas.corners.size(); ++side) {
    const bool has = map.atlas.has(SideId::at(side));
    page_of.push_back(has ? static_cast<std::int32_t>(map.atlas.page_of(SideId::at(side))) : -1);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto at = has ? map.atlas.uv(SideId::at(side), corner) : Vec2(0.0f);
      uv.insert(uv.end(), {at.x, at.y});
    }
  }
  const auto patches = static_cast<py::ssize_t>(handle.baked.patches.size());
  py::dict result;
  result["irradiance"] = pixels_of(std::move(irradiance)).attr("reshape")(shape);
  result["irradiance_error"] = pixels_of(std::move(error)).attr("reshape")(shape);
  result["texels"] = taken(std::move(kinds), {pages, size, size});
  result["uv"] = taken(std::move(uv), {patches, 2, 3, 2});
  result["page"] = taken(std::move(page_of), {patches, 2});
  result["charts"] = report.charts;
  result["rays"] = report.texels.rays;
  return result;
}

}  // namespace

void define_outputs(py::module_& module) {
  module.def("render", drawn);
  module.def("write", write, py::arg("solution"), py::arg("path"), py::arg("scene").none(true),
             py::arg("scale"), py::arg("given"), py::arg("call"));
  py::class_<LightmapOptions>(module, "LightmapOptions")
      .def(py::init<>())
      .def_readwrite("texels_per_metre", &LightmapOptions::texels_per_metre)
      .def_readwrite("page_size", &LightmapOptions::page_size)
      .def_readwrite("margin", &LightmapOptions::margin)
      .def_readwrite("crease_angle", &LightmapOptions::crease_angle)
      .def_property(
          "final_gather", [](const LightmapOptions& o) { return o.texels.error; },
          [](LightmapOptions& o, double error) { o.texels.error = error; })
      .def_property(
          "gather_rays", [](const LightmapOptions& o) { return o.texels.max_rays; },
          [](LightmapOptions& o, std::uint32_t rays) { o.texels.max_rays = rays; })
      .def_property(
          "seed", [](const LightmapOptions& o) { return o.texels.seed; },
          [](LightmapOptions& o, std::uint64_t seed) { o.texels.seed = seed; });
  module.def("lightmap", lightmap);
}

}  // namespace luxel
