// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/core/hint.h"
#include "luxel/scene/scene.h"

namespace luxel {

/// lx, on an unobstructed horizontal surface under the default sky: an overcast day.
inline constexpr double default_daylight = 10'000.0;
/// Reflectance of the ground outside under this sky.
inline constexpr double default_albedo = 0.2;
/// lx, the average in a closed scene that gets electric light: an office.
inline constexpr double default_lamp_light = 300.0;

/// The sky of a scene without light.
enum class DefaultSky {
  over_ground,  ///< uniform above the horizon, over ground of default_albedo
  all_around    ///< uniform in all directions, for methods that take no other sky
};

enum class DefaultLightKind {
  not_needed,         ///< the scene has light of its own
  sun_without_sky,    ///< so it has, but its sky, which surfaces see, is black; nothing is added
  daylight,           ///< a uniform sky
  lamp_materials,     ///< materials that are named like lamps emit
  ceiling_luminaires  ///< squares below the ceiling emit
};

/// The light that add_default_light() added.
struct DefaultLight {
  DefaultLightKind kind = DefaultLightKind::not_needed;
  std::vector<std::string> materials = {};  ///< lamp_materials: their names
  std::size_t luminaires = 0;               ///< ceiling_luminaires: their number
  /// sun_without_sky: radiance of a sky that would suit it, W/(m² sr): blue, with an eighth of the
  /// illuminance of a surface that faces the sun, as on a clear day.
  Vec3 suitable_sky = Vec3(0.0f);

  /// One sentence for a person; empty where none is needed.
  std::string as_text() const;
  /// The setting that replaces this light, or adds the sky that is missing.
  std::vector<Hint> hints() const;
};

/// Adds light to a scene that has none (has_light()) and no sun, so that it can be solved: a uniform white
/// sky of default_daylight. Under such a sky over ground, the sides of a solid differ and show its shape.
/// Where the sky reaches less than 1 % of the surfaces, the scene is a closed room. Then materials with names
/// such as "ceiling lamp" or "Bulb.001" emit instead; where there are none, white square luminaires that face
/// down are placed below the ceilings, so that nearly every point of the open space sees one. Their triangles
/// come last, see Scene::added_triangles; their power gives about default_lamp_light.
///
/// The same scene gets the same light for any number of threads. Throws what make_patches() and Tracer throw.
/// Cost: building a Tracer, and 0.2 million rays; nothing where the scene has light but no sun without a sky.
/// Reports no progress.
DefaultLight add_default_light(Scene& scene, const Context& context = {},
                               DefaultSky sky = DefaultSky::over_ground);

}  // namespace luxel
