// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/glass.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace luxel {
namespace {

// Reflectance of one face for the two polarisations, by the cosines outside and inside of the glass.
std::array<double, 2> face_reflectance(double outside, double inside) {
  const auto squared = [](double x) { return x * x; };
  return {squared((outside - glass_index * inside) / (outside + glass_index * inside)),
          squared((glass_index * outside - inside) / (glass_index * outside + inside))};
}

double cosine_inside(double cosine) {
  return std::sqrt(1.0 - (1.0 - cosine * cosine) / (glass_index * glass_index));
}

// r: reflectance of a face; a: what the glass lets through on the way from one face to the other.
double slab(double r, double a) {
  if (r >= 1.0) return 0.0;  // grazing
  return (1.0 - r) * (1.0 - r) * a / (1.0 - r * r * a * a);
}

double slab_at(double a_normal, double cosine) {
  const auto inside = cosine_inside(cosine);
  const auto r = face_reflectance(cosine, inside);
  const auto a = a_normal < 1.0 ? std::pow(a_normal, 1.0 / inside) : 1.0;
  return 0.5 * (slab(r[0], a) + slab(r[1], a));
}

// Solves slab(r, a) = at_normal for a: a quadratic equation, in the form that is exact for small values.
double transmissivity_of(double at_normal) {
  const auto r = face_reflectance(1.0, 1.0)[0];
  const auto faces = (1.0 - r) * (1.0 - r);
  return 2.0 * at_normal / (faces + std::sqrt(faces * faces + 4.0 * r * r * at_normal * at_normal));
}

}  // namespace

double clear_slab_transmittance() { return slab_at(1.0, 1.0); }

double pane_transmittance(double at_normal, double cosine) {
  cosine = std::clamp(cosine, 0.0, 1.0);
  if (at_normal >= 1.0) return 1.0;
  if (at_normal <= 0.0 || cosine <= 0.0) return 0.0;
  const auto clear = clear_slab_transmittance();
  if (at_normal <= clear) return slab_at(transmissivity_of(at_normal), cosine);
  return std::pow(slab_at(1.0, cosine), std::log(at_normal) / std::log(clear));
}

double transmittance_of_transmissivity(double transmissivity) { return slab_at(transmissivity, 1.0); }

}  // namespace luxel
