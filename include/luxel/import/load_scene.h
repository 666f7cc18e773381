// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/scene/scene.h"

namespace luxel {

inline constexpr int min_bands = 8;
inline constexpr int max_bands = 500;

/// A regular array of luminaires over the horizontal extents of a scene, half a step from its edges, that
/// aim straight down.
struct LuminaireGrid {
  std::filesystem::path file;         ///< IES or EULUMDAT
  std::size_t columns = 1, rows = 1;  ///< along the first and the second horizontal axis (x; y or z)
  double height = 0.0;                ///< m, on the up axis
  double rotation = 0.0;              ///< degrees, anticlockwise seen from above
  double maintenance = 1.0;           ///< maintenance factor, (0, 1]
};

/// Makes materials panes of glass, or diffusers, of this transmittance.
struct GlassOption {
  std::string materials = {};       ///< names (* and ? allowed); empty: all that are not opaque in the file
  Vec3 transmittance = Vec3(1.0f);  ///< visible transmittance at normal incidence, [0, 1], not 0 in all bands
  bool is_diffuse =
      false;  ///< Material::diffuse_transmittance, [0, LoadOptions::max_reflectance], in its place
};

/// The sky and the sun around a scene. Angles are in degrees; azimuths are counted from north to the east.
struct Daylight {
  enum class Sky {
    uniform,
    cie,     ///< a CIE standard general sky (ISO 15469), or the traditional overcast sky as type 16
    perez,   ///< Perez all-weather (1993), from irradiances
    picture  ///< an equirectangular picture of the surroundings: HDR or EXR
  };
  struct Sun {
    double elevation = 0.0, azimuth = 0.0;  ///< of its centre; below the horizon it does not shine
  };

  Sky sky = Sky::uniform;
  int cie_type = 16;  ///< 1 to 16
  /// Horizontal illuminance of open ground by the sky, without the sun, lx. If 0, a Perez sky takes it from
  /// the irradiances. With a picture: by its whole upper half, including its sun.
  double illuminance = 10'000.0;
  std::filesystem::path picture = {};  ///< left edge north, centre south, left half the east, top the zenith
  std::optional<Sun> sun = {};         ///< skies of most types depend on it; pictures have their own
  /// Illuminance by the sun on a plane that faces it, lx. Default: under a Perez sky from the irradiance;
  /// under a CIE sky 127,500 exp(-c m) lx with the air mass m = 1 / sin(elevation) (Kasten and Young near the
  /// horizon) and c = 0.21 for types 11 to 15 (clear), 0.80 for 7 to 10 (partly cloudy); none under others.
  std::optional<double> sun_illuminance = {};
  double direct_normal = 0.0, diffuse_horizontal = 0.0;  ///< W/m², of a Perez sky
  double dew_point = 11.0;                               ///< °C, for the luminous efficacy of a Perez sky
  double orbit_factor = 1.0;  ///< (mean distance of the sun / its distance)², of a Perez sky
  double albedo = 0.2;        ///< diffuse reflectance of the ground, [0, 1]
  /// Direction of north: clockwise seen from above, from +Y where +Z is up, from -Z where +Y is up.
  double north = 0.0;
};

struct LoadOptions {
  double scale = 1.0;             ///< metres per unit of the file
  float max_reflectance = 0.98f;  ///< reflectances above are lowered to it, with a warning
  /// Files that the scene's file names (buffers, materials, textures, luminaires) may lie outside its folder.
  bool allow_outside = false;
  std::vector<std::string> one_sided = {};  ///< materials (* and ? allowed) whose back absorbs
  std::vector<std::string> flip = {};       ///< materials (* and ? allowed) whose triangles are turned round
  std::vector<GlassOption> glass = {};      ///< in this order: the last one that matches a material counts
  float weld = 0.0f;                        ///< m; vertices nearer than this become one, see weld_vertices()
  bool orient = false;  ///< make the winding of each component consistent, see orient_windings()
  /// Triangulate flat surfaces of needles again, as walls with arches, see retriangulate_needles().
  bool retriangulate = true;
  Vec3 sky = Vec3(0.0f);                  ///< Scene::sky, W/(m² sr): light from all around
  std::optional<Daylight> daylight = {};  ///< instead of `sky`: Scene::sky_radiance, and the sun
  std::filesystem::path spectra = {};     ///< a CSV file, see read_spectra(); empty: plain colour
  std::vector<std::filesystem::path> luminaires =
      {};  ///< lists of luminaires: CSV files, see docs/luminaires.md
  std::vector<LuminaireGrid> luminaire_grids = {};
  /// Up axis for the sky and the luminaires: (0, 1, 0) or (0, 0, 1); 0: that of the file, else estimated.
  Vec3 up = Vec3(0.0f);
  /// with spectra: number of evenly spaced wavelengths; 0: those of the file, see apply_spectra()
  int bands = 0;
};

/// Reads a scene by the file's ending: .obj (with its .mtl and textures), .glb or .gltf (glTF 2.0, with its
/// buffers and pictures), .ply, .stl, .fbx, .dae or .3ds. Throws InputError with file and line (or JSON path)
/// for anything that cannot be read. The log receives warnings (a missing MTL file or texture and its
/// replacement, flipped faces, lowered reflectances, a size that suggests another unit, with the scale that
/// mends it as a hint) and the changes made by requested repairs. The order of repairs is welding, orienting,
/// flipping; flat surfaces of needles are triangulated again last. Cost: about half a second per million
/// faces, plus the decoding of textures. Call from one thread per scene.
///
/// Files that the scene's file names are read only where they lie in its folder or below it, links followed,
/// but for LoadOptions::allow_outside: a buffer, MTL or photometric file elsewhere is an InputError, a
/// texture elsewhere a warning, as if it were missing. Files that the options name may lie anywhere.
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
/// Luminaires: those of the lists and grids; in glTF also those of EXT_lights_ies; in OBJ a material that is
/// called like a photometric file beside the OBJ (panel.ies, panel.ldt) makes each connected component of its
/// triangles a luminaire. See PointLight.
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
