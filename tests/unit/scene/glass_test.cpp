// SPDX-License-Identifier: Apache-2.0
// Transmittance of panes by the angle of incidence.
#include "luxel/scene/glass.h"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace luxel {
namespace {

double cosine_of(double degrees) { return std::cos(degrees * std::numbers::pi / 180.0); }

// A slab without absorption by another way: reflections between its faces, one after the other, with the
// reflectances by sines and tangents of the angles.
double traced_slab(double degrees) {
  const auto outside = degrees * std::numbers::pi / 180.0;
  const auto inside = std::asin(std::sin(outside) / 1.52);
  const auto s = std::pow(std::sin(outside - inside) / std::sin(outside + inside), 2.0);
  const auto p = std::pow(std::tan(outside - inside) / std::tan(outside + inside), 2.0);
  double sum = 0.0;
  for (const auto r : {s, p}) {
    auto power = 0.5 * (1.0 - r);  // in the glass
    for (int k = 0; k < 200; ++k) {
      sum += power * (1.0 - r);
      power *= r * r;
    }
  }
  return sum;
}

TEST(Glass, without_absorption_it_is_a_slab_of_fresnel_reflections) {
  const auto clear = clear_slab_transmittance();
  EXPECT_NEAR(clear, 2.0 * 1.52 / (1.52 * 1.52 + 1.0), 1e-12);  // (1 - r) / (1 + r) at normal incidence
  for (const auto degrees : {10.0, 45.0, 56.66, 60.0, 75.0, 85.0, 89.0})
    EXPECT_NEAR(pane_transmittance(clear, cosine_of(degrees)), traced_slab(degrees), 1e-9) << degrees;
}

// Direct solar transmittance of clear float glass of 4, 6 and 10 mm at 0, 40, 55, 70 and 80 degrees in the
// database of optical properties of ESP-r (index 1.52; three digits).
TEST(Glass, with_absorption_it_meets_published_values_of_float_glass) {
  constexpr std::array<double, 5> degrees = {0.0, 40.0, 55.0, 70.0, 80.0};
  constexpr std::array<std::array<double, 5>, 3> published = {{{0.819, 0.802, 0.761, 0.621, 0.376},
                                                               {0.779, 0.759, 0.717, 0.581, 0.348},
                                                               {0.699, 0.672, 0.629, 0.503, 0.294}}};
  for (const auto& glass : published)
    for (std::size_t i = 0; i < degrees.size(); ++i)
      EXPECT_NEAR(pane_transmittance(glass[0], cosine_of(degrees[i])), glass[i], 0.01)
          << glass[0] << " at " << degrees[i];
}

TEST(Glass, every_transmittance_is_met_at_normal_incidence_and_falls_with_the_angle) {
  for (const auto at_normal : {0.0, 1e-6, 0.05, 0.5, 0.9, 0.9183, 0.92, 0.96, 0.999, 1.0}) {
    EXPECT_NEAR(pane_transmittance(at_normal, 1.0), at_normal, 1e-12);
    auto before = at_normal;
    for (double degrees = 1.0; degrees <= 90.0; degrees += 1.0) {
      const auto t = pane_transmittance(at_normal, cosine_of(degrees));
      EXPECT_LE(t, before + 1e-12) << at_normal << " at " << degrees;
      EXPECT_GE(t, 0.0);
      before = t;
    }
    EXPECT_NEAR(pane_transmittance(at_normal, 0.0), at_normal < 1.0 ? 0.0 : 1.0, 1e-12);
  }
}

TEST(Glass, values_on_both_sides_of_the_clear_slab_join) {
  const auto clear = clear_slab_transmittance();
  for (const auto degrees : {0.0, 30.0, 60.0, 80.0, 88.0})
    EXPECT_NEAR(pane_transmittance(clear - 1e-9, cosine_of(degrees)),
                pane_transmittance(clear + 1e-9, cosine_of(degrees)), 1e-7);
}

// Radiance's transmissivity of a glass of transmittance t, from the manual page of its material "glass".
double transmissivity_in_radiance(double t) {
  return (std::sqrt(0.8402528435 + 0.0072522239 * t * t) - 0.9166530661) / 0.0036261119 / t;
}

TEST(Glass, transmissivity_is_converted_as_radiance_does) {
  for (const auto t : {0.2, 0.6, 0.8, 0.88, 0.9})
    EXPECT_NEAR(transmittance_of_transmissivity(transmissivity_in_radiance(t)), t, 1e-6);
  EXPECT_NEAR(transmittance_of_transmissivity(0.96), 0.8815, 1e-4);
  EXPECT_NEAR(transmittance_of_transmissivity(1.0), clear_slab_transmittance(), 1e-12);
}

}  // namespace
}  // namespace luxel
