// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "luxel/session/light_value.h"
#include "luxel/trace/tracer.h"

namespace luxel {

// The surface under the cursor.
struct Probe {
  std::uint32_t patch = 0;
  bool back = false;
  float distance = 0.0f;      // m, along the ray
  float u = 0.0f, v = 0.0f;   // where in the patch, see Hit
  Vec3d at{0.0};              // m, in the file's coordinates
  Vec3 normal{0.0f};          // unit, of the side that is seen
  double area = 0.0;          // m², of the patch
  double longest_edge = 0.0;  // m
  std::string material;
  std::uint32_t triangle = 0;           // of the file, from 0
  std::uint32_t line = 0;               // of the file, from 1; 0 where unknown
  std::string group = {}, object = {};  // of the file; empty where unknown
  // Empty where there is no light yet.
  std::optional<LightValue> irradiance;         // of the patch's side: its mean
  std::optional<LightValue> radiosity;          // of the patch's side
  std::optional<LightValue> smooth_irradiance;  // at that point, as it is drawn
};

// The nearest surface along the ray (counted from the patches' origin): nothing where it meets none, or there
// is no tracer yet. light: null, or of the same geometry as the mesh. Cost: microseconds.
std::optional<Probe> probe(const SessionMesh& mesh, const SessionLight* light, const Ray& ray);

struct ProfilePoint {
  double along = 0.0;              // m, from the first point on, in a straight line from each to the next
  std::optional<Vec3> place = {};  // m, counted from the patches' origin; nothing: the ray met nothing
  bool is_lit = false;  // false: the ray met nothing, or there is no light yet; the rest is empty then
  std::uint32_t patch = 0;
  bool back = false;
  LightValue irradiance;  // as it is drawn at that point, with the error of the patch's mean
};

// Light along a line that was drawn on the screen: at the hit of each ray, in their order. Where a ray has no
// hit, the line continues at the next hit.
std::vector<ProfilePoint> profile(const SessionMesh& mesh, const SessionLight* light,
                                  std::span<const Ray> rays);

}  // namespace luxel
