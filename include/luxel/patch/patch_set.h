// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/patch/side.h"
#include "luxel/photometry/sky_patches.h"
#include "luxel/scene/camera.h"
#include "luxel/scene/material.h"
#include "luxel/scene/point_light.h"
#include "luxel/scene/spectrum.h"
#include "luxel/scene/texture.h"

namespace luxel {

class BandColours;

/// Upper limit of the albedo of a patch, whatever its texture and material are changed to.
inline constexpr float max_reflectance = 0.999f;

/// A material in the transport: one number per band.
struct BandMaterial {
  std::string name;
  bool two_sided = true;
  std::vector<float> reflectance;  ///< [band], [0, 1)
  std::vector<float> emittance;    ///< [band], W/m² in the band, front side
  std::uint32_t light_group = 0;   ///< of PatchSet::light_groups; counts for lamps only
  MaterialTextures textures = {};
  /// [band], [0, 1]: of a pane of glass at normal incidence; empty: opaque, or light passes freely.
  std::vector<float> transmittance = {};
  /// [band], [0, 1): transmittance of a diffuser, see Material; empty: not a diffuser. Such a material is
  /// two-sided.
  std::vector<float> diffuse_transmittance = {};

  bool is_lamp() const;
  bool is_diffuser() const { return !diffuse_transmittance.empty(); }
};

/// A lamp without a surface in the transport.
struct BandPointLight {
  PointLight light;              ///< its colour is replaced by `intensity`
  std::vector<float> intensity;  ///< [band]: W/sr in the band, or W/m² of a directional one
  std::uint32_t light_group = 0;
};

/// Contact with another surface that touches this one along an edge of its patches, or passes through it
/// there: on the side of the other surface light may jump across the edge though the surface continues.
struct Contact {
  std::array<std::uint32_t, 2> edge{};  ///< vertices, the lower first
  Vec3 into{0.0f};                      ///< unit, at right angles to the edge: where the other surface goes

  bool operator==(const Contact&) const = default;
};

/// A triangle of open space through which the sky lights a dim place: a part of a window, a door, a pane of
/// glass. It is no surface. Rays towards it are shadow rays whose light is the sky's, see lamps/portals.h.
struct Portal {
  std::array<Vec3, 3> corner{};  ///< m; counter-clockwise seen from the place that it lights
  bool both_ways = false;        ///< lights what lies behind it, too

  bool operator==(const Portal&) const = default;
};

/// A triangle of glass that absorbs a part of the light that crosses it. It is no surface: it receives and
/// reflects nothing. See trace/panes.h.
struct Pane {
  std::array<Vec3, 3> corner{};  ///< m
  Vec3 axis{0.0f};               ///< unit: angles of incidence are measured from it
  MaterialId material{};         ///< with BandMaterial::transmittance
  /// Exponent of that transmittance: 1 for a sheet, 0.5 for a face of a closed body, of which a ray crosses
  /// two.
  float exponent = 1.0f;

  bool operator==(const Pane&) const = default;
};

/// The surfaces cut into patches of constant radiosity. Parallel arrays: entry i of each is patch i. Patches
/// stand in the order of their input triangles. Vertices at the same place are one vertex, so neighbours
/// share indices.
struct PatchSet {
  std::vector<Vec3> vertices;                         ///< m, counted from `origin`
  std::vector<std::array<std::uint32_t, 3>> corners;  ///< counter-clockwise seen from the front
  std::vector<Vec3> normal;                           ///< unit, front side
  std::vector<float> area;                            ///< m²
  std::vector<MaterialId> material;
  std::vector<std::uint32_t> triangle;  ///< index of the input triangle, see Scene
  std::vector<Contact> contacts;        ///< sorted by edge; a wall through a floor makes two, above and below

  std::vector<std::string> bands;   ///< names: "red", "green", "blue", or "400 nm", "404 nm" and so on
  std::vector<Waveband> wavebands;  ///< [band], where light is solved by wavelength; else empty
  std::vector<BandMaterial> materials;
  std::vector<BandPointLight> point_lights;
  SkyPatches sky_patches;  ///< of what lies around the scene: one, or of a sky that is not the same all over
  std::vector<float> sky;  ///< [sky patch * bands + band], W/(m² sr): their radiance; empty: dark
  /// Any set of triangles gives the same light; a good one gives it with less noise. Without a sky they have
  /// no effect. The samples of a run belong to its portals, so a solution file keeps them.
  std::vector<Portal> portals;
  std::vector<Pane> panes;  ///< of glass that absorbs light; rays of the tracer pass them
  /// Names of lamps that are dimmed together, see light_groups.h; the sky is the last one where there is a
  /// sky. Empty: one group for all light.
  std::vector<std::string> light_groups;
  std::uint64_t scene_fingerprint = 0;
  Vec3d origin = Vec3d(0.0);  ///< m, as in Scene
  Vec3 up = Vec3(0.0f);       ///< unit, as in Scene, or estimated by make_patches(); 0: unknown

