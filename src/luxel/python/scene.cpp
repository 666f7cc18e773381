// SPDX-License-Identifier: Apache-2.0
// Scenes: read from files, and made of arrays.
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "luxel/import/finish_scene.h"
#include "luxel/import/place_positions.h"
#include "luxel/python/arrays.h"
#include "luxel/python/handles.h"
#include "luxel/runs/bake_settings.h"
#include "luxel/runs/lit_scene.h"
#include "luxel/scene/up_axis.h"

namespace py = pybind11;

namespace luxel {
namespace {

using Floats = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

// The settings that the options of a scene fill.
struct SceneOptions {
  BakeSettings settings;
  OptionSet set{"bake", ""};

  explicit SceneOptions(const GivenOptions& given) {
    settings.declare(set);
    set.give(given);
    settings.scene.check();
  }
  LoadOptions load_options() const { return luxel::load_options(settings.scene, settings.look.up); }
};

std::shared_ptr<SceneHandle> load(const std::string& path, const GivenOptions& given,
                                  const CallOptions& call) {
  const SceneOptions options(given);
  auto reporter = call.reporter();
  return reporter.run([&] {
    const auto context = call.context();
    return std::make_shared<SceneHandle>(
        SceneHandle{load_scene(path, options.load_options(), reporter.reporting(context)), given});
  });
}

struct MaterialRow {
  std::string name;
  std::vector<double> reflectance, radiance, transmittance;  // of three bands; transmittance may be empty
  bool two_sided = true;
};

Vec3 vector_of(const std::vector<double>& three) {
  return {static_cast<float>(three[0]), static_cast<float>(three[1]), static_cast<float>(three[2])};
}

Material material_of(const MaterialRow& row, float max_reflectance) {
  constexpr auto pi_float = 3.14159265358979f;
  Material material;
  material.name = row.name;
  const auto stated = vector_of(row.reflectance);
  material.reflectance = glm::min(stated, Vec3(max_reflectance));
  if (material.reflectance != stated) material.stated_reflectance = stated;
  material.emittance = pi_float * vector_of(row.radiance);
  material.two_sided = row.two_sided;
  material.opaque = row.transmittance.empty();
  if (!material.opaque) material.transmittance = vector_of(row.transmittance);
  return material;
}

Scene scene_of_arrays(const Floats& vertices, const Integers& faces, const Integers& material,
                      const std::vector<MaterialRow>& rows, const LoadOptions& options) {
  Scene scene;
  scene.source = "arrays";
  scene.groups = {"default"};
  for (const auto& row : rows) scene.materials.push_back(material_of(row, options.max_reflectance));
  const auto at = vertices.unchecked<2>();
  std::vector<Vec3d> positions;
  for (py::ssize_t i = 0; i < at.shape(0); ++i) positions.emplace_back(at(i, 0), at(i, 1), at(i, 2));
  const auto corner = faces.unchecked<2>();
  const auto of = material.unchecked<1>();
  Reach reach;
  for (py::ssize_t i = 0; i < corner.shape(0); ++i) {
    auto& triangle = scene.triangles.emplace_back();
    for (py::ssize_t k = 0; k < 3; ++k) {
      triangle[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(corner(i, k));
      reach.add(positions[static_cast<std::size_t>(corner(i, k))]);
    }
    scene.triangle_material.push_back(static_cast<MaterialId>(of(i)));
  }
  scene.triangle_line.assign(scene.triangles.size(), 0);
  scene.triangle_group.assign(scene.triangles.size(), 0);
  place_positions(positions, reach, options.scale, scene);
  return scene;
}

// Indices are in range: the Python side has checked them.
std::shared_ptr<SceneHandle> from_arrays(const Floats& vertices, const Integers& faces,
                                         const Integers& material, const std::vector<MaterialRow>& rows,
                                         const GivenOptions& given, const CallOptions& call) {
  const SceneOptions options(given);
  auto how = options.load_options();
  how.retriangulate = false;  // faces are numbered as they were given
  auto scene = scene_of_arrays(vertices, faces, material, rows, how);
  auto reporter = call.reporter();
  reporter.run([&] {
    const auto context = call.context();
    finish_scene(scene.source, how, scene, reporter.reporting(context));
    check_scene(scene);
  });
  return std::make_shared<SceneHandle>(SceneHandle{std::move(scene), given});
}

std::vector<std::string> names_of(const std::vector<Material>& materials) {
  std::vector<std::string> names;
  for (const auto& material : materials) names.push_back(material.name);
  return names;
}

py::tuple as_tuple(const Vec3d& v) { return py::make_tuple(v.x, v.y, v.z); }

}  // namespace

void define_scene(py::module_& module) {
  using Handle = std::shared_ptr<SceneHandle>;
  py::class_<MaterialRow>(module, "MaterialRow")
      .def(py::init([](std::string name, std::vector<double> reflectance, std::vector<double> radiance,
                       std::vector<double> transmittance, bool two_sided) {
        return MaterialRow{std::move(name), std::move(reflectance), std::move(radiance),
                           std::move(transmittance), two_sided};
      }));
  py::class_<SceneHandle, Handle>(module, "Scene")
      .def_property_readonly("source", [](const SceneHandle& self) { return self.scene.source; })
      .def_readonly("given", &SceneHandle::given)
      .def_property_readonly(
          "vertices",
          [](py::object self) { return rows_of<float>(self.cast<Handle>()->scene.positions, self); })
      .def_property_readonly(
          "faces",
          [](py::object self) { return rows_of<std::uint32_t>(self.cast<Handle>()->scene.triangles, self); })
      .def_property_readonly("face_materials",
                             [](py::object self) {
                               return rows_of<std::uint32_t>(self.cast<Handle>()->scene.triangle_material,
                                                             self)
                                   .attr("reshape")(-1);
                             })
      .def_property_readonly(
          "face_groups",
          [](py::object self) { return view_of(self.cast<Handle>()->scene.triangle_group, self); })
      .def_property_readonly("materials",
                             [](const SceneHandle& self) { return names_of(self.scene.materials); })
      .def_property_readonly("groups", [](const SceneHandle& self) { return self.scene.groups; })
      .def_property_readonly("objects", [](const SceneHandle& self) { return self.scene.objects; })
      .def_property_readonly("origin", [](const SceneHandle& self) { return as_tuple(self.scene.origin); })
      .def_property_readonly("has_light", [](const SceneHandle& self) { return has_light(self.scene); })
      .def_property_readonly("luminaires",
                             [](const SceneHandle& self) { return self.scene.point_lights.size(); })
      .def_property_readonly(
          "up_axis",
          [](const SceneHandle& self) { return std::abs(up_of_scene(self.scene).y) > 0.5f ? 1 : 2; })
      .def_property_readonly("fingerprint", [](const SceneHandle& self) { return fingerprint(self.scene); });
  module.def("load_scene", load);
  module.def("scene_from_arrays", from_arrays);
}

}  // namespace luxel
