// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/scene/observer.h"
#include "luxel/scene/scene.h"

namespace luxel {
namespace {

void check_lengths(const Scene& scene) {
  const auto expect = [&](std::size_t found, const char* array) {
    if (found == scene.triangles.size()) return;
    throw InputError(scene.source, fmt::format("expected one {} for each of the {} triangles, found {}",
                                               array, scene.triangles.size(), found));
  };
  if (scene.triangles.empty()) throw InputError(scene.source, "expected at least one triangle, found none");
  if (scene.materials.empty()) throw InputError(scene.source, "expected at least one material, found none");
  if (!is_finite(scene.up)) throw InputError(scene.source, "expected a finite up direction");
  if (scene.groups.empty()) throw InputError(scene.source, "expected at least one group, found none");
  expect(scene.triangle_material.size(), "triangle_material");
  expect(scene.triangle_line.size(), "triangle_line");
  expect(scene.triangle_group.size(), "triangle_group");
  if (!scene.objects.empty()) expect(scene.triangle_object.size(), "triangle_object");
  for (const auto& set : scene.uv_sets) expect(set.size(), "entry of each of the uv_sets");
  if (!scene.corner_colours.empty()) expect(scene.corner_colours.size(), "corner_colours");
}

void check_index(const Scene& scene, std::size_t triangle, std::size_t index, std::size_t count,
                 const char* what) {
  if (index < count) return;
  throw InputError(scene.source, scene.triangle_line[triangle],
                   fmt::format("triangle {} names {} {}, but there are only {} (numbered from 0)", triangle,
                               what, index, count));
}

void check_triangles(const Scene& scene) {
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    for (const auto corner : scene.triangles[i])
      check_index(scene, i, corner, scene.positions.size(), "vertex");
    check_index(scene, i, static_cast<std::size_t>(scene.triangle_material[i]), scene.materials.size(),
                "material");
    check_index(scene, i, scene.triangle_group[i], scene.groups.size(), "group");
    if (!scene.objects.empty())
      check_index(scene, i, scene.triangle_object[i], scene.objects.size(), "object");
  }
}

void check_positions(const Scene& scene) {
  for (std::size_t i = 0; i < scene.positions.size(); ++i)
    if (const auto distance = glm::abs(scene.origin + Vec3d(scene.positions[i]));  // so that NaN fails too
        !(distance.x <= farthest && distance.y <= farthest && distance.z <= farthest))
      throw InputError(scene.source,
                       fmt::format("vertex {} is not finite, or lies beyond {:g} m", i, farthest));
}

// Written so that NaN fails too.
void check_material(const Scene& scene, const Material& material) {
  for (int band = 0; band < 3; ++band) {
    const float rho = material.reflectance[band];
    if (!(rho >= 0.0f && rho < 1.0f))
      throw InputError(
          scene.source,
          fmt::format("expected the reflectance of material '{}' in [0, 1), found {}", material.name, rho));
    const float emitted = material.emittance[band];
    if (!(emitted >= 0.0f && std::isfinite(emitted)))
      throw InputError(scene.source,
                       fmt::format("expected the emittance of material '{}' to be 0 or more, found {}",
                                   material.name, emitted));
  }
}

void check_use(const Scene& scene, const Material& material, const std::optional<TextureUse>& use) {
  if (!use) return;
  const auto refuse = [&](const std::string& what) {
    throw InputError(scene.source, fmt::format("material '{}': {}", material.name, what));
  };
  if (use->texture >= scene.textures.size())
    refuse(fmt::format("it names texture {}, but there are only {} (numbered from 0)", use->texture,
                       scene.textures.size()));
  if (use->uv_set >= scene.uv_sets.size())
    refuse(fmt::format("it names set {} of texture coordinates, but there are only {} (numbered from 0)",
                       use->uv_set, scene.uv_sets.size()));
  for (const auto number : use->placement)
    if (!std::isfinite(number)) refuse("expected finite numbers for where its texture lies");
}

void check_textures(const Scene& scene) {
  for (const auto& material : scene.materials)
    for (const auto* use :
         {&material.textures.reflectance, &material.textures.emittance, &material.textures.cutout})
      check_use(scene, material, *use);
  for (const auto& texture : scene.textures)
    if (!texture.raster || texture.raster->width < 1 || texture.raster->height < 1)
      throw InputError(scene.source, fmt::format("expected pixels in texture '{}'", texture.name));
  for (const auto& set : scene.uv_sets)
    for (std::size_t i = 0; i < set.size(); ++i)
      for (const auto& uv : set[i])
        if (!std::isfinite(uv.x) || !std::isfinite(uv.y))
          throw InputError(scene.source, scene.triangle_line[i],
                           fmt::format("expected finite texture coordinates for triangle {}", i));
  for (const auto& corners : scene.corner_colours)
    for (const auto& colour : corners)
      for (int band = 0; band < 3; ++band)
        if (!(colour[band] >= 0.0f && colour[band] <= 1.0f))
          throw InputError(scene.source,
                           fmt::format("expected colours of corners in [0, 1], found {}", colour[band]));
}

void check_point_light(const Scene& scene, const PointLight& light) {
  const auto refuse = [&](const char* what) {
    throw InputError(scene.source, fmt::format("lamp '{}': expected {}", light.name, what));
  };
  if (!is_finite(light.position)) refuse("a finite position");
  if (light.kind != PointLightKind::point && !(std::abs(glm::length(light.direction) - 1.0f) < 1e-3f))
    refuse("a direction of length 1");
  for (int band = 0; band < 3; ++band)
    if (!(light.intensity[band] >= 0.0f && std::isfinite(light.intensity[band])))
      refuse("an intensity of 0 or more");
  if (light.kind == PointLightKind::spot &&
      !(light.cos_outer >= -1.0f && light.cos_outer < light.cos_inner && light.cos_inner <= 1.0f))
    refuse("an inner angle smaller than the outer one");
  if (!(light.angular_radius >= 0.0f && light.angular_radius <= 0.5f))
    refuse("an angular radius from 0 to 0.5 rad");
  if (light.kind != PointLightKind::luminaire) return;
  if (!light.photometry) refuse("the distribution of a photometric file");
  const auto is_axis = [](const Vec3& v, const Vec3& w) {
    return std::abs(glm::length(v) - 1.0f) < 1e-3f && std::abs(glm::dot(v, w)) < 1e-3f;
  };
  if (!is_axis(light.local_x, light.direction) || !is_axis(light.local_y, light.direction) ||
      !is_axis(light.local_x, light.local_y))
    refuse("axes of length 1 at right angles");
  if (!(light.dimming >= 0.0f && std::isfinite(light.dimming))) refuse("a dimming of 0 or more");
  if (!(light.maintenance > 0.0f && light.maintenance <= 1.0f))
    refuse("a maintenance factor above 0, at most 1");
}

void check_sky(const Scene& scene) {
  for (int band = 0; band < 3; ++band)
    if (!(scene.sky[band] >= 0.0f && std::isfinite(scene.sky[band])))
      throw InputError(scene.source, fmt::format("expected the radiance of the sky to be 0 or more, found {}",
                                                 scene.sky[band]));
  const auto& uneven = scene.sky_radiance;
  if (uneven.empty() ? !scene.sky_patches.is_one() : uneven.size() != scene.sky_patches.size())
    throw InputError(scene.source, fmt::format("expected a radiance for each of the {} patches of the sky, "
                                               "found {}",
                                               scene.sky_patches.size(), uneven.size()));
  if (!uneven.empty() && (scene.sky != Vec3(0.0f) || !scene.sky_spectrum.empty()))
    throw InputError(scene.source,
                     "expected either a sky of one radiance or one of a radiance per patch, found both");
  for (const auto& radiance : uneven)
    if (!(is_finite(radiance) && radiance.r >= 0.0f && radiance.g >= 0.0f && radiance.b >= 0.0f))
      throw InputError(scene.source, "expected the radiance of each patch of the sky to be 0 or more");
}

void check_spectrum(const Scene& scene, const Spectrum& spectrum, double limit, const std::string& what) {
  double before = 0.0;
  for (const auto& [wavelength, value] : spectrum.samples()) {
    if (!(wavelength > before && std::isfinite(wavelength)))
      throw InputError(scene.source,
                       fmt::format("expected the wavelengths of {} to ascend, found {} nm after "
                                   "{} nm",
                                   what, wavelength, before));
    before = wavelength;
    if (!(value >= 0.0 && value < limit))
      throw InputError(scene.source,
                       fmt::format("expected {} at {} nm to be 0 or more and below {:g}, found {}", what,
                                   wavelength, limit, value));
  }
}

void check_spectra(const Scene& scene) {
  if (scene.wavelengths.size() == 1)
    throw InputError(scene.source, "expected no wavelengths, or at least two, found one");
  double before = 0.0;
  for (const auto wavelength : scene.wavelengths) {
    if (!(wavelength > before && wavelength >= first_visible && wavelength <= last_visible))
      throw InputError(
          scene.source,
          fmt::format("expected wavelengths that ascend from {:g} to {:g} nm, found {} nm after {} nm",
                      first_visible, last_visible, wavelength, before));
    before = wavelength;
  }
  constexpr double max_light = 1e30;
  for (const auto& material : scene.materials) {
    check_spectrum(scene, material.reflectance_spectrum, 1.0,
                   fmt::format("the reflectance of material '{}'", material.name));
    check_spectrum(scene, material.emittance_spectrum, max_light,
                   fmt::format("the emittance of material '{}'", material.name));
  }
  check_spectrum(scene, scene.sky_spectrum, max_light, "the radiance of the sky");
}

void check_camera(const Scene& scene, const Camera& camera) {
  const auto view = camera.target - camera.eye;
  const bool finite = is_finite(camera.eye) && is_finite(camera.target) && is_finite(camera.up);
  if (!finite || glm::cross(Vec3d(view), Vec3d(camera.up)) == Vec3d(0.0))
    throw InputError(scene.source,
                     "expected a camera that looks somewhere, with an up that is not along the view");
  if (!(camera.vertical_fov > 0.0f && camera.vertical_fov < 180.0f))
    throw InputError(scene.source,
                     fmt::format("expected a vertical field of view between 0 and 180 degrees, found {}",
                                 camera.vertical_fov));
}

}  // namespace

void check_scene(const Scene& scene) {
  check_lengths(scene);
  check_positions(scene);
  check_triangles(scene);
  for (const auto& material : scene.materials) check_material(scene, material);
  check_textures(scene);
  for (const auto& light : scene.point_lights) check_point_light(scene, light);
  check_sky(scene);
  check_spectra(scene);
  for (const auto& camera : scene.cameras) check_camera(scene, camera);
}

}  // namespace luxel
