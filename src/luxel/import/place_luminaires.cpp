// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "luxel/core/disjoint_sets.h"
#include "luxel/core/ending_of.h"
#include "luxel/core/error.h"
#include "luxel/core/real_path.h"
#include "luxel/core/smallest_rectangle.h"
#include "luxel/core/triangle.h"
#include "luxel/core/trig.h"
#include "luxel/import/luminaires.h"
#include "luxel/import/scene_folder.h"
#include "luxel/scene/luminous_efficacy.h"

namespace luxel {
namespace {

// Local axes in the scene; the luminaire aims at -Z.
struct Axes {
  Vec3d x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, aim{0.0, 0.0, -1.0};
};

// Aiming straight down (or up): X is the scene's X, and Y the other horizontal axis, so that X, Y and up
// (down) are right-handed. Tilted: X stays level and Y points up. Then both turn about the aim.
Axes axes_of(const Vec3d& direction, const Vec3d& up, double rotation) {
  Axes axes;
  axes.aim = glm::normalize(direction);
  const auto level = glm::cross(axes.aim, up);
  if (glm::length(level) > 1e-6) {
    axes.x = glm::normalize(level);
  } else {
    axes.x = Vec3d(1.0, 0.0, 0.0);
  }
  axes.y = glm::cross(-axes.aim, axes.x);
  const auto turn = sin_cos(rotation * std::numbers::pi / 180.0);
  const auto x = axes.x;
  axes.x = turn.cosine * x + turn.sine * axes.y;
  axes.y = turn.cosine * axes.y - turn.sine * x;
  return axes;
}

// W/sr along the largest intensity, of a colour whose luminance is 1.
Vec3 intensity_of(const LuminairePlacement& placement) {
  const auto& c = placement.colour;
  const auto relative_luminance = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
  const auto candela = placement.photometry->intensity.maximum() * placement.dimming * placement.maintenance;
  return Vec3(c * (candela / (luminous_efficacy * relative_luminance)));
}

bool names_photometry(const std::string& material) {
  const auto ending = ending_of(material);
  return ending == ".ies" || ending == ".ldt";
}

// A connected component of triangles.
struct Component {
  Vec3d weighted_centre{0.0}, facing{0.0};
  double area = 0.0;
  std::vector<Vec3d> places = {};

  void add(const Scene& scene, std::size_t triangle) {
    const auto& corners = scene.triangles[triangle];
    const auto at = [&](std::size_t i) { return Vec3d(scene.positions[corners[i]]); };
    const auto normal = 0.5 * area_vector2(scene.positions[corners[0]], scene.positions[corners[1]],
                                           scene.positions[corners[2]]);
    const auto own = glm::length(normal);
    weighted_centre += own * (at(0) + at(1) + at(2)) / 3.0;
    facing += normal;
    area += own;
    for (std::size_t i = 0; i < 3; ++i) places.push_back(at(i));
  }
};

// Degrees, (-90, 90], from local X to the longer sides of the smallest rectangle around a component.
double turn_of(const Component& component, const Axes& axes) {
  std::vector<glm::dvec2> points;
  points.reserve(component.places.size());
  for (const auto& p : component.places) points.emplace_back(glm::dot(p, axes.x), glm::dot(p, axes.y));
  auto along = smallest_rectangle(std::move(points)).along;
  if (along.x < 0.0 || (along.x == 0.0 && along.y < 0.0)) along = -along;
  return 180.0 / std::numbers::pi * arc_tangent(along.y, along.x);
}

}  // namespace

void add_luminaires(const LuminairePlacement& placement, const Vec3& up, Scene& scene) {
  PointLight light;
  light.name = placement.group;
  light.kind = PointLightKind::luminaire;
  light.photometry = placement.photometry;
  const auto axes = axes_of(placement.direction.value_or(-Vec3d(up)), Vec3d(up), placement.rotation);
  light.local_x = Vec3(axes.x);
  light.local_y = Vec3(axes.y);
  light.direction = Vec3(axes.aim);
  light.dimming = static_cast<float>(placement.dimming);
  light.maintenance = static_cast<float>(placement.maintenance);
  light.intensity = intensity_of(placement);
  for (std::size_t row = 0; row < placement.rows; ++row)
    for (std::size_t column = 0; column < placement.columns; ++column) {
      const auto at = placement.position + static_cast<double>(column) * placement.column_step +
                      static_cast<double>(row) * placement.row_step;
      for (int axis = 0; axis < 3; ++axis)
        if (!(std::abs(at[axis]) <= double{farthest}))
          throw InputError(scene.source,
                           fmt::format("luminaire '{}' comes to lie beyond {:g} m", light.name, farthest));
      light.position = Vec3(at - scene.origin);
      scene.point_lights.push_back(light);
    }
}

LuminairePlacement place_over(const LuminaireGrid& grid, const Scene& scene, const Vec3& up,
                              PhotometryStore& store) {
  LuminairePlacement placement;
  placement.photometry = store.load(grid.file, {});
  placement.group = grid.file.stem().string();
  placement.rotation = grid.rotation;
  placement.maintenance = grid.maintenance;
  placement.columns = grid.columns;
  placement.rows = grid.rows;
  const auto box = bounds(scene);
  const int up_axis = up.y > 0.5f ? 1 : 2, across = 3 - up_axis;
  const auto low = Vec3d(box.low) + scene.origin, size = Vec3d(box.high) - Vec3d(box.low);
  placement.column_step[0] = size[0] / static_cast<double>(grid.columns);
  placement.row_step[across] = size[across] / static_cast<double>(grid.rows);
  placement.position = low + 0.5 * (placement.column_step + placement.row_step);
  placement.position[up_axis] = grid.height;
  return placement;
}

void replace_by_luminaires(const std::filesystem::path& scene_file, const Vec3& up, PhotometryStore& store,
                           Scene& scene) {
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    auto& material = scene.materials[m];
    if (!names_photometry(material.name)) continue;
    const auto file = scene_file.parent_path() / std::filesystem::path(material.name).filename();
    if (!is_plain_file(file)) continue;
    if (!SceneFolder(scene_file, scene.allows_outside).permits(file))
      refuse_outside(scene_file.string(), fmt::format("the file '{}'", material.name));
    add_file(scene.files, file);
    DisjointSets sets(scene.positions.size());
    std::vector<std::size_t> triangles;
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
      if (static_cast<std::size_t>(scene.triangle_material[t]) != m) continue;
      triangles.push_back(t);
      sets.join(scene.triangles[t][0], scene.triangles[t][1]);
      sets.join(scene.triangles[t][0], scene.triangles[t][2]);
    }
    std::map<std::uint32_t, Component> components;
    for (const auto t : triangles) components[sets.of(scene.triangles[t][0])].add(scene, t);
    for (const auto& [root, component] : components) {
      if (!(component.area > 0.0)) continue;
      LuminairePlacement placement;
      placement.photometry = store.load(file, {});
      placement.group = material.name;
      placement.position = component.weighted_centre / component.area + scene.origin;
      if (glm::length(component.facing) > 0.1 * component.area) {
        placement.direction = component.facing;
        // The length of the opening lies along that of the component.
        placement.rotation = turn_of(component, axes_of(component.facing, Vec3d(up), 0.0));
        const auto& size = placement.photometry->opening.size;
        if (size.y > size.x) placement.rotation -= 90.0;
      }
      add_luminaires(placement, up, scene);
    }
    material.opaque = false;
    material.emittance = Vec3(0.0f);
  }
}

}  // namespace luxel
