// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/choose_portals.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "luxel/core/address.h"
#include "luxel/core/discrete_distribution.h"
#include "luxel/core/triangle.h"
#include "luxel/core/warp.h"
#include "luxel/lamps/sky_box.h"
#include "luxel/patch/side.h"

namespace luxel {
namespace {

constexpr std::uint32_t first_lines = 16, all_lines = 64;
constexpr std::size_t compared_lines = 16;  // other polygons' lines that are compared with this polygon
constexpr double fraction_classes = 4.0;
constexpr std::uint32_t looks = 2;  // cosine rays from each lit point
constexpr float min_lift = 4.0f;    // of ray origins, in multiples of the rounding bound

// A line along which the sky lights a surface.
struct LitLine {
  Vec3d from{0.0}, direction{0.0};  // the lit point; unit, towards the sky
};

struct Trial {
  Vec3d normal{0.0};
  double area = 0.0;  // m²
  Vec3d centre{0.0};
  double radius = 0.0;                 // m
  std::array<std::uint32_t, 2> lit{};  // lines that light something, in front of the polygon and behind it
  std::array<std::uint32_t, 2> looked{},
      escaped{};  // cosine rays traced from the lit points, and those that escape
  std::vector<LitLine> lines;
  std::array<bool, 2> pays{};

  // Fraction of the lines that light a surface from which a cosine ray seldom finds the sky.
  double fraction() const {
    return ((pays[0] ? lit[0] : 0) + (pays[1] ? lit[1] : 0)) / static_cast<double>(all_lines);
  }
  // Sort key: polygons that few sampled lines find come first, such as a window in front of a plane that cuts
  // through many rooms; ties are broken by brightness. A plain product would reverse that order.
  std::pair<int, double> rank() const {
    return {-static_cast<int>(fraction_classes * fraction()), -area * fraction()};
  }
};

class Trials {
 public:
  Trials(const PatchSet& patches, const Tracer& tracer, const PortalOptions& options)
      : patches_(patches), tracer_(tracer), options_(options) {}

  Trial of(const OpenPolygon& polygon, std::uint32_t number) const {
    Trial trial;
    Vec3d area2(0.0);
    DiscreteDistribution triangles;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      const auto of_triangle = area_vector2(polygon[0], polygon[i - 1], polygon[i]);
      area2 += of_triangle;
      triangles.add(glm::length(of_triangle));
    }
    trial.area = 0.5 * glm::length(area2);
    if (!(trial.area > 0.0)) return trial;
    trial.normal = glm::normalize(area2);
    for (const auto& corner : polygon) trial.centre += Vec3d(corner) / static_cast<double>(polygon.size());
    for (const auto& corner : polygon)
      trial.radius = std::max(trial.radius, glm::length(Vec3d(corner) - trial.centre));
    const auto key = stream_key(0, RandomPurpose::portals, number);
    for (std::uint32_t i = 0; i < all_lines; ++i) {
      if (i == first_lines && trial.lit[0] + trial.lit[1] == 0) break;
      const auto u = uniform4(key, 2 * i);
      const auto chosen = triangles.choose(static_cast<double>(u[0]));
      const std::array<Vec3, 3> corner = {polygon[0], polygon[chosen + 1], polygon[chosen + 2]};
      const auto weights = uniform_triangle(uniform4(key, 2 * i + 1)[0], u[1]);
      const auto point =
          corner[0] + weights.x * (corner[1] - corner[0]) + weights.y * (corner[2] - corner[0]);
      add_line(trial, point, min_lift * origin_lift(corner), u[2], u[3], mix64(key + i));
    }
    for (std::size_t side = 0; side < 2; ++side)
      trial.pays[side] = trial.lit[side] >= options_.min_fraction * all_lines &&
                         trial.escaped[side] <= options_.max_open * trial.looked[side];
    return trial;
  }

