// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/sun_position.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "luxel/core/trig.h"

namespace luxel {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

// Terrestrial time less universal time, s: 29 in 1950, 69 in 2020, 93 predicted for 2050. The sun moves 0.001
// degrees in 90 s.
constexpr double delta_t = 69.0;

double normalised(double angle) { return angle - 360.0 * std::floor(angle / 360.0); }

SinCos of_degrees(double angle) { return sin_cos(normalised(angle) * degree); }

struct Equatorial {
  double right_ascension, declination;  // degrees
  double nutation;                      // of the equinox in right ascension, degrees
  double distance;                      // astronomical units
};

// Perturbation of the sun's longitude by Venus (two terms), Jupiter, the moon and a slow inequality, degrees.
// J. Meeus, "Astronomical Formulae for Calculators", 1982, chapter 18. They reduce the error at 13 equinoxes
// and solstices of the almanac from 0.008 to 0.003 degrees. t: Julian centuries since 2000.
double perturbations(double t) {
  t += 1.0;  // since 1900
  return 0.00134 * of_degrees(153.23 + 22518.7541 * t).cosine +
         0.00154 * of_degrees(216.57 + 45037.5082 * t).cosine +
         0.00200 * of_degrees(312.69 + 32964.3577 * t).cosine +
         0.00179 * of_degrees(350.74 + 445267.1142 * t).sine + 0.00178 * of_degrees(231.19 + 20.20 * t).sine;
}

// t: Julian centuries of terrestrial time since 2000.
Equatorial apparent_sun(double t) {
  const auto mean_longitude = 280.46646 + t * (36000.76983 + t * 0.0003032);
  const auto anomaly = 357.52911 + t * (35999.05029 - t * 0.0001537);
  const auto eccentricity = 0.016708634 - t * (0.000042037 + t * 0.0000001267);
  const auto centre = (1.914602 - t * (0.004817 + t * 0.000014)) * of_degrees(anomaly).sine +
                      (0.019993 - t * 0.000101) * of_degrees(2.0 * anomaly).sine +
                      0.000289 * of_degrees(3.0 * anomaly).sine;
  const auto node = of_degrees(125.04 - 1934.136 * t);
  // Aberration and nutation in longitude.
  const auto longitude =
      of_degrees(mean_longitude + centre + perturbations(t) - 0.00569 - 0.00478 * node.sine);
  const auto mean_obliquity =
      23.0 + (26.0 + (21.448 - t * (46.8150 + t * (0.00059 - t * 0.001813))) / 60.0) / 60.0;
  const auto obliquity = of_degrees(mean_obliquity + 0.00256 * node.cosine);
  Equatorial sun;
  sun.right_ascension = arc_tangent(obliquity.cosine * longitude.sine, longitude.cosine) / degree;
  sun.declination = 90.0 - arc_cosine(obliquity.sine * longitude.sine) / degree;
  sun.nutation = -0.00478 * node.sine * obliquity.cosine;
  sun.distance = 1.000001018 * (1.0 - eccentricity * eccentricity) /
                 (1.0 + eccentricity * of_degrees(anomaly + centre).cosine);
  return sun;
}

// Degrees; true elevation in degrees.
double refraction(double elevation, const Atmosphere& atmosphere) {
  constexpr double min_elevation = -0.84;
  if (elevation < min_elevation) return 0.0;
  const auto argument = of_degrees(elevation + 10.3 / (elevation + 5.11));
  return 1.02 / 60.0 * argument.cosine / argument.sine * (atmosphere.pressure / 1010.0) *
         (283.0 / (273.0 + atmosphere.temperature));
}

}  // namespace

SunPosition sun_position(Instant instant, const Site& site, const Atmosphere& atmosphere) {
  constexpr std::chrono::sys_seconds j2000 =
      std::chrono::sys_days(std::chrono::January / 1 / 2000) + std::chrono::hours(12);
  const auto days = static_cast<double>((instant - j2000).count()) / 86400.0;  // of universal time
  const auto sun = apparent_sun((days + delta_t / 86400.0) / 36525.0);
  const auto centuries = days / 36525.0;
  const auto sidereal = 280.46061837 + 360.98564736629 * days +
                        centuries * centuries * (0.000387933 - centuries / 38710000.0) + sun.nutation;
  const auto hour_angle = of_degrees(sidereal + site.longitude - sun.right_ascension);
  const auto latitude = of_degrees(site.latitude), declination = of_degrees(sun.declination);

  const Vec3d d(-declination.cosine * hour_angle.sine,
                declination.sine * latitude.cosine - declination.cosine * latitude.sine * hour_angle.cosine,
                declination.sine * latitude.sine + declination.cosine * latitude.cosine * hour_angle.cosine);
  SunPosition position;
  position.distance = sun.distance;
  position.azimuth = azimuth_of(d);
  const auto parallax = 8.794 / 3600.0 / sun.distance * std::sqrt(std::max(0.0, 1.0 - d.z * d.z));
  const auto elevation = elevation_of(d) - parallax;
  position.elevation = std::min(90.0, elevation + refraction(elevation, atmosphere));
  position.direction = direction_towards(position.elevation, position.azimuth);
  return position;
}

Vec3d direction_towards(double elevation, double azimuth) {
  const auto height = of_degrees(elevation), turn = of_degrees(azimuth);
  return {height.cosine * turn.sine, height.cosine * turn.cosine, height.sine};
}

double elevation_of(const Vec3d& direction) {
  return arc_tangent(direction.z, std::hypot(direction.x, direction.y)) / degree;
}

double azimuth_of(const Vec3d& direction) {
  return normalised(arc_tangent(direction.x, direction.y) / degree);
}

}  // namespace luxel
