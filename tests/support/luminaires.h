// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "luxel/photometry/photometry.h"
#include "luxel/scene/luminous_efficacy.h"
#include "luxel/scene/point_light.h"

namespace luxel::test {

// Type C: a cosine below the horizontal, tabulated every half degree; candela straight down.
inline IntensityDistribution cosine_distribution(double candela) {
  std::vector<double> gamma, values;
  for (int i = 0; i <= 180; ++i) {
    gamma.push_back(0.5 * i);
    values.push_back(std::max(0.0, candela * std::cos(0.5 * i * std::numbers::pi / 180.0)));
  }
  return {GoniometerType::c, gamma, {0.0}, values};
}

// No symmetry: the intensity is linear in the horizontal angle up to 270 degrees and differs above and below.
inline IntensityDistribution lopsided_distribution() {
  std::vector<double> gamma, around, values;
  for (int i = 0; i <= 12; ++i) gamma.push_back(15.0 * i);
  for (int j = 0; j <= 12; ++j) around.push_back(30.0 * j);
  for (int j = 0; j <= 12; ++j)
    for (int i = 0; i <= 12; ++i) values.push_back(100.0 + 50.0 * (j % 12) + 20.0 * i * ((j % 12) + 1));
  return {GoniometerType::c, gamma, around, values};
}

// z up, aims down, without colour; intensity in candela as in the distribution.
inline PointLight luminaire(IntensityDistribution distribution, const LuminousOpening& opening,
                            const Vec3& position) {
  auto photometry = std::make_shared<Photometry>();
  photometry->file = "test.ies";
  photometry->intensity = std::move(distribution);
  photometry->opening = opening;
  PointLight light;
  light.name = "luminaire";
  light.kind = PointLightKind::luminaire;
  light.position = position;
  light.direction = {0, 0, -1};
  light.local_x = {1, 0, 0};
  light.local_y = {0, 1, 0};
  light.intensity = Vec3(static_cast<float>(photometry->intensity.maximum() / luminous_efficacy));
  light.photometry = std::move(photometry);
  return light;
}

}  // namespace luxel::test
