// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/vertex_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/barycentric.h"
#include "luxel/core/conjugate_gradients.h"
#include "luxel/core/disjoint_sets.h"
#include "luxel/core/error.h"
#include "luxel/core/none.h"

namespace luxel {
namespace {

constexpr int max_steps = 200;
constexpr double enough = 1e-7;  // of the residual, relative to that of no light

using Corners = std::array<std::uint32_t, 3>;

void check(const Scene& scene, const PatchSet& patches, const SmoothLight& light) {
  const auto beyond = [&](std::uint32_t triangle) { return triangle >= scene.triangles.size(); };
  if (light.corners.size() != patches.size() ||
      std::any_of(patches.triangle.begin(), patches.triangle.end(), beyond))
    throw MismatchError(fmt::format("the light is not of {}: solve this scene", scene.source));
}

// Integral of f g over a triangle of unit area, for linear functions given by their values at the corners.
double integral(const Vec3d& f, const Vec3d& g) {
  return (glm::dot(f, g) + (f.x + f.y + f.z) * (g.x + g.y + g.z)) / 12.0;
}

// The triangles with patches, and their unknowns.
class Fit {
 public:
  Fit(const Scene& scene, const PatchSet& patches, const SmoothLight& light)
      : scene_(scene), patches_(patches), light_(light), unknown_of_(scene.positions.size()) {
    join_vertices();
    measure();
  }

  // values: [smooth vertex][band]; fitted: [scene vertex][band]. Adds to the sums of squares of the light and
  // of the residual.
  void solve(const std::vector<float>& values, std::size_t band, std::vector<float>& fitted, double& all,
             double& missed) const;

 private:
  void join_vertices();
  void measure();
  std::array<Vec3, 3> corners_of(std::size_t triangle) const {
    const auto& c = scene_.triangles[triangle];
    return {scene_.positions[c[0]], scene_.positions[c[1]], scene_.positions[c[2]]};
  }
  Vec3d smooth_values(std::size_t patch, const std::vector<float>& values, std::size_t band) const {
    const auto& c = light_.corners[patch];
    const auto bands = patches_.band_count();
    return {values[c[0] * bands + band], values[c[1] * bands + band], values[c[2] * bands + band]};
  }
  // The unknowns of a triangle's corners.
  Corners unknowns(std::size_t triangle) const {
    const auto& c = scene_.triangles[triangle];
    return {unknown_of_[c[0]], unknown_of_[c[1]], unknown_of_[c[2]]};
  }
  void multiply(const std::vector<double>& x, std::vector<double>& product) const;

  const Scene& scene_;
  const PatchSet& patches_;
  const SmoothLight& light_;
  std::vector<std::uint32_t> unknown_of_;   // [scene vertex]
  std::vector<double> area_;                // [triangle], m²: of its patches
  std::vector<double> patch_area_;          // [patch], m², including holes
  std::vector<std::array<Vec3d, 3>> hats_;  // [patch][its corner]: weights of the triangle's corners
  std::vector<double> diagonal_;            // [unknown]
};

// Vertices of the file at one position between which smooth light is continuous are one unknown.
void Fit::join_vertices() {
  DisjointSets sets(scene_.positions.size());
  std::vector<std::uint32_t> vertex_of(light_.size(), none);  // [smooth vertex]
  for (std::size_t p = 0; p < patches_.size(); ++p)
    for (const auto s : light_.corners[p])
      for (const auto v : scene_.triangles[patches_.triangle[p]])
        if (scene_.positions[v] == patches_.vertices[light_.vertex[s]]) {
          if (vertex_of[s] == none) vertex_of[s] = v;
          sets.join(vertex_of[s], v);
        }
  for (std::uint32_t v = 0; v < unknown_of_.size(); ++v) unknown_of_[v] = sets.of(v);
}

void Fit::measure() {
  area_.resize(scene_.triangles.size());
  diagonal_.resize(scene_.positions.size());
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    const auto triangle = patches_.triangle[p];
    const auto points = patches_.points(p);
    patch_area_.push_back(
        glm::length(glm::cross(Vec3d(points[1]) - Vec3d(points[0]), Vec3d(points[2]) - Vec3d(points[0]))) /
        2.0);
    area_[triangle] += patch_area_.back();
    auto& hats = hats_.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) hats[i] = barycentric(corners_of(triangle), points[i]);
  }
  for (std::size_t t = 0; t < area_.size(); ++t)
    for (const auto u : unknowns(t)) diagonal_[u] += area_[t] / 6.0;
}

