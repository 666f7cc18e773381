// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/room_model.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "luxel/runs/option_set.h"

namespace luxel {
namespace {

constexpr std::array<const char*, 4> wall_names = {"south", "east", "north", "west"};

bool is_along_x(RoomWall wall) { return wall == RoomWall::south || wall == RoomWall::north; }

// To a whole number of micrometres, so that lengths that are equal as decimal numbers are equal.
double snapped(double metres) { return std::round(metres * 1e6) / 1e6; }
double end_along(const RoomWindow& w) { return snapped(w.along + w.width); }
double top_of(const RoomWindow& w) { return snapped(w.sill + w.height); }

double length_of(const RoomModel& room, RoomWall wall) {
  return is_along_x(wall) ? room.size.x : room.size.y;
}

// A polygon that faces into the room.
struct Face {
  std::string group, material;
  std::vector<Vec3d> corners;
};

// A rectangle of a wall, by ranges along it and of height.
Face wall_face(const RoomModel& room, RoomWall wall, const std::array<double, 2>& along,
               const std::array<double, 2>& height) {
  const auto at = [&](std::size_t i, std::size_t j) {
    const auto s = along[i], z = height[j];
    switch (wall) {
      case RoomWall::south:
        return Vec3d(s, 0.0, z);
      case RoomWall::north:
        return Vec3d(s, room.size.y, z);
      case RoomWall::west:
        return Vec3d(0.0, s, z);
      case RoomWall::east:
        break;
    }
    return Vec3d(room.size.x, s, z);
  };
  Face face{.group = fmt::format("{}_wall", wall_names[static_cast<std::size_t>(wall)]),
            .material = room.names[1],
            .corners = {at(0, 0), at(1, 0), at(1, 1), at(0, 1)}};
  if (wall == RoomWall::south || wall == RoomWall::east)
    std::reverse(face.corners.begin(), face.corners.end());
  return face;
}

// 0, the borders of windows, and the end, ascending.
std::vector<double> cuts(double end, std::vector<double> borders) {
  borders.push_back(0.0);
  borders.push_back(end);
  std::sort(borders.begin(), borders.end());
  borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
  return borders;
}

// The wall around its windows, in cells between the extended borders of these.
void add_wall(const RoomModel& room, RoomWall wall, std::vector<Face>& faces) {
  std::vector<double> along, height;
  std::vector<const RoomWindow*> windows;
  for (const auto& w : room.windows) {
    if (w.wall != wall) continue;
    windows.push_back(&w);
    along.insert(along.end(), {w.along, end_along(w)});
    height.insert(height.end(), {w.sill, top_of(w)});
  }
  along = cuts(length_of(room, wall), std::move(along));
  height = cuts(room.size.z, std::move(height));
  for (std::size_t i = 0; i + 1 < along.size(); ++i)
    for (std::size_t j = 0; j + 1 < height.size(); ++j) {
      const bool is_open = std::any_of(windows.begin(), windows.end(), [&](const RoomWindow* w) {
        return along[i] >= w->along && along[i + 1] <= end_along(*w) && height[j] >= w->sill &&
               height[j + 1] <= top_of(*w);
      });
      if (!is_open)
        faces.push_back(wall_face(room, wall, {along[i], along[i + 1]}, {height[j], height[j + 1]}));
    }
}

std::vector<Face> faces_of(const RoomModel& room) {
  const auto& s = room.size;
  std::vector<Face> faces = {
      {"floor", room.names[2], {{0, 0, 0}, {s.x, 0, 0}, {s.x, s.y, 0}, {0, s.y, 0}}},
      {"ceiling", room.names[0], {{0, 0, s.z}, {0, s.y, s.z}, {s.x, s.y, s.z}, {s.x, 0, s.z}}}};
  for (const auto wall : {RoomWall::south, RoomWall::east, RoomWall::north, RoomWall::west})
    add_wall(room, wall, faces);
  for (std::size_t i = 0; i < room.windows.size(); ++i) {
    const auto& w = room.windows[i];
    auto pane = wall_face(room, w.wall, {w.along, end_along(w)}, {w.sill, top_of(w)});
    pane.group = fmt::format("window_{}", i + 1);
    pane.material = "glass";
    faces.push_back(std::move(pane));
  }
  return faces;
}

std::size_t index_of(std::vector<Vec3d>& vertices, const Vec3d& at) {
  const auto found = std::find(vertices.begin(), vertices.end(), at);
  if (found != vertices.end()) return static_cast<std::size_t>(found - vertices.begin());
  vertices.push_back(at);
  return vertices.size() - 1;
}

// Corners of a face with the vertices that lie on its edges, which are parallel to the axes.
std::vector<Vec3d> with_vertices_between(const std::vector<Vec3d>& corners,
                                         const std::vector<Vec3d>& vertices) {
  std::vector<Vec3d> outline;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto &a = corners[i], &b = corners[(i + 1) % corners.size()];
    outline.push_back(a);
    const auto way = b - a;
    std::vector<std::pair<double, Vec3d>> between;
    for (const auto& v : vertices) {
      const auto t = glm::dot(v - a, way) / glm::dot(way, way);
      const int axis = way.x != 0.0 ? 0 : way.y != 0.0 ? 1 : 2;
      const bool is_on_line =
          v[(axis + 1) % 3] == a[(axis + 1) % 3] && v[(axis + 2) % 3] == a[(axis + 2) % 3];
      if (is_on_line && t > 0.0 && t < 1.0 && v != b && v != a) between.emplace_back(t, v);
    }
    std::sort(between.begin(), between.end(), [](const auto& p, const auto& q) { return p.first < q.first; });
    for (const auto& [t, v] : between) outline.push_back(v);
  }
  return outline;
}

std::vector<std::string> fields_of(const std::string& text, char separator) {
  std::vector<std::string> fields;
  for (std::size_t at = 0;;) {
    const auto end = text.find(separator, at);
    fields.push_back(text.substr(at, end - at));
    if (end == std::string::npos) return fields;
    at = end + 1;
  }
}

}  // namespace

