// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "luxel/core/vector.h"
#include "luxel/photometry/photometry.h"
#include "luxel/scene/point_light.h"

namespace luxel {

constexpr double recess = 5e-3;  // m: surfaces so close to a luminaire's opening do not hide it

// A punctual light as seen from a point.
struct PointSight {
  double irradiance = 0.0;       // of the point's surface at unit intensity, nothing between; 0: none
  Vec3d direction = Vec3d(0.0);  // unit, towards the lamp
  float distance = 0.0f;         // m, of where a shadow ray ends; infinite for directional lamps
};

// normal: unit, of the side that is lit. E = I cos / d² (inverse square law); a spot fades as defined by
// KHR_lights_punctual; a luminaire has its distribution, seen from its photometric centre. Distances below a
// thousandth of a millimetre are clamped to it.
PointSight sight_of(const PointLight& light, const Vec3d& point, const Vec3d& normal);

// The same for a point of a luminaire's opening: each point has the whole distribution, and the mean over u
// is the irradiance by the whole opening (near field). A ray ends `recess` before it enters the opening, so
// that neither a ceiling that a luminaire is recessed in or reaches through nor a model of its housing hides
// it; a point within `recess` of the opening gets nothing, as the luminaire covers it. Other lights: as
// above. u: uniform in [0, 1). For a sun: points of its disc.
PointSight sight_of(const PointLight& light, const Vec3d& point, const Vec3d& normal,
                    const std::array<double, 2>& u);

// Returns whether the light is a luminaire whose opening has an extent.
bool has_opening(const PointLight& light);

// Returns whether it is seen under an angle: a luminaire's opening, or the disc of a sun.
bool is_extended(const PointLight& light);

// Radius of the sphere about its position that holds the light, m; 0 but of luminaires with openings.
double extent_of(const PointLight& light);

// Intensity towards a point, relative to the largest, [0, 1]; from the photometric centre.
double relative_intensity(const PointLight& light, const Vec3d& point);

// About the largest intensity of the directions that go as steeply along the aim as this point lies, relative
// to the largest of all, [0, 1]. Costs a few nanoseconds.
double zone_intensity(const PointLight& light, const Vec3d& point);

// A vector of the scene in a luminaire's local axes, and a point of them in the scene.
Vec3d in_local_axes(const PointLight& light, const Vec3d& v);
Vec3d from_local_axes(const PointLight& light, const Vec3d& at);

// Radiance of a luminaire's opening seen from far away, relative to the largest intensity, 1/m²: relative
// intensity over projected area. 0 where it does not emit. opening: the luminaire's, or what stands for it;
// to_eye: unit, in the scene's axes, from the luminaire to the eye.
double relative_radiance(const PointLight& light, const LuminousOpening& opening, const Vec3d& to_eye);

// Returns the ratio of emitted power to intensity along the axis, sr: 4 pi for points, 0 for directional
// ones, whose power is not finite.
double emitting_angle(const PointLight& light);

}  // namespace luxel