void Fit::multiply(const std::vector<double>& x, std::vector<double>& product) const {
  std::fill(product.begin(), product.end(), 0.0);
  for (std::size_t t = 0; t < area_.size(); ++t) {
    const auto u = unknowns(t);
    const auto sum = x[u[0]] + x[u[1]] + x[u[2]];
    for (const auto i : u) product[i] += area_[t] / 12.0 * (x[i] + sum);
  }
}

void Fit::solve(const std::vector<float>& values, std::size_t band, std::vector<float>& fitted, double& all,
                double& missed) const {
  const auto n = diagonal_.size();
  std::vector<double> wanted(n), x(n);
  std::vector<double> low(n, std::numeric_limits<double>::infinity()), high(n, 0.0);
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    const auto light = smooth_values(p, values, band);
    const auto u = unknowns(patches_.triangle[p]);
    for (int i = 0; i < 3; ++i) {
      const Vec3d hat(hats_[p][0][i], hats_[p][1][i], hats_[p][2][i]);
      const auto of = u[static_cast<std::size_t>(i)];
      wanted[of] += patch_area_[p] * integral(hat, light);
      low[of] = std::min({low[of], light.x, light.y, light.z});
      high[of] = std::max({high[of], light.x, light.y, light.z});
    }
    all += patch_area_[p] * integral(light, light);
  }

  // Starts from the solution of the lumped matrix, preconditioned by the diagonal.
  for (std::size_t i = 0; i < n; ++i)
    if (diagonal_[i] > 0.0) x[i] = wanted[i] / (2.0 * diagonal_[i]);
  const auto apply = [&](const auto& v, auto& product) { multiply(v, product); };
  const auto precondition = [&](const auto& v, auto& scaled) {
    for (std::size_t i = 0; i < n; ++i) scaled[i] = diagonal_[i] > 0.0 ? v[i] / diagonal_[i] : 0.0;
  };
  const auto dot = [](const auto& a, const auto& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
  };
  std::vector<double> product(n);
  precondition(wanted, product);
  const auto of_no_light = dot(wanted, product);
  multiply(x, product);
  auto residual = wanted;
  for (std::size_t i = 0; i < n; ++i) residual[i] -= product[i];
  conjugate_gradients(x, std::move(residual), {max_steps, enough * enough, of_no_light},
                      LinearSystem{apply, precondition, dot}, [](int, const auto&) { return true; });

  const auto bands = patches_.band_count();
  for (std::size_t v = 0; v < unknown_of_.size(); ++v) {
    const auto u = unknown_of_[v];
    if (diagonal_[u] > 0.0) fitted[v * bands + band] = static_cast<float>(std::clamp(x[u], low[u], high[u]));
  }
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    const auto& c = scene_.triangles[patches_.triangle[p]];
    const Vec3d at(fitted[c[0] * bands + band], fitted[c[1] * bands + band], fitted[c[2] * bands + band]);
    const Vec3d here(glm::dot(hats_[p][0], at), glm::dot(hats_[p][1], at), glm::dot(hats_[p][2], at));
    const auto off = smooth_values(p, values, band) - here;
    missed += patch_area_[p] * integral(off, off);
  }
}

}  // namespace

VertexFit fit_vertices(const Scene& scene, const PatchSet& patches, const SmoothLight& light) {
  check(scene, patches, light);
  VertexFit fit;
  fit.irradiance.front.resize(scene.positions.size() * patches.band_count());
  fit.irradiance.back = fit.irradiance.front;
  const Fit least(scene, patches, light);
  double all = 0.0, missed = 0.0;
  for (std::size_t band = 0; band < patches.band_count(); ++band) {
    least.solve(light.irradiance.front, band, fit.irradiance.front, all, missed);
    least.solve(light.irradiance.back, band, fit.irradiance.back, all, missed);
  }
  fit.difference = all > 0.0 ? std::sqrt(missed / all) : 0.0;
  return fit;
}

}  // namespace luxel
