// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/make_patches.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "luxel/math/triangle.h"
#include "luxel/mesh/clean_triangles.h"
#include "luxel/mesh/triangle_shape.h"
#include "luxel/report/error.h"

namespace luxel {
namespace {

// Area of a triangle whose longest edge bisection has brought between h / sqrt(2) and h, as a share of h²: a
// right isosceles triangle on such a hypotenuse, averaged.
constexpr double split_area_share = 0.18;

// An estimate, good to some tens of per cent: parts by area, and for slivers by the length of their longest
// edge.
double expected_parts(double area, double longest, double max_edge) {
  if (longest <= max_edge) return 1.0;
  return std::max({1.0, area / (split_area_share * max_edge * max_edge), 1.5 * longest / max_edge});
}

struct Shape {
  double area = 0.0;
  double longest = 0.0;
};

// Of the triangles that become patches.
std::vector<Shape> shapes(const Scene& scene) {
  std::vector<Shape> result;
  result.reserve(scene.triangles.size());
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    if (!scene.materials[static_cast<std::size_t>(scene.triangle_material[i])].opaque) continue;
    const auto& t = scene.triangles[i];
    const Vec3d a(scene.positions[t[0]]), b(scene.positions[t[1]]), c(scene.positions[t[2]]);
    result.push_back({0.5 * glm::length(glm::cross(b - a, c - a)),
                      std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)})});
  }
  return result;
}

double expected_count(const std::vector<Shape>& all, double max_edge) {
  double count = 0.0;
  for (const auto& s : all) count += expected_parts(s.area, s.longest, max_edge);
  return count;
}

// The shortest edge (to 1 %) that keeps the expected count within the given one.
double edge_for_count(const std::vector<Shape>& all, double count) {
  double longest = 0.0;
  for (const auto& s : all) longest = std::max(longest, s.longest);
  if (longest == 0.0) return 1.0;
  double low = longest * 1e-7;
  double high = longest;
  while (high > low * 1.01) {
    const auto middle = std::sqrt(low * high);
    (expected_count(all, middle) > count ? low : high) = middle;
  }
  return high;
}

// Cuts one triangle until no edge is too long, and appends the parts.
class Splitter {
 public:
  Splitter(PatchSet& patches, VertexWeld& weld, const PatchOptions& options, double max_edge)
      : patches_(patches), weld_(weld), max_count_(options.max_count), max_edge2_(max_edge * max_edge) {}

  void add(const std::array<std::uint32_t, 3>& corners, const Vec3& normal, std::uint32_t triangle,
           MaterialId material) {
    normal_ = normal;
    triangle_ = triangle;
    material_ = material;
    split(corners);
  }

 private:
  double length2(std::uint32_t i, std::uint32_t j) const {
    const auto d = Vec3d(weld_.positions()[i]) - Vec3d(weld_.positions()[j]);
    return glm::dot(d, d);
  }

  void split(const std::array<std::uint32_t, 3>& c) {
    const std::array<double, 3> edge2 = {length2(c[0], c[1]), length2(c[1], c[2]), length2(c[2], c[0])};
    const auto k = static_cast<std::size_t>(std::max_element(edge2.begin(), edge2.end()) - edge2.begin());
    const auto i = c[k];
    const auto j = c[(k + 1) % 3];
    const auto apex = c[(k + 2) % 3];
    if (max_edge2_ <= 0.0 || edge2[k] <= max_edge2_) return append(c);
    // a + b is the same number as b + a: both neighbours of the edge find the same place.
    const auto& p = weld_.positions();
    const auto place = 0.5f * (p[i] + p[j]);
    if (!has_area(p[i], place, p[apex]) || !has_area(place, p[j], p[apex]))
      return append(c);  // as small as floats can tell
    const auto middle = weld_.index_of(place);
    split({i, middle, apex});
    split({middle, j, apex});
  }

  void append(const std::array<std::uint32_t, 3>& c) {
    if (patches_.size() >= max_count_)
      throw InputError(fmt::format("more than {} patches: a longer edge is needed (--max-edge)", max_count_));
    const auto& p = weld_.positions();
    patches_.corners.push_back(c);
    patches_.normal.push_back(normal_);
    patches_.area.push_back(static_cast<float>(triangle_area(p[c[0]], p[c[1]], p[c[2]])));
    patches_.material.push_back(material_);
    patches_.triangle.push_back(triangle_);
  }

