// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/draw_vertices.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace luxel {
namespace {

// Calls body(patch, cut) for each patch in order; cut: null where it is drawn as it is.
template <typename Body>
void for_each_patch(const PatchSet& patches, const std::vector<PatchCut>& cuts, Body body) {
  auto next = cuts.begin();
  for (std::uint32_t patch = 0; patch < patches.size(); ++patch)
    body(patch, next != cuts.end() && next->patch == patch ? &*next++ : nullptr);
}

}  // namespace

DrawVertices::DrawVertices(const PatchSet& patches, const std::vector<PatchCut>& cuts,
                           const SmoothLight& light)
    : patches_(patches), cuts_(cuts), light_(light), latest_(light.size(), none), ratios_(patches) {
  corners_.reserve(patches.size());
  triangles_.reserve(patches.size());
  vertices_.reserve(light.size() + light.size() / 8);
}

std::uint32_t DrawVertices::add(const DrawVertex& vertex) {
  vertices_.push_back(vertex);
  before_.push_back(none);
  return static_cast<std::uint32_t>(vertices_.size() - 1);
}

std::uint32_t DrawVertices::vertex(std::uint32_t smooth, std::uint32_t material) {
  for (auto v = latest_[smooth]; v != none; v = before_[v])
    if (vertices_[v].material == material) return v;
  const auto added = add({.smooth = smooth, .material = material});
  before_[added] = std::exchange(latest_[smooth], added);
  return added;
}

void DrawVertices::cut(const PatchCut& cut) {
  const auto& corners = corners_[cut.patch];
  std::vector<std::uint32_t> points;
  for (const auto& point : cut.points)
    points.push_back(point.is_corner() ? corners[point.edge]
                                       : add({.from = corners[point.edge],
                                              .to = corners[(point.edge + 1) % 3],
                                              .fraction = point.fraction,
                                              .vertex = point.vertex}));
  for (const auto& t : cut.triangles) triangles_.push_back({points[t[0]], points[t[1]], points[t[2]]});
}

void DrawVertices::go_on(std::size_t count) {
  const auto end = std::min(patches_.size(), corners_.size() + count);
  for (auto patch = corners_.size(); patch < end; ++patch) {
    const auto material = static_cast<std::uint32_t>(patches_.material[patch]);
    const auto& smooth = light_.corners[patch];
    corners_.push_back(
        {vertex(smooth[0], material), vertex(smooth[1], material), vertex(smooth[2], material)});
    for (const auto v : corners_.back()) ratios_.add(v, patch);
    if (next_cut_ < cuts_.size() && cuts_[next_cut_].patch == patch)
      cut(cuts_[next_cut_++]);
    else
      triangles_.push_back(corners_.back());
  }
}

std::vector<std::array<std::uint32_t, 3>> drawn_triangles(const PatchSet& patches,
                                                          const std::vector<PatchCut>& cuts) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(patches.size());
  for_each_patch(patches, cuts, [&](std::uint32_t patch, const PatchCut* cut) {
    if (cut == nullptr) {
      triangles.push_back(patches.corners[patch]);
    } else {
      for (const auto& t : cut->triangles)
        triangles.push_back({cut->points[t[0]].vertex, cut->points[t[1]].vertex, cut->points[t[2]].vertex});
    }
  });
  return triangles;
}

std::vector<std::uint32_t> patches_of_triangles(const PatchSet& patches, const std::vector<PatchCut>& cuts) {
  std::vector<std::uint32_t> of;
  of.reserve(patches.size());
  for_each_patch(patches, cuts, [&](std::uint32_t patch, const PatchCut* cut) {
    of.insert(of.end(), cut == nullptr ? 1 : cut->triangles.size(), patch);
  });
  return of;
}

TwoSides value_of(const DrawVertex& vertex, const TextureRatio& ratio, VertexValue what,
                  const PatchSet& patches, const BandColours& colours, const SmoothLight& light) {
  const auto bands = patches.band_count();
  const float* front = light.irradiance.front.data() + vertex.smooth * bands;
  const float* back = light.irradiance.back.data() + vertex.smooth * bands;
  if (what == VertexValue::radiance) {
    const auto& material = patches.materials[vertex.material];
    return {in_gamut(radiance_of(material, false, {front, back}, colours, ratio)),
            in_gamut(radiance_of(material, true, {back, front}, colours, ratio))};
  }
  const auto number = [&](const float* irradiance) {
    return Vec3(what == VertexValue::lux ? static_cast<float>(colours.lumens(irradiance))
                                         : std::accumulate(irradiance, irradiance + bands, 0.0f));
  };
  return {number(front), number(back)};
}

}  // namespace luxel
