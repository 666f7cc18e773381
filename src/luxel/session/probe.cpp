// SPDX-License-Identifier: Apache-2.0
#include "luxel/session/probe.h"

#include <algorithm>

namespace luxel {
namespace {

bool lies_on(const SessionLight* light, const SessionMesh& mesh) {
  return light != nullptr && light->smooth && light->mesh.geometry == mesh.geometry;
}

}  // namespace

std::optional<Probe> probe(const SessionMesh& mesh, const SessionLight* light, const Ray& ray) {
  if (!mesh.tracer) return {};
  const auto hit = mesh.tracer->nearest(ray);
  if (!hit) return {};
  const auto& patches = *mesh.patches;
  const auto points = patches.points(hit.patch);
  Probe found;
  found.patch = hit.patch;
  found.back = hit.back;
  found.distance = hit.distance;
  found.u = hit.u;
  found.v = hit.v;
  found.at = patches.in_file(ray.origin + hit.distance * ray.direction);
  found.normal = hit.back ? -patches.normal[hit.patch] : patches.normal[hit.patch];
  found.area = static_cast<double>(patches.area[hit.patch]);
  for (std::size_t k = 0; k < 3; ++k)
    found.longest_edge =
        std::max(found.longest_edge, static_cast<double>(glm::distance(points[k], points[(k + 1) % 3])));
  found.material = patches.material_of(hit.patch).name;
  found.triangle = patches.triangle[hit.patch];
  if (const auto* scene = mesh.scene.get(); scene != nullptr && found.triangle < scene->triangles.size()) {
    found.line = scene->triangle_line[found.triangle];
    found.group = scene->groups[scene->triangle_group[found.triangle]];
    if (!scene->triangle_object.empty())
      found.object = scene->objects[scene->triangle_object[found.triangle]];
  }
  if (lies_on(light, mesh)) {
    found.irradiance = irradiance_of(*light, hit.patch, hit.back);
    found.radiosity = radiosity_of(*light, hit.patch, hit.back);
    found.smooth_irradiance = smooth_irradiance(*light, hit.patch, hit.back, hit.u, hit.v);
  }
  return found;
}

std::vector<ProfilePoint> profile(const SessionMesh& mesh, const SessionLight* light,
                                  std::span<const Ray> rays) {
  std::vector<ProfilePoint> points(rays.size());
  if (!mesh.tracer) return points;
  std::optional<Vec3> last;
  double along = 0.0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto hit = mesh.tracer->nearest(rays[i]);
    if (hit) {
      const auto at = rays[i].origin + hit.distance * rays[i].direction;
      if (last) along += static_cast<double>(glm::distance(*last, at));
      last = points[i].place = at;
    }
    points[i].along = along;
    if (!hit || !lies_on(light, mesh)) continue;
    points[i].is_lit = true;
    points[i].patch = hit.patch;
    points[i].back = hit.back;
    points[i].irradiance = smooth_irradiance(*light, hit.patch, hit.back, hit.u, hit.v);
    const auto of_patch = irradiance_of(*light, hit.patch, hit.back);
    points[i].irradiance.watts_error = of_patch.watts_error;
    points[i].irradiance.lux_error = of_patch.lux_error;
  }
  return points;
}

}  // namespace luxel
