// SPDX-License-Identifier: Apache-2.0
#include "luxel/lamps/light_tree.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "luxel/core/trig.h"
#include "luxel/core/unit_vector.h"

namespace luxel {
namespace {

constexpr std::size_t bins = 16;
constexpr float rounding = 1e-4f;          // tolerance of cosines
constexpr float sphere_margin = 1.00001f;  // of a bounding sphere's radius, for the rounding of floats
constexpr float nearest_ball = 1.02f;      // distance over radius; nearer balls are split into facets
// Minimum ratio of the lamps' area to that of their bounding sphere. On average a convex bulb shows a quarter
// of its area, and the sphere a quarter of its own: the ratio is therefore the fraction of rays towards the
// sphere that hit the bulb.
constexpr float min_fill = 0.5f;
// Minimum number of facets of a ball. Measured with 40 lamps close to walls and 16 samples per replicate:
// variance times cost of a bulb of 20 facets was 0.7 of that of its individual facets; of a bulb of 8, for
// which the closed form applies, 1.5 times.
constexpr std::ptrdiff_t min_facets = 16;
constexpr float min_cosine =
    0.05f;  // lamps at the horizon are sampled rarely but not never: bounds the weights

// Quantities that determine the cost of a split, additive over lamps.
struct Cluster {
  Bounds bounds;
  Vec3d normals{0.0};  // sum, weighted by power
  double power = 0.0;

  void add(const LampTriangle& lamp) {
    for (const auto& v : lamp.corner) bounds.add(v);
    const auto p = lamp.area * lamp.weight;
    normals += p * lamp.normal;
    power += p;
  }
  void add(const Cluster& other) {
    if (other.bounds.empty()) return;
    bounds.add(other.bounds.low);
    bounds.add(other.bounds.high);
    normals += other.normals;
    power += other.power;
  }
  // Surface area orientation heuristic (Conty Estevez and Kulla 2018, equation 1); the spread of normals is
  // derived from the length of their mean.
  double cost() const {
    if (bounds.empty()) return 0.0;
    const auto d = Vec3d(bounds.size());
    const auto surface = d.x * d.y + d.y * d.z + d.z * d.x;
    const auto spread = arc_cosine(2.0 * glm::length(normals) / power - 1.0);
    const auto whole = std::min(spread + std::numbers::pi / 2.0, std::numbers::pi);
    const auto [s, c] = sin_cos(spread);
    const auto measure = 2.0 * std::numbers::pi * (1.0 - c) +
                         std::numbers::pi / 2.0 *
                             (2.0 * whole * s - sin_cos(spread - 2.0 * whole).cosine - 2.0 * spread * s + c);
    return power * surface * measure;
  }
};

Vec3 centre_of(const LampTriangle& lamp) { return (lamp.corner[0] + lamp.corner[1] + lamp.corner[2]) / 3.0f; }

struct Split {
  int axis = -1;
  float at = 0.0f;
};

// The cheapest split between bins along the three axes; axis -1 where all centres coincide.
Split best_split(std::span<const LampTriangle> lamps, const std::uint32_t* begin, const std::uint32_t* end) {
  Bounds centres;
  for (auto i = begin; i != end; ++i) centres.add(centre_of(lamps[*i]));
  const auto size = centres.size();
  Split best;
  auto least = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (!(size[axis] > 0.0f)) continue;
    std::array<Cluster, bins> cluster;
    for (auto i = begin; i != end; ++i) {
      const auto fraction = (centre_of(lamps[*i])[axis] - centres.low[axis]) / size[axis];
      cluster[std::min(bins - 1, static_cast<std::size_t>(fraction * static_cast<float>(bins)))].add(
          lamps[*i]);
    }
    std::array<double, bins> right{};
    Cluster sum;
    for (auto k = bins - 1; k > 0; --k) {
      sum.add(cluster[k]);
      right[k] = sum.cost();
    }
    sum = {};
    for (std::size_t k = 1; k < bins; ++k) {
      sum.add(cluster[k - 1]);
      // Penalises splits along the short axes of thin boxes.
      const auto interval = static_cast<double>(std::max({size.x, size.y, size.z}) / size[axis]);
      const auto cost = interval * (sum.cost() + right[k]);
      if (cost < least) {
        least = cost;
        best = {axis, centres.low[axis] + size[axis] * static_cast<float>(k) / static_cast<float>(bins)};
      }
    }
  }
  return best;
}

float sine_of(float cosine) { return std::sqrt(std::max(0.0f, 1.0f - cosine * cosine)); }

// The cosine of max(0, a - b).
float cosine_of_less(float cosine_a, float sine_b, float cosine_b) {
  return cosine_a >= cosine_b ? 1.0f : cosine_a * cosine_b + sine_of(cosine_a) * sine_b;
}

}  // namespace