 private:
  void add_line(Trial& trial, const Vec3& point, float lift, float u, float v, std::uint64_t key) const {
    const Vec3 normal(trial.normal);
    const Ray through{point + lift * normal, -normal};
    if (tracer_.occluded(through, 2.0f * lift)) return;  // a surface lies in the polygon
    const auto way = Frame(normal).to_world(cosine_hemisphere(u, v));
    const Ray before{point + lift * normal, way}, behind{point - lift * normal, -way};
    const auto front = tracer_.nearest(before), back = tracer_.nearest(behind);
    if (static_cast<bool>(front) == static_cast<bool>(back)) return;
    const std::size_t side = front ? 0 : 1;
    const auto& hit = front ? front : back;
    const auto& ray = front ? before : behind;
    if (!takes_part(patches_, hit)) return;
    ++trial.lit[side];
    const auto place = ray.origin + hit.distance * ray.direction;
    trial.lines.push_back({Vec3d(place), -Vec3d(ray.direction)});
    const auto out = patches_.normal_of({hit.patch, hit.back});
    const auto from = place + min_lift * origin_lift(patches_.points(hit.patch)) * out;
    for (std::uint32_t i = 0; i < looks; ++i) {
      const auto w = uniform4(key, i);
      ++trial.looked[side];
      if (!tracer_.nearest({from, Frame(out).to_world(cosine_hemisphere(w[0], w[1]))})) ++trial.escaped[side];
    }
  }

  const PatchSet& patches_;
  const Tracer& tracer_;
  PortalOptions options_;
};

// Returns whether a line goes through a convex polygon.
bool crosses(const OpenPolygon& polygon, const Trial& trial, const LitLine& line) {
  const auto aside = glm::cross(trial.centre - line.from, line.direction);
  if (glm::dot(aside, aside) > trial.radius * trial.radius) return false;
  const auto slope = glm::dot(trial.normal, line.direction);
  const auto along = glm::dot(trial.normal, Vec3d(polygon[0]) - line.from);
  if (!(along * slope > 0.0)) return false;
  const auto point = line.from + along / slope * line.direction;
  const auto slack = 1e-3 * trial.area;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3d a(polygon[i]), b(polygon[(i + 1) % polygon.size()]);
    if (glm::dot(trial.normal, glm::cross(b - a, point - a)) < -slack) return false;
  }
  return true;
}

}  // namespace

std::vector<Portal> choose_portals(const PatchSet& patches, const Tracer& tracer,
                                   std::span<const OpenPolygon> polygons, const PortalOptions& options,
                                   const Context& context) {
  std::vector<Trial> trials(polygons.size());
  const Trials rays(patches, tracer, options);
  context.for_chunks(polygons.size(), 1, [&](std::size_t begin, std::size_t end, int) {
    for (auto i = begin; i < end; ++i) trials[i] = rays.of(polygons[i], static_cast<std::uint32_t>(i));
  });
  std::vector<std::size_t> order(polygons.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return trials[a].rank() < trials[b].rank(); });
  std::vector<std::size_t> kept;
  for (const auto i : order) {
    if (!(trials[i].fraction() > 0.0)) continue;
    const auto lines = std::span(trials[i].lines).first(std::min(compared_lines, trials[i].lines.size()));
    const auto known = std::count_if(lines.begin(), lines.end(), [&](const LitLine& line) {
      return std::any_of(kept.begin(), kept.end(),
                         [&](std::size_t k) { return crosses(polygons[k], trials[k], line); });
    });
    if (static_cast<double>(known) > options.same_lines * static_cast<double>(lines.size())) continue;
    if (kept.size() == options.max_polygons) return {};
    kept.push_back(i);
  }
  std::vector<Portal> portals;
  for (const auto i : kept)
    for (std::size_t k = 2; k < polygons[i].size(); ++k) {
      const auto &a = polygons[i][0], &b = polygons[i][k - 1], &c = polygons[i][k];
      const auto& pays = trials[i].pays;
      portals.push_back({pays[0] ? std::array{a, b, c} : std::array{a, c, b}, pays[0] && pays[1]});
    }
  return portals;
}

void set_portals(const Scene& scene, const Tracer& tracer, PatchSet& patches, const Context& context) {
  patches.portals.clear();
  if (patches.has_sky())
    patches.portals = choose_portals(patches, tracer, find_open_polygons(scene), {}, context);
}

void set_portals(const Scene& scene, PatchSet& patches, const Context& context) {
  if (patches.has_sky()) set_portals(scene, Tracer(patches, context), patches, context);
}

}  // namespace luxel
