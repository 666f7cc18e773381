// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "luxel/math/bounds.h"
#include "luxel/transport/lamps.h"

namespace luxel {

struct LampChoice {
  std::uint32_t lamp = 0;
  double probability = 0.0;  // 0: no lamp can light the point
  double rest = 0.0;         // of the number that chose, uniform in [0, 1) again
};

// Chooses one of many lamps in proportion to what it may give a point, at a cost that grows with the
// logarithm of their number: a binary tree whose nodes know box, power and spread of normals (Conty Estevez
// and Kulla 2018). A lamp that gives the point light is never left out. Read-only after it was made; 64 bytes
// a lamp and as much again for the inner nodes.
class LightTree {
 public:
  explicit LightTree(const Lamps& lamps);

  // u: uniform in [0, 1); rescaled at each step down, so that even numbers make even choices. 0.3 us among
  // 10,000.
  LampChoice choose(const Vec3& x, const Vec3& n, double u) const;

 private:
  struct Node {
    Vec3 centre{0.0f};
    float radius = 0.0f;
    Vec3 axis{0.0f};      // mean normal
    float spread = 0.0f;  // of the normals about the axis: cosine, and sine
    float spread_sine = 0.0f;
    float power = 0.0f;
    std::uint32_t next = 0;  // first of two children, or the lamp
    bool leaf = false;
  };
  void build(std::uint32_t node, const Lamps& lamps, std::uint32_t* begin, std::uint32_t* end);
  static float importance(const Node& node, const Vec3& x, const Vec3& n);

  std::vector<Node> nodes_;
};

}  // namespace luxel
