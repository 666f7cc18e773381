// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel {

/// The coordinates of a goniometer's angles (IES LM-75, CIE 121). Axes: see IntensityDistribution.
enum class GoniometerType : std::uint8_t {
  c,  ///< vertical: gamma, 0 at the aim, 180 opposite to it; horizontal: C, about the aim
  b,  ///< horizontal planes turn about the luminaire's length; floodlights
  a   ///< vertical planes turn about the luminaire's upright axis; headlamps
};

/// The luminous intensity of a luminaire in every direction, cd.
///
/// Local axes: the luminaire aims at -Z (gamma 0: straight down when it is not turned). Type C: the plane of
/// horizontal angle 0 contains +X, that of 90 degrees +Y, so that angles grow anticlockwise seen from +Z
/// (above). Types A and B: horizontal and vertical angle 0 is the aim, -Z; horizontal angles grow towards +X
/// (clockwise seen from +Y, which is up), vertical ones towards +Y.
///
/// Between the angles of the file intensity is bilinear in the angles; beyond its range of vertical angles it
/// is 0. Read-only after it was made: any number of threads may call.
class IntensityDistribution {
 public:
  IntensityDistribution() = default;
  /// vertical, horizontal: degrees, strictly ascending, at least two and (type C) one. Horizontal angles may
  /// cover a part by symmetry as LM-63 defines it: one angle is rotational symmetry; 0..90 a quadrant; 0..180
  /// and 90..270 a half; 0..360 none, where the last plane may be left out. In types A and B, angles that
  /// begin at 0 or above are mirrored below 0. candela: [horizontal][vertical], finite, not negative. Throws
  /// InputError where these do not hold.
  IntensityDistribution(GoniometerType type, std::vector<double> vertical, std::vector<double> horizontal,
                        std::vector<double> candela);

  GoniometerType type() const { return type_; }
  const std::vector<double>& vertical() const { return vertical_; }      ///< degrees
  const std::vector<double>& horizontal() const { return horizontal_; }  ///< degrees
  const std::vector<double>& candela() const { return candela_; }        ///< [horizontal][vertical]

  /// Returns the intensity in a direction in local axes, cd; direction: of any length above 0, away from the
  /// luminaire. Cost: about 50 ns.
  double at(const Vec3d& direction) const;
  /// cd at angles of the distribution's own type, degrees.
  double at_angles(double vertical, double horizontal) const;
  double maximum() const { return maximum_; }  ///< cd
  /// cd, the largest intensity of the directions with nearly this z, the local cosine in [-1, 1]. A rough
  /// measure for choosing lamps, which costs 2 ns.
  double zone_maximum(double z) const {
    const auto zone = static_cast<std::size_t>(std::max(0.0, 0.5 * (z + 1.0) * zones));
    return zone_maxima_[std::min<std::size_t>(zone, zones - 1)];
  }

  /// Flux of the interpolated distribution, lm, which is what a scene receives; relative error below 1e-6.
  double linear_flux() const { return linear_flux_; }
  /// lm by the zonal rule of the trade: over the file's own intervals, the mean intensity of two neighbouring
  /// angles times the solid angle between them. This is the number that photometric tools print.
  double zonal_flux() const { return zonal_flux_; }

 private:
  void close_planes();
  void find_fluxes();
  void find_zones();

  static constexpr int zones = 64;

  GoniometerType type_ = GoniometerType::c;
  std::vector<double> vertical_, horizontal_, candela_;
  double maximum_ = 0.0, linear_flux_ = 0.0, zonal_flux_ = 0.0;
  std::array<double, zones> zone_maxima_{};
};

enum class OpeningShape : std::uint8_t {
  point,              ///< no extent
  rectangle,          ///< flat, in the plane of X and Y
  ellipse,            ///< flat, in the plane of X and Y; a disk where both sizes are equal
  box,                ///< luminous on all sides
  vertical_cylinder,  ///< axis along Z; elliptic where the sizes differ
  cylinder_along_x,   ///< a horizontal tube
  cylinder_along_y,   ///< a horizontal tube
  ellipsoid,          ///< a sphere where all sizes are equal
  vertical_disk       ///< in the plane of Z and of the horizontal axis along which it has an extent
};

/// The luminous opening: the part of a luminaire that emits light, centred on its photometric centre.
struct LuminousOpening {
  OpeningShape shape = OpeningShape::point;
  Vec3d size = Vec3d(0.0);  ///< m, extents along the local axes
};

/// Lamps that a luminaire is equipped with.
struct LampSet {
  double count = 1.0;                          ///< number of lamps
  double flux = 0.0;                           ///< lm of all of them; 0 where photometry is absolute
  double watts = 0.0;                          ///< W with ballast; 0: not stated
  std::string name, colour, colour_rendering;  ///< as the file has it, UTF-8
};

/// A photometric file: IES LM-63 or EULUMDAT.
struct Photometry {
  std::string file;                                      ///< as the user named it
  std::string format;                                    ///< such as "IES LM-63-2002", "EULUMDAT"
  std::string luminaire, catalogue, maker, test_report;  ///< UTF-8; empty: not stated
  bool absolute = false;            ///< candela were measured as such, not per lamp lumen
  IntensityDistribution intensity;  ///< all factors of the file applied
  LuminousOpening opening;
  std::vector<LampSet> lamps;         ///< alternatives; the first unless chosen otherwise
  std::size_t lamp_set = 0;           ///< the alternative that `intensity` is for
  double header_flux = 0.0;           ///< lm that the header promises of the luminaire; 0: none
  std::vector<std::string> warnings;  ///< sentences with file and line

  const LampSet* lamp() const { return lamp_set < lamps.size() ? &lamps[lamp_set] : nullptr; }
};

struct PhotometryOptions {
  std::size_t lamp_set = 1;  ///< EULUMDAT: which of the alternative sets of lamps, from 1
  double rotate = 0.0;       ///< degrees, anticlockwise seen from above: turns angles and opening. IES and
                             ///< EULUMDAT lay a luminaire's length along different axes, and makers differ
};

/// Reads a photometric file; its kind is found from its content, not from its name. Throws InputError with
/// file and line.
Photometry load_photometry(const std::string& file, const PhotometryOptions& options = {});

}  // namespace luxel
