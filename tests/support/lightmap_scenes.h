// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "luxel/patch/make_patches.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/surface/make_charts.h"
#include "luxel/surface/pack_charts.h"

#include "support/truth_scenes.h"

namespace luxel::test {

// Light that was not solved: the same on every front, and on every back.
inline Solution even_light(const PatchSet& patches, float front, float back = 0.0f) {
  Solution s;
  s.bands = patches.bands;
  const auto values = patches.size() * patches.band_count();
  s.irradiance.front.assign(values, front);
  s.irradiance.back.assign(values, back);
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (std::size_t b = 0; b < patches.band_count(); ++b) {
      const auto& m = patches.material_of(p);
      s.radiosity.front.push_back(m.emittance[b] + m.reflectance[b] * front);
      s.radiosity.back.push_back(m.reflectance[b] * back);
    }
  return s;
}

// The wall of a round tower, radius 1 m, seen from outside.
inline Scene tower(int slices, float height) {
  truth::SceneBuilder b;
  b.material("wall", 0.5f, 0.0f);
  const auto at = [&](int i, float z) {
    const auto angle = 2.0 * M_PI * (i % slices) / slices;
    return Vec3(std::cos(angle), std::sin(angle), z);
  };
  for (int i = 0; i < slices; ++i) b.quad(at(i, 0), at(i + 1, 0), at(i + 1, height), at(i, height));
  return b.scene();
}

// A ramp that winds upwards twice, 2 m high: seen from above it lies over itself.
inline Scene ramp(int slices) {
  truth::SceneBuilder b;
  b.material("ramp", 0.5f, 0.0f);
  const auto at = [&](int i, float radius) {
    const auto angle = 2.0 * M_PI * i / slices;
    return Vec3(radius * std::cos(angle), radius * std::sin(angle),
                static_cast<float>(i) / static_cast<float>(slices));
  };
  for (int i = 0; i < 2 * slices; ++i) b.quad(at(i, 2), at(i + 1, 2), at(i + 1, 4), at(i, 4));
  return b.scene();
}

// Adds a closed box, normals outwards.
inline void add_box(truth::SceneBuilder& b, const Vec3& l, const Vec3& h) {
  b.quad({l.x, h.y, l.z}, {h.x, h.y, l.z}, {h.x, l.y, l.z}, {l.x, l.y, l.z});
  b.quad({l.x, l.y, h.z}, {h.x, l.y, h.z}, {h.x, h.y, h.z}, {l.x, h.y, h.z});
  b.quad({l.x, l.y, l.z}, {h.x, l.y, l.z}, {h.x, l.y, h.z}, {l.x, l.y, h.z});
  b.quad({h.x, l.y, l.z}, {h.x, h.y, l.z}, {h.x, h.y, h.z}, {h.x, l.y, h.z});
  b.quad({h.x, h.y, l.z}, {l.x, h.y, l.z}, {l.x, h.y, h.z}, {h.x, h.y, h.z});
  b.quad({l.x, h.y, l.z}, {l.x, l.y, l.z}, {l.x, l.y, h.z}, {l.x, h.y, h.z});
}

// A closed room from `l` to `h`, normals inwards; its floor is a material of its own.
inline void add_room(truth::SceneBuilder& b, const Vec3& l, const Vec3& h, float rho) {
  b.material("floor", rho, 0.0f).quad({l.x, l.y, l.z}, {h.x, l.y, l.z}, {h.x, h.y, l.z}, {l.x, h.y, l.z});
  b.material("walls", rho, 0.0f);
  b.quad({l.x, h.y, h.z}, {h.x, h.y, h.z}, {h.x, l.y, h.z}, {l.x, l.y, h.z});
  b.quad({l.x, l.y, h.z}, {h.x, l.y, h.z}, {h.x, l.y, l.z}, {l.x, l.y, l.z});
  b.quad({h.x, l.y, h.z}, {h.x, h.y, h.z}, {h.x, h.y, l.z}, {h.x, l.y, l.z});
  b.quad({h.x, h.y, h.z}, {l.x, h.y, h.z}, {l.x, h.y, l.z}, {h.x, h.y, l.z});
  b.quad({l.x, h.y, h.z}, {l.x, l.y, h.z}, {l.x, l.y, l.z}, {l.x, h.y, l.z});
}

}  // namespace luxel::test
