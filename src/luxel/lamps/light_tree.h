// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "luxel/core/bounds.h"
#include "luxel/lamps/lamps.h"

namespace luxel {

// One node of the tree: a single lamp or many.
struct LampBranch {
  std::uint32_t index = 0;  // of the lamp, or of the node
  bool single = false;
  bool ball = false;        // many that fill their bounding sphere, which does not touch the patch's own
  double power = 0.0;       // W/sr before the front, summed over bands: area times radiance
  double area = 0.0;        // m²
  double irradiance = 0.0;  // a rough bound of what it may give the patch, W/m²
};

struct LampChoice {
  std::uint32_t lamp = 0;
  double probability = 0.0;  // 0: no lamp can light the point
  double rest = 0.0;         // of the number that chose, uniform in [0, 1) again
};

// Chooses among many lamps at a cost that grows with the logarithm of their number: a binary tree whose nodes
// store box, power and spread of normals (Conty Estevez and Kulla 2018). A lamp that may give light is never
// left out. Read-only after it was made; 120 bytes per lamp.
class LightTree {
 public:
  explicit LightTree(const Lamps& lamps);

  // Returns the lamps that may light something within `radius` of `centre`, which faces n, as at most `most`
  // branches: strong nodes that are near for their size are opened first, so that important lamps stand
  // alone. balls: whether a bulb of many facets becomes one branch that is sampled by its bounding sphere.
  void cut(const Vec3& centre, float radius, const Vec3& n, std::size_t most, bool balls,
           std::vector<LampBranch>& branches) const;
  struct Sphere {
    Vec3 centre{0.0f};
    float radius = 0.0f;  // m
  };
  // Holds all lamps of the branch.
  Sphere sphere(const LampBranch& branch) const {
    return {nodes_[branch.index].centre, nodes_[branch.index].radius};
  }

  // Chooses one lamp of a branch with many, in proportion to its bound at x or, by_area, to its area. u:
  // uniform in [0, 1); rescaled at each step down, so that even numbers make even choices.
  LampChoice choose(const LampBranch& branch, const Vec3& x, const Vec3& n, double u, bool by_area) const;
  // Returns whether the lamp is one of the branch's, and the probability with which choose() gives it. For a
  // branch with many.
  bool holds(const LampBranch& branch, std::uint32_t lamp) const;
  double probability(const LampBranch& branch, std::uint32_t lamp, const Vec3& x, const Vec3& n,
                     bool by_area) const;

 private:
  struct Node {
    Vec3 centre{0.0f};
    float radius = 0.0f;
    Vec3 axis{0.0f};           // mean normal
    float spread = 0.0f;       // of the normals about the axis: cosine
    float spread_sine = 0.0f;  // and sine
    float power = 0.0f;
    float area = 0.0f;
    std::uint32_t next = 0;    // first of two children, or the lamp
    std::uint32_t parent = 0;  // of the root: itself
    bool leaf = false;
    bool round = false;  // fills its sphere
  };
  std::array<double, 2> values_of(const Node* children, const Vec3& x, const Vec3& n, bool by_area) const;
  void build(std::uint32_t node, const Lamps& lamps, std::uint32_t* begin, std::uint32_t* end);
  static float importance(const Node& node, const Vec3& x, const Vec3& n, float extra_radius);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> leaf_of_;  // [lamp]
};

}  // namespace luxel
