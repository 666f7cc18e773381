// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/sky_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/trig.h"

namespace luxel {
namespace {

struct Gradation {
  double a, b, c, d, e;
};

// ISO 15469:2004, table 1: types 1 to 15.
constexpr std::array<Gradation, 15> standard_types = {{
    {4.0, -0.70, 0.0, -1.0, 0.0},     // 1: overcast, steep gradation
    {4.0, -0.70, 2.0, -1.5, 0.15},    // 2: the same, slightly brighter towards the sun
    {1.1, -0.80, 0.0, -1.0, 0.0},     // 3: overcast, moderate gradation
    {1.1, -0.80, 2.0, -1.5, 0.15},    // 4: the same, slightly brighter towards the sun
    {0.0, -1.00, 0.0, -1.0, 0.0},     // 5: uniform
    {0.0, -1.00, 2.0, -1.5, 0.15},    // 6: partly cloudy, slightly brighter towards the sun
    {0.0, -1.00, 5.0, -2.5, 0.30},    // 7: the same, brighter circumsolar region
    {0.0, -1.00, 10.0, -3.0, 0.45},   // 8: the same, distinct corona
    {-1.0, -0.55, 2.0, -1.5, 0.15},   // 9: partly cloudy, the sun obscured
    {-1.0, -0.55, 5.0, -2.5, 0.30},   // 10: partly cloudy, brighter circumsolar region
    {-1.0, -0.55, 10.0, -3.0, 0.45},  // 11: white-blue, distinct corona
    {-1.0, -0.32, 10.0, -3.0, 0.45},  // 12: clear, low turbidity
    {-1.0, -0.32, 16.0, -3.0, 0.30},  // 13: clear, polluted
    {-1.0, -0.15, 16.0, -3.0, 0.30},  // 14: cloudless, turbid, broad corona
    {-1.0, -0.15, 24.0, -2.8, 0.15},  // 15: white-blue, turbid, broad corona
}};

Vec3d not_below_horizon(const Vec3d& sun) {
  if (sun.z >= 0.0) return sun;
  const auto level = std::hypot(sun.x, sun.y);
  return level > 0.0 ? Vec3d(sun.x / level, sun.y / level, 0.0) : Vec3d(0.0, 1.0, 0.0);
}

}  // namespace

SkyModel SkyModel::cie(int type, const Vec3d& sun) {
  if (type < 1 || type > sky_types)
    throw InputError(fmt::format("there is no CIE sky of type {}; types are 1 to {}", type, sky_types));
  SkyModel model;
  model.sun_ = not_below_horizon(sun);
  if (type == 16) {
    model.kind_ = Kind::overcast;
    return model;
  }
  const auto& g = standard_types[static_cast<std::size_t>(type - 1)];
  model.kind_ = Kind::graded;
  model.a_ = g.a;
  model.b_ = g.b;
  model.c_ = g.c;
  model.d_ = g.d;
  model.e_ = g.e;
  model.constant_ = 1.0 - g.c * std::exp(g.d * 0.5 * std::numbers::pi);
  model.scale_ = 1.0 / model.relative_luminance({0.0, 0.0, 1.0});
  return model;
}

SkyModel SkyModel::perez(const std::array<double, 5>& parameters, const Vec3d& sun) {
  SkyModel model;
  model.kind_ = Kind::graded;
  model.sun_ = not_below_horizon(sun);
  model.a_ = parameters[0];
  model.b_ = std::min(parameters[1], 0.0);
  model.c_ = parameters[2];
  model.d_ = parameters[3];
  model.e_ = parameters[4];
  return model;
}

double SkyModel::relative_luminance(const Vec3d& direction) const {
  if (direction.z < 0.0) return 0.0;
  if (kind_ == Kind::uniform) return 1.0;
  if (kind_ == Kind::overcast) return (1.0 + 2.0 * direction.z) / 3.0;
  const auto at_horizon = b_ < 0.0 ? 1.0 : 1.0 + a_;
  const auto gradation = direction.z > 0.0 ? 1.0 + a_ * std::exp(b_ / direction.z) : at_horizon;
  if (!follows_sun()) return std::max(0.0, scale_ * gradation * constant_);
  const auto cosine = std::clamp(glm::dot(direction, sun_), -1.0, 1.0);
  const auto indicatrix = constant_ + c_ * std::exp(d_ * arc_cosine(cosine)) + e_ * cosine * cosine;
  return std::max(0.0, scale_ * gradation * indicatrix);
}

}  // namespace luxel
