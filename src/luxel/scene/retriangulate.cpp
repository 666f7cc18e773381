// SPDX-License-Identifier: Apache-2.0
#include "luxel/scene/retriangulate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <span>
#include <vector>

#include "luxel/core/none.h"
#include "luxel/core/triangle.h"
#include "luxel/scene/clean_triangles.h"
#include "luxel/scene/edges.h"
#include "luxel/scene/fragment_mesh.h"
#include "luxel/scene/halve_needles.h"
#include "luxel/scene/triangle_shape.h"
#include "luxel/scene/vertex_weld.h"

namespace luxel {
namespace {

constexpr double needle_of_file = 16.0;    // slenderness above which a surface is triangulated again
constexpr double needle_left = 8.0;        // above which its triangles are cut
constexpr double longest_of_scene = 0.01;  // of its diagonal: shorter needles stay
constexpr double height_roundings = 8.0;   // heights of triangles, in roundings of the coordinates
constexpr std::size_t points_per_triangle = 4, more_points = 50;

// Attributes of a corner of a triangle, without its position.
struct Attributes {
  std::vector<Vec2> places;  // [set]: on pictures
  Vec3 colour = Vec3(1.0f);
};
Attributes attributes_of(const Scene& scene, std::size_t triangle, std::size_t corner) {
  Attributes all;
  for (const auto& set : scene.uv_sets) all.places.push_back(set[triangle][corner]);
  if (!scene.corner_colours.empty()) all.colour = scene.corner_colours[triangle][corner];
  return all;
}
Attributes middle_of(const Attributes& a, const Attributes& b) {
  Attributes middle;
  for (std::size_t s = 0; s < a.places.size(); ++s)
    middle.places.push_back(0.5f * (a.places[s] + b.places[s]));
  middle.colour = 0.5f * (a.colour + b.colour);
  return middle;
}
void append_numbers(const Attributes& all, std::vector<double>& numbers) {
  numbers.clear();
  for (const auto& place : all.places) numbers.insert(numbers.end(), {double{place.x}, double{place.y}});
  numbers.insert(numbers.end(), {double{all.colour.x}, double{all.colour.y}, double{all.colour.z}});
}

double rounding_of(const Bounds& box) {
  const auto largest = glm::max(glm::abs(box.low), glm::abs(box.high));
  return 0x1p-24 * static_cast<double>(std::max({largest.x, largest.y, largest.z}));
}

// The plane of a triangle, and the linear functions of the place on it that its attributes are.
class Plane {
 public:
  Plane(const Scene& scene, std::size_t triangle, double rounding) : rounding_(rounding) {
    std::array<Vec3d, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = Vec3d(scene.positions[scene.triangles[triangle][k]]);
    origin_ = p[0];
    normal_ = glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]));
    x_ = glm::normalize(p[1] - p[0]);
    y_ = glm::cross(normal_, x_);
    const auto longest =
        std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
    height_ = glm::length(glm::cross(p[1] - p[0], p[2] - p[0])) / longest;
    const auto b = flat(p[1]), c = flat(p[2]);
    std::array<std::vector<double>, 3> values;
    for (std::size_t k = 0; k < 3; ++k) append_numbers(attributes_of(scene, triangle, k), values[k]);
    for (std::size_t i = 0; i < values[0].size(); ++i) {
      const auto along = (values[1][i] - values[0][i]) / b.x;
      functions_.push_back({values[0][i], along, (values[2][i] - values[0][i] - along * c.x) / c.y});
    }
  }

  glm::dvec2 flat(const Vec3d& place) const {
    return {glm::dot(place - origin_, x_), glm::dot(place - origin_, y_)};
  }

  // Returns whether a triangle lies in this plane, faces the same way, and continues the attributes.
  bool contains(const Scene& scene, std::size_t triangle) const {
    const auto& t = scene.triangles[triangle];
    const std::array places{scene.positions[t[0]], scene.positions[t[1]], scene.positions[t[2]]};
    return std::all_of(places.begin(), places.end(), [&](const Vec3& p) { return is_near(Vec3d(p)); }) &&
           glm::dot(area_vector2(places[0], places[1], places[2]), normal_) > 0.0 &&
           continues(scene, triangle, places);
  }

 private:
  // Factor by which errors of the triangle are larger at a place, where its plane and functions are
  // extrapolated.
  double growth(const Vec3d& place) const { return 1.0 + glm::distance(place, origin_) / height_; }

  bool is_near(const Vec3d& place) const {
    constexpr double roundings = 8.0;
    return std::abs(glm::dot(place - origin_, normal_)) <= roundings * rounding_ * growth(place);
  }

  bool continues(const Scene& scene, std::size_t triangle, const std::array<Vec3, 3>& places) const {
    constexpr double error = 0x1p-20;
    std::vector<double> values;
    for (std::size_t k = 0; k < 3; ++k) {
      append_numbers(attributes_of(scene, triangle, k), values);
      const auto at = flat(Vec3d(places[k]));
      const auto allowed = error * growth(Vec3d(places[k]));
      for (std::size_t i = 0; i < values.size(); ++i) {
        const auto& f = functions_[i];
        if (std::abs(f[0] + f[1] * at.x + f[2] * at.y - values[i]) > allowed * (1.0 + std::abs(values[i])))
          return false;
      }
    }
    return true;
  }

  double rounding_;
  Vec3d origin_, normal_, x_, y_;
  double height_ = 0.0;
  std::vector<std::array<double, 3>> functions_;  // value at the origin, and slopes
};

