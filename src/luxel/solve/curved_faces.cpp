// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/curved_faces.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "luxel/patch/refine_patches.h"

namespace luxel {
namespace {

constexpr float flat_cosine = 0.9998f;  // 1.1 degrees

bool is_bent(const PatchSet& patches, const SmoothLight& light, std::size_t patch) {
  const auto& corners = light.corners[patch];
  return std::any_of(corners.begin(), corners.end(), [&](auto v) {
    return std::abs(glm::dot(light.normal[v], patches.normal[patch])) < flat_cosine;
  });
}

}  // namespace

CurvedFaces::CurvedFaces(const PatchSet& patches, const SmoothLight& light) : patches_(patches) {
  const auto& triangle = patches.triangle;
  if (triangle.empty()) return;
  is_curved_.assign(*std::max_element(triangle.begin(), triangle.end()) + 1, 0);
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (is_bent(patches, light, p)) is_curved_[triangle[p]] = 1;
}

FaceCorners::FaceCorners(const CurvedFaces& faces, const SmoothLight& light)
    : places_(3 * faces.patches().size(), alone) {
  const auto& triangle = faces.patches().triangle;
  for (std::uint32_t p = 0; p < triangle.size(); ++p)
    if (faces.has(p) && is_part(triangle, p))
      for (const auto vertex : light.corners[p]) list_.push_back({triangle[p], vertex, p});
  std::sort(list_.begin(), list_.end(), [](const Place& a, const Place& b) {
    return std::tie(a.triangle, a.vertex, a.patch) < std::tie(b.triangle, b.vertex, b.patch);
  });
  std::uint32_t first = 0;
  for (std::uint32_t i = 0; i < list_.size(); ++i) {
    if (!list_[i].is_at(list_[first])) first = i;
    const auto& corners = light.corners[list_[i].patch];
    const auto corner = std::find(corners.begin(), corners.end(), list_[i].vertex) - corners.begin();
    places_[3 * std::size_t{list_[i].patch} + static_cast<std::size_t>(corner)] = first;
  }
}

}  // namespace luxel
