// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/vertex_texture_ratios.h"

namespace luxel {

void VertexTextureRatios::add(std::size_t vertex, std::size_t patch) {
  if (patches_.reflectance_ratio.empty() && patches_.emittance_ratio.empty()) return;
  if (vertex >= area_.size()) area_.resize(vertex + 1, 0.0f);
  area_[vertex] += patches_.area[patch];
  const auto weight = patches_.area[patch] / area_[vertex];
  mix(reflectance_, patches_.reflectance_ratio, vertex, patch, weight);
  mix(emittance_, patches_.emittance_ratio, vertex, patch, weight);
}

void VertexTextureRatios::mix(std::vector<float>& means, const std::vector<float>& ratios, std::size_t vertex,
                              std::size_t patch, float weight) const {
  if (ratios.empty()) return;
  const auto bands = patches_.band_count();
  if (means.size() < (vertex + 1) * bands) means.resize((vertex + 1) * bands, 0.0f);
  for (std::size_t b = 0; b < bands; ++b)
    means[vertex * bands + b] += weight * (ratios[patch * bands + b] - means[vertex * bands + b]);
}

TextureRatio VertexTextureRatios::at(std::size_t vertex) const {
  const auto of = [&](const std::vector<float>& means) {
    return means.empty() ? nullptr : &means[vertex * patches_.band_count()];
  };
  return {of(reflectance_), of(emittance_)};
}

}  // namespace luxel
