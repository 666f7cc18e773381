// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "luxel/core/none.h"
#include "luxel/core/vector.h"

namespace luxel {

// Number of occurrences and the place of the first one, for a warning.
struct Tally {
  std::size_t count = 0;
  std::size_t first_line = 0;

  void add(std::size_t line) {
    if (count++ == 0) first_line = line;
  }
};

// Words of a file and the line they stand on.
struct NamedLine {
  std::string name;
  std::size_t line = 0;
};

// The content of an OBJ, PLY or STL file, including polygons, before it becomes a Scene. Every face has three
// corners or more.
struct PolygonMesh {
  struct Corner {
    std::uint32_t position = 0;
    std::uint32_t normal = none;
    std::uint32_t uv = none;
  };
  struct Face {
    std::size_t first_corner = 0;  // its corners end where those of the next face begin
    std::uint32_t line = 0;        // 0 where unknown: in binary files
    std::uint32_t material = 0;
    std::uint32_t group = 0;
    std::uint32_t object = 0;
  };

  std::vector<Vec3d> positions;  // as the file has them
  std::vector<Vec3> normals;     // any length; zero where the file's cannot be read
  std::vector<Vec2> uvs;         // finite; zero where the file's cannot be read
  std::vector<Corner> corners;
  std::vector<Face> faces;
  std::vector<Vec3> vertex_colours;  // by position, linear, [0, 1]; empty where there are none
  std::vector<Vec3> face_colours;    // by face, linear, [0, 1]; these take precedence
  std::vector<std::string> groups;   // those that hold faces
  std::vector<std::string> objects;  // that hold faces; empty where the file has no o
  std::vector<NamedLine>
      materials;  // those that faces use, with the first usemtl; line 0 where there is none
  std::vector<NamedLine> libraries;  // the operands of each mtllib

  Tally short_faces;         // of fewer than three corners, dropped
  Tally unreadable_normals;  // vn
  Tally unreadable_uvs;      // vt
  Tally faces_without_material;
};

}  // namespace luxel
