// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "luxel/core/bounds.h"
#include "luxel/core/vector.h"
#include "luxel/photometry/sky_patches.h"
#include "luxel/scene/camera.h"
#include "luxel/scene/material.h"
#include "luxel/scene/point_light.h"
#include "luxel/scene/texture.h"

namespace luxel {

/// Maximum absolute coordinate, m. Areas, and the distances that rays travel, stay finite in floats.
inline constexpr float farthest = 1e12f;

/// A flat surface that has other triangles than in the file. Its points are corners of the file's triangles,
/// and after them the middles of two points before.
struct FlatSurface {
  std::uint32_t first = 0;                              ///< its first triangle in the scene
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< [triangle - first]: points
  std::vector<std::uint32_t> of_file;                   ///< its triangles in the file, ascending
  std::vector<std::uint32_t> corner_of;                 ///< [point]: one of these that has this corner
  std::vector<std::array<std::uint32_t, 2>> halved;     ///< [point - corner_of.size()]: ends of the middle
};

/// A mesh with materials, as in the file. Parallel arrays: entry i of every triangle_* array is triangle i,
/// and triangles stand in the order of the file, even those without area (so that indices stay the same); a
/// polygon of n corners is n - 2 triangles, a fan where it is convex. Only flat surfaces of needles have
/// other triangles than in the file (`retriangulated`). Everything is finite, no position is beyond
/// `farthest`, and every index is in range: loading and check_scene() verify this.
struct Scene {
  std::string source;                        ///< the file, as the user named it
  std::vector<std::filesystem::path> files;  ///< read for it besides the source: those that it names
  bool allows_outside = false;               ///< whether these may lie outside its folder

  std::vector<Vec3> positions;                          ///< m, counted from `origin`
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise seen from the front
  std::vector<MaterialId> triangle_material;
  std::vector<std::uint32_t> triangle_line;    ///< line in the source file, from 1; 0 where unknown
  std::vector<std::uint32_t> triangle_group;   ///< index into groups
  std::vector<std::uint32_t> triangle_object;  ///< index into objects; empty where there are none

  /// Surfaces that are not as in the file (LoadOptions::retriangulate), by their first triangle; often none.
  /// Each stands at the place of its first triangle in the file.
  std::vector<FlatSurface> retriangulated;

  std::vector<std::string> groups;   ///< names of groups or objects; at least one ("default")
  std::vector<std::string> objects;  ///< names of objects alone; empty where the file names none
  std::vector<Material> materials;   ///< at least one
  std::vector<Camera> cameras;       ///< as the file gave them; often none

  std::vector<Texture> textures;                    ///< those that materials use
  std::vector<UvSet> uv_sets;                       ///< those that materials use; each for all triangles
  std::vector<std::array<Vec3, 3>> corner_colours;  ///< [triangle][corner], linear, [0, 1]: reflectance is
                                                    ///< times these; empty where the file has none
  std::vector<PointLight> point_lights;             ///< lamps without a surface; often none

  /// The last triangles, which are not in the file: luminaires of add_default_light().
  std::size_t added_triangles = 0;

  /// Origin of positions and cameras in the file's coordinates, m. 0 except in a scene so far from the file's
  /// zero that floats would round its surfaces, see load_scene(). Input and output for users stay in the
  /// file's coordinates, origin + position.
  Vec3d origin = Vec3d(0.0);

  /// Unit; which way is up, where the file's format defines it (glTF: +Y). 0: it is estimated, see
  /// PatchSet::up.
  Vec3 up = Vec3(0.0f);

  Vec3 sky = Vec3(0.0f);  ///< radiance of what lies around the scene, the same all over, W/(m² sr)
  /// Patches of an uneven sky, and the radiance of each, W/(m² sr), linear sRGB,
  /// instead of `sky`. Empty: the sky is even.
  SkyPatches sky_patches;
  std::vector<Vec3> sky_radiance;  ///< [sky patch]

  /// Wavelengths of a scene that is solved by wavelength; empty if it is solved in plain colour. Materials
  /// and skies without measured spectra get spectra of the same colour (ColourSpectra).
  std::vector<double> wavelengths;  ///< nm, ascending, first_visible to last_visible
  bool averages_spectra = false;    ///< around each wavelength, not read at it: where these are few
  Spectrum sky_spectrum;            ///< W/(m² sr nm), instead of `sky`; empty: nothing measured
};

/// Flips a triangle: its front becomes its back; the attributes of its corners move with them.
void turn_triangle(Scene& scene, std::size_t triangle);

/// The box of all triangles, counted from the origin; a vertex that no triangle uses does not count.
Bounds bounds(const Scene& scene);

/// Returns whether light comes from what lies around the scene.
bool has_sky(const Scene& scene);

/// Returns whether the scene has an emitting surface or a punctual light.
bool has_lamp(const Scene& scene);

/// Returns whether the scene has a lamp or a sky.
bool has_light(const Scene& scene);

/// Throws InputError naming the source where an array's length, an index or a number breaks the promise
/// above; reflectances must lie in [0, 1), light is not negative, and a scene has at least one triangle.
void check_scene(const Scene& scene);

/// 64-bit hash of the data that the light depends on: positions, triangles, materials, and where present the
/// sky, the origin and the wavelengths with the values measured at them (not names, groups, objects, lines,
/// cameras), in their order, -0 counted as +0. The same scene gives the same fingerprint on every host.
std::uint64_t fingerprint(const Scene& scene);

}  // namespace luxel
