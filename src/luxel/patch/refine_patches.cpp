// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/refine_patches.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <tuple>
#include <utility>

#include "luxel/core/none.h"
#include "luxel/core/triangle.h"
#include "luxel/patch/colour_patches.h"
#include "luxel/scene/triangle_shape.h"

namespace luxel {
namespace {

using Edge = std::array<std::uint32_t, 2>;  // the lower vertex first

constexpr double shortest = 0x1p-18;  // of an edge's largest coordinate
// Edges of a marked patch below this fraction of its longest edge are not halved, so that the parts of a
// needle are wider for their length than the needle.
constexpr double min_halved = 0.4;
// A patch whose shortest edge is below this fraction of its longest one is a needle.
constexpr double max_needle = 0.1;
constexpr float min_flat_cosine = 0.9998f;  // 1 degree

Edge edge_of(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

// The edges of a set, each once, and which of them are halved.
class EdgeCuts {
 public:
  explicit EdgeCuts(const PatchSet& patches) : patches_(patches) {
    struct Use {
      Edge edge;
      std::uint32_t corner;
    };
    std::vector<Use> uses;
    uses.reserve(3 * patches.size());
    for (std::uint32_t p = 0; p < patches.size(); ++p)
      for (std::uint32_t k = 0; k < 3; ++k)
        uses.push_back({edge_of(patches.corners[p][k], patches.corners[p][(k + 1) % 3]), 3 * p + k});
    std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
      return std::tie(a.edge, a.corner) < std::tie(b.edge, b.corner);
    });
    edge_of_corner_.resize(uses.size());
    for (const auto& use : uses) {
      if (edges_.empty() || edges_.back() != use.edge) {
        edges_.push_back(use.edge);
        begins_.push_back(static_cast<std::uint32_t>(corners_.size()));
      }
      edge_of_corner_[use.corner] = static_cast<std::uint32_t>(edges_.size() - 1);
      corners_.push_back(use.corner);
    }
    begins_.push_back(static_cast<std::uint32_t>(corners_.size()));
    middle_.assign(edges_.size(), none);
  }

  // Halves the long edges of the marked patches; where an edge of a patch is halved, its longest edge is
  // halved too.
  void mark(std::span<const std::uint8_t> is_marked) {
    for (std::uint32_t p = 0; p < patches_.size(); ++p)
      if (is_marked[p] != 0) halve_long_edges(p);
    while (!open_.empty()) {
      const auto e = open_.back();
      open_.pop_back();
      for (auto i = begins_[e]; i < begins_[e + 1]; ++i) {
        const auto patch = corners_[i] / 3;
        if (is_long_edge_of_needle(e, patch) && lies_between_coplanar(patch))
          halve_long_edges(patch);
        else
          halve(edge(patch, longest(patch)));
      }
    }
  }

  // Creates the midpoints of halved edges, in the order of edges.
  void add_vertices(std::vector<Vec3>& vertices) {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (middle_[e] == none) continue;
      middle_[e] = static_cast<std::uint32_t>(vertices.size());
      const auto place = 0.5f * (vertices[edges_[e][0]] + vertices[edges_[e][1]]);
      vertices.push_back(place);
    }
  }

  // The edge from corner k of the patch to the next one.
  std::uint32_t edge(std::uint32_t patch, std::uint32_t k) const { return edge_of_corner_[3 * patch + k]; }
  // The vertex at its midpoint; none: the edge is not halved.
  std::uint32_t middle(std::uint32_t edge) const { return middle_[edge]; }
  std::uint32_t middle(const Edge& edge) const {
    const auto at = std::lower_bound(edges_.begin(), edges_.end(), edge);
    return at != edges_.end() && *at == edge ? middle_[static_cast<std::size_t>(at - edges_.begin())] : none;
  }
  // Returns the longest edge of a patch; ties are ordered by vertices, so that all patches at an edge agree.
  std::uint32_t longest(std::uint32_t patch) const {
    const auto order = [&](std::uint32_t k) {
      const auto& e = edges_[edge(patch, k)];
      return std::pair(length2(e), e);
    };
    std::uint32_t best = 0;
    for (std::uint32_t k = 1; k < 3; ++k)
      if (order(best) < order(k)) best = k;
    return best;
  }

 private:
  double length2(const Edge& e) const {
    const auto d = Vec3d(patches_.vertices[e[1]]) - Vec3d(patches_.vertices[e[0]]);
    return glm::dot(d, d);
  }

  // Calls body(edge) for each edge of a patch that is not much shorter than its longest one.
  template <typename Body>
  void for_long_edges(std::uint32_t patch, Body body) const {
    const auto least = min_halved * min_halved * length2(edges_[edge(patch, longest(patch))]);
    for (std::uint32_t k = 0; k < 3; ++k)
      if (length2(edges_[edge(patch, k)]) >= least) body(edge(patch, k));
  }

  void halve_long_edges(std::uint32_t patch) {
    for_long_edges(patch, [this](std::uint32_t e) { halve(e); });
  }

  bool is_long_edge_of_needle(std::uint32_t e, std::uint32_t patch) const {
    const auto lengths = std::array{length2(edges_[edge(patch, 0)]), length2(edges_[edge(patch, 1)]),
                                    length2(edges_[edge(patch, 2)])};
    const auto [least, most] = std::minmax_element(lengths.begin(), lengths.end());
    return *least < max_needle * max_needle * *most && length2(edges_[e]) > *least;
  }

