// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/punctual_choices.h"

#include <algorithm>
#include <cmath>

namespace luxel {
namespace {

// Part of the largest intensity that each light counts with in every direction, so that no lit point is
// missed where the distribution is dark towards the receiver's centre.
constexpr double defensive = 0.1;

struct Ranked {
  std::uint32_t light = 0;
  double importance = 0.0;
};

}  // namespace

// Irradiance at the receiver's centre, roughly: 0 only where the whole light is behind the receiver's plane.
double PunctualChoices::importance(std::uint32_t light, const Receiver& receiver) const {
  const auto& lamp = lights_[light].light;
  if (lamp.kind == PointLightKind::directional)
    return weights_[light] * std::max(0.0, -glm::dot(Vec3d(lamp.direction), receiver.normal));
  const auto way = Vec3d(lamp.position) - receiver.centre;
  const auto height = glm::dot(way, receiver.normal) + extent_of(lamp) + 1e-6 * receiver.radius;
  if (!(height > 0.0)) return 0.0;
  const auto reach = receiver.radius + extent_of(lamp);
  const auto distance = std::max({glm::length(way), reach, 1e-6});
  const auto intensity = defensive + (1.0 - defensive) * zone_intensity(lamp, receiver.centre);
  return weights_[light] * intensity * std::min(1.0, (height + reach) / distance) / (distance * distance);
}

void PunctualChoices::make(std::span<const BandPointLight> lights, std::span<const double> weights,
                           std::span<const std::uint32_t> taking_part, const Receiver& receiver) {
  lights_ = lights;
  weights_ = weights;
  far_.clear();
  far_choice_.clear();
  near_.assign(taking_part.begin(), taking_part.end());
  if (near_.size() > max_near) {
    thread_local std::vector<Ranked> ranked;
    ranked.clear();
    for (const auto light : taking_part)
      if (const auto value = importance(light, receiver); value > 0.0) ranked.push_back({light, value});
    const auto count = std::min(max_near, ranked.size());
    std::partial_sort(ranked.begin(), ranked.begin() + static_cast<std::ptrdiff_t>(count), ranked.end(),
                      [](const Ranked& a, const Ranked& b) {
                        return a.importance != b.importance ? a.importance > b.importance : a.light < b.light;
                      });
    near_.clear();
    for (std::size_t i = 0; i < ranked.size(); ++i) {
      if (i < count) {
        near_.push_back(ranked[i].light);
      } else {
        far_.push_back(ranked[i].light);
        far_choice_.add(ranked[i].importance);
      }
    }
  }
  sights_.resize(near_.size() + 1);
}

PunctualSample PunctualChoices::sample(const Vec3d& point, const Vec3d& normal, double u,
                                       const std::array<double, 2>& opening) {
  choice_.clear();
  for (std::size_t i = 0; i < near_.size(); ++i) {
    sights_[i] = sight_of(lights_[near_[i]].light, point, normal, opening);
    choice_.add(weights_[near_[i]] * sights_[i].irradiance);
  }
  std::uint32_t far_light = 0;
  if (!far_.empty()) {
    const auto element = far_choice_.choose(u);
    const auto probability = far_choice_.weight(element) / far_choice_.total();
    u = std::clamp((u * far_choice_.total() - far_choice_.before(element)) / far_choice_.weight(element), 0.0,
                   0x1.fffffffffffffp-1);
    far_light = far_[element];
    sights_[near_.size()] = sight_of(lights_[far_light].light, point, normal, opening);
    choice_.add(weights_[far_light] * sights_[near_.size()].irradiance / probability);
  }
  const auto whole = choice_.total();
  if (!(whole > 0.0)) return {};
  const auto chosen = choice_.choose(u);
  const auto light = chosen < near_.size() ? near_[chosen] : far_light;
  return {light, sights_[chosen], whole / weights_[light]};
}

}  // namespace luxel