LightTree::LightTree(const Lamps& lamps) {
  if (lamps.size() == 0) return;
  std::vector<std::uint32_t> order(lamps.size());
  std::iota(order.begin(), order.end(), 0u);
  nodes_.reserve(2 * lamps.size());
  leaf_of_.resize(lamps.size());
  nodes_.emplace_back();
  build(0, lamps, order.data(), order.data() + order.size());
}

void LightTree::build(std::uint32_t node, const Lamps& lamps, std::uint32_t* begin, std::uint32_t* end) {
  const auto triangles = lamps.triangles();
  Cluster all;
  for (auto i = begin; i != end; ++i) all.add(triangles[*i]);
  Node made;
  made.centre = all.bounds.center();
  made.power = static_cast<float>(all.power);
  for (auto i = begin; i != end; ++i) made.area += static_cast<float>(triangles[*i].area);
  const auto length = glm::length(all.normals);
  made.axis = length > 1e-6 * all.power ? Vec3(all.normals / length) : Vec3(0, 0, 1);
  made.spread = 1.0f;
  for (auto i = begin; i != end; ++i) {
    for (const auto& v : triangles[*i].corner)
      made.radius = std::max(made.radius, glm::distance(v, made.centre));
    made.spread = std::min(made.spread, glm::dot(made.axis, Vec3(triangles[*i].normal)));
  }
  made.radius *= sphere_margin;
  made.spread_sine = sine_of(made.spread);
  made.leaf = end - begin == 1;
  made.round = end - begin >= min_facets && made.area >= min_fill * 4.0f * pi * made.radius * made.radius &&
               std::none_of(begin, end, [&](std::uint32_t i) {
                 return triangles[i].has_holes || triangles[i].is_portal();
               });
  made.next = made.leaf ? *begin : static_cast<std::uint32_t>(nodes_.size());
  made.parent = nodes_[node].parent;
  nodes_[node] = made;
  if (made.leaf) {
    leaf_of_[*begin] = node;
    return;
  }
  nodes_.resize(nodes_.size() + 2);
  nodes_[made.next].parent = nodes_[made.next + 1].parent = node;
  const auto split = best_split(triangles, begin, end);
  auto* middle = split.axis < 0 ? begin : std::stable_partition(begin, end, [&](std::uint32_t i) {
    return centre_of(triangles[i])[split.axis] < split.at;
  });
  if (middle == begin || middle == end) middle = begin + (end - begin) / 2;
  build(made.next, lamps, begin, middle);
  build(made.next + 1, lamps, middle, end);
}

// Power times a bound of both cosines over the node's sphere, over the squared distance; zero only where no
// lamp of the node lights anything within extra_radius of x.
float LightTree::importance(const Node& node, const Vec3& x, const Vec3& n, float extra_radius) {
  const auto to = node.centre - x;
  const auto distance2 = glm::dot(to, to);
  const auto radius = node.radius + extra_radius;
  if (distance2 <= radius * radius) return node.power / std::max(distance2, node.radius * node.radius);
  const auto inverse = 1.0f / std::sqrt(distance2);
  const auto sphere_sine = radius * inverse;
  const auto sphere_cosine = sine_of(sphere_sine);
  const auto here = cosine_of_less(glm::dot(n, to) * inverse, sphere_sine, sphere_cosine);
  if (here < -rounding) return 0.0f;
  // At the lamps: the angle to their axis, less the spread of normals and the angle of the sphere.
  const auto away = cosine_of_less(-glm::dot(node.axis, to) * inverse, node.spread_sine, node.spread);
  const auto there = cosine_of_less(away, sphere_sine, sphere_cosine);
  if (there < -rounding) return 0.0f;
  return node.power * std::max(here, min_cosine) * std::max(there, min_cosine) * (inverse * inverse);
}