using Neighbours = std::vector<std::array<std::uint32_t, 3>>;

// Neighbours of clean triangles at whole edges, where one surface may go on.
Neighbours neighbours_of(const Scene& scene, const CleanTriangles& clean, std::size_t vertices,
                         JoinedAt joined) {
  std::vector<bool> is_doubled(clean.kept.size(), false);
  for (const auto& twin : clean.twins) is_doubled[twin.kept] = true;
  const auto goes_on = [&](std::uint32_t a, std::uint32_t b) {
    const auto s = clean.kept[a].triangle, t = clean.kept[b].triangle;
    return !is_doubled[a] && !is_doubled[b] && scene.triangle_material[s] == scene.triangle_material[t] &&
           scene.triangle_group[s] == scene.triangle_group[t] &&
           (scene.triangle_object.empty() || scene.triangle_object[s] == scene.triangle_object[t]);
  };
  const auto end = [&](const Edges::Use& use, std::size_t k) {
    return scene.triangles[clean.kept[use.triangle].triangle][(use.corner + k) % 3];
  };
  Neighbours result(clean.kept.size(), {none, none, none});
  const auto edges = find_edges(clean.kept, vertices);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!edges.is_inner(e) || edges.winds_inconsistently(e)) continue;
    const auto uses = edges.uses_of(e);
    if (!goes_on(uses[0].triangle, uses[1].triangle)) continue;
    if (joined == JoinedAt::vertices &&
        (end(uses[0], 0) != end(uses[1], 1) || end(uses[0], 1) != end(uses[1], 0)))
      continue;
    result[uses[0].triangle][uses[0].corner] = uses[1].triangle;
    result[uses[1].triangle][uses[1].corner] = uses[0].triangle;
  }
  return result;
}

// A flat surface: its triangles, and the same as a mesh of the plane.
struct Surface {
  std::uint32_t largest = none;          // clean triangle, whose plane it is
  std::vector<std::uint32_t> triangles;  // clean ones, ascending
  FragmentMesh mesh;
  double steps_per_metre = 1.0;          // of the mesh's grid
  std::vector<std::uint32_t> positions;  // [point]: in the scene
  std::vector<Attributes> attributes;    // [point]
  FlatSurface record;
};

class Retriangulation {
 public:
  Retriangulation(Scene& scene, JoinedAt joined)
      : scene_(scene),
        joined_(joined),
        box_(bounds(scene)),
        rounding_(rounding_of(box_)),
        longest_(longest_of_scene * static_cast<double>(glm::length(box_.size()))) {}

  Retriangulated run() {
    if (!has_needles()) return {};
    clean_ = clean_triangles(scene_, weld_);
    neighbours_ = neighbours_of(scene_, clean_, weld_.positions().size(), joined_);
    Retriangulated result;
    for (auto& surface : surfaces()) {
      make_mesh(surface);
      if (!improve(surface)) continue;
      ++result.surfaces;
      result.before += surface.triangles.size();
      result.after += surface.mesh.fragments().size();
      improved_.push_back(std::move(surface));
    }
    if (!improved_.empty()) rewrite();
    return result;
  }

