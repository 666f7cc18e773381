// SPDX-License-Identifier: Apache-2.0
#include "scenes/shapes/walls.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/shapes/sheets.h"
#include "scenes/shapes/solids.h"

namespace luxel::scenes {
namespace {

constexpr auto arch_pieces = 16;
constexpr auto crown = 0.12;  // m of wall above an arch that is cut in its columns
constexpr auto joint = 0.001;

// The arch as points along the face, from its left springing to the right one.
std::vector<glm::dvec2> arch_of(const Hole& hole) {
  auto points = std::vector<glm::dvec2>{};
  const auto middle = 0.5 * (hole.left + hole.right);
  const auto radius = 0.5 * (hole.right - hole.left);
  for (auto k = 0; k <= arch_pieces; ++k) {
    const auto angle = std::numbers::pi * k / arch_pieces;
    points.emplace_back(middle - radius * std::cos(angle), hole.high + hole.rise * std::sin(angle));
  }
  points.back() = {hole.right, hole.high};
  return points;
}

std::vector<double> without_repeats(std::vector<double> stops) {
  std::sort(stops.begin(), stops.end());
  auto result = std::vector<double>{};
  for (const auto stop : stops) {
    if (result.empty() || stop > result.back() + 1e-6) result.push_back(stop);
  }
  return result;
}

bool within(double low, double value, double high) { return low < value && value < high; }

// The holes seen from behind, on a face that is wider by `margin` on all sides.
std::vector<Hole> from_behind(const std::vector<Hole>& holes, double length, double margin,
                              double margin_below) {
  auto result = std::vector<Hole>{};
  for (auto hole : holes) {
    const auto left = length - hole.right;
    hole.right = length - hole.left + margin;
    hole.left = left + margin;
    hole.low += margin_below;
    hole.high += margin_below;
    result.push_back(hole);
  }
  return result;
}

Face opposite(const Face& face, double depth, double margin, double margin_below) {
  const auto normal = glm::cross(face.along, face.up);
  return {face.origin - depth * normal + (face.length + margin) * face.along - margin_below * face.up,
          -face.along, face.up, face.length + 2.0 * margin, face.height + margin + margin_below};
}

}  // namespace

Mesh holed_face(const Face& face, const std::vector<Hole>& holes, double cell) {
  auto columns = std::vector<double>{0.0, face.length};
  auto rows = std::vector<double>{0.0, face.height};
  for (const auto& hole : holes) {
    columns.insert(columns.end(), {hole.left, hole.right});
    rows.insert(rows.end(), {hole.low, hole.high});
    if (hole.rise <= 0.0) continue;
    for (const auto& p : arch_of(hole)) columns.push_back(p.x);
    rows.push_back(hole.high + hole.rise + crown);
  }
  const auto a = steps(without_repeats(columns), cell);
  auto b = steps(without_repeats(rows), cell);
  // The rows of arches are not cut: their lower edges are the curves.
  for (const auto& hole : holes) {
    if (hole.rise <= 0.0) continue;
    std::erase_if(
        b, [&](double y) { return within(hole.high + 1e-6, y, hole.high + hole.rise + crown - 1e-6); });
  }
  auto mesh = panel(face.origin, face.along, face.up, a, b, [&](double x, double y) {
    return std::any_of(holes.begin(), holes.end(), [&](const Hole& hole) {
      const auto top = hole.high + (hole.rise > 0.0 ? hole.rise + crown : 0.0);
      return within(hole.left, x, hole.right) && within(hole.low, y, top);
    });
  });
  for (const auto& hole : holes) {
    if (hole.rise <= 0.0) continue;
    const auto at = [&](double x, double y) {
      return mesh.add_point(face.origin + x * face.along + y * face.up);
    };
    const auto top = hole.high + hole.rise + crown;
    const auto arch = arch_of(hole);
    // Columns of cells may be finer than the arch: its chords are cut where they are.
    const auto height = [&](double x) {
      for (std::size_t k = 1; k < arch.size(); ++k) {
        if (x > arch[k].x + 1e-9) continue;
        const auto t = (x - arch[k - 1].x) / (arch[k].x - arch[k - 1].x);
        return glm::mix(arch[k - 1].y, arch[k].y, std::clamp(t, 0.0, 1.0));
      }
      return hole.high;
    };
    for (std::size_t i = 0; i + 1 < a.size(); ++i) {
      if (!within(hole.left, 0.5 * (a[i] + a[i + 1]), hole.right)) continue;
      mesh.add_quad(at(a[i], height(a[i])), at(a[i + 1], height(a[i + 1])), at(a[i + 1], top), at(a[i], top));
    }
  }
  return welded(mesh);
}

Mesh reveals(const Face& face, const std::vector<Hole>& holes, double depth, bool with_sill) {
  auto mesh = Mesh{};
  const auto back = -depth * glm::cross(face.along, face.up);
  const auto inwards = std::vector<double>{0.0, 1.0};
  for (const auto& hole : holes) {
    const auto place = [&](double x, double y) { return face.origin + x * face.along + y * face.up; };
    const auto width = hole.right - hole.left;
    const auto height = hole.high - hole.low;
    const auto up = steps({0.0, height}, 0.5);
    const auto across = steps({0.0, width}, 0.5);
    if (with_sill || hole.low > 1e-6) {
      append(mesh, panel(place(hole.left, hole.low), face.along, back, across, inwards));
    }
    if (height > 1e-6) {
      append(mesh, panel(place(hole.left, hole.low) + back, face.up, -back, up, inwards));
      append(mesh, panel(place(hole.right, hole.low), face.up, back, up, inwards));
    }
    if (hole.rise <= 0.0) {
      append(mesh, panel(place(hole.left, hole.high) + back, face.along, -back, across, inwards));
      continue;
    }
    auto intrados = Mesh{};
    const auto arch = arch_of(hole);
    for (const auto& p : arch) {
      intrados.add_point(place(p.x, p.y));
      intrados.add_point(place(p.x, p.y) + back);
    }
    for (auto k = 0u; k + 1 < arch.size(); ++k) {
      intrados.add_quad(2 * k + 1, 2 * k + 3, 2 * k + 2, 2 * k);
    }
    append(mesh, intrados);
  }
  return welded(mesh);
}

Mesh holed_wall(const Face& face, const std::vector<Hole>& holes, double thickness, double cell) {
  const auto behind = opposite(face, thickness, 0.0, 0.0);
  const auto back = -thickness * glm::cross(face.along, face.up);
  const auto up = steps({0.0, face.height}, cell);
  const auto inwards = std::vector<double>{0.0, 1.0};
  const auto right = face.origin + face.length * face.along;
  return joined({holed_face(face, holes, cell),
                 holed_face(behind, from_behind(holes, face.length, 0.0, 0.0), cell),
                 reveals(face, holes, thickness, false), panel(right + back, face.up, -back, up, inwards),
                 panel(face.origin, face.up, back, up, inwards)});
}

Face inner_face(const Room& room, Wall wall) {
  const auto size = room.high - room.low;
  constexpr auto x = Vec3d(1.0, 0.0, 0.0);
  constexpr auto y = Vec3d(0.0, 1.0, 0.0);
  constexpr auto z = Vec3d(0.0, 0.0, 1.0);
  const auto& low = room.low;
  const auto& high = room.high;
  switch (wall) {
    case back_wall:
      return {low, x, y, size.x, size.y};
    case right_wall:
      return {{high.x, low.y, low.z}, z, y, size.z, size.y};
    case front_wall:
      return {{high.x, low.y, high.z}, -x, y, size.x, size.y};
    case left_wall:
      return {{low.x, low.y, high.z}, -z, y, size.z, size.y};
    default:
      return {{low.x, high.y, low.z}, x, z, size.x, size.z};
  }
}

Mesh inner_wall(const Room& room, Wall wall, double cell) {
  return holed_face(inner_face(room, wall), room.holes[wall], cell);
}

Mesh room_floor(const Room& room, double cell_x, double cell_z) {
  return panel({room.low.x, room.low.y, room.high.z}, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0},
               steps({0.0, room.high.x - room.low.x}, cell_x),
               steps({0.0, room.high.z - room.low.z}, cell_z));
}

