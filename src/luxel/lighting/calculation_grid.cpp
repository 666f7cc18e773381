// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/calculation_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "luxel/core/bounds.h"
#include "luxel/core/convex_hull.h"
#include "luxel/core/error.h"
#include "luxel/lighting/grid_rule.h"
#include "luxel/patch/focus.h"

namespace luxel {
namespace {

constexpr std::size_t max_points = 1'000'000;
constexpr double level = 0.999;  // cosine to the up axis from which a plane is horizontal

double cross(const Vec2d& a, const Vec2d& b) { return a.x * b.y - a.y * b.x; }

// Axes of a plane: seen from the side that it faces, `along` to the right and `across` upwards; of a
// horizontal plane, `along` is the x axis.
struct PlaneFrame {
  Vec3d origin{0.0}, along{1.0, 0.0, 0.0}, across{0.0, 1.0, 0.0};

  PlaneFrame(const Vec3d& at, const Vec3d& normal, const Vec3d& up) : origin(at) {
    const bool is_level = std::abs(glm::dot(normal, up)) > level;
    along = is_level ? Vec3d(1.0, 0.0, 0.0) : glm::cross(up, normal);
    along = glm::normalize(along - glm::dot(along, normal) * normal);
    across = glm::cross(normal, along);
  }
  Vec2d flat(const Vec3d& p) const { return {glm::dot(p - origin, along), glm::dot(p - origin, across)}; }
};

// The flat shape of an area: a polygon, or the triangles of a surface.
struct Shape {
  std::vector<std::vector<Vec2d>> polygons;
  std::vector<std::vector<Vec2d>> holes;

