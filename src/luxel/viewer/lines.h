// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "luxel/core/bounds.h"
#include "luxel/core/matrix.h"
#include "luxel/core/vector.h"

namespace luxel {

// Things to draw over surfaces: segments, or points. Colours are linear RGB in [0, 1].
struct Marks {
  struct Mark {
    Vec3 place, colour;
  };
  std::vector<Mark> segments;  // two each
  std::vector<Mark> points;

  void add_segment(const Vec3& from, const Vec3& to, const Vec3& colour) {
    segments.push_back({from, colour});
    segments.push_back({to, colour});
  }
  void add_point(const Vec3& place, const Vec3& colour) { points.push_back({place, colour}); }
  void add_box(const Bounds& box, const Vec3& colour);  // its twelve edges
  bool empty() const { return segments.empty() && points.empty(); }
};

// Marks on the graphics card. Needs the context it was made in.
class MarkBuffer {
 public:
  MarkBuffer();
  ~MarkBuffer();
  MarkBuffer(const MarkBuffer&) = delete;
  MarkBuffer& operator=(const MarkBuffer&) = delete;

  void set(const Marks& marks);
  // through: also shows marks behind surfaces, fainter. point_size: pixels.
  void draw(const Mat4& projection, float point_size, bool through) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace luxel
