// SPDX-License-Identifier: Apache-2.0
#include "luxel/viewer/draw_vertices.h"

#include <algorithm>
#include <numeric>

#include "luxel/core/none.h"

namespace luxel {
namespace {}  // namespace

DrawVertices::DrawVertices(const PatchSet& patches, const SmoothLight& light)
    : patches_(patches), light_(light), latest_(light.size(), none), ratios_(patches) {
  corners_.reserve(patches.size());
  vertices_.reserve(light.size() + light.size() / 8);
}

std::uint32_t DrawVertices::vertex(std::uint32_t smooth, std::uint32_t material) {
  for (auto v = latest_[smooth]; v != none; v = before_[v])
    if (vertices_[v].material == material) return v;
  const auto added = static_cast<std::uint32_t>(vertices_.size());
  vertices_.push_back({smooth, material});
  before_.push_back(latest_[smooth]);
  latest_[smooth] = added;
  return added;
}

void DrawVertices::go_on(std::size_t count) {
  const auto end = std::min(patches_.size(), corners_.size() + count);
  for (auto patch = corners_.size(); patch < end; ++patch) {
    const auto material = static_cast<std::uint32_t>(patches_.material[patch]);
    const auto& smooth = light_.corners[patch];
    corners_.push_back(
        {vertex(smooth[0], material), vertex(smooth[1], material), vertex(smooth[2], material)});
    for (const auto v : corners_.back()) ratios_.add(v, patch);
  }
}

TwoSides value_of(const DrawVertex& vertex, const TextureRatio& ratio, VertexValue what,
                  const PatchSet& patches, const BandColours& colours, const SmoothLight& light) {
  const auto bands = patches.band_count();
  const float* front = light.irradiance.front.data() + vertex.smooth * bands;
  const float* back = light.irradiance.back.data() + vertex.smooth * bands;
  if (what == VertexValue::radiance) {
    const auto& material = patches.materials[vertex.material];
    return {in_gamut(radiance_of(material, false, front, colours, ratio)),
            in_gamut(radiance_of(material, true, back, colours, ratio))};
  }
  const auto number = [&](const float* irradiance) {
    return Vec3(what == VertexValue::lux ? static_cast<float>(colours.lumens(irradiance))
                                         : std::accumulate(irradiance, irradiance + bands, 0.0f));
  };
  return {number(front), number(back)};
}

}  // namespace luxel
