// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/displayed_corners.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "luxel/image/image.h"
#include "luxel/scene/band_colours.h"
#include "luxel/solution/back_is_lit.h"

namespace luxel {
namespace {

// Relative error of the irradiance that is always allowed: half of the default error of the light.
constexpr float irradiance_error = 0.01f;
constexpr float darkest = 1e-4f;  // displayed, linear: a thirtieth of an 8-bit code

// Derivative of the sRGB encoding (IEC 61966-2-1).
float srgb_slope(float linear) {
  if (linear <= 0.0031308f) return 12.92f;
  return 1.055f / 2.4f * std::pow(linear, 1.0f / 2.4f - 1.0f);
}

// [smooth vertex]: 1 where a patch shows this side of it. A corner may come to belong to another patch at its
// vertex, so whether it counts does not depend on the patch.
std::vector<std::uint8_t> shown_vertices(const SmoothLight& light, const std::vector<std::uint8_t>& hidden) {
  std::vector<std::uint8_t> is_shown(light.size(), hidden.empty() ? 1 : 0);
  for (std::size_t p = 0; p < hidden.size(); ++p)
    if (hidden[p] == 0)
      for (const auto smooth : light.corners[p]) is_shown[smooth] = 1;
  return is_shown;
}

}  // namespace

DisplayedCorners::DisplayedCorners(const PatchSet& patches, const Solution& solution,
                                   const SmoothLight& light, const ToneCurve& curve, float max_error,
                                   const FrontAndBack<std::uint8_t>& hidden)
    : look_(3 * patches.size()) {
  const auto colours = patches.colours();
  const auto bands = colours.bands();
  const FrontAndBack<std::uint8_t> shown{shown_vertices(light, hidden.front),
                                         shown_vertices(light, hidden.back)};
  const auto look_of = [&](std::uint32_t smooth, const BandMaterial& material, bool back) {
    Look look;
    const auto here = std::span(light.irradiance.of(back)).subspan(smooth * bands, bands);
    look.colour =
        curve(in_gamut(radiance_of(material, back, irradiance_at(light, smooth, back, bands), colours)));
    for (const auto e : here) look.irradiance += e;
    if (shown.of(back)[smooth] == 0) return look;
    float relative = 0.0f;  // allowed error over the colour, of the channel that allows most
    for (int k = 0; k < 3; ++k) {
      const auto allowed = max_error / srgb_slope(look.colour[k]);
      look.colour_scale[k] = 1.0f / allowed;
      relative = std::max(relative, allowed / std::max(darkest, look.colour[k]));
    }
    const auto allowed = std::max(irradiance_error, relative) * look.irradiance;
    look.irradiance_scale = allowed > 0.0f ? 1.0f / allowed : 0.0f;
    return look;
  };

  for (std::size_t p = 0; p < patches.size() && !has_backs_; ++p)
    has_backs_ = back_is_lit(solution, p) && (hidden.back.empty() || hidden.back[p] == 0);
  // Looks are numbered by smooth vertex and material.
  std::vector<std::tuple<std::uint32_t, std::uint32_t, CornerId>> order;
  order.reserve(look_.size());
  for (CornerId c = 0; c < look_.size(); ++c)
    order.emplace_back(light.corners[c / 3][c % 3], static_cast<std::uint32_t>(patches.material[c / 3]), c);
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto [smooth, material, corner] = order[i];
    if (i == 0 || std::get<0>(order[i - 1]) != smooth || std::get<1>(order[i - 1]) != material) {
      front_.push_back(look_of(smooth, patches.materials[material], false));
      if (has_backs_) back_.push_back(look_of(smooth, patches.materials[material], true));
    }
    look_[corner] = static_cast<std::uint32_t>(front_.size() - 1);
  }
}

float DisplayedCorners::error(const Look& at, const std::array<const Look*, 3>& others, const Vec3& weights) {
  Vec3 colour(0.0f);
  float irradiance = 0.0f;
  for (int k = 0; k < 3; ++k) {
    colour += weights[k] * others[static_cast<std::size_t>(k)]->colour;
    irradiance += weights[k] * others[static_cast<std::size_t>(k)]->irradiance;
  }
  const auto off = glm::abs(colour - at.colour) * at.colour_scale;
  return std::max({off.r, off.g, off.b, std::abs(irradiance - at.irradiance) * at.irradiance_scale});
}

DisplayedCorners::Look DisplayedCorners::middle(const Look& a, const Look& b) {
  return {0.5f * (a.colour + b.colour), 0.5f * (a.colour_scale + b.colour_scale),
          0.5f * (a.irradiance + b.irradiance), 0.5f * (a.irradiance_scale + b.irradiance_scale)};
}

template <typename At>
float DisplayedCorners::error_of_sides(const At& at, const std::array<CornerId, 3>& others,
                                       const Vec3& weights) const {
  const std::array looks{look_[others[0]], look_[others[1]], look_[others[2]]};
  const auto of = [&](const std::vector<Look>& side) {
    return error(at(side), {&side[looks[0]], &side[looks[1]], &side[looks[2]]}, weights);
  };
  return has_backs_ ? std::max(of(front_), of(back_)) : of(front_);
}

float DisplayedCorners::error(CornerId at, const std::array<CornerId, 3>& others, const Vec3& weights) const {
  return error_of_sides([&](const auto& side) -> const Look& { return side[look_[at]]; }, others, weights);
}

float DisplayedCorners::middle_error(CornerId a, CornerId b, const std::array<CornerId, 3>& others,
                                     const Vec3& weights) const {
  return error_of_sides([&](const auto& side) { return middle(side[look_[a]], side[look_[b]]); }, others,
                        weights);
}

}  // namespace luxel
