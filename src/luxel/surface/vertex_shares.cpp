// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/vertex_shares.h"

namespace luxel {

void VertexShares::add(std::size_t vertex, std::size_t patch) {
  if (patches_.reflectance_share.empty() && patches_.emittance_share.empty()) return;
  if (vertex >= area_.size()) area_.resize(vertex + 1, 0.0f);
  area_[vertex] += patches_.area[patch];
  const auto weight = patches_.area[patch] / area_[vertex];
  mix(reflectance_, patches_.reflectance_share, vertex, patch, weight);
  mix(emittance_, patches_.emittance_share, vertex, patch, weight);
}

void VertexShares::mix(std::vector<float>& means, const std::vector<float>& shares, std::size_t vertex,
                       std::size_t patch, float weight) const {
  if (shares.empty()) return;
  const auto bands = patches_.band_count();
  if (means.size() < (vertex + 1) * bands) means.resize((vertex + 1) * bands, 0.0f);
  for (std::size_t b = 0; b < bands; ++b)
    means[vertex * bands + b] += weight * (shares[patch * bands + b] - means[vertex * bands + b]);
}

SurfaceShare VertexShares::at(std::size_t vertex) const {
  const auto of = [&](const std::vector<float>& means) {
    return means.empty() ? nullptr : &means[vertex * patches_.band_count()];
  };
  return {of(reflectance_), of(emittance_)};
}

}  // namespace luxel