std::optional<Vec3d> parse_room_size(const std::string& text) {
  const auto fields = fields_of(text, 'x');
  if (fields.size() != 3) return {};
  Vec3d size;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = parse_double(fields[i]);
    if (!value || !(*value >= 0.1 && *value <= 1000.0)) return {};
    size[static_cast<int>(i)] = snapped(*value);
  }
  return size;
}

std::string text_of_size(const Vec3d& size) { return fmt::format("{}x{}x{}", size.x, size.y, size.z); }

std::optional<RoomWindow> parse_room_window(const std::string& text) {
  const auto colon = text.find(':');
  const auto wall = std::find(wall_names.begin(), wall_names.end(), text.substr(0, colon));
  if (colon == std::string::npos || wall == wall_names.end()) return {};
  const auto fields = fields_of(text.substr(colon + 1), ',');
  if (fields.size() != 4) return {};
  std::array<double, 4> numbers{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto value = parse_double(fields[i]);
    if (!value || !(*value >= (i < 2 ? 0.0 : 0.01) && *value <= 1000.0)) return {};
    numbers[i] = snapped(*value);
  }
  return RoomWindow{static_cast<RoomWall>(wall - wall_names.begin()), numbers[0], numbers[1], numbers[2],
                    numbers[3]};
}

std::string text_of(const RoomWindow& w) {
  return fmt::format("{}:{},{},{},{}", wall_names[static_cast<std::size_t>(w.wall)], w.along, w.sill, w.width,
                     w.height);
}

void check(const RoomModel& room) {
  for (std::size_t i = 0; i < room.windows.size(); ++i) {
    const auto& w = room.windows[i];
    const auto length = length_of(room, w.wall);
    if (end_along(w) > length || top_of(w) > room.size.z)
      throw UsageError(fmt::format(
          "--window {}: it ends {:g} m along and {:g} m above the floor, outside its wall of {:g} x {:g} m",
          text_of(w), end_along(w), top_of(w), length, room.size.z));
    for (std::size_t j = 0; j < i; ++j) {
      const auto& v = room.windows[j];
      if (v.wall == w.wall && w.along < end_along(v) && v.along < end_along(w) && w.sill < top_of(v) &&
          v.sill < top_of(w))
        throw UsageError(fmt::format("--window {}: it overlaps the window {}", text_of(w), text_of(v)));
    }
  }
}

std::string obj_of(const RoomModel& room, const std::string& material_library) {
  const auto faces = faces_of(room);
  std::vector<Vec3d> vertices;
  for (const auto& face : faces)
    for (const auto& corner : face.corners) index_of(vertices, corner);
  auto text = fmt::format(
      "# A room of {:g} x {:g} x {:g} m: x along its length, y along its width, z up. Surfaces face "
      "inwards.\n"
      "mtllib {}\n\n",
      room.size.x, room.size.y, room.size.z, material_library);
  for (const auto& v : vertices) text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", v.x, v.y, v.z);
  std::string group;
  for (const auto& face : faces) {
    if (face.group != group) text += fmt::format("\ng {}\nusemtl {}\n", face.group, face.material);
    group = face.group;
    text += "f";
    for (const auto& corner : with_vertices_between(face.corners, vertices))
      text += fmt::format(" {}", index_of(vertices, corner) + 1);
    text += "\n";
  }
  return text;
}

std::string mtl_of(const RoomModel& room) {
  std::string text = "# Kd: diffuse reflectance, the same in red, green and blue.\n";
  for (std::size_t i = 0; i < 3; ++i)
    text += fmt::format("\nnewmtl {0}\nKd {1:g} {1:g} {1:g}\n", room.names[i], room.reflectance[i] / 100.0);
  if (!room.windows.empty())
    text += "\n# A pane of glass, through which light passes.\nnewmtl glass\nKd 0 0 0\nNi 1.5\nillum 4\n";
  return text;
}

}  // namespace luxel
