// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "luxel/patch/patch_set.h"
#include "luxel/scene/scene.h"

namespace luxel::truth {

// Small enclosures with a known solution, made here so that the tests need no file. Emittance is given as
// such (W/m²), normals point into the rooms.

// A scene built face by face. Each call of quad or triangle adds to the group and material last named.
class SceneBuilder {
 public:
  // Reflectance and emittance, equal in all three bands; or band by band.
  SceneBuilder& material(const std::string& name, float reflectance, float emittance, bool two_sided = true);
  SceneBuilder& material(const std::string& name, const Vec3& reflectance, const Vec3& emittance,
                         bool two_sided = true);
  SceneBuilder& quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
  SceneBuilder& triangle(const Vec3& a, const Vec3& b, const Vec3& c);
  Scene scene() const { return scene_; }

 private:
  std::uint32_t vertex(const Vec3& p);
  Scene scene_;
};

// Reflectance and emittance of one wall.
struct Wall {
  float reflectance = 0.5f;
  float emittance = 0.0f;
};

// The unit cube, six walls with the names floor, ceiling, wall_x0, wall_x1, wall_y0, wall_y1, each one
// material; Z is up.
Scene cube(const std::array<Wall, 6>& walls, float size = 1.0f);
// All walls 0.5, the ceiling emits 1 W/m².
Scene cube_a();
// Opposed unit squares one metre apart, reflectance 0.5, the lower emits 1 W/m².
Scene plates();
// The L-shaped room: 2 x 2 x 1 m without the quarter x > 1, y > 1; the end wall x = 2 emits 1 W/m²; floor
// 0.3, ceiling 0.7, walls 0.5. Materials are named after the parts of which the mean irradiance is known.
Scene l_room();
// A sphere of radius 1 seen from inside, `rings` rings of triangles; the cap above latitude `cap` (z > cap)
// emits 1 W/m² and all reflects 0.5.
Scene sphere(int rings, float cap);
// A furnace: every surface emits 1 - reflectance, so that radiosity and irradiance are 1 everywhere. With a
// block inside.
Scene furnace(const Vec3& walls, const Vec3& block);

// Mean irradiance (first band) of the front of the patches of one material, area-weighted.
double mean_irradiance(const PatchSet& patches, const std::vector<float>& irradiance,
                       const std::string& material);

}  // namespace luxel::truth
