// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/sky_box.h"

#include <algorithm>

#include "luxel/core/address.h"
#include "luxel/core/bounds.h"

namespace luxel {
namespace {

constexpr float margin = 1e-4f;  // of the box's diagonal
constexpr std::size_t trial_rays = 4096;

// Face 2 * axis is the lower of the two that stand across an axis.
int axis_of(std::size_t face) { return static_cast<int>(face / 2); }

}  // namespace

SkyBox::SkyBox(const PatchSet& patches) {
  Bounds box;
  for (const auto& corners : patches.corners)
    for (const auto c : corners) box.add(patches.vertices[c]);
  const auto lift = origin_lift({box.low, box.high, box.center()});
  const Vec3 more(std::max(margin * glm::length(box.size()), 4.0f * lift));
  low_ = box.low - more;
  high_ = box.high + more;
}

double SkyBox::area(std::size_t face) const {
  const Vec3d size(high_ - low_);
  const auto axis = axis_of(face);
  return size[(axis + 1) % 3] * size[(axis + 2) % 3];
}

Ray SkyBox::ray(std::size_t face, const std::array<float, 4>& u) const {
  const auto axis = axis_of(face);
  const bool is_lower = face % 2 == 0;
  auto origin = low_;
  if (!is_lower) origin[axis] = high_[axis];
  for (const auto k : {1, 2}) {
    const auto across = (axis + k) % 3;
    origin[across] += u[static_cast<std::size_t>(k - 1)] * (high_[across] - low_[across]);
  }
  Vec3 inwards(0.0f);
  inwards[axis] = is_lower ? 1.0f : -1.0f;
  return {origin, Frame(inwards).to_world(cosine_hemisphere(u[2], u[3]))};
}

double sky_hit_fraction(const PatchSet& patches, const Tracer& tracer, const SkyBox& box) {
  double area = 0.0;
  double met = 0.0;
  for (std::size_t face = 0; face < SkyBox::faces; ++face) {
    const auto key = stream_key(0, RandomPurpose::sky_box, static_cast<std::uint32_t>(face));
    std::size_t hits = 0;
    for (std::size_t i = 0; i < trial_rays / SkyBox::faces; ++i)
      if (takes_part(patches, tracer.nearest(box.ray(face, uniform4(key, i))))) ++hits;
    area += box.area(face);
    met += box.area(face) * static_cast<double>(hits) / static_cast<double>(trial_rays / SkyBox::faces);
  }
  return met / area;
}

}  // namespace luxel
