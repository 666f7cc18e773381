// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/scene/scene.h"

namespace luxel {

inline constexpr int min_bands = 8;
inline constexpr int max_bands = 500;

struct LoadOptions {
  double scale = 1.0;                       ///< metres a file unit
  float max_reflectance = 0.98f;            ///< reflectances above are lowered to it, with a warning
  std::vector<std::string> one_sided = {};  ///< materials (* and ? allowed) whose back absorbs
  std::vector<std::string> flip = {};       ///< materials (* and ? allowed) whose triangles are turned round
  float weld = 0.0f;                        ///< m; vertices nearer than this become one, see weld_vertices()
  bool orient = false;                 ///< turn windings consistent piece by piece, see orient_windings()
  Vec3 sky = Vec3(0.0f);               ///< Scene::sky, W/(m² sr): light from all around
  std::filesystem::path spectra = {};  ///< a CSV file, see read_spectra(); empty: plain colour
  /// with spectra: so many wavelengths at even steps; 0: those of the file, see apply_spectra()
  int bands = 0;
};

/// Reads a scene by the file's ending: .obj (with its .mtl and textures), .glb or .gltf (glTF 2.0, with its
/// buffers and pictures). Throws InputError with file and line (or JSON path) for anything that cannot be
/// read; says warnings (a missing MTL or texture and the default taken, turned faces, capped reflectances)
/// and what repairs on request changed to log. Welding comes before orienting, and both before flipping,
/// which so has the last word. Cost: about half a second a million faces, and what decoding its textures
/// takes.
///
/// OBJ as Luxel reads it: metres, Y up or Z up as it comes; materials are two-sided; Ke is radiance in W/(m²
/// sr); Kd times the linear colour of map_Kd is the reflectance, or Ks where Kd is black; light passes freely
/// through what has d below 0.5; vertex normals, where given, say which side of a face is its front.
///
/// glTF as Luxel reads it: metres, Y up; base colour times (1 - metallic) is the reflectance; emission is
/// luminance in cd/m², lamps have candela and lux, and all of these become watts by luminous_efficacy; what
/// is not doubleSided absorbs at its back; light passes freely where alpha says that less than half is there.
///
/// Coordinates are read in doubles. A scene that reaches farther from the file's zero than eight times its
/// own size (the longest side of its box) gets an origin in its midst, and positions count from there: a room
/// of 5 m at coordinates of 1e6 m is as exact as one at zero. See Scene::origin.
///
/// The monitor is told of the stages "load" and "triangles"; after its stop the scene has no triangles.
Scene load_scene(const std::filesystem::path& path, const LoadOptions& options = {},
                 const Context& context = {});

}  // namespace luxel
