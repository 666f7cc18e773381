// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "luxel/form_factors/exact_view_factors.h"
#include "luxel/form_factors/sample_view_factors.h"
#include "luxel/form_factors/view_elements.h"
#include "luxel/patch/make_patches.h"
#include "luxel/trace/tracer.h"

#include "support/truth_scenes.h"

namespace luxel::truth {

// A scene with the input of its view factors.
struct FactorScene {
  FactorScene(Scene built, Between kind, ElementSides sides = ElementSides::front, float max_edge = 0.0f)
      : scene(std::move(built)),
        patches(make_patches(scene, {.max_edge = max_edge})),
        tracer(patches, context),
        elements(make_view_elements(scene, patches, kind, sides)) {}

  ViewFactors counted(const SampleFactorsOptions& options) const {
    return *sample_view_factors(patches, tracer, elements, options, report, context);
  }
  ViewFactors exact() const {
    ExactFactorsReport ignored;
    return *exact_view_factors(patches, tracer, elements, {}, ignored, context);
  }

  Context context{2};
  Scene scene;
  PatchSet patches;
  Tracer tracer;
  ViewElements elements;
  mutable SampleFactorsReport report;
};

struct Factor {
  double value = 0.0, standard_error = 0.0;
};

inline std::size_t element(const ViewFactors& factors, const std::string& name) {
  const auto at = std::find(factors.name.begin(), factors.name.end(), name);
  return static_cast<std::size_t>(at - factors.name.begin());
}

inline Factor factor(const ViewFactors& factors, std::size_t from, std::size_t to) {
  for (auto at = factors.row_begin[from]; at < factors.row_begin[from + 1]; ++at)
    if (factors.column[at] == to)
      return {factors.factor[at], static_cast<double>(factors.standard_error[at])};
  return {};
}

inline Factor factor(const ViewFactors& factors, const std::string& from, const std::string& to) {
  return factor(factors, element(factors, from), element(factors, to));
}

inline double row_sum(const ViewFactors& factors, std::size_t row) {
  double sum = 0.0;
  for (auto at = factors.row_begin[row]; at < factors.row_begin[row + 1]; ++at) sum += factors.factor[at];
  for (const auto& sink : factors.sink) sum += sink.factor[row];
  return sum;
}

// Unit squares, hot at z = 0 and cold at z = gap, which face each other, one-sided; between them, where
// asked, a two-sided square "shield" that covers the plates for x below `cover`.
inline Scene plates_with_shield(float gap, bool has_shield, float cover = 1.0f) {
  SceneBuilder b;
  b.material("hot", 0.5f, 0.0f, false).quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  b.material("cold", 0.5f, 0.0f, false).quad({0, 1, gap}, {1, 1, gap}, {1, 0, gap}, {0, 0, gap});
  const float z = 0.5f * gap;
  if (has_shield) b.material("shield", 0.5f, 0.0f).quad({0, 0, z}, {cover, 0, z}, {cover, 1, z}, {0, 1, z});
  return b.scene();
}

// Adds the six faces of a cube around the origin, of the material last named, seen from outside or inside.
inline void add_cube(SceneBuilder& b, float half, bool outwards) {
  const auto quad = [&](const Vec3& normal, const Vec3& u) {
    const auto v = glm::cross(normal, u);
    const auto n = half * normal;
    const auto w = outwards ? half * v : -half * v;
    b.quad(n - half * u - w, n + half * u - w, n + half * u + w, n - half * u + w);
  };
  for (const float s : {1.0f, -1.0f}) {
    quad({s, 0, 0}, {0, 1, 0});
    quad({0, s, 0}, {0, 0, 1});
    quad({0, 0, s}, {1, 0, 0});
  }
}

}  // namespace luxel::truth