Mesh all_reveals(const Room& room) {
  auto mesh = Mesh{};
  for (auto wall = std::size_t{0}; wall < wall_count; ++wall) {
    append(mesh, reveals(inner_face(room, static_cast<Wall>(wall)), room.holes[wall], room.thickness));
  }
  return mesh;
}

Mesh outside(const Room& room) {
  const auto t = room.thickness;
  auto mesh = Mesh{};
  for (auto wall = std::size_t{0}; wall < wall_count; ++wall) {
    const auto face = inner_face(room, static_cast<Wall>(wall));
    append(mesh, holed_face(opposite(face, t, t, t), from_behind(room.holes[wall], face.length, t, t), 1.0));
  }
  const auto low = room.low - t;
  const auto size = room.high - room.low + 2.0 * t;
  append(mesh,
         panel(low, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, steps({0.0, size.x}, 1.0), steps({0.0, size.z}, 1.0)));
  return mesh;
}

Mesh skirting_boards(const Room& room, double height, double thickness) {
  auto mesh = Mesh{};
  const auto section = std::vector<glm::dvec2>{
      {0.0, 0.0}, {thickness, 0.0}, {thickness, height - 0.010}, {0.5 * thickness, height}, {0.0, height}};
  for (const auto wall : {back_wall, right_wall, front_wall, left_wall}) {
    const auto face = inner_face(room, wall);
    const auto normal = glm::cross(face.along, face.up);
    // Boards of two opposite walls end at those of the other two.
    const auto inset = wall == back_wall || wall == front_wall ? joint : thickness + 2.0 * joint;
    auto stops = std::vector<double>{inset};
    auto holes = room.holes[wall];
    std::sort(holes.begin(), holes.end(), [](const Hole& a, const Hole& b) { return a.left < b.left; });
    for (const auto& hole : holes) {
      if (hole.low < height) stops.insert(stops.end(), {hole.left - 0.08, hole.right + 0.08});
    }
    stops.push_back(face.length - inset);
    for (std::size_t k = 0; k + 1 < stops.size(); k += 2) {
      if (stops[k + 1] < stops[k] + 0.02) continue;
      const auto board = prism(section, stops[k + 1] - stops[k]);
      // The prism's x leads away from the wall, its z back along it.
      append(mesh, deformed(board, [&](const Vec3d& p) {
               return face.origin + (p.x + joint) * normal + (p.y + joint) * face.up +
                      (stops[k + 1] - p.z) * face.along;
             }));
    }
  }
  return mesh;
}

}  // namespace luxel::scenes
