// SPDX-License-Identifier: Apache-2.0
#include "luxel/surface/needle_nodes.h"

#include <algorithm>
#include <array>
#include <utility>

#include "luxel/core/barycentric.h"
#include "luxel/core/bounds.h"
#include "luxel/core/disjoint_sets.h"
#include "luxel/patch/side.h"

namespace luxel {
namespace {

constexpr float max_width = 0.1f;           // of a needle and of a group, over the needle's longest edge
constexpr float min_flat_cosine = 0.9998f;  // 1 degree
constexpr double max_bent_area = 0.1;       // of the area around a node

// The short edge of a needle, from a corner to the next one.
struct ShortEdge {
  std::size_t corner = 0;
  float longest = 0.0f;  // edge of the patch, m; 0: the patch is no needle
};

ShortEdge short_edge(const PatchSet& patches, std::size_t patch) {
  const auto points = patches.points(patch);
  std::array<float, 3> length{};
  for (std::size_t k = 0; k < 3; ++k) length[k] = glm::distance(points[k], points[(k + 1) % 3]);
  const auto shortest = std::min_element(length.begin(), length.end());
  const auto longest = *std::max_element(length.begin(), length.end());
  if (*shortest > max_width * longest) return {};
  return {static_cast<std::size_t>(shortest - length.begin()), longest};
}

class Groups {
 public:
  Groups(const PatchSet& patches, const SideNodes& nodes)
      : patches_(patches),
        nodes_(nodes),
        sets_(nodes.size()),
        boxes_(nodes.size()),
        vertex_(nodes.size()),
        normal_(nodes.size()) {
    for (std::uint32_t v = 0; v < patches.vertices.size(); ++v)
      for (auto node = nodes.first[v]; node < nodes.first[v + 1]; ++node) {
        boxes_[node].add(patches.vertices[v]);
        vertex_[node] = v;
      }
    for (std::size_t p = 0; p < patches.size(); ++p)
      if (const auto edge = short_edge(patches, p); edge.longest > 0.0f)
        for (const bool back : {false, true}) join({p, back}, edge);
  }

  // Calls body(nodes) for each group of several nodes, which are ascending.
  template <typename Body>
  void for_each(Body body) {
    std::vector<std::uint32_t> joined;  // all that are in such groups
    for (std::uint32_t node = 0; node < nodes_.size(); ++node)
      if (const auto first = sets_.of(node); first != node) {
        joined.push_back(first);
        joined.push_back(node);
      }
    std::sort(joined.begin(), joined.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(sets_.of(a), a) < std::pair(sets_.of(b), b);
    });
    joined.erase(std::unique(joined.begin(), joined.end()), joined.end());
    for (std::size_t begin = 0, end = 0; begin < joined.size(); begin = end) {
      while (end < joined.size() && sets_.of(joined[end]) == joined[begin]) ++end;
      body(std::span(joined).subspan(begin, end - begin));
    }
  }

  const Vec3& vertex_of(std::uint32_t node) const { return patches_.vertices[vertex_[node]]; }

  // Returns whether a side is parallel to the needles at a node, which must be in a group.
  bool is_beside(std::uint32_t node, SideId side) const { return is_parallel(side, normal_[node]); }

 private:
  bool is_parallel(SideId side, const Vec3& normal) const {
    return glm::dot(patches_.normal_of(side), normal) > min_flat_cosine;
  }

  bool is_flat(std::uint32_t node, const Vec3& normal) const {
    double whole = 0.0, bent = 0.0;
    for (const auto& m : nodes_.at(node)) {
      const auto area = static_cast<double>(patches_.area[m.side.patch()]);
      whole += area;
      if (!is_parallel(m.side, normal)) bent += area;
    }
    return bent <= max_bent_area * whole;
  }

  void join(SideId side, const ShortEdge& edge) {
    const auto& corners = nodes_.of_side[side.index()];
    const std::array ends{corners[edge.corner], corners[(edge.corner + 1) % 3]};
    const auto normal = patches_.normal_of(side);
    if (!is_flat(ends[0], normal) || !is_flat(ends[1], normal)) return;
    const auto a = sets_.of(ends[0]), b = sets_.of(ends[1]);
    auto box = boxes_[a];
    box.add(boxes_[b]);
    if (glm::distance(box.low, box.high) > max_width * edge.longest) return;
    sets_.join(a, b);
    boxes_[sets_.of(a)] = box;
    for (const auto node : ends) normal_[node] = normal;
  }

  const PatchSet& patches_;
  const SideNodes& nodes_;
  DisjointSets sets_;
  std::vector<Bounds> boxes_;          // [node], of its group where it is the lowest of it
  std::vector<std::uint32_t> vertex_;  // [node]
  std::vector<Vec3> normal_;           // [node], of a needle that joined it
};

}  // namespace

NeedleNodes::NeedleNodes(const PatchSet& patches, const SideNodes& nodes) : list_of_(nodes.size(), none) {
  Groups groups(patches, nodes);
  groups.for_each([&](std::span<const std::uint32_t> group) {
    for (const auto node : group) {
      std::vector<FarSide> far;
      std::vector<SideId> known;
      for (const auto& m : nodes.at(node)) known.push_back(m.side);
      for (const auto other : group)
        for (const auto& m : nodes.at(other)) {
          if (other == node || std::find(known.begin(), known.end(), m.side) != known.end()) continue;
          known.push_back(m.side);
          const auto patch = m.side.patch();
          if (short_edge(patches, patch).longest > 0.0f || !groups.is_beside(node, m.side)) continue;
          far.push_back({m.side, barycentric(patches.points(patch), groups.vertex_of(node))});
        }
      if (far.empty()) continue;
      list_of_[node] = static_cast<std::uint32_t>(lists_.size());
      lists_.push_back(std::move(far));
    }
  });
}

}  // namespace luxel
