// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/smooth_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "luxel/report/error.h"
#include "luxel/surface/vertex_fan.h"

namespace luxel {
namespace {

void check(const PatchSet& patches, const Solution& solution, const SmoothOptions& options) {
  const auto values = patches.size() * patches.band_count();
  if (solution.bands != patches.bands || solution.irradiance_front.size() != values ||
      solution.irradiance_back.size() != values)
    throw MismatchError(
        fmt::format("the solution has {} irradiances but the patches need {}: it was not "
                    "made from this scene; solve it again",
                    solution.irradiance_front.size(), values));
  if (!(options.crease_angle >= 0.0f && options.crease_angle <= 180.0f))
    throw InputError(
        fmt::format("the crease angle must be from 0 to 180 degrees, but it is {}", options.crease_angle));
}

// Rounded to float, which hides the last bit of a double cosine: that one differs between hosts.
float cosine_of_degrees(float degrees) {
  return static_cast<float>(std::cos(static_cast<double>(degrees) * std::numbers::pi / 180.0));
}

// The corners (3 * patch + corner) at each vertex, in rows: row v is corners[begin[v]] to
// corners[begin[v+1]].
struct CornersOfVertex {
  std::vector<std::size_t> begin;
  std::vector<std::uint32_t> corners;

  std::span<const std::uint32_t> at(std::size_t vertex) const {
    return std::span(corners).subspan(begin[vertex], begin[vertex + 1] - begin[vertex]);
  }
};

CornersOfVertex corners_of_vertices(const PatchSet& patches) {
  CornersOfVertex rows;
  rows.begin.assign(patches.vertices.size() + 1, 0);
  for (const auto& patch : patches.corners)
    for (const auto v : patch) ++rows.begin[v + 1];
  for (std::size_t v = 0; v < patches.vertices.size(); ++v) rows.begin[v + 1] += rows.begin[v];

  auto next = rows.begin;
  rows.corners.resize(3 * patches.size());
  for (std::uint32_t c = 0; c < rows.corners.size(); ++c)
    rows.corners[next[patches.corners[c / 3][c % 3]]++] = c;
  return rows;
}

// Sums over the sides of each smooth surface at one vertex. Entry s belongs to the surface named s.
class SurfaceMeans {
 public:
  SurfaceMeans(const PatchSet& patches, const Solution& solution) : patches_(patches), solution_(solution) {}

  void fill(const VertexFan& fan) {
    area_.assign(2 * fan.size(), 0.0);
    normal_.assign(2 * fan.size(), Vec3d(0.0));
    light_.assign(2 * fan.size() * patches_.band_count(), 0.0);
    for (std::size_t i = 0; i < fan.size(); ++i) {
      add(fan.patch(i), false, fan.surface(i, false));
      add(fan.patch(i), true, fan.surface(i, true));
    }
  }

  void append_irradiance(std::uint32_t surface, std::vector<float>& out) const {
    const auto bands = patches_.band_count();
    for (std::size_t b = 0; b < bands; ++b)
      out.push_back(area_[surface] > 0.0 ? static_cast<float>(light_[surface * bands + b] / area_[surface])
                                         : 0.0f);
  }

  Vec3 normal(std::uint32_t surface, const Vec3& otherwise) const {
    const auto length = glm::length(normal_[surface]);
    if (length > 0.0) return Vec3(normal_[surface] / length);
    return glm::dot(otherwise, otherwise) > 0.0f ? otherwise : Vec3(0.0f, 0.0f, 1.0f);
  }

 private:
  // The back of a one-sided patch holds no light because nothing was ever asked there: it has no say.
  void add(std::uint32_t patch, bool back, std::uint32_t surface) {
    const auto area = static_cast<double>(patches_.area[patch]);
    normal_[surface] += Vec3d(patches_.normal[patch]) * (back ? -area : area);
    if (back && !patches_.material_of(patch).two_sided) return;
    const auto bands = patches_.band_count();
    const auto& irradiance = back ? solution_.irradiance_back : solution_.irradiance_front;
    area_[surface] += area;
    for (std::size_t b = 0; b < bands; ++b)
      light_[surface * bands + b] += area * static_cast<double>(irradiance[patch * bands + b]);
  }

  const PatchSet& patches_;
  const Solution& solution_;
  std::vector<double> area_;
  std::vector<Vec3d> normal_;
  std::vector<double> light_;
};

// Corners whose front and whose back belong to the same surfaces share one smooth vertex.
struct CornerSurfaces {
  std::uint32_t front, back;
  std::size_t i;  // in the fan

  auto order() const { return std::tuple(front, back, i); }
};

void add_vertex(std::uint32_t vertex, const VertexFan& fan, const SurfaceMeans& means,
                const PatchSet& patches, std::vector<CornerSurfaces>& scratch, SmoothLight& light) {
  scratch.clear();
  for (std::size_t i = 0; i < fan.size(); ++i)
    scratch.push_back({fan.surface(i, false), fan.surface(i, true), i});
  std::sort(scratch.begin(), scratch.end(),
            [](const auto& a, const auto& b) { return a.order() < b.order(); });

  const CornerSurfaces* previous = nullptr;
  for (const auto& c : scratch) {
    if (previous == nullptr || c.front != previous->front || c.back != previous->back) {
      light.vertex.push_back(vertex);
      light.normal.push_back(means.normal(c.front, patches.normal[fan.patch(c.i)]));
      means.append_irradiance(c.front, light.irradiance_front);
      means.append_irradiance(c.back, light.irradiance_back);
    }
    const auto corner = fan.corner(c.i);
    light.corners[corner / 3][corner % 3] = static_cast<std::uint32_t>(light.vertex.size() - 1);
    previous = &c;
  }
}

}  // namespace

SmoothLight make_smooth_light(const PatchSet& patches, const Solution& solution,
                              const SmoothOptions& options) {
  check(patches, solution, options);
  SmoothLight light;
  light.corners.resize(patches.size());

  const auto rows = corners_of_vertices(patches);
  VertexFan fan(patches, cosine_of_degrees(options.crease_angle));
  SurfaceMeans means(patches, solution);
  std::vector<CornerSurfaces> scratch;
  for (std::uint32_t v = 0; v < patches.vertices.size(); ++v) {
    fan.fill(rows.at(v));
    means.fill(fan);
    add_vertex(v, fan, means, patches, scratch, light);
  }
  return light;
}

void radiance_of(const BandMaterial& material, bool back, const float* irradiance, float* out) {
  const auto black = back && !material.two_sided;
  for (std::size_t b = 0; b < material.reflectance.size(); ++b) {
    const auto emittance = back ? 0.0f : material.emittance[b];
    out[b] = black ? 0.0f : (emittance + material.reflectance[b] * irradiance[b]) / pi;
  }
}

void check_rgb(const std::vector<std::string>& bands) {
  static const std::vector<std::string> rgb = {"red", "green", "blue"};
  if (bands != rgb)
    throw MismatchError(
        fmt::format("a picture needs the bands red, green, blue in this order, but the solution has {}; "
                    "solve the scene with plain colour",
                    bands.empty() ? "none" : fmt::format("{}", fmt::join(bands, ", "))));
}

}  // namespace luxel