  /// Textures and corner colours of the surfaces; all of these are empty where there are none.
  std::vector<Texture> textures;
  std::vector<UvSet> uv_sets;                       ///< [set], of the patches' corners
  std::vector<std::array<Vec3, 3>> corner_colours;  ///< [patch][corner], linear
  /// Ratios of the patch to its material in reflectance and emittance: means over the part that holes leave
  /// of the patch. `area` is the area of that part.
  std::vector<float> reflectance_ratio, emittance_ratio;  ///< [patch][band]

  /// Where the error of the light matters in addition to the open space, see trace/place_views.h. None of
  /// these changes what the light converges to.
  std::vector<Camera> cameras;      ///< as in Scene, or those that a person gave; often none
  bool focuses_on_cameras = false;  ///< what these see is all that matters
  std::vector<std::uint8_t> focus;  ///< [patch], 1 where it matters; empty: everywhere
  /// A view that shows the scene well, for pictures of 4 to 3 that name no camera: computed once per scene,
  /// so that pictures of all its meshes show the same view.
  std::optional<Camera> view;

  std::size_t size() const { return corners.size(); }
  std::vector<Vec3> eyes() const;  ///< of the cameras
  std::size_t band_count() const { return bands.size(); }
  std::size_t group_count() const { return light_groups.empty() ? 1 : light_groups.size(); }
  bool has_sky() const;
  bool has_even_sky() const { return sky_patches.is_one(); }
  bool has_diffusers() const;
  /// Irradiance of a receiver that sees only this patch of the sky, W/m²: pi times its radiance, like the
  /// radiosity of a surface.
  double sky_radiosity(std::size_t sky_patch, std::size_t band) const {
    const auto at = sky_patch * bands.size() + band;
    assert(sky.empty() || at < sky.size());
    return sky.empty() ? 0.0 : std::numbers::pi * static_cast<double>(sky[at]);
  }
  /// Radiance in the mean over the directions above the horizon, or over all where the lower half mirrors
  /// it: [band], W/(m² sr); empty where it is dark.
  std::vector<float> mean_sky() const;
  /// Radiance of the ground over that of mean_sky(), in the mean over the bands; 1 where the sky goes on
  /// below the horizon, and where it is dark.
  double ground_over_sky() const;
  /// Irradiance of open ground by the sky, W/m²: [band]; empty where it is dark. Suns are not included.
  std::vector<double> open_irradiance() const;
  const BandMaterial& material_of(std::size_t patch) const {
    assert(patch < material.size());
    return materials[static_cast<std::size_t>(material[patch])];
  }
  /// Mean reflectance over the area of a patch: [0, 1).
  float reflectance(std::size_t patch, std::size_t band) const {
    const auto& m = material_of(patch);
    assert(band < m.reflectance.size());
    const auto of_material = m.reflectance[band];
    if (reflectance_ratio.empty() && !m.is_diffuser()) return of_material;
    const auto ratio = reflectance_ratio.empty() ? 1.0f : reflectance_ratio[patch * bands.size() + band];
    return std::min(max_reflectance - diffuse_transmittance(patch, band), of_material * ratio);
  }
  /// Fraction of the light on a side that leaves the other side of the patch: [0, 1).
  float diffuse_transmittance(std::size_t patch, std::size_t band) const {
    const auto& m = material_of(patch);
    return m.is_diffuser() ? m.diffuse_transmittance[band] : 0.0f;
  }
  /// Fraction of the light on a side that leaves the patch again, on either side; the rest is absorbed.
  float albedo(std::size_t patch, std::size_t band) const {
    return reflectance(patch, band) + diffuse_transmittance(patch, band);
  }
  /// Mean emittance of the front of a patch, W/m² in the band.
  float emittance(std::size_t patch, std::size_t band) const {
    assert(band < material_of(patch).emittance.size());
    const auto of_material = material_of(patch).emittance[band];
    return emittance_ratio.empty() ? of_material : of_material * emittance_ratio[patch * bands.size() + band];
  }
  std::array<Vec3, 3> points(std::size_t patch) const {
    assert(patch < corners.size());
    const auto& c = corners[patch];
    return {vertices[c[0]], vertices[c[1]], vertices[c[2]]};
  }
  Vec3 normal_of(SideId side) const { return side.is_back() ? -normal[side.patch()] : normal[side.patch()]; }
  Vec3 centroid(std::size_t patch) const {
    const auto p = points(patch);
    return (p[0] + p[1] + p[2]) / 3.0f;
  }
  /// Returns whether the bands are plain colour, or wavebands.
  bool has_colours() const;
  /// Returns the conversion of the bands to colour. Throws MismatchError where they are neither plain colour
  /// (red, green and blue in this order) nor wavebands.
  BandColours colours() const;
  /// A point in the file's coordinates, for a person to read.
  Vec3d in_file(const Vec3& point) const { return origin + Vec3d(point); }
};

}  // namespace luxel