  // Returns whether the patch has a coplanar neighbour at each of its long edges.
  bool lies_between_coplanar(std::uint32_t patch) const {
    const auto is_coplanar = [&](std::uint32_t corner) {
      const auto other = corner / 3;
      return other != patch &&
             std::abs(glm::dot(patches_.normal[other], patches_.normal[patch])) > min_flat_cosine;
    };
    bool all = true;
    for_long_edges(patch, [&](std::uint32_t e) {
      all = all && std::any_of(corners_.begin() + begins_[e], corners_.begin() + begins_[e + 1], is_coplanar);
    });
    return all;
  }

  void halve(std::uint32_t e) {
    if (middle_[e] != none) return;
    const auto a = glm::abs(patches_.vertices[edges_[e][0]]);
    const auto b = glm::abs(patches_.vertices[edges_[e][1]]);
    const auto largest = shortest * static_cast<double>(std::max({a.x, a.y, a.z, b.x, b.y, b.z}));
    if (length2(edges_[e]) <= largest * largest) return;
    middle_[e] = 0;  // numbered later
    open_.push_back(e);
  }

  const PatchSet& patches_;
  std::vector<Edge> edges_;                    // ascending
  std::vector<std::uint32_t> begins_;          // [edge], into corners_
  std::vector<std::uint32_t> corners_;         // 3 * patch + corner that the edge begins at
  std::vector<std::uint32_t> edge_of_corner_;  // [3 * patch + corner]
  std::vector<std::uint32_t> middle_;          // [edge]
  std::vector<std::uint32_t> open_;            // halved; their patches are still to be processed
};

class Refiner {
 public:
  Refiner(const PatchSet& old, std::span<const std::uint8_t> is_marked) : old_(old), cuts_(old) {
    cuts_.mark(is_marked);
    auto& set = result_.patches;
    set.vertices = old.vertices;
    cuts_.add_vertices(set.vertices);
    set.bands = old.bands;
    set.wavebands = old.wavebands;
    set.materials = old.materials;
    set.scene_fingerprint = old.scene_fingerprint;
    set.origin = old.origin;
    set.up = old.up;
    set.sky_patches = old.sky_patches;
    set.sky = old.sky;
    set.point_lights = old.point_lights;
    set.portals = old.portals;
    set.panes = old.panes;
    set.light_groups = old.light_groups;
    set.cameras = old.cameras;
    set.focuses_on_cameras = old.focuses_on_cameras;
    set.view = old.view;
    for (std::uint32_t p = 0; p < old.size(); ++p) cut(p);
    inherit_contacts();
  }

  RefinedPatches take() { return std::move(result_); }

 private:
  void cut(std::uint32_t p) {
    const auto k = cuts_.longest(p);
    const auto m = cuts_.middle(cuts_.edge(p, k));
    const auto& c = old_.corners[p];
    if (m == none) return append(c, p);
    const auto i = c[k];
    const auto j = c[(k + 1) % 3];
    const auto apex = c[(k + 2) % 3];
    cut_half({i, m, apex}, cuts_.middle(cuts_.edge(p, (k + 2) % 3)), p);
    cut_half({apex, m, j}, cuts_.middle(cuts_.edge(p, (k + 1) % 3)), p);
  }

  // middle: midpoint of the edge from the last corner to the first.
  void cut_half(const std::array<std::uint32_t, 3>& c, std::uint32_t middle, std::uint32_t p) {
    if (middle == none) return append(c, p);
    append({c[0], c[1], middle}, p);
    append({middle, c[1], c[2]}, p);
  }

  void append(const std::array<std::uint32_t, 3>& c, std::uint32_t p) {
    auto& set = result_.patches;
    const auto& v = set.vertices;
    // A triangle that floats cannot distinguish from a line carries no light; its neighbours share its
    // corners anyway.
    if (c != old_.corners[p] && !has_area(v[c[0]], v[c[1]], v[c[2]])) return;
    set.corners.push_back(c);
    set.normal.push_back(old_.normal[p]);
    set.area.push_back(static_cast<float>(triangle_area(v[c[0]], v[c[1]], v[c[2]])));
    set.material.push_back(old_.material[p]);
    set.triangle.push_back(old_.triangle[p]);
    if (!old_.focus.empty()) set.focus.push_back(old_.focus[p]);
    result_.parent.push_back(p);
  }

  void inherit_contacts() {
    auto& contacts = result_.patches.contacts;
    for (const auto& contact : old_.contacts) {
      const auto m = cuts_.middle(contact.edge);
      if (m == none) {
        contacts.push_back(contact);
        continue;
      }
      contacts.push_back({edge_of(contact.edge[0], m), contact.into});
      contacts.push_back({edge_of(contact.edge[1], m), contact.into});
    }
    std::stable_sort(contacts.begin(), contacts.end(),
                     [](const Contact& a, const Contact& b) { return a.edge < b.edge; });
  }

  const PatchSet& old_;
  EdgeCuts cuts_;
  RefinedPatches result_;
};

}  // namespace

RefinedPatches refine_patches(const PatchSet& patches, std::span<const std::uint8_t> is_marked,
                              const Context& context) {
  assert(is_marked.size() == patches.size());
  auto refined = Refiner(patches, is_marked).take();
  inherit_textures(refined.patches, patches, refined.parent, context);
  return refined;
}

}  // namespace luxel