 private:
  std::array<Vec3, 3> corners(std::size_t triangle) const {
    const auto& t = scene_.triangles[triangle];
    return {scene_.positions[t[0]], scene_.positions[t[1]], scene_.positions[t[2]]};
  }
  double area(std::uint32_t clean) const {
    const auto p = corners(clean_.kept[clean].triangle);
    return triangle_area(p[0], p[1], p[2]);
  }
  bool is_needle(std::size_t triangle) const {
    const auto [a, b, c] = corners(triangle);
    return longest_edge(a, b, c) > longest_ && slenderness(a, b, c) > needle_of_file;
  }
  bool has_needles() const {
    for (std::size_t t = 0; t < scene_.triangles.size(); ++t)
      if (is_needle(t)) return true;
    return false;
  }

  // Surfaces that have needles, each found from its largest triangle.
  std::vector<Surface> surfaces() const {
    std::vector<std::uint32_t> by_area(clean_.kept.size());
    std::iota(by_area.begin(), by_area.end(), 0u);
    std::stable_sort(by_area.begin(), by_area.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return area(a) > area(b); });
    std::vector<bool> is_taken(clean_.kept.size(), false);
    std::vector<Surface> result;
    for (const auto first : by_area) {
      if (is_taken[first] || neighbours_[first] == std::array{none, none, none}) continue;
      const Plane plane(scene_, clean_.kept[first].triangle, rounding_);
      Surface surface;
      surface.largest = first;
      bool any_needle = false;
      std::vector<std::uint32_t> open{first};
      is_taken[first] = true;
      while (!open.empty()) {
        const auto t = open.back();
        open.pop_back();
        surface.triangles.push_back(t);
        any_needle = any_needle || is_needle(clean_.kept[t].triangle);
        for (const auto next : neighbours_[t])
          if (next != none && !is_taken[next] && plane.contains(scene_, clean_.kept[next].triangle)) {
            is_taken[next] = true;
            open.push_back(next);
          }
      }
      if (!any_needle || surface.triangles.size() < 3) continue;
      std::sort(surface.triangles.begin(), surface.triangles.end());
      result.push_back(std::move(surface));
    }
    return result;
  }

  void make_mesh(Surface& surface) const {
    const Plane plane(scene_, clean_.kept[surface.largest].triangle, rounding_);
    const auto fragment_of = [&](std::uint32_t t) {
      const auto at = std::lower_bound(surface.triangles.begin(), surface.triangles.end(), t);
      return at != surface.triangles.end() && *at == t
                 ? static_cast<std::uint32_t>(at - surface.triangles.begin())
                 : none;
    };
    std::map<std::uint32_t, std::uint32_t> point_at;
    std::vector<glm::dvec2> places;
    std::vector<FragmentMesh::Fragment> fragments;
    for (const auto t : surface.triangles) {
      const auto& clean = clean_.kept[t];
      surface.record.of_file.push_back(clean.triangle);
      auto& fragment = fragments.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [found, is_new] =
            point_at.try_emplace(clean.corners[k], static_cast<std::uint32_t>(places.size()));
        if (is_new) {
          const auto position = scene_.triangles[clean.triangle][k];
          surface.record.corner_of.push_back(clean.triangle);
          surface.positions.push_back(position);
          surface.attributes.push_back(attributes_of(scene_, clean.triangle, k));
          places.push_back(plane.flat(Vec3d(scene_.positions[position])));
        }
        fragment.v[k] = found->second;
        fragment.across[k] = neighbours_[t][k] == none ? none : fragment_of(neighbours_[t][k]);
      }
    }
    auto low = places.front(), high = low;
    for (const auto& p : places) low = glm::min(low, p), high = glm::max(high, p);
    surface.steps_per_metre =
        static_cast<double>(FragmentMesh::grid) / std::max(high.x - low.x, high.y - low.y);
    std::vector<FragmentMesh::Point> points;
    for (const auto& p : places) {
      const auto steps = surface.steps_per_metre * (p - low);
      points.push_back({std::llround(steps.x), std::llround(steps.y)});
    }
    surface.mesh = FragmentMesh(std::move(points), std::move(fragments));
  }

  bool improve(Surface& surface) {
    NeedleLimits limits{.slenderness = needle_of_file,
                        .longest = surface.steps_per_metre * longest_,
                        .min_height = surface.steps_per_metre * height_roundings * rounding_,
                        .points = points_per_triangle * surface.triangles.size() + more_points};
    auto& mesh = surface.mesh;
    bool any = false;
    for (std::uint32_t t = 0; t < mesh.fragments().size() && !any; ++t)
      any = is_needle_inside(mesh, t, limits);
    if (!any) return false;
    make_delaunay(mesh, limits.min_height);
    limits.slenderness = needle_left;
    auto finer = mesh;
    const auto halved = halve_needles(finer, limits);
    if (halved.size() >= limits.points) return true;  // narrow parts would need ever more of them
    mesh = std::move(finer);
    for (const auto& [a, b] : halved) {
      surface.record.halved.push_back({a, b});
      const auto middle =
          0.5f * (scene_.positions[surface.positions[a]] + scene_.positions[surface.positions[b]]);
      surface.positions.push_back(static_cast<std::uint32_t>(scene_.positions.size()));
      scene_.positions.push_back(middle);
      surface.attributes.push_back(middle_of(surface.attributes[a], surface.attributes[b]));
    }
    return true;
  }

  // Appends a triangle of the file, or of a surface that stands there, without its corners' attributes.
  void append(const Scene& old, std::uint32_t t, const std::array<std::uint32_t, 3>& corners) {
    scene_.triangles.push_back(corners);
    scene_.triangle_material.push_back(old.triangle_material[t]);
    scene_.triangle_line.push_back(old.triangle_line[t]);
    scene_.triangle_group.push_back(old.triangle_group[t]);
    if (!old.triangle_object.empty()) scene_.triangle_object.push_back(old.triangle_object[t]);
  }

  void append_same(const Scene& old, std::uint32_t t) {
    append(old, t, old.triangles[t]);
    for (std::size_t s = 0; s < old.uv_sets.size(); ++s) scene_.uv_sets[s].push_back(old.uv_sets[s][t]);
    if (!old.corner_colours.empty()) scene_.corner_colours.push_back(old.corner_colours[t]);
  }

  void append_surface(const Scene& old, std::uint32_t t, Surface& surface) {
    surface.record.first = static_cast<std::uint32_t>(scene_.triangles.size());
    for (const auto& fragment : surface.mesh.fragments()) {
      const auto& v = fragment.v;
      const auto of = [&](auto value) { return std::array{value(v[0]), value(v[1]), value(v[2])}; };
      append(old, t, of([&](std::uint32_t p) { return surface.positions[p]; }));
      for (std::size_t s = 0; s < old.uv_sets.size(); ++s)
        scene_.uv_sets[s].push_back(of([&](std::uint32_t p) { return surface.attributes[p].places[s]; }));
      if (!old.corner_colours.empty())
        scene_.corner_colours.push_back(of([&](std::uint32_t p) { return surface.attributes[p].colour; }));
      surface.record.triangles.push_back(v);
    }
    scene_.retriangulated.push_back(std::move(surface.record));
  }

  // Replaces the triangles of the improved surfaces.
  void rewrite() {
    std::map<std::uint32_t, std::size_t> begins;  // first triangle of a surface
    std::vector<bool> is_replaced(scene_.triangles.size(), false);
    for (std::size_t s = 0; s < improved_.size(); ++s) {
      begins[improved_[s].record.of_file.front()] = s;
      for (const auto t : improved_[s].record.of_file) is_replaced[t] = true;
    }
    const Scene old = scene_;
    for (auto* numbers : {&scene_.triangle_line, &scene_.triangle_group, &scene_.triangle_object})
      numbers->clear();
    scene_.triangles.clear();
    scene_.triangle_material.clear();
    scene_.corner_colours.clear();
    for (auto& set : scene_.uv_sets) set.clear();
    for (std::uint32_t t = 0; t < old.triangles.size(); ++t)
      if (!is_replaced[t])
        append_same(old, t);
      else if (const auto found = begins.find(t); found != begins.end())
        append_surface(old, t, improved_[found->second]);
  }

  Scene& scene_;
  JoinedAt joined_;
  Bounds box_;
  double rounding_, longest_;
  VertexWeld weld_;
  CleanTriangles clean_;
  Neighbours neighbours_;
  std::vector<Surface> improved_;
};

}  // namespace

Retriangulated retriangulate_needles(Scene& scene, JoinedAt joined) {
  return Retriangulation(scene, joined).run();
}

}  // namespace luxel
