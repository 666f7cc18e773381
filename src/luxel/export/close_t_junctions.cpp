// SPDX-License-Identifier: Apache-2.0
#include "luxel/export/close_t_junctions.h"

#include <array>
#include <utility>
#include <vector>

#include "luxel/core/triangle.h"
#include "luxel/surface/patch_cuts.h"

namespace luxel {
namespace {

// A point on the border of a patch: a corner, or a hanging vertex.
struct Point {
  std::uint32_t vertex = 0, smooth = 0;
  Vec3 weights{0.0f};  // barycentric, in the patch
};

class TJunctions {
 public:
  explicit TJunctions(SimplifiedMesh& mesh) : mesh_(mesh), old_(mesh.patches), corners_(mesh.light.corners) {}

  void close() {
    const auto cuts = cut_at_hanging_vertices(old_);
    if (cuts.empty()) return;
    start();
    auto next = cuts.begin();
    for (std::uint32_t p = 0; p < old_.size(); ++p) {
      if (next != cuts.end() && next->patch == p)
        cut(*next++);
      else
        append(p, {corner(p, 0), corner(p, 1), corner(p, 2)});
    }
  }

 private:
  // Empties the arrays over patches.
  void start() {
    auto& set = mesh_.patches;
    for (auto* values : {&set.area, &set.reflectance_ratio, &set.emittance_ratio}) values->clear();
    set.corners.clear();
    set.normal.clear();
    set.material.clear();
    set.triangle.clear();
    for (auto& uv : set.uv_sets) uv.clear();
    set.corner_colours.clear();
    mesh_.light.corners.clear();
    light_ = std::exchange(mesh_.solution, {});
    mesh_.solution.bands = light_.bands;
    mesh_.solution.provenance = light_.provenance;
  }

  Point corner(std::uint32_t p, std::uint32_t k) const {
    return {old_.corners[p][k], corners_[p][k], BorderVertex{.edge = k}.weights()};
  }

  void cut(const PatchCut& cut) {
    const auto p = cut.patch;
    std::vector<Point> points;
    for (const auto& point : cut.points)
      points.push_back(point.is_corner() ? corner(p, point.edge) : on_edge(p, point));
    for (const auto& t : cut.triangles) append(p, {points[t[0]], points[t[1]], points[t[2]]});
  }

  Point on_edge(std::uint32_t p, const BorderVertex& h) {
    auto& light = mesh_.light;
    const auto a = corners_[p][h.edge], b = corners_[p][(h.edge + 1) % 3];
    const auto bands = old_.band_count();
    for (const bool back : {false, true}) {
      auto& values = light.irradiance.of(back);
      for (std::size_t band = 0; band < bands; ++band)
        values.push_back((1.0f - h.fraction) * values[a * bands + band] +
                         h.fraction * values[b * bands + band]);
    }
    light.vertex.push_back(h.vertex);
    const auto normal = (1.0f - h.fraction) * light.normal[a] + h.fraction * light.normal[b];
    const auto length = glm::length(normal);
    light.normal.push_back(length > 0.0f ? normal / length : light.normal[a]);
    return {h.vertex, static_cast<std::uint32_t>(light.vertex.size() - 1), h.weights()};
  }

  void append(std::uint32_t p, const std::array<Point, 3>& points) {
    auto& set = mesh_.patches;
    const auto each = [&](const auto& value) {
      return std::array{value(points[0]), value(points[1]), value(points[2])};
    };
    const auto between = [](const auto& values, const Vec3& w) {
      return w.x * values[0] + w.y * values[1] + w.z * values[2];
    };
    set.corners.push_back(each([](const Point& q) { return q.vertex; }));
    mesh_.light.corners.push_back(each([](const Point& q) { return q.smooth; }));
    const auto& c = set.corners.back();
    set.area.push_back(
        static_cast<float>(triangle_area(set.vertices[c[0]], set.vertices[c[1]], set.vertices[c[2]])));
    set.normal.push_back(old_.normal[p]);
    set.material.push_back(old_.material[p]);
    set.triangle.push_back(old_.triangle[p]);
    for (std::size_t s = 0; s < set.uv_sets.size(); ++s)
      set.uv_sets[s].push_back(each([&](const Point& q) { return between(old_.uv_sets[s][p], q.weights); }));
    if (!old_.corner_colours.empty())
      set.corner_colours.push_back(
          each([&](const Point& q) { return between(old_.corner_colours[p], q.weights); }));
    copy_row(old_.reflectance_ratio, p, set.reflectance_ratio);
    copy_row(old_.emittance_ratio, p, set.emittance_ratio);
    for (const bool back : {false, true}) {
      copy_row(light_.irradiance.of(back), p, mesh_.solution.irradiance.of(back));
      copy_row(light_.radiosity.of(back), p, mesh_.solution.radiosity.of(back));
    }
  }

  void copy_row(const std::vector<float>& from, std::uint32_t p, std::vector<float>& to) const {
    if (from.empty()) return;
    const auto bands = static_cast<std::ptrdiff_t>(old_.band_count());
    const auto row = from.begin() + static_cast<std::ptrdiff_t>(p) * bands;
    to.insert(to.end(), row, row + bands);
  }

  SimplifiedMesh& mesh_;
  const PatchSet old_;
  const std::vector<std::array<std::uint32_t, 3>> corners_;  // smooth vertices, as they were
  Solution light_;                                           // as it was
};

}  // namespace

void close_t_junctions(SimplifiedMesh& mesh) { TJunctions(mesh).close(); }

}  // namespace luxel
