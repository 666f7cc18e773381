// SPDX-License-Identifier: Apache-2.0
#include "luxel/transport/lamps.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "luxel/math/triangle.h"

namespace luxel {
namespace {

constexpr double area_tolerance = 1e-4;    // relative; what the rounding of split corners may do
constexpr double colour_tolerance = 1e-6;  // relative; what the rounding of floats may do

// The triangle that patches [begin, end) of one input triangle fill: the point of a triangle farthest from
// any place is one of its corners, and the corner farthest from a line through two others is the third.
std::array<Vec3, 3> joined(const PatchSet& patches, std::size_t begin, std::size_t end) {
  Vec3d centre(0.0);
  for (auto p = begin; p < end; ++p)
    for (const auto& v : patches.points(p)) centre += Vec3d(v);
  centre /= 3.0 * static_cast<double>(end - begin);
  const auto farthest = [&](const auto& distance) {
    Vec3 best(0.0f);
    double most = -1.0;
    for (auto p = begin; p < end; ++p)
      for (const auto& v : patches.points(p))
        if (const auto d = distance(Vec3d(v)); d > most) {
          most = d;
          best = v;
        }
    return best;
  };
  const auto a = farthest([&](const Vec3d& v) { return glm::length(v - centre); });
  const auto b = farthest([&](const Vec3d& v) { return glm::length(v - Vec3d(a)); });
  const auto along = Vec3d(b) - Vec3d(a);
  const auto c = farthest([&](const Vec3d& v) { return glm::length(glm::cross(along, v - Vec3d(a))); });
  if (glm::dot(area_vector2(a, b, c), Vec3d(patches.normal[begin])) < 0.0) return {a, c, b};
  return {a, b, c};
}

}  // namespace

Lamps::Lamps(const PatchSet& patches)
    : lamp_of_patch_(patches.size(), no_lamp), bands_(patches.band_count()) {
  for (std::size_t begin = 0, end = 0; begin < patches.size(); begin = end) {
    for (end = begin + 1; end < patches.size() && patches.triangle[end] == patches.triangle[begin] &&
                          patches.material[end] == patches.material[begin];)
      ++end;
    const auto& material = patches.material_of(begin);
    if (!material.is_lamp()) continue;
    const auto area = std::accumulate(patches.area.data() + begin, patches.area.data() + end, 0.0);
    const auto whole = joined(patches, begin, end);
    const auto newest = [this] { return static_cast<std::uint32_t>(triangles_.size() - 1); };
    if (std::fabs(triangle_area(whole[0], whole[1], whole[2]) - area) <= area_tolerance * area) {
      if (add(whole, material))
        for (auto p = begin; p < end; ++p) lamp_of_patch_[p] = newest();
    } else {
      for (auto p = begin; p < end; ++p)
        if (add(patches.points(p), material)) lamp_of_patch_[p] = newest();
    }
  }
}

bool Lamps::add(const std::array<Vec3, 3>& corner, const BandMaterial& material) {
  LampTriangle lamp;
  lamp.corner = corner;
  const auto [a, b, c] = corner;
  const auto normal2 = area_vector2(a, b, c);
  lamp.area = 0.5 * glm::length(normal2);
  if (!(lamp.area > 0.0)) return false;
  lamp.normal = normal2 / (2.0 * lamp.area);
  lamp.longest_edge = std::max(
      {glm::length(Vec3d(b) - Vec3d(a)), glm::length(Vec3d(c) - Vec3d(b)), glm::length(Vec3d(a) - Vec3d(c))});
  for (const auto emittance : material.emittance) {
    radiance_.push_back(static_cast<float>(static_cast<double>(emittance) / std::numbers::pi));
    lamp.weight += static_cast<double>(emittance) / std::numbers::pi;
  }
  if (triangles_.empty())
    for (const auto emittance : material.emittance)
      colour_.push_back(static_cast<double>(emittance) / (std::numbers::pi * lamp.weight));
  for (std::size_t band = 0; band < bands_; ++band) {
    const auto share = static_cast<double>(material.emittance[band]) / (std::numbers::pi * lamp.weight);
    if (std::fabs(share - colour_[band]) > colour_tolerance) one_colour_ = false;
  }
  triangles_.push_back(lamp);
  return true;
}

}  // namespace luxel