void LightTree::cut(const Vec3& centre, float radius, const Vec3& n, std::size_t most, bool balls,
                    std::vector<LampBranch>& branches) const {
  assert(is_unit(n) && radius >= 0.0f && most > 0);
  branches.clear();
  if (nodes_.empty()) return;
  struct Open {
    float priority;
    std::uint32_t node;
    float importance;
    bool operator<(const Open& other) const { return priority < other.priority; }
  };
  std::vector<Open> heap;
  const auto add = [&](std::uint32_t index) {
    const auto& node = nodes_[index];
    const auto value = importance(node, centre, n, radius);
    if (!(value > 0.0f)) return;
    if (node.leaf) {
      branches.push_back({node.next, true, false, node.power, node.area, value});
      return;
    }
    if (balls && node.round && glm::distance(node.centre, centre) - radius > nearest_ball * node.radius) {
      branches.push_back({index, false, true, node.power, node.area, value});
      return;
    }
    // The larger a cluster appears, the more its lamps differ in importance.
    const auto distance = std::max(0.0f, glm::distance(node.centre, centre) - radius);
    heap.push_back({distance > node.radius ? value * node.radius / distance : value, index, value});
    std::push_heap(heap.begin(), heap.end());
  };
  add(0);
  while (!heap.empty() && heap.size() + branches.size() < most) {
    const auto children = nodes_[heap.front().node].next;
    std::pop_heap(heap.begin(), heap.end());
    heap.pop_back();
    add(children);
    add(children + 1);
  }
  for (const auto& open : heap) {
    const auto& node = nodes_[open.node];
    branches.push_back({open.node, false, false, node.power, node.area, open.importance});
  }
}

// Weights by which one of two children is chosen; 0 and 0 where neither can light x.
std::array<double, 2> LightTree::values_of(const Node* children, const Vec3& x, const Vec3& n,
                                           bool by_area) const {
  const auto value = [&](const Node& child) {
    return static_cast<double>(by_area ? child.area : importance(child, x, n, 0.0f));
  };
  return {value(children[0]), value(children[1])};
}

LampChoice LightTree::choose(const LampBranch& branch, const Vec3& x, const Vec3& n, double u,
                             bool by_area) const {
  assert(is_unit(n) && u >= 0.0 && u < 1.0);
  const auto* node = &nodes_[branch.index];
  double probability = 1.0;
  while (!node->leaf) {
    const auto* children = &nodes_[node->next];
    const auto [a, b] = values_of(children, x, n, by_area);
    if (!(a + b > 0.0)) return {};
    const auto at = u * (a + b);
    const bool first = at < a;
    node = first ? children : children + 1;
    // Two divisions that do not depend on each other.
    probability *= (first ? a : b) / (a + b);
    u = std::min(first ? at / a : (at - a) / b, 0x1.fffffffffffffp-1);
  }
  return {node->next, probability, u};
}

bool LightTree::holds(const LampBranch& branch, std::uint32_t lamp) const {
  assert(!branch.single && lamp < leaf_of_.size());
  auto at = leaf_of_[lamp];
  while (at > branch.index) at = nodes_[at].parent;  // children follow their parents
  return at == branch.index;
}

double LightTree::probability(const LampBranch& branch, std::uint32_t lamp, const Vec3& x, const Vec3& n,
                              bool by_area) const {
  double probability = 1.0;
  for (auto at = leaf_of_[lamp]; at != branch.index; at = nodes_[at].parent) {
    const auto first = nodes_[nodes_[at].parent].next;
    const auto [a, b] = values_of(&nodes_[first], x, n, by_area);
    if (!(a + b > 0.0)) return 0.0;
    probability *= (at == first ? a : b) / (a + b);
  }
  return probability;
}

}  // namespace luxel
