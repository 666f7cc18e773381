// SPDX-License-Identifier: Apache-2.0
#include "luxel/patch/plane_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <unordered_set>

#include "luxel/core/disjoint_sets.h"

namespace luxel {
namespace {

constexpr float plane_step = 1e-3f;  // of a normal's components, and of the scene's size

// The plane of each patch's input triangle, rounded so that triangles modelled on one plane agree.
std::vector<std::uint64_t> planes_of(const PatchSet& patches) {
  const auto size = largest_coordinate(patches);
  const auto rounded = [](float x, float step) {
    return static_cast<std::int64_t>(std::floor(x / step + 0.5f));
  };
  std::vector<std::uint64_t> planes(patches.size());
  for (std::size_t p = 0; p < patches.size(); ++p) {
    if (p > 0 && patches.triangle[p] == patches.triangle[p - 1]) {
      planes[p] = planes[p - 1];
      continue;
    }
    const auto& n = patches.normal[p];
    const auto offset = glm::dot(n, patches.points(p)[0]);
    std::uint64_t key = 0;
    for (const auto part : {rounded(n.x, plane_step), rounded(n.y, plane_step), rounded(n.z, plane_step),
                            rounded(offset, plane_step * size)})
      key = (key ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15u + (key >> 29);
    planes[p] = key;
  }
  return planes;
}

// Components connected by edges without contacts, for planes that have contacts.
class Parts {
 public:
  Parts(const PatchSet& patches, const std::vector<std::uint64_t>& planes)
      : patches_(patches), planes_(planes), sets_(patches.size()), touched_(patches.size(), false) {
    auto edges = edges_of_touched_planes();
    std::sort(edges.begin(), edges.end(), [](const Use& a, const Use& b) {
      return std::tuple(a.edge, a.patch) < std::tuple(b.edge, b.patch);
    });
    for (std::size_t i = 1; i < edges.size(); ++i)
      if (edges[i].edge == edges[i - 1].edge && planes_[edges[i].patch] == planes_[edges[i - 1].patch] &&
          !is_contact(edges[i].edge))
        sets_.join(edges[i - 1].patch, edges[i].patch);
    for (std::uint32_t p = 0; p < patches.size(); ++p)
      if (touched_[p]) touched_[sets_.of(p)] = true;
  }

  // The first patch of the part, if the part has contacts.
  std::uint64_t of(std::uint32_t patch) {
    const auto first = sets_.of(patch);
    return touched_[first] ? first + 1ull : 0;
  }

 private:
  using Edge = std::array<std::uint32_t, 2>;
  struct Use {
    Edge edge;
    std::uint32_t patch;
  };

  Edge edge(std::uint32_t patch, std::size_t k) const {
    const auto& c = patches_.corners[patch];
    const auto [low, high] = std::minmax(c[k], c[(k + 1) % 3]);
    return {low, high};
  }

  bool is_contact(const Edge& edge) const {
    const auto& all = patches_.contacts;
    const auto found = std::lower_bound(all.begin(), all.end(), edge,
                                        [](const Contact& c, const Edge& e) { return c.edge < e; });
    return found != all.end() && found->edge == edge;
  }

  std::vector<Use> edges_of_touched_planes() {
    std::vector<bool> is_end(patches_.vertices.size(), false);
    for (const auto& contact : patches_.contacts)
      for (const auto v : contact.edge) is_end[v] = true;
    std::unordered_set<std::uint64_t> touched_planes;
    for (std::uint32_t p = 0; p < patches_.size(); ++p)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto e = edge(p, k);
        if (!is_end[e[0]] || !is_end[e[1]] || !is_contact(e)) continue;
        touched_[p] = true;
        touched_planes.insert(planes_[p]);
      }
    std::vector<Use> edges;
    for (std::uint32_t p = 0; p < patches_.size(); ++p)
      if (touched_planes.count(planes_[p]) > 0)
        for (std::size_t k = 0; k < 3; ++k) edges.push_back({edge(p, k), p});
    return edges;
  }

  const PatchSet& patches_;
  const std::vector<std::uint64_t>& planes_;
  DisjointSets sets_;
  std::vector<bool> touched_;  // has a contact
};

}  // namespace

float largest_coordinate(const PatchSet& patches) {
  float largest = 0.0f;
  for (const auto& v : patches.vertices)
    largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return largest;
}

std::vector<std::uint64_t> plane_parts(const PatchSet& patches) {
  auto planes = planes_of(patches);
  if (patches.contacts.empty()) return planes;
  Parts parts(patches, planes);
  std::vector<std::uint64_t> result(patches.size());
  for (std::uint32_t p = 0; p < patches.size(); ++p)
    result[p] = planes[p] ^ (parts.of(p) * 0x9e3779b97f4a7c15u);
  return result;
}

}  // namespace luxel