  PatchSet& patches_;
  VertexWeld& weld_;
  std::size_t max_count_;
  double max_edge2_;
  Vec3 normal_{0.0f};
  std::uint32_t triangle_ = 0;
  MaterialId material_{};
};

BandMaterial band_material(const Material& m) {
  return {m.name,
          m.two_sided,
          {m.reflectance.r, m.reflectance.g, m.reflectance.b},
          {m.emittance.r, m.emittance.g, m.emittance.b}};
}

// Two one-sided sheets back to back are one sheet seen from both sides; its material is a two-sided twin.
class TwoSidedTwins {
 public:
  explicit TwoSidedTwins(PatchSet& patches) : patches_(patches) {}

  MaterialId of(MaterialId material) {
    const auto i = static_cast<std::size_t>(material);
    if (patches_.materials[i].two_sided) return material;
    const auto [entry, is_new] = twin_.try_emplace(i, static_cast<MaterialId>(patches_.materials.size()));
    if (is_new) {
      auto twin = patches_.materials[i];
      twin.two_sided = true;
      patches_.materials.push_back(std::move(twin));
    }
    return entry->second;
  }

 private:
  PatchSet& patches_;
  std::map<std::size_t, MaterialId> twin_;
};

void reserve(PatchSet& patches, std::size_t count) {
  patches.corners.reserve(count);
  patches.normal.reserve(count);
  patches.area.reserve(count);
  patches.material.reserve(count);
  patches.triangle.reserve(count);
}

// The edge to split to, or 0 for none; refuses one that would fill the memory.
double chosen_edge(const Scene& scene, const PatchOptions& options) {
  if (options.max_edge == automatic_edge) return automatic_max_edge(scene, options.target_count);
  if (!(options.max_edge >= 0.0f))
    throw InputError(fmt::format("max_edge must be 0 or more metres, not {}", options.max_edge));
  if (options.max_edge == no_max_edge) return 0.0;
  const auto all = shapes(scene);
  const auto expected = expected_count(all, options.max_edge);
  if (expected > 2.0 * static_cast<double>(options.max_count))
    throw InputError(fmt::format(
        "an edge of {} m would make about {:.2g} patches, more than {}: {:.3g} m would fit (--max-edge)",
        options.max_edge, expected, options.max_count,
        edge_for_count(all, 0.7 * static_cast<double>(options.max_count))));
  return options.max_edge;
}

}  // namespace

float automatic_max_edge(const Scene& scene, std::size_t target_count) {
  const auto all = shapes(scene);
  // The target is for what splitting adds: triangles that are finer already stay as they are.
  return static_cast<float>(edge_for_count(all, static_cast<double>(all.size() + target_count)));
}

PatchSet make_patches(const Scene& scene, const PatchOptions& options, const LogSink& log) {
  PatchSet patches;
  patches.bands = {"red", "green", "blue"};
  patches.scene_fingerprint = fingerprint(scene);
  for (const auto& m : scene.materials) patches.materials.push_back(band_material(m));
  if (scene.sky != Vec3(0.0f)) patches.sky = {scene.sky.r, scene.sky.g, scene.sky.b};

  VertexWeld weld;
  const auto triangles = clean_triangles(scene, weld, log).kept;
  if (triangles.empty())
    throw InputError(scene.source,
                     "expected at least one triangle with area, found none: there is nothing to light");

  reserve(patches, triangles.size());
  TwoSidedTwins twins(patches);
  Splitter splitter(patches, weld, options, chosen_edge(scene, options));
  for (const auto& t : triangles) {
    const auto& p = weld.positions();
    auto material = scene.triangle_material[t.triangle];
    if (t.opposite_twin) material = twins.of(material);
    const auto normal = triangle_normal(p[t.corners[0]], p[t.corners[1]], p[t.corners[2]]);
    splitter.add(t.corners, normal, t.triangle, material);
  }
  patches.vertices = weld.take();
  return patches;
}

}  // namespace luxel
