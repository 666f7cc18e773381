// SPDX-License-Identifier: Apache-2.0
// The dense method against the factors F_T of CIE 190:2010: interreflection in square rooms whose walls, of
// one element each, are alike by symmetry. That wall_transfer() has the printed numbers is a test of its own
// (unit/lighting/room_transfer_test.cpp).
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "luxel/classical/classical.h"
#include "luxel/lighting/room_transfer.h"
#include "luxel/lighting/ugr_table.h"
#include "luxel/patch/make_patches.h"
#include "luxel/patch/uncut_faces.h"

#include "support/truth_scenes.h"

namespace luxel {
namespace {

// A room of side x side x 1 m whose surfaces of one kind emit the first reflection of one lumen spread over
// them.
Scene room(float side, const RoomReflectance& rho, const std::string& source) {
  truth::SceneBuilder b;
  const auto s = side;
  const auto next = [&](const char* kind, double reflectance, float area) {
    const auto r = static_cast<float>(reflectance);
    b.material(kind, r, source == kind ? r / area : 0.0f, false);
  };
  next("floor", rho.floor, s * s);
  b.quad({0, 0, 0}, {s, 0, 0}, {s, s, 0}, {0, s, 0});
  next("ceiling", rho.ceiling, s * s);
  b.quad({0, 0, 1}, {0, s, 1}, {s, s, 1}, {s, 0, 1});
  next("wall", rho.wall, 4.0f * s);
  b.quad({0, 0, 0}, {0, s, 0}, {0, s, 1}, {0, 0, 1})
      .quad({s, 0, 0}, {s, 0, 1}, {s, s, 1}, {s, s, 0})
      .quad({0, 0, 0}, {0, 0, 1}, {s, 0, 1}, {s, 0, 0})
      .quad({0, s, 0}, {s, s, 0}, {s, s, 1}, {0, s, 1});
  auto scene = b.scene();
  for (std::size_t t = 0; t < scene.triangles.size(); ++t)
    scene.triangle_line[t] = static_cast<std::uint32_t>(t / 2 + 1);  // a quad is one element
  return scene;
}

double illuminance_of_walls(const Scene& scene) {
  const Context context;
  const auto patches = make_patches(scene, {.max_edge = no_max_edge});
  const Tracer tracer(patches, context);
  Solution solution;
  DenseSolveOptions options;
  options.face = uncut_faces(scene, patches);
  solve_dense(patches, tracer, solution, options, context);
  double sum = 0.0;
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (patches.material_of(p).name == "wall")
      sum += double{patches.area[p]} * double{solution.irradiance.front[3 * p]};
  return sum;
}

TEST(Cie190, square_rooms_have_its_factors) {
  for (const float side : {2.0f, 4.0f, 8.0f})
    for (const auto& rho : ugr_reflectances) {
      const auto expected = wall_transfer(side, side, rho);
      for (const auto& [source, factor] : {std::pair("floor", expected.from_floor),
                                           {"wall", expected.from_wall},
                                           {"ceiling", expected.from_ceiling}})
        EXPECT_NEAR(illuminance_of_walls(room(side, rho, source)), factor, 2e-6)
            << side << " " << name_of(rho) << " from " << source;
    }
}

}  // namespace
}  // namespace luxel