  bool has(const Vec2d& p) const {
    const auto is_inside = [&](const std::vector<Vec2d>& polygon) { return contains(polygon, p); };
    return std::any_of(polygons.begin(), polygons.end(), is_inside) &&
           std::none_of(holes.begin(), holes.end(), is_inside);
  }
  // Returns whether all that is nearer than the border lies inside, too.
  bool has(const Vec2d& p, double border) const {
    if (!has(p)) return false;
    constexpr int directions = 16;
    for (int i = 0; border > 0.0 && i < directions; ++i) {
      const auto angle = 2.0 * std::numbers::pi * i / directions;
      if (!has(p + border * Vec2d(std::cos(angle), std::sin(angle)))) return false;
    }
    return true;
  }
  // By the number of edges to the right (even-odd rule).
  static bool contains(const std::vector<Vec2d>& polygon, const Vec2d& p) {
    bool inside = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
      const auto &a = polygon[i], &b = polygon[j];
      if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
    }
    return inside;
  }
};

// Convex hull, anticlockwise.
std::vector<Vec2d> hull_of(std::vector<Vec2d> points) {
  std::sort(points.begin(), points.end(),
            [](const Vec2d& a, const Vec2d& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  return hull_of_sorted(
      points, [](const Vec2d& a, const Vec2d& b, const Vec2d& c) { return !(cross(b - a, c - b) <= 0.0); });
}

// The rectangle of smallest area around points, among those along the axes and along edges of the hull.
struct Rectangle {
  Vec2d along{1.0, 0.0}, low{0.0}, size{0.0};  // low, size: along and across
};
Rectangle rectangle_of(const std::vector<Vec2d>& points) {
  const auto hull = hull_of(points);
  Rectangle best;
  double best_area = std::numeric_limits<double>::infinity();
  const auto look_at = [&](const Vec2d& along) {
    const Vec2d across(-along.y, along.x);
    Vec2d low(std::numeric_limits<double>::infinity()), high(-low);
    for (const auto& p : hull) {
      const Vec2d q(glm::dot(p, along), glm::dot(p, across));
      low = glm::min(low, q);
      high = glm::max(high, q);
    }
    const auto area = (high - low).x * (high - low).y;
    if (!(area < best_area * (1.0 - 1e-4))) return;
    best_area = area;
    best = {along, low, high - low};
  };
  look_at({1.0, 0.0});
  for (std::size_t i = 0; i < hull.size(); ++i) {
    auto edge = hull[(i + 1) % hull.size()] - hull[i];
    if (!(glm::length(edge) > 0.0)) continue;
    edge = glm::normalize(edge);
    // The turn by less than 45 degrees, so that columns stay columns.
    if (std::abs(edge.y) > std::abs(edge.x)) edge = {edge.y, -edge.x};
    look_at(edge.x < 0.0 ? -edge : edge);
  }
  return best;
}

class GridMaker {
 public:
  GridMaker(const CalculationArea& area, const AreaScene& scene) : area_(area), scene_(scene) {
    for (const auto& v : scene.patches.vertices) extents_.add(v);
    grid_.facing = area.facing;
  }

  CalculationGrid make() {
    if (!area_.line.empty()) return make_line();
    const auto plane_normal = area_.surface.empty() ? take_polygon() : take_surface();
    grid_.normal = area_.normal.value_or(plane_normal);
    place_rectangle();
    add_points();
    return std::move(grid_);
  }

 private:
  [[noreturn]] void refuse(const std::string& sentence) const {
    throw InputError(fmt::format("area \"{}\": {}", area_.name, sentence));
  }

  CalculationGrid make_line() {
    const auto whole = area_.line[1] - area_.line[0];
    grid_.along = glm::normalize(whole);
    const auto start = area_.line[0] + area_.border * grid_.along;
    grid_.width = glm::length(whole) - 2.0 * area_.border;
    if (!(grid_.width > 0.0)) refuse(fmt::format("the border of {} m leaves nothing of it", area_.border));
    grid_.normal = area_.normal.value_or(scene_.up);
    const auto across = glm::cross(grid_.normal, grid_.along);
    grid_.across = glm::length(across) > 0.0 ? glm::normalize(across) : Vec3d(0.0);
    grid_.corner = start;
    choose_cells();
    grid_.outline = {{{0.0, 0.0}, {grid_.width, 0.0}}};
    add_all([](const Vec2d&) { return true; });
    return std::move(grid_);
  }

  void choose_cells() {
    grid_.is_by_rule = !area_.spacing;
    const auto height = grid_.height > 0.0 ? grid_.height : grid_.width;
    const auto rule = en12464_grid(grid_.width, height);
    grid_.spacing = area_.spacing.value_or(rule.spacing);
    const auto cells = [&](double side) { return std::max(1.0, std::round(side / grid_.spacing)); };
    const auto columns = cells(grid_.width), rows = grid_.height > 0.0 ? cells(grid_.height) : 1.0;
    if (!(columns * rows <= static_cast<double>(max_points)))
      refuse(fmt::format("a spacing of {} m makes more than {} points; expected a larger one", grid_.spacing,
                         max_points));
    grid_.columns = static_cast<std::size_t>(columns);
    grid_.rows = static_cast<std::size_t>(rows);
  }

  // Return the normal of the plane.
  Vec3d take_polygon() {
    const auto& polygon = area_.polygon;
    Vec3d normal(0.0);
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
      normal += glm::cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    normal = glm::normalize(normal);
    if (glm::dot(normal, scene_.up) < -1e-6) normal = -normal;
    set_frame(polygon[0], normal);
    shape_.polygons = {flat(polygon)};
    loops_ = {polygon};
    for (const auto& hole : area_.without) {
      shape_.holes.push_back(flat(hole));
      loops_.push_back(hole);
    }
    return normal;
  }

  Vec3d take_surface() {
    const auto& patches = scene_.patches;
    std::vector<std::uint32_t> found;
    for (std::size_t p = 0; p < patches.size(); ++p)
      if (is_called(scene_.scene, patches, p, area_.surface)) found.push_back(static_cast<std::uint32_t>(p));
    if (found.empty())
      refuse(fmt::format("no {} is called '{}'{}", scene_.scene ? "material, object or group" : "material",
                         area_.surface, scene_.scene ? "" : "; objects and groups need the scene's file"));
    const Vec3d front(patches.normal[found[0]]);
    const auto at = patches.in_file(patches.points(found[0])[0]);
    double light[2] = {0.0, 0.0}, extent = 0.0, bend = 0.0;
    for (const auto p : found) {
      const auto is_turned = glm::dot(Vec3d(patches.normal[p]), front) < 0.0;
      for (const auto& corner : patches.points(p)) {
        const auto d = patches.in_file(corner) - at;
        extent = std::max(extent, glm::length(d));
        bend = std::max(bend, std::abs(glm::dot(d, front)));
      }
      for (const bool back : {false, true})
        for (std::size_t b = 0; b < patches.band_count(); ++b)
          light[back != is_turned ? 1 : 0] +=
              static_cast<double>(patches.area[p]) *
              static_cast<double>(scene_.solution.irradiance.of(back)[p * patches.band_count() + b]);
    }
    if (bend > 1e-3 * extent)
      refuse(
          fmt::format("the surface '{}' is not flat: it bends by {:.3g} m; expected a flat one, or a "
                      "polygon",
                      area_.surface, bend));
    auto normal = light[1] > light[0] ? -front : front;
    if (area_.normal && glm::dot(*area_.normal, normal) < 0.0) normal = -normal;
    set_frame(at + area_.offset * normal, normal);
    for (const auto p : found) {
      const auto c = patches.points(p);
      loops_.push_back({patches.in_file(c[0]), patches.in_file(c[1]), patches.in_file(c[2])});
      shape_.polygons.push_back(flat(loops_.back()));
    }
    return normal;
  }

  void set_frame(const Vec3d& at, const Vec3d& normal) { frame_ = PlaneFrame(at, normal, scene_.up); }
  std::vector<Vec2d> flat(const std::vector<Vec3d>& loop) const {
    std::vector<Vec2d> result;
    for (const auto& p : loop) result.push_back(frame_.flat(p));
    return result;
  }

  void place_rectangle() {
    std::vector<Vec2d> corners;
    for (const auto& polygon : shape_.polygons) corners.insert(corners.end(), polygon.begin(), polygon.end());
    const auto box = rectangle_of(corners);
    const Vec2d across(-box.along.y, box.along.x);
    const auto low = box.low + Vec2d(area_.border), size = box.size - Vec2d(2.0 * area_.border);
    if (!(size.x > 0.0 && size.y > 0.0))
      refuse(fmt::format("the border of {} m leaves nothing of {:.4g} x {:.4g} m", area_.border, box.size.x,
                         box.size.y));
    flat_corner_ = low.x * box.along + low.y * across;
    flat_along_ = box.along;
    flat_across_ = across;
    const auto in_space = [&](const Vec2d& d) { return d.x * frame_.along + d.y * frame_.across; };
    grid_.corner = frame_.origin + in_space(flat_corner_);
    grid_.along = in_space(box.along);
    grid_.across = in_space(across);
    grid_.width = size.x;
    grid_.height = size.y;
    if (!area_.around.empty()) shrink_to_room();
    choose_cells();
    for (auto& loop : loops_) {
      std::vector<Vec2d> outline;
      for (const auto& p : loop)
        outline.push_back(
            {glm::dot(p - grid_.corner, grid_.along), glm::dot(p - grid_.corner, grid_.across)});
      grid_.outline.push_back(std::move(outline));
    }
    if (!area_.surface.empty()) grid_.outline = {{{0.0, 0.0}, {size.x, 0.0}, size, {0.0, size.y}}};
  }

  bool is_in_shape(const Vec2d& m) const {
    return shape_.has(flat_corner_ + m.x * flat_along_ + m.y * flat_across_, area_.border);
  }
  void add_points() {
    add_all([&](const Vec2d& m) { return is_in_shape(m); });
  }

  // Makes the rectangle of a band that of its part in the room, so that the grid is that of this part: found
  // on a lattice, hence to a two-hundredth of the band's extent.
  void shrink_to_room() {
    auto lattice = grid_;
    lattice.columns = lattice.rows = 200;
    Vec2d low(lattice.width, lattice.height), high(0.0);
    const auto half = 0.5 * Vec2d(lattice.width, lattice.height) / 200.0;
    for (std::uint32_t c = 0; c < lattice.columns * lattice.rows; ++c) {
      const auto m = lattice.middle(c);
      if (!is_in_shape(m) || !is_near_task(lattice.corner + m.x * grid_.along + m.y * grid_.across)) continue;
      low = glm::min(low, m - half);
      high = glm::max(high, m + half);
    }
    if (!(low.x < high.x)) refuse("nothing of it lies in the room of its task area");
    flat_corner_ += low.x * flat_along_ + low.y * flat_across_;
    grid_.corner += low.x * grid_.along + low.y * grid_.across;
    grid_.width = high.x - low.x;
    grid_.height = high.y - low.y;
  }

  template <typename IsInside>
  void add_all(const IsInside& is_inside) {
    for (std::uint32_t c = 0; c < grid_.columns * grid_.rows; ++c) {
      const auto m = grid_.middle(c);
      const auto at = grid_.corner + m.x * grid_.along + m.y * grid_.across;
      if (!is_inside(m) || (!area_.around.empty() && !is_near_task(at))) continue;
      if (grid_.facing == at) refuse("one of its points is the place that they face");
      grid_.cell.push_back(c);
      grid_.position.push_back(at);
    }
    if (grid_.position.empty()) refuse("no point of the grid lies in it; expected a smaller spacing");
  }

  // Returns whether a point of a band lies in the scene's extents and sees the next point of the task area.
  bool is_near_task(const Vec3d& at) const {
    constexpr double lift = 0.01;  // m, off surfaces in the plane
    const auto& hole = area_.without.front();
    auto next = hole.front();
    for (std::size_t i = 0; i < hole.size(); ++i) {
      const auto edge = hole[(i + 1) % hole.size()] - hole[i];
      const auto t = std::clamp(glm::dot(at - hole[i], edge) / glm::dot(edge, edge), 0.0, 1.0);
      if (glm::length(hole[i] + t * edge - at) < glm::length(next - at)) next = hole[i] + t * edge;
    }
    const auto& box = extents_;
    const auto from = at + lift * grid_.normal - scene_.patches.origin;
    for (int k = 0; k < 3; ++k)
      if (from[k] < double{box.low[k]} - lift || from[k] > double{box.high[k]} + lift) return false;
    const auto way = next - at;
    const auto distance = glm::length(way);
    return !(distance > 0.0) ||
           !scene_.tracer.occluded({Vec3(from), Vec3(way / distance)}, static_cast<float>(distance));
  }

  const CalculationArea& area_;
  const AreaScene& scene_;
  Bounds extents_;  // of the scene
  CalculationGrid grid_;
  PlaneFrame frame_{Vec3d(0.0), Vec3d(0.0, 0.0, 1.0), Vec3d(0.0, 0.0, 1.0)};
  Shape shape_;
  std::vector<std::vector<Vec3d>> loops_;
  Vec2d flat_corner_{0.0}, flat_along_{1.0, 0.0}, flat_across_{0.0, 1.0};
};

}  // namespace

std::vector<std::uint32_t> CalculationGrid::point_of_cells() const {
  std::vector<std::uint32_t> point(columns * rows, none);
  for (std::size_t i = 0; i < cell.size(); ++i) point[cell[i]] = static_cast<std::uint32_t>(i);
  return point;
}

CalculationGrid make_grid(const CalculationArea& area, const AreaScene& scene) {
  return GridMaker(area, scene).make();
}

}  // namespace luxel
