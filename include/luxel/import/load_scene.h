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
  double scale = 1.0;                       ///< metres per unit of the file
  float max_reflectance = 0.98f;            ///< reflectances above are lowered to it, with a warning
  std::vector<std::string> one_sided = {};  ///< materials (* and ? allowed) whose back absorbs
  std::vector<std::string> flip = {};       ///< materials (* and ? allowed) whose triangles are turned round
  float weld = 0.0f;                        ///< m; vertices nearer than this become one, see weld_vertices()
  bool orient = false;    ///< make the winding of each component consistent, see orient_windings()
  Vec3 sky = Vec3(0.0f);  ///< Scene::sky, W/(m² sr): light from all around
  std::filesystem::path spectra = {};  ///< a CSV file, see read_spectra(); empty: plain colour
  /// with spectra: number of evenly spaced wavelengths; 0: those of the file, see apply_spectra()
  int bands = 0;
};

/// Reads a scene by the file's ending: .obj (with its .mtl and textures), .glb or .gltf (glTF 2.0, with its
/// buffers and pictures), .ply, .stl, .fbx, .dae or .3ds. Throws InputError with file and line (or JSON path)
/// for anything that cannot be read. The log receives warnings (a missing MTL file or texture and its
/// replacement, flipped faces, lowered reflectances, a size that suggests another unit, with the scale that
/// mends it as a hint) and the changes made by requested repairs. The order of repairs is welding, orienting,
/// flipping. Cost: about half a second per million faces, plus the decoding of textures. Call from one thread
/// per scene.
///
/// OBJ: metres, Y up or Z up as in the file; materials are two-sided; Ke is radiance in W/(m² sr); Kd times
/// the linear colour of map_Kd is the reflectance, or Ks where a mirror or metal has a dark Kd; light passes
/// through surfaces whose d is below 0.5, and through glass; vertex normals, if given, define which side of a
/// face is its front.
///
/// glTF: metres, Y up; base colour times (1 - metallic), or all of it where there is more metal than not, is
/// the reflectance; emission is luminance in cd/m²,
/// lamps are in candela and lux, and luminous_efficacy converts all of these to watts; the back of a material
/// that is not doubleSided absorbs; light passes where alpha is below one half.
///
/// PLY and STL: as OBJ; colours of PLY's faces or vertices are the reflectance, or the picture that it names.
///
/// FBX, COLLADA (.dae) and 3DS: converted to glTF by the program luxel-import, which is run as a child
/// process under limits of time and memory; InputError where it is not installed, refuses the file, crashes
/// or exceeds a limit. Metres, Y up as the file states; of 3DS as OBJ. Emission is radiance in W/(m² sr), the
/// intensity of lamps is radiant power in W (or W/m²), and materials are two-sided.
///
/// Coordinates are read in doubles. A scene that reaches farther from the file's zero than eight times its
/// own size (the longest side of its box) gets an origin at its centre, and positions count from there: a
/// room of 5 m at coordinates of 1e6 m is as exact as one at zero. See Scene::origin.
///
/// The monitor receives the stages "load" and "triangles"; after its stop the scene has no triangles.
Scene load_scene(const std::filesystem::path& path, const LoadOptions& options = {},
                 const Context& context = {});

}  // namespace luxel
